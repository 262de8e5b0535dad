// WebP as a container of bytes: four channels, without loss. Private to io/.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fastscene {

struct RgbaBytes {
    int width = 0, height = 0;
    std::vector<std::uint8_t> bytes;  // red green blue alpha, row by row
    std::size_t pixels() const { return bytes.size() / 4; }
};
std::string encode_webp_lossless(const RgbaBytes& picture);
RgbaBytes decode_webp_rgba(std::string_view bytes, const std::string& where);

}  // namespace fastscene
