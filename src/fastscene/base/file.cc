#include "fastscene/base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "fastscene/base/error.h"
#include "fastscene/base/forced_exit.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/process_name.h"
#include "fastscene/base/temporary_name.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

struct Descriptor {
    int fd = -1;
    ~Descriptor() {
        if (fd >= 0) ::close(fd);
    }
};

void rename_or_throw(const fs::path& from, const fs::path& to) {
    std::error_code code;
    fs::rename(from, to, code);
    if (!code) return;
    std::error_code ignored;
    fs::remove(from, ignored);
    throw Error("{}: cannot be written: {}", to.string(), code.message());
}

}  // namespace

fs::path temporary_beside(const fs::path& path) {
    constexpr std::size_t kLongestName = 255;  // bytes, of Linux
    static std::atomic<unsigned> count = 0;    // two threads may write the same file
    const std::string ending = fmt::format("{}-{}.part", process_name(), count++);
    std::string name = fmt::format(".{}.{}", path.filename().string(), ending);
    if (name.size() > kLongestName) name = fmt::format(".{}.part", Hash().add(path.string() + ending).hex());
    return path.parent_path() / name;
}

std::string read_file(const fs::path& path) {
    // Opening a pipe without a writer must not block.
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)};
    struct stat info {};
    if (file.fd < 0 || ::fstat(file.fd, &info) != 0)
        throw Error("{}: cannot be read: {}", path.string(), std::strerror(errno));
    if (S_ISDIR(info.st_mode)) throw Error("{}: cannot be read: expected a file, found a directory", path.string());
    // Pipes and devices have no size and cannot be read twice, but pictures are read more than once.
    if (!S_ISREG(info.st_mode))
        throw Error("{}: cannot be read: expected a file, found a pipe or device", path.string());
    std::string bytes(static_cast<std::size_t>(info.st_size), '\0');
    std::size_t have = 0;
    while (have < bytes.size()) {
        const ssize_t got = ::read(file.fd, bytes.data() + have, bytes.size() - have);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw Error("{}: cannot be read: {}", path.string(), std::strerror(errno));
        if (got == 0) break;
        have += static_cast<std::size_t>(got);
    }
    bytes.resize(have);
    return bytes;
}

void write_renamed(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    const fs::path temporary = temporary_beside(path);
    const auto remove = [temporary] {
        std::error_code ignored;
        fs::remove(temporary, ignored);
    };
    ExitDuty tidy(remove);
    try {
        write(temporary);
    } catch (...) {
        remove();
        throw;
    }
    tidy.dismiss();
    rename_or_throw(temporary, path);
}

void write_pieces(const fs::path& path, const std::function<void(const std::function<void(std::string_view)>&)>& make) {
    write_renamed(path, [&](const fs::path& temporary) {
        Descriptor file{::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)};
        if (file.fd < 0) throw Error("{}: cannot be written: {}", path.string(), std::strerror(errno));
        make([&](std::string_view rest) {
            while (!rest.empty()) {
                const ssize_t put = ::write(file.fd, rest.data(), rest.size());
                if (put < 0 && errno == EINTR) continue;
                if (put < 0) throw Error("{}: cannot be written: {}", path.string(), std::strerror(errno));
                rest.remove_prefix(static_cast<std::size_t>(put));
            }
        });
        const int fd = file.fd;
        file.fd = -1;
        // Some file systems report a full disk only on close.
        if (::close(fd) != 0) throw Error("{}: cannot be written: {}", path.string(), std::strerror(errno));
    });
}

void write_file(const fs::path& path, std::string_view bytes) {
    write_pieces(path, [&](const auto& put) { put(bytes); });
}

void make_directories(const fs::path& path) {
    std::error_code code;
    fs::create_directories(path, code);
    if (code) throw Error("{}: cannot make this directory: {}", path.string(), code.message());
    if (!fs::is_directory(path)) throw Error("{}: expected a directory, found a file", path.string());
}

}  // namespace fastscene
