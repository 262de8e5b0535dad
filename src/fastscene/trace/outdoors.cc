#include "fastscene/trace/outdoors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/trace/light_bytes.h"
#include "fastscene/trace/noise.h"
#include "fastscene/trace/outdoors_site.h"
#include "fastscene/trace/outdoors_tracer.h"

namespace fastscene {
namespace {

constexpr EquirectSize kTable{512, 256};
constexpr float kTop = 0.96f;           // radians: height up to which the band reaches, and depth
constexpr float kStretch = 0.3f;        // radians: rows lie 1.4 times as far apart at this height as at the horizon
constexpr float kSteepest = 1.36f;      // radians from a window's normal: its reveal hides the rest
constexpr int kFewest = 6, kMost = 24;  // samples per pixel of the band
constexpr float kError = 0.06f;         // standard error of a pixel's mean, relative to it, at which sampling stops

Vec3f outward_of(const Portal& p) { return -normalize(cross(p.edge_u, p.edge_v)); }

// Azimuths that a window shows, as offsets from its own: from every corner of the room through every corner of it.
Vec2f azimuths_shown(const Portal& p, Vec3f low, Vec3f high) {
    const Vec3f out = outward_of(p), side = normalize(Vec3f{out.z, 0, -out.x});
    Vec2f range{0, 0};
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3f from{corner & 1 ? low.x : high.x, corner & 2 ? low.y : high.y, corner & 4 ? low.z : high.z};
        for (int k = 0; k < 4; ++k) {
            const Vec3f to = p.corner + p.edge_u * static_cast<float>(k & 1) + p.edge_v * static_cast<float>(k >> 1);
            const Vec3f way = to - from;
            const float turn = std::atan2(dot(way, side), std::max(0.f, dot(way, out)));
            range = {std::min(range.x, turn), std::max(range.y, turn)};
        }
    }
    return {std::max(range.x, -kSteepest), std::min(range.y, kSteepest)};
}

std::vector<bool> columns_shown(const std::vector<Portal>& portals, Vec3f low, Vec3f high, int width) {
    std::vector<bool> shown(static_cast<std::size_t>(width), false);
    for (const Portal& p : portals) {
        const Vec3f out = outward_of(p);
        if (std::hypot(out.x, out.z) < 0.5f) continue;  // a skylight shows the sky
        const float middle = std::atan2(out.x, out.z);
        const Vec2f range = azimuths_shown(p, low, high);
        const float per_radian = static_cast<float>(width) / (2 * kPi);
        const int first = floor_int((middle + range.x + kPi) * per_radian) - 1,
                  last = floor_int((middle + range.y + kPi) * per_radian) + 1;
        for (int x = first; x <= last; ++x) shown[static_cast<std::size_t>(wrap_column(x, width))] = true;
    }
    return shown;
}

// The mean over a pixel, sampled until its standard error is below kError. What is left of the noise is part of the
// scene: every picture shows the same. `towards`: direction at a position within the pixel, in [0, 1)^2.
template <class Towards>
Vec3f pixel_mean(const outdoors::Tracer& tracer, std::uint64_t key, float width, int fewest, int most,
                 const Towards& towards) {
    Random random(key);
    const Vec2f shift{random.uniform(), random.uniform()};
    Vec3f sum{};
    float mean = 0, squares = 0;  // of the luminance; squares: summed squared deviations (Welford 1962)
    int count = 0;
    for (bool certain = false; count < most && !certain;) {
        const auto k = static_cast<float>(count);
        const Vec2f at{std::fmod(shift.x + 0.754877666f * k, 1.f), std::fmod(shift.y + 0.569840291f * k, 1.f)};
        const Vec3f radiance = tracer.sample(towards(at), width, random).radiance;
        sum += radiance;
        const auto n = static_cast<float>(++count);
        const float bright = luminance(radiance), off = bright - mean;
        mean += off / n;
        squares += off * (bright - mean);
        const float allowed = kError * mean;
        certain = count >= fewest && squares <= allowed * allowed * n * (n - 1);
    }
    return sum / static_cast<float>(count);
}

Vec3f picture_at(const ImageColor& picture, Vec3f direction) {
    const Vec2f p = pixel_of_direction(direction, {picture.width, picture.height}) - Vec2f{0.5f, 0.5f};
    const int x = floor_int(p.x), y = std::clamp(floor_int(p.y), 0, picture.height - 2);
    const float a = p.x - static_cast<float>(x), b = unit_clamp(p.y - static_cast<float>(y));
    const int left = wrap_column(x, picture.width), right = wrap_column(x + 1, picture.width);
    return lerp(lerp(picture.at(left, y), picture.at(right, y), a),
                lerp(picture.at(left, y + 1), picture.at(right, y + 1), a), b);
}

// The mean of a photographed outside over a pixel.
template <class Towards>
Vec3f picture_mean(const ImageColor& picture, const Towards& towards) {
    constexpr int kSide = 4;
    Vec3f sum{};
    for (int k = 0; k < kSide * kSide; ++k)
        sum += picture_at(
            picture,
            towards(Vec2f{static_cast<float>(k % kSide) + 0.5f, static_cast<float>(k / kSide) + 0.5f} * (1.f / kSide)));
    return sum / static_cast<float>(kSide * kSide);
}

}  // namespace

float main_outlook(const std::vector<Portal>& portals) {
    float azimuth = 0, largest = 0;
    for (const Portal& p : portals) {
        const Vec3f out = outward_of(p);
        const float area = length(cross(p.edge_u, p.edge_v)) * std::hypot(out.x, out.z);
        if (area > largest) largest = area, azimuth = std::atan2(out.x, out.z);
    }
    return azimuth;
}

Vec2f Outdoors::Band::position(Vec3f d) const {
    const float azimuth = std::atan2(d.x, d.z), rise = std::atan2(-d.y, std::hypot(d.x, d.z));
    const float row = std::asinh(rise / stretch) / std::asinh(top / stretch);
    return {(azimuth / (2 * kPi) + 0.5f) * static_cast<float>(width), (0.5f - 0.5f * row) * static_cast<float>(height)};
}

Vec3f Outdoors::Band::direction(Vec2f p) const {
    const float azimuth = (p.x / static_cast<float>(width) - 0.5f) * 2 * kPi,
                row = 1 - 2 * p.y / static_cast<float>(height);
    const float rise = stretch * std::sinh(row * std::asinh(top / stretch));
    return {std::cos(rise) * std::sin(azimuth), -std::sin(rise), std::cos(rise) * std::cos(azimuth)};
}

bool Outdoors::Band::covers(Vec2f p) const {
    if (width == 0 || !(p.y >= 0.5f && p.y < static_cast<float>(height) - 0.5f)) return false;
    const int x = floor_int(p.x - 0.5f);
    return column[static_cast<std::size_t>(wrap_column(x, width))] >= 0 &&
           column[static_cast<std::size_t>(wrap_column(x + 1, width))] >= 0;
}

Vec3f Outdoors::Band::at(Vec2f p) const {
    const float u = p.x - 0.5f, v = p.y - 0.5f;
    const int x = floor_int(u), y = std::clamp(floor_int(v), 0, height - 2);
    const float a = u - static_cast<float>(x), b = unit_clamp(v - static_cast<float>(y));
    const int left = column[static_cast<std::size_t>(wrap_column(x, width))],
              right = column[static_cast<std::size_t>(wrap_column(x + 1, width))];
    return lerp(lerp(pixels.at(left, y), pixels.at(right, y), a),
                lerp(pixels.at(left, y + 1), pixels.at(right, y + 1), a), b);
}

Outdoors::Outdoors(const Sky& sky, const std::vector<Portal>& portals, Vec3f room_low, Vec3f room_high,
                   float pixels_per_degree)
    : Outdoors(sky) {
    pixels_per_degree_ = pixels_per_degree;
    if (portals.empty()) return;
    std::optional<outdoors::Tracer> tracer;
    if (!sky.picture) tracer.emplace(sky, outdoors::make_world(sky, main_outlook(portals)));
    const auto mean = [&](std::uint64_t key, float width, int fewest, int most, const auto& towards) {
        return tracer ? pixel_mean(*tracer, key, width, fewest, most, towards) : picture_mean(*sky.picture, towards);
    };
    const float per_radian = pixels_per_degree * 180 / kPi;
    if (pixels_per_degree > 0) {
        band_.stretch = kStretch, band_.top = kTop;
        band_.width = static_cast<int>(std::lround(2 * kPi * per_radian));
        band_.height = static_cast<int>(
            std::lround(2 * per_radian * band_.stretch * std::asinh(band_.top / band_.stretch)));
        band_.column.assign(static_cast<std::size_t>(band_.width), -1);
        std::vector<int> shown;
        const std::vector<bool> mask = columns_shown(portals, room_low, room_high, band_.width);
        for (int x = 0; x < band_.width; ++x)
            if (mask[static_cast<std::size_t>(x)]) {
                band_.column[static_cast<std::size_t>(x)] = static_cast<int>(shown.size());
                shown.push_back(x);
            }
        band_.pixels = ImageColor(static_cast<int>(shown.size()), band_.height);
        parallel_for(band_.height, 2, [&](std::int64_t begin, std::int64_t end) {
            for (auto y = static_cast<int>(begin); y < end; ++y)
                for (std::size_t k = 0; k < shown.size(); ++k) {
                    const Vec2f corner{static_cast<float>(shown[k]), static_cast<float>(y)};
                    const std::uint64_t key = mix64(sky.seed) ^ (static_cast<std::uint64_t>(y) << 32 |
                                                                 static_cast<std::uint64_t>(shown[k]));
                    band_.pixels.at(static_cast<int>(k), y) = mean(
                        key, 1 / per_radian, kFewest, kMost, [&](Vec2f at) { return band_.direction(corner + at); });
                }
        });
    }
    ImageColor table(kTable.width, kTable.height);
    parallel_for(kTable.height, 4, [&](std::int64_t begin, std::int64_t end) {
        for (auto y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < kTable.width; ++x) {
                const Vec2f corner{static_cast<float>(x), static_cast<float>(y)};
                constexpr int kSide = 4;
                Vec3f sum{};
                bool covered = true;
                for (int k = 0; k < kSide * kSide && covered; ++k) {
                    const Vec2f at{(static_cast<float>(k % kSide) + 0.5f) / kSide,
                                   (static_cast<float>(k / kSide) + 0.5f) / kSide};
                    const Vec2f p = band_.position(direction_at(corner + at, kTable));
                    covered = band_.covers(p);
                    if (covered) sum += band_.at(p) * (1.f / (kSide * kSide));
                }
                const std::uint64_t key = mix64(sky.seed + 1) ^
                                          (static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x));
                table.at(x, y) = covered ? sum : mean(key, 2 * kPi / kTable.width, 2, 2, [&](Vec2f at) {
                    return direction_at(corner + at, kTable);
                });
            }
    });
    table_ = std::move(table);
    const std::string exact = bytes();
    ByteReader in("outside", exact);
    *this = from_bytes(in, sky);  // rounded as in the file
}

std::string Outdoors::bytes() const {
    float brightest = 0;
    for (const ImageColor* image : {&band_.pixels, &table_})
        for (const Vec3f pixel : image->pixels) brightest = std::max({brightest, pixel.x, pixel.y, pixel.z});
    const float scale = scale_ > 0 ? scale_ : scale_for_halves(brightest);
    std::string out;
    append(out, pixels_per_degree_), append(out, scale), append(out, band_.stretch), append(out, band_.top);
    append(out, static_cast<std::uint64_t>(band_.column.size()));
    for (const int column : band_.column) append(out, column);
    for (const ImageColor* image : {&band_.pixels, &table_}) {
        append(out, image->width);
        append(out, static_cast<std::uint64_t>(image->size()));
        for (const Vec3f pixel : image->pixels) append_halves(out, pixel, scale);
    }
    return out;
}

Outdoors Outdoors::from_bytes(ByteReader& in, const Sky& sky) {
    const auto expect = [&](bool holds) {
        if (!holds) in.refuse("expected the view through a room's windows, found something else");
    };
    Outdoors out(sky);
    Band& band = out.band_;
    out.pixels_per_degree_ = in.get<float>(), out.scale_ = in.get<float>();
    band.stretch = in.get<float>(), band.top = in.get<float>();
    expect(out.scale_ > 0);
    band.column.resize(in.count(sizeof(int)));
    band.width = static_cast<int>(band.column.size());
    int shown = 0;
    for (int& column : band.column) {
        column = in.get<int>();
        expect(column == -1 || column == shown);
        shown += column >= 0;
    }
    const auto image = [&] {
        const int width = in.get<int>();
        const std::size_t pixels = in.count(kHalvesBytes);
        expect(pixels == 0 ? width >= 0 : width > 0 && pixels % static_cast<std::size_t>(width) == 0);
        ImageColor read(width, width > 0 ? static_cast<int>(pixels / static_cast<std::size_t>(width)) : 0);
        for (Vec3f& pixel : read.pixels) pixel = halves_from(in, out.scale_);
        return read;
    };
    band.pixels = image();
    band.height = band.pixels.height;
    expect(band.pixels.width == shown);
    out.table_ = image();
    expect(out.table_.empty() ? shown == 0 : out.table_.width == kTable.width && out.table_.height == kTable.height);
    return out;
}

Vec3f Outdoors::bare(Vec3f direction) const { return direction.y > 0 ? ground_ : dome_.at(direction); }

Vec3f Outdoors::light(Vec3f direction) const {
    if (table_.pixels.empty()) return bare(direction);
    const Vec2f p = pixel_of_direction(direction, kTable);
    return table_.at(std::clamp(static_cast<int>(p.x), 0, kTable.width - 1),
                     std::clamp(static_cast<int>(p.y), 0, kTable.height - 1));
}

float Outdoors::brightness() const {
    constexpr int kAzimuths = 360;
    constexpr float kLow_deg = -20, kHigh_deg = 8, kStep_deg = 2, kLeast = 1e-5f;
    double sum = 0, count = 0;
    for (int a = 0; a < kAzimuths; ++a)
        for (float h = kLow_deg; h <= kHigh_deg; h += kStep_deg) {
            const float azimuth = 2 * kPi * static_cast<float>(a) / kAzimuths, height = h * kPi / 180;
            const Vec3f direction{std::sin(azimuth) * std::cos(height), -std::sin(height),
                                  std::cos(azimuth) * std::cos(height)};
            if (!band_.covers(band_.position(direction))) continue;
            sum += std::log2(std::max(kLeast, luminance(seen(direction))));
            ++count;
        }
    return count > 0 ? static_cast<float>(std::exp2(sum / count)) : luminance(ground_);
}

Vec3f Outdoors::seen(Vec3f direction) const {
    if (table_.pixels.empty()) return bare(direction);
    if (band_.width > 0)
        if (const Vec2f p = band_.position(direction); band_.covers(p)) return band_.at(p);
    if (!pictured_ && -direction.y > std::sin(kTop)) return dome_.at(direction);
    const Vec2f p = pixel_of_direction(direction, kTable) - Vec2f{0.5f, 0.5f};
    const int x = floor_int(p.x), y = std::clamp(floor_int(p.y), 0, kTable.height - 2);
    const float a = p.x - static_cast<float>(x), b = unit_clamp(p.y - static_cast<float>(y));
    const int left = wrap_column(x, kTable.width), right = wrap_column(x + 1, kTable.width);
    return lerp(lerp(table_.at(left, y), table_.at(right, y), a),
                lerp(table_.at(left, y + 1), table_.at(right, y + 1), a), b);
}

}  // namespace fastscene
