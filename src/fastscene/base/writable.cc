#include "fastscene/base/writable.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "fastscene/base/error.h"

namespace fastscene {

void check_writable(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw Error("{}: cannot be written: expected a file or nothing, found a folder", path.string());
    const std::filesystem::path trial = path.parent_path() /
                                        fmt::format(".{}.{}.part", path.filename().string(), ::getpid());
    const int fd = ::open(trial.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
    if (fd < 0) throw Error("{}: cannot be written: {}", path.string(), std::strerror(errno));
    ::close(fd);
    std::filesystem::remove(trial, ignored);
}

}  // namespace fastscene
