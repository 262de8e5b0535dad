// PlayCanvas' SOG, version 2: a ZIP archive of meta.json and pictures in lossless WebP whose pixels are splats, row by
// row. Positions have 16 bits an axis, on a logarithmic scale; scales, colors and harmonics are indices into codebooks.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fastscene/base/json.h"
#include "fastscene/io/codebook.h"
#include "fastscene/io/packed.h"
#include "fastscene/io/splat_format.h"
#include "fastscene/io/webp_lossless.h"
#include "fastscene/io/zip.h"
#include "fastscene/math/morton.h"
#include "fastscene/scene/splat_edit.h"

namespace fastscene::splat_formats {
namespace {

constexpr std::size_t kMostPalette = 65536;      // sets of harmonics: their index has 16 bits
constexpr std::size_t kLeastPalette = 1024;      // a scene of fewer splats keeps every set
constexpr std::size_t kSplatsPerEntry = 4;       // in scenes between the two
constexpr std::size_t kPaletteColumns = 64;      // sets in a row of the picture that holds them
constexpr std::uint8_t kFirstRotationTag = 252;  // alpha of a rotation: this + the index of its largest component

float folded(float metres) { return std::copysign(std::log1p(std::fabs(metres)), metres); }
float unfolded(float v) { return std::copysign(std::expm1(std::fabs(v)), v); }

// A picture with room for so many splats, as square as can be.
RgbaBytes picture_for(std::size_t splats) {
    const int width = std::max(4, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(splats)) / 4)) * 4);
    const int height = (static_cast<int>((splats + static_cast<std::size_t>(width) - 1) /
                                         static_cast<std::size_t>(width)) +
                        3) /
                       4 * 4;
    return {width, height,
            std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 255)};
}

// Writes one pixel a splat.
template <class Pixel>
std::string picture_of_splats(std::size_t count, const Pixel& pixel) {
    RgbaBytes picture = picture_for(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::array<std::uint8_t, 4> p = pixel(i);
        std::copy(p.begin(), p.end(), picture.bytes.begin() + static_cast<std::ptrdiff_t>(4 * i));
    }
    return encode_webp_lossless(picture);
}

// Neighbours in space become neighbours in the pictures, which then take fewer bytes.
Splats in_morton_order(const Splats& splats) {
    Vec3f low = splats.mean_m[0], high = low;
    for (const Vec3f p : splats.mean_m)
        for (std::size_t a = 0; a < 3; ++a)
            low[a] = std::min(low[a], folded(p[a])), high[a] = std::max(high[a], folded(p[a]));
    std::vector<std::uint64_t> code;
    for (const Vec3f p : splats.mean_m) {
        std::array<std::uint32_t, 3> cell{};
        for (std::size_t a = 0; a < 3; ++a)
            cell[a] = unorm((folded(p[a]) - low[a]) / std::max(high[a] - low[a], 1e-6f), 21);
        code.push_back(morton_code(cell[0], cell[1], cell[2]));
    }
    std::vector<std::uint32_t> order(splats.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return code[a] < code[b]; });
    return chosen(splats, order);
}

using Files = std::vector<std::pair<std::string, std::string>>;

Json add_means(const Splats& s, Files& files) {
    Vec3f low, high;
    for (std::size_t a = 0; a < 3; ++a) {
        low[a] = high[a] = folded(s.mean_m[0][a]);
        for (const Vec3f p : s.mean_m)
            low[a] = std::min(low[a], folded(p[a])), high[a] = std::max(high[a], folded(p[a]));
    }
    const auto half = [&](std::size_t i, int shift) {
        std::array<std::uint8_t, 4> p{0, 0, 0, 255};
        for (std::size_t a = 0; a < 3; ++a) {
            const float wide = high[a] - low[a];
            const std::uint32_t v = wide > 0 ? unorm((folded(s.mean_m[i][a]) - low[a]) / wide, 16) : 0;
            p[a] = static_cast<std::uint8_t>(v >> shift & 255);
        }
        return p;
    };
    files.emplace_back("means_l.webp", picture_of_splats(s.size(), [&](std::size_t i) { return half(i, 0); }));
    files.emplace_back("means_u.webp", picture_of_splats(s.size(), [&](std::size_t i) { return half(i, 8); }));
    return {{"mins", {low.x, low.y, low.z}},
            {"maxs", {high.x, high.y, high.z}},
            {"files", {"means_l.webp", "means_u.webp"}}};
}

// Three numbers a splat as indices into one codebook; alpha as given.
template <class Alpha>
Json add_codes(const std::vector<Vec3f>& values, const std::string& file, Files& files, const Alpha& alpha) {
    std::vector<float> all;
    for (const Vec3f v : values) all.insert(all.end(), {v.x, v.y, v.z});
    const ScalarCodebook book = scalar_codebook(std::move(all));
    files.emplace_back(file, picture_of_splats(values.size(), [&](std::size_t i) {
                           const Vec3f v = values[i];
                           return std::array{nearest_in(book, v.x), nearest_in(book, v.y), nearest_in(book, v.z),
                                             static_cast<std::uint8_t>(alpha(i))};
                       }));
    return {{"codebook", book}, {"files", {file}}};
}

Json add_rotations(const Splats& s, Files& files) {
    files.emplace_back("quats.webp", picture_of_splats(s.size(), [&](std::size_t i) {
                           const std::array<float, 4> q = unit_quaternion(s.rotation[i]);  // w x y z
                           const std::size_t largest = largest_of(q);
                           const float sign = q[largest] < 0 ? -1.f : 1.f;
                           std::array<std::uint8_t, 4> p{};
                           for (std::size_t k = 0, at = 0; k < 4; ++k)
                               if (k != largest) p[at++] = byte_near((sign * q[k] * std::sqrt(0.5f) + 0.5f) * 255.f);
                           p[3] = static_cast<std::uint8_t>(kFirstRotationTag + largest);
                           return p;
                       }));
    return {{"files", {"quats.webp"}}};
}

// Sets of harmonics as indices into a palette, whose numbers are indices into a codebook in turn.
Json add_harmonics(const Splats& s, Files& files) {
    const auto functions = static_cast<std::size_t>(s.rest_coefficients());
    const VectorCodebook palette = vector_codebook(s.sh_rest, 3 * functions,
                                                   std::clamp(s.size() / kSplatsPerEntry, kLeastPalette, kMostPalette));
    const ScalarCodebook book = scalar_codebook(palette.centroids);
    const std::size_t rows = (palette.size() + kPaletteColumns - 1) / kPaletteColumns;
    RgbaBytes picture{static_cast<int>(kPaletteColumns * functions), static_cast<int>(rows), {}};
    picture.bytes.assign(kPaletteColumns * functions * rows * 4, 255);
    for (std::size_t e = 0; e < palette.size(); ++e)
        for (std::size_t k = 0; k < functions; ++k)
            for (std::size_t c = 0; c < 3; ++c)
                picture.bytes[4 * (e * functions + k) + c] = nearest_in(book,
                                                                        palette.centroids[(e * 3 + c) * functions + k]);
    files.emplace_back("shN_centroids.webp", encode_webp_lossless(picture));
    files.emplace_back("shN_labels.webp", picture_of_splats(s.size(), [&](std::size_t i) {
                           const std::uint32_t label = palette.labels[i];
                           return std::array{static_cast<std::uint8_t>(label & 255),
                                             static_cast<std::uint8_t>(label >> 8), std::uint8_t{0}, std::uint8_t{255}};
                       }));
    return {{"count", palette.size()},
            {"bands", s.sh_degree},
            {"codebook", book},
            {"files", {"shN_centroids.webp", "shN_labels.webp"}}};
}

std::string write_sog(const Splats& splats, const SplatWriting&) {
    const Splats s = in_morton_order(splats);
    Files files(1);
    Json meta{{"version", 2}, {"asset", {{"generator", "fastscene"}}}, {"count", s.size()}};
    meta["antialias"] = s.filter.antialias;
    if (s.filter.low_pass_px2 != FootprintFilter{}.low_pass_px2) meta[kLowPassKey] = s.filter.low_pass_px2;
    meta["means"] = add_means(s, files);
    meta["scales"] = add_codes(s.log_scale, "scales.webp", files, [](std::size_t) { return 255; });
    meta["quats"] = add_rotations(s, files);
    meta["sh0"] = add_codes(s.sh0, "sh0.webp", files,
                            [&](std::size_t i) { return byte_near(sigmoid(s.opacity_logit[i]) * 255.f); });
    if (s.sh_degree > 0) meta["shN"] = add_harmonics(s, files);
    files.front() = {"meta.json", meta.dump()};
    return stored_zip(files);
}

// The archive of a file, and what its meta.json says.
class Bundle {
  public:
    explicit Bundle(const std::filesystem::path& file) : name_(file.string()), zip_(file) {
        try {
            meta_ = Json::parse(zip_.read("meta.json"));
            if (const int version = meta_.value("version", 1); version != 2)
                throw Error("{}: expected SOG version 2, found {}", name_, version);
            count_ = meta_.at("count").get<std::size_t>();
        } catch (const Json::exception& e) {
            throw Error("{}: meta.json: {}", name_, e.what());
        }
    }
    Splats splats() const {
        try {
            return read();
        } catch (const Json::exception& e) {
            throw Error("{}: meta.json: {}", name_, e.what());
        }
    }

  private:
    RgbaBytes picture(const Json& files, std::size_t index, std::size_t least_pixels) const {
        const auto file = files.at(index).get<std::string>();
        const std::string where = name_ + ": " + file;
        RgbaBytes picture = decode_webp_rgba(zip_.read(file), where);
        if (picture.pixels() < least_pixels)
            throw Error("{}: expected {} pixels, found {}", where, least_pixels, picture.pixels());
        return picture;
    }
    ScalarCodebook codebook(const Json& section) const {
        const auto values = section.at("codebook").get<std::vector<float>>();
        ScalarCodebook book{};
        if (values.empty() || values.size() > book.size())
            throw Error("{}: expected codebooks of 1 to 256 numbers, found {}", name_, values.size());
        std::copy(values.begin(), values.end(), book.begin());
        return book;
    }
    void read_means(Splats& s) const {
        const Json& means = meta_.at("means");
        const auto low = means.at("mins").get<std::array<float, 3>>(),
                   high = means.at("maxs").get<std::array<float, 3>>();
        const RgbaBytes lower = picture(means.at("files"), 0, count_), upper = picture(means.at("files"), 1, count_);
        for (std::size_t i = 0; i < count_; ++i)
            for (std::size_t a = 0; a < 3; ++a) {
                const int v = upper.bytes[4 * i + a] << 8 | lower.bytes[4 * i + a];
                s.mean_m[i][a] = unfolded(low[a] + (high[a] - low[a]) * static_cast<float>(v) / 65535.f);
            }
    }
    void read_scales_and_colors(Splats& s) const {
        const ScalarCodebook scale = codebook(meta_.at("scales")), color = codebook(meta_.at("sh0"));
        const RgbaBytes scales = picture(meta_.at("scales").at("files"), 0, count_),
                        colors = picture(meta_.at("sh0").at("files"), 0, count_);
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t a = 0; a < 3; ++a) {
                s.log_scale[i][a] = scale[scales.bytes[4 * i + a]];
                s.sh0[i][a] = color[colors.bytes[4 * i + a]];
            }
            s.opacity_logit[i] = logit_of(static_cast<float>(colors.bytes[4 * i + 3]) / 255.f);
        }
    }
    void read_rotations(Splats& s) const {
        const RgbaBytes quats = picture(meta_.at("quats").at("files"), 0, count_);
        for (std::size_t i = 0; i < count_; ++i) {
            const std::uint8_t* p = &quats.bytes[4 * i];
            if (p[3] < kFirstRotationTag)
                throw Error("{}: expected rotations with alpha 252 to 255, found {} in splat {}", name_, p[3], i);
            const auto largest = static_cast<std::size_t>(p[3] - kFirstRotationTag);
            std::array<float, 4> q{};
            float rest = 1;
            for (std::size_t k = 0, at = 0; k < 4; ++k) {
                if (k == largest) continue;
                q[k] = (static_cast<float>(p[at++]) / 255.f - 0.5f) * std::sqrt(2.f);
                rest -= q[k] * q[k];
            }
            q[largest] = std::sqrt(std::max(0.f, rest));
            s.rotation[i] = {q[0], q[1], q[2], q[3]};
        }
    }
    void read_harmonics(Splats& s) const {
        const Json& section = meta_.at("shN");
        const ScalarCodebook book = codebook(section);
        const auto entries = section.at("count").get<std::size_t>(),
                   functions = static_cast<std::size_t>(s.rest_coefficients());
        const std::size_t rows = (entries + kPaletteColumns - 1) / kPaletteColumns;
        if (entries == 0 || entries > kMostPalette)
            throw Error("{}: expected 1 to {} sets of harmonics, found {}", name_, kMostPalette, entries);
        const RgbaBytes palette = picture(section.at("files"), 0, rows * kPaletteColumns * functions),
                        labels = picture(section.at("files"), 1, count_);
        if (static_cast<std::size_t>(palette.width) != kPaletteColumns * functions)
            throw Error("{}: expected sets of harmonics in a picture {} wide, found {}", name_,
                        kPaletteColumns * functions, palette.width);
        for (std::size_t i = 0; i < count_; ++i) {
            const std::size_t e = labels.bytes[4 * i] | static_cast<std::size_t>(labels.bytes[4 * i + 1]) << 8;
            if (e >= entries)
                throw Error("{}: expected a set of harmonics below {}, found {} in splat {}", name_, entries, e, i);
            for (std::size_t k = 0; k < functions; ++k)
                for (std::size_t c = 0; c < 3; ++c)
                    s.sh_rest[(i * 3 + c) * functions + k] = book[palette.bytes[4 * (e * functions + k) + c]];
        }
    }
    Splats read() const {
        // A picture that is there vouches for the count, before memory is asked for.
        picture(meta_.at("quats").at("files"), 0, count_);
        Splats s;
        s.filter.antialias = meta_.value("antialias", false);
        if (const Json low_pass = meta_.value(kLowPassKey, Json()); low_pass.is_number())
            s.filter.low_pass_px2 = low_pass_px2_from(low_pass.get<double>());
        if (meta_.contains("shN")) s.sh_degree = meta_.at("shN").at("bands").get<int>();
        if (s.sh_degree < 0 || s.sh_degree > 3)
            throw Error("{}: expected harmonics of degree 0 to 3, found {}", name_, s.sh_degree);
        s.resize(count_);
        read_means(s);
        read_scales_and_colors(s);
        read_rotations(s);
        if (s.sh_degree > 0) read_harmonics(s);
        return s;
    }

    std::string name_;
    ZipFile zip_;
    Json meta_;
    std::size_t count_ = 0;
};

}  // namespace

SplatFormat sog() {
    return {
        .name = "sog",
        .ending = ".sog",
        .about = "PlayCanvas' SOG: a bundle of lossless WebP images, the smallest",
        .readers = "SuperSplat, PlayCanvas",
        .keeps_order = false,
        .empty = false,
        .precision = {.mean_m = 2e-4f,
                      .log_scale = 0.02f,
                      .rotation = 0.014f,
                      .opacity_logit = 0.05f,
                      .sh0 = 0.02f,
                      .sh_rest = 0.01f},
        .recognizes = [](std::string_view bytes) { return bytes.starts_with("PK\x03\x04"); },
        .read = [](const std::filesystem::path& file, std::string_view) -> ReadSplats { return Bundle(file).splats(); },
        .write = write_sog};
}

}  // namespace fastscene::splat_formats
