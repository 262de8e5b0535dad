// Radiance RGBE (Ward 1991): a text header, "-Y height +X width", then rows of four bytes per pixel: three mantissas
// with a shared exponent. Rows are uncompressed, run-length coded by pixel (old format) or by channel (new format,
// marked by 2, 2 and the width).
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "fastscene/io/formats.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

using Rgbe = std::array<std::uint8_t, 4>;

struct RadianceHeader {
    int width = 0, height = 0;
    std::size_t data = 0;  // offset of the rows
};

RadianceHeader radiance_header(const fs::path& path, std::string_view bytes) {
    std::size_t at = 0;
    const auto line = [&] {
        const std::size_t end = bytes.find('\n', at);
        if (end == std::string_view::npos)
            throw Error("{}: expected a Radiance header, found its end after {} bytes", path.string(), bytes.size());
        const std::string text(bytes.substr(at, end - at));
        at = end + 1;
        return text;
    };
    for (std::string text = line(); !text.empty(); text = line())
        if (text.starts_with("FORMAT=") && text.find("32-bit_rle_rgbe") == std::string::npos)
            throw Error("{}: expected FORMAT=32-bit_rle_rgbe, found {}", path.string(), text);
    RadianceHeader header;
    const std::string size = line();
    int read = 0;
    if (std::sscanf(size.c_str(), "-Y %d +X %d%n", &header.height, &header.width, &read) != 2)
        throw Error("{}: expected \"-Y height +X width\" (rows from the top, columns from the left), found \"{}\"",
                    path.string(), size.substr(0, 40));
    header.data = at;
    return header;
}

// Reads rows from a file's content.
class Rows {
  public:
    Rows(const fs::path& path, std::string_view bytes, std::size_t at) : path_(path), bytes_(bytes), at_(at) {}
    void read(std::vector<Rgbe>& row) {
        const std::size_t width = row.size();
        const bool by_channel = width >= 8 && width < 0x8000 && peek(0) == 2 && peek(1) == 2 &&
                                (peek(2) << 8 | peek(3)) == static_cast<int>(width);
        if (!by_channel) return read_pixels(row);
        at_ += 4;
        for (std::size_t channel = 0; channel < 4; ++channel)
            for (std::size_t x = 0; x < width;) {
                const std::uint8_t count = next();
                const std::size_t run = count > 128 ? count - 128u : count;
                if (run == 0 || run > width - x) refuse("a run beyond the end of its row");
                const std::uint8_t value = count > 128 ? next() : 0;
                for (std::size_t i = 0; i < run; ++i) row[x++][channel] = count > 128 ? value : next();
            }
    }

  private:
    // Old format: (1, 1, 1, n) repeats the previous pixel n times; directly following ones count multiples of 256.
    void read_pixels(std::vector<Rgbe>& row) {
        int shift = 0;
        for (std::size_t x = 0; x < row.size();) {
            const Rgbe pixel{next(), next(), next(), next()};
            if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1 || x == 0) {
                row[x++] = pixel;
                shift = 0;
                continue;
            }
            const std::size_t run = static_cast<std::size_t>(pixel[3]) << shift;
            if (run > row.size() - x || shift > 24) refuse("a run beyond the end of its row");
            for (std::size_t i = 0; i < run; ++i, ++x) row[x] = row[x - 1];
            shift += 8;
        }
    }
    int peek(std::size_t ahead) const {
        return at_ + ahead < bytes_.size() ? static_cast<unsigned char>(bytes_[at_ + ahead]) : -1;
    }
    std::uint8_t next() {
        if (at_ >= bytes_.size()) refuse("its end");
        return static_cast<std::uint8_t>(bytes_[at_++]);
    }
    [[noreturn]] void refuse(std::string_view found) const {
        throw Error("{}: expected a whole Radiance picture, found {} at byte {}", path_.string(), found, at_);
    }

    const fs::path& path_;
    std::string_view bytes_;
    std::size_t at_;
};

Vec3f light_of(Rgbe pixel) {
    if (pixel[3] == 0) return {};
    const float unit = std::ldexp(1.f, pixel[3] - 128 - 8);
    return {(static_cast<float>(pixel[0]) + 0.5f) * unit, (static_cast<float>(pixel[1]) + 0.5f) * unit,
            (static_cast<float>(pixel[2]) + 0.5f) * unit};
}

}  // namespace

PictureInfo radiance_info(const fs::path& path, std::string_view bytes) {
    const RadianceHeader header = radiance_header(path, bytes);
    return {header.width, header.height};
}

ImageColor decode_radiance(const fs::path& path, std::string_view bytes) {
    const RadianceHeader header = radiance_header(path, bytes);
    // A row takes at least 8 bytes, even compressed.
    if (!plausible_size(header.width, header.height) || static_cast<std::size_t>(header.height) * 8 > bytes.size())
        throw Error("{}: expected a size that the file can hold, found {} x {} in {} bytes", path.string(),
                    header.width, header.height, bytes.size());
    Rows rows(path, bytes, header.data);
    ImageColor image(header.width, header.height);
    std::vector<Rgbe> row(static_cast<std::size_t>(header.width));
    for (int y = 0; y < header.height; ++y) {
        rows.read(row);
        for (int x = 0; x < header.width; ++x) image.at(x, y) = light_of(row[static_cast<std::size_t>(x)]);
    }
    return image;
}

}  // namespace fastscene
