#include "fastscene/base/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "fastscene/base/error.h"

namespace fastscene {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0) throw Error("{}: cannot be opened: {}", folder.string(), std::strerror(errno));
    // Some network file systems do not support locks; there the user is responsible.
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        ::close(descriptor_);
        throw Error("{}: another fastscene is working on this folder", folder.string());
    }
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace fastscene
