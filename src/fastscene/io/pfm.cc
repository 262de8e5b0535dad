#include <bit>
#include <cstring>
#include <string>
#include <vector>

#include "fastscene/base/file.h"
#include "fastscene/io/formats.h"

// Portable float map: "Pf", width, height, scale (negative: little endian), then rows from bottom to top.
namespace fastscene {
namespace {

namespace fs = std::filesystem;

struct PfmHeader {
    int width = 0, height = 0;
    bool little = true, color = false;
    std::size_t data = 0;
};

PfmHeader pfm_header(const fs::path& path, std::string_view bytes) {
    PfmHeader header;
    float scale = 0;
    int read = 0;
    const std::string head(bytes.substr(0, 128));
    header.color = head.substr(0, 2) == "PF";
    if ((head.substr(0, 2) != "Pf" && !header.color) ||
        std::sscanf(head.c_str() + 2, "%d %d %f%n", &header.width, &header.height, &scale, &read) != 3)
        throw Error("{}: expected a float map (\"Pf\" or \"PF\", width, height, scale), found \"{}\"", path.string(),
                    head.substr(0, 2));
    header.little = scale < 0;
    header.data = 2 + static_cast<std::size_t>(read) + 1;
    return header;
}

float swapped(float v) { return std::bit_cast<float>(__builtin_bswap32(std::bit_cast<std::uint32_t>(v))); }

}  // namespace

PictureInfo pfm_info(const fs::path& path, std::string_view bytes) {
    const PfmHeader header = pfm_header(path, bytes);
    return {header.width, header.height};
}

namespace {

std::size_t row_bytes(const PfmHeader& header, std::size_t channels) {
    return sizeof(float) * channels * static_cast<std::size_t>(header.width);
}

// Before memory is allocated.
void check_length(const fs::path& path, std::string_view bytes, const PfmHeader& header, std::size_t channels) {
    const std::size_t expected = header.data + row_bytes(header, channels) * static_cast<std::size_t>(header.height);
    if (bytes.size() < expected)
        throw Error("{}: expected {} bytes for {} x {} floats, found {}", path.string(), expected, header.width,
                    header.height, bytes.size());
}

// `channels` floats per pixel, bottom row first.
void read_rows(std::string_view bytes, const PfmHeader& header, std::size_t channels, float* pixels) {
    const std::size_t row = row_bytes(header, channels), rows = static_cast<std::size_t>(header.height);
    for (std::size_t y = 0; y < rows; ++y)
        std::memcpy(pixels + (rows - 1 - y) * row / sizeof(float), bytes.data() + header.data + y * row, row);
    if (header.little) return;
    for (std::size_t i = 0; i < rows * row / sizeof(float); ++i) pixels[i] = swapped(pixels[i]);
}

PfmHeader checked_header(const fs::path& path, std::string_view bytes) {
    const PfmHeader header = pfm_header(path, bytes);
    if (!plausible_size(header.width, header.height))
        throw Error("{}: expected a picture of at most {} pixels a side, found {} x {}", path.string(), kMaxPictureSide,
                    header.width, header.height);
    return header;
}

}  // namespace

ImageF decode_pfm(const fs::path& path, std::string_view bytes) {
    const PfmHeader header = checked_header(path, bytes);
    if (header.color) throw Error("{}: expected a gray float map (\"Pf\"), found color (\"PF\")", path.string());
    check_length(path, bytes, header, 1);
    ImageF image(header.width, header.height);
    read_rows(bytes, header, 1, image.pixels.data());
    return image;
}

ImageColor decode_pfm_color(const fs::path& path, std::string_view bytes) {
    const PfmHeader header = checked_header(path, bytes);
    check_length(path, bytes, header, header.color ? 3 : 1);
    ImageColor image(header.width, header.height);
    if (header.color) {
        read_rows(bytes, header, 3, &image.pixels.data()->x);
        return image;
    }
    std::vector<float> gray(image.size());
    read_rows(bytes, header, 1, gray.data());
    for (std::size_t i = 0; i < gray.size(); ++i) image.pixels[i] = {gray[i], gray[i], gray[i]};
    return image;
}

void save_pfm(const fs::path& path, const ImageF& image) {
    std::string bytes = fmt::format("Pf\n{} {}\n-1.0\n", image.width, image.height);
    for (int y = image.height - 1; y >= 0; --y)
        bytes.append(reinterpret_cast<const char*>(image.row(y)),
                     std::size_t{4} * static_cast<std::size_t>(image.width));
    write_file(path, bytes);
}

}  // namespace fastscene
