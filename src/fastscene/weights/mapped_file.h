// A file mapped into memory read-only; pages are loaded on access.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <utility>

namespace fastscene {

class MappedFile {
  public:
    // Throws Error if it cannot be opened or is a directory.
    explicit MappedFile(const std::filesystem::path& path);
    // Wraps static memory; `name` is used in messages.
    MappedFile(std::filesystem::path name, std::string_view memory)
        : path_(std::move(name)), data_(memory.data()), size_(memory.size()), mapped_(false) {}
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    ~MappedFile();

    const std::filesystem::path& path() const { return path_; }
    std::string_view text() const { return {data_, size_}; }
    std::span<const std::byte> bytes() const { return {reinterpret_cast<const std::byte*>(data_), size_}; }

  private:
    std::filesystem::path path_;
    const char* data_ = nullptr;
    std::size_t size_ = 0;
    bool mapped_ = true;
};

}  // namespace fastscene
