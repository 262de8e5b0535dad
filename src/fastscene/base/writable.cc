#include "fastscene/base/writable.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "fastscene/base/error.h"
#include "fastscene/base/temporary_name.h"

namespace fastscene {

void check_writable(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw Error("{}: cannot be written: expected a file or nothing, found a folder", path.string());
    const std::filesystem::path trial = temporary_beside(path);
    const int fd = ::open(trial.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
    if (fd < 0) throw Error("{}: cannot be written: {}", path.string(), std::strerror(errno));
    ::close(fd);
    std::filesystem::remove(trial, ignored);
}

}  // namespace fastscene
