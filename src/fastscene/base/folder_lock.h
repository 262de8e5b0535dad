#pragma once

#include <filesystem>

namespace fastscene {

// Exclusive lock on a folder. Throws Error if another process holds it. Released with the object, or when the process
// ends.
class FolderLock {
  public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int descriptor_;
};

}  // namespace fastscene
