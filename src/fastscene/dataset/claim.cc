#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/process_name.h"
#include "fastscene/dataset/parts.h"

namespace fastscene::dataset {
namespace {

namespace fs = std::filesystem;

// "HOST PID", the content of a claim file.
std::string signature() { return fmt::format("{} {}", host_name(), ::getpid()); }

bool left_behind(const fs::path& path, int stale_minutes) {
    std::string text;
    try {
        text = read_file(path);
    } catch (const Error&) {
        return false;  // just released
    }
    const auto space = text.find(' ');
    if (space != std::string::npos && text.substr(0, space) == host_name()) {
        const int pid = std::atoi(text.c_str() + space + 1);
        return pid > 0 && ::kill(pid, 0) != 0 && errno == ESRCH;
    }
    std::error_code none;
    const auto written = fs::last_write_time(path, none);
    return !none && fs::file_time_type::clock::now() - written > std::chrono::minutes(stale_minutes);
}

// Exclusive creation: exactly one process succeeds.
bool create(const fs::path& path) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (file < 0) {
        if (errno == EEXIST) return false;
        throw Error("{}: cannot be created: {}", path.string(), std::strerror(errno));
    }
    const std::string text = signature();
    const bool whole = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    const int reason = errno;
    ::close(file);
    if (!whole) {
        ::unlink(path.c_str());
        throw Error("{}: cannot be written: {}", path.string(), std::strerror(reason));
    }
    return true;
}

}  // namespace

std::optional<Claim> Claim::take(const fs::path& folder, const std::string& name, int stale_minutes) {
    const fs::path path = folder / (name + ".claim");
    if (create(path)) return Claim(path);
    if (!left_behind(path, stale_minutes)) return {};
    // If several processes find a stale claim, the one whose rename succeeds continues.
    const fs::path mine = folder / fmt::format("{}.stale.{}", name, process_name());
    if (std::rename(path.c_str(), mine.c_str()) != 0) return {};
    fs::remove(mine);
    if (create(path)) return Claim(path);
    return {};
}

Claim::~Claim() {
    std::error_code none;
    if (!path_.empty()) fs::remove(path_, none);
}

void Claim::still_alive() const {
    std::error_code none;
    fs::last_write_time(path_, fs::file_time_type::clock::now(), none);
}

}  // namespace fastscene::dataset
