#include "fastscene/io/exif.h"

#include <cstddef>
#include <cstdint>

namespace fastscene {
namespace {

// A number of 1 to 4 bytes at an offset; 0 beyond the end.
std::uint32_t integer_at(std::string_view bytes, std::size_t at, std::size_t size, bool little) {
    if (at > bytes.size() || bytes.size() - at < size) return 0;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[at + (little ? size - 1 - i : i)]);
    return value;
}

// A TIFF header, then a directory of entries: tag, type, count, value.
int orientation_of_tiff(std::string_view tiff) {
    const bool little = tiff.substr(0, 4) == std::string_view("II\x2a\0", 4);
    if (!little && tiff.substr(0, 4) != std::string_view("MM\0\x2a", 4)) return 1;
    const std::size_t directory = integer_at(tiff, 4, 4, little);
    const std::size_t entries = integer_at(tiff, directory, 2, little);
    constexpr std::uint32_t kOrientation = 0x0112, kShort = 3;
    for (std::size_t i = 0; i < entries && directory + 2 + 12 * (i + 1) <= tiff.size(); ++i) {
        const std::size_t entry = directory + 2 + 12 * i;
        if (integer_at(tiff, entry, 2, little) != kOrientation || integer_at(tiff, entry + 2, 2, little) != kShort)
            continue;
        const std::uint32_t value = integer_at(tiff, entry + 8, 2, little);
        return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
    }
    return 1;
}

int orientation_of_jpeg(std::string_view file) {
    for (std::size_t at = 2; at + 4 <= file.size() && static_cast<unsigned char>(file[at]) == 0xff;) {
        const std::uint32_t marker = integer_at(file, at + 1, 1, false), length = integer_at(file, at + 2, 2, false);
        if (marker == 0xda || length < 2) return 1;  // start of the image data
        constexpr std::string_view kExif("Exif\0\0", 6);
        if (marker == 0xe1 && file.substr(at + 4, kExif.size()) == kExif && length >= 2 + kExif.size())
            return orientation_of_tiff(file.substr(at + 4 + kExif.size(), length - 2 - kExif.size()));
        at += 2 + length;
    }
    return 1;
}

int orientation_of_png(std::string_view file) {
    for (std::size_t at = 8; at + 12 <= file.size();) {  // length, name, data, checksum
        const std::size_t length = integer_at(file, at, 4, false);
        if (file.substr(at + 4, 4) == "eXIf") return orientation_of_tiff(file.substr(at + 8, length));
        if (length > file.size() - at - 12) return 1;
        at += 12 + length;
    }
    return 1;
}

// RIFF chunks: name, length, data, padded to an even length. Some writers prefix the block with JPEG's marker name.
int orientation_of_webp(std::string_view file) {
    for (std::size_t at = 12; at + 8 <= file.size();) {
        const std::size_t length = integer_at(file, at + 4, 4, true);
        if (file.substr(at, 4) == "EXIF") {
            const std::string_view block = file.substr(at + 8, length);
            constexpr std::string_view kExif("Exif\0\0", 6);
            return orientation_of_tiff(block.starts_with(kExif) ? block.substr(kExif.size()) : block);
        }
        at += 8 + length + length % 2;
    }
    return 1;
}

}  // namespace

int exif_orientation(std::string_view file) {
    if (file.substr(0, 2) == "\xff\xd8") return orientation_of_jpeg(file);
    if (file.substr(0, 4) == "\x89PNG") return orientation_of_png(file);
    if (file.substr(0, 4) == "RIFF") return orientation_of_webp(file);
    return 1;
}

}  // namespace fastscene
