#include <bit>
#include <cstring>

#include "fastscene/base/file.h"
#include "fastscene/io/formats.h"

// Portable float map: "Pf", width, height, scale (negative: little endian), then rows from BOTTOM to top.
namespace fastscene {
namespace {

namespace fs = std::filesystem;

struct Header {
    int width = 0, height = 0;
    bool little = true;
    std::size_t data = 0;
};

Header parse(const fs::path& path, std::string_view bytes) {
    Header header;
    float scale = 0;
    int read = 0;
    const std::string head(bytes.substr(0, 128));
    if (head.substr(0, 2) != "Pf" || std::sscanf(head.c_str() + 2, "%d %d %f%n", &header.width, &header.height, &scale, &read) != 3)
        throw Error("{}: expected a gray float map (\"Pf\", width, height, scale), found \"{}\"", path.string(), head.substr(0, 2));
    header.little = scale < 0;
    header.data = 2 + static_cast<std::size_t>(read) + 1;
    return header;
}

float swapped(float v) { return std::bit_cast<float>(__builtin_bswap32(std::bit_cast<std::uint32_t>(v))); }

}  // namespace

PictureInfo pfm_info(const fs::path& path, std::string_view bytes) {
    const Header header = parse(path, bytes);
    return {header.width, header.height};
}

ImageF load_pfm(const fs::path& path) {
    const std::string bytes = read_file(path);
    const Header header = parse(path, bytes);
    if (!plausible_size(header.width, header.height))
        throw Error("{}: expected a picture of at most {} pixels a side, found {} x {}", path.string(), kMaxPictureSide, header.width, header.height);
    const std::size_t expected = header.data + std::size_t{4} * static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
    if (bytes.size() < expected) throw Error("{}: expected {} bytes for {} x {} floats, found {}", path.string(), expected, header.width, header.height, bytes.size());
    ImageF image(header.width, header.height);
    for (int y = 0; y < image.height; ++y)
        std::memcpy(image.row(image.height - 1 - y), bytes.data() + header.data + std::size_t{4} * static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width),
                    std::size_t{4} * static_cast<std::size_t>(image.width));
    if (!header.little)
        for (float& v : image.pixels) v = swapped(v);
    return image;
}

void save_pfm(const fs::path& path, const ImageF& image) {
    std::string bytes = fmt::format("Pf\n{} {}\n-1.0\n", image.width, image.height);
    for (int y = image.height - 1; y >= 0; --y)
        bytes.append(reinterpret_cast<const char*>(image.row(y)), std::size_t{4} * static_cast<std::size_t>(image.width));
    write_file(path, bytes);
}

}  // namespace fastscene
