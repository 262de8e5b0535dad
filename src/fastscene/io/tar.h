// Tar archives (POSIX ustar) without owners and dates: the same files give the same bytes.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace fastscene {

// The bytes that a file of this size takes in an archive: its header, and its content in blocks.
std::size_t tar_entry_size(std::size_t file_size);
// The most that an archive's end takes: two empty blocks, and what fills a record.
inline constexpr std::size_t kTarEndSize = 2 * 512 + 10240 - 512;

// Writes an archive piece by piece.
class TarWriter {
  public:
    explicit TarWriter(std::function<void(std::string_view)> put) : put_(std::move(put)) {}
    // `name`: with folders, of at most 100 bytes. Throws Error for a longer one, or for more than 8 GiB.
    void add(const std::string& name, std::string_view content);
    // The archive's end; nothing may be added afterwards.
    void finish();

  private:
    void put(std::string_view bytes);
    std::function<void(std::string_view)> put_;
    std::size_t written_ = 0;
};

}  // namespace fastscene
