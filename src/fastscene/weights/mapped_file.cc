#include "fastscene/weights/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "fastscene/base/error.h"

namespace fastscene {

MappedFile::MappedFile(const std::filesystem::path& path) : path_(path) {
    const int handle = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    struct stat about {};
    if (handle < 0 || ::fstat(handle, &about) != 0) {
        const int reason = errno;
        if (handle >= 0) ::close(handle);
        throw Error("{}: cannot be read: {}", path.string(), std::strerror(reason));
    }
    if (!S_ISREG(about.st_mode)) {
        ::close(handle);
        throw Error("{}: expected a file, found a {}", path.string(),
                    S_ISDIR(about.st_mode) ? "directory" : "pipe or device");
    }
    size_ = static_cast<std::size_t>(about.st_size);
    void* at = size_ ? ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, handle, 0) : nullptr;
    const int reason = errno;
    ::close(handle);
    if (at == MAP_FAILED && reason == ENOMEM)
        throw Error(
            "{}: expected room for its {:.1f} GiB in the program's memory, found too little (ulimit -v sets a limit)",
            path.string(), static_cast<double>(size_) / (1 << 30));
    if (at == MAP_FAILED) throw Error("{}: cannot be read: {}", path.string(), std::strerror(reason));
    data_ = static_cast<const char*>(at);
}

MappedFile::~MappedFile() {
    if (data_ && mapped_) ::munmap(const_cast<char*>(data_), size_);
}

}  // namespace fastscene
