// Reads zip archives with stored and deflated entries, as used by furniture packs (.sh3f).
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace fastscene {

class ZipFile {
  public:
    // Reads the directory. Throws Error if the file is missing, truncated or not a zip archive.
    explicit ZipFile(std::filesystem::path path);

    bool contains(const std::string& name) const { return entries_.contains(name); }
    std::vector<std::string> names() const;
    // The decompressed content. Throws Error for an unknown name, a damaged entry (checksum mismatch), encryption, or
    // more than 256 MiB.
    std::string read(const std::string& name) const;
    const std::filesystem::path& path() const { return path_; }

  private:
    struct Entry {
        std::uint64_t offset;  // of its local header
        std::uint32_t packed, size, crc;
        std::uint16_t method, flags;
    };
    std::filesystem::path path_;
    std::uint64_t file_size_ = 0;
    std::map<std::string, Entry> entries_;
};

// An archive of these files (name, content), stored as they are. Without dates: the same files give the same bytes.
std::string stored_zip(const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace fastscene
