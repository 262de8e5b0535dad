#include "fastscene/geometry/resample.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/resample_source.h"

namespace fastscene {
namespace {

constexpr int kMostSamples =
    // maximum samples per side, for a pixel that is longer in columns than in rows; next to a pole it may span all of
    // them
    64;
constexpr int kCubicSamples = 8;
constexpr std::size_t kTapsAtOnce =
    1 << 20;  // maximum taps of a pixel before merging duplicates; enough for half a picture
constexpr float kUnit = 65536.f;
// Near the poles and in rotated pictures, the source is read along columns, which hardware prefetchers do not predict.
constexpr std::size_t kPrefetchAhead = 96;
constexpr int kGrain = 8;  // rows per task

}  // namespace

SpherePicture equirect_picture(EquirectSize size, const Mat3f& world_from_picture) {
    return {SpherePicture::Kind::equirect, size.width, size.height, {}, world_from_picture};
}
SpherePicture cube_picture(int face_size, float fov_deg, const Mat3f& world_from_picture) {
    return {SpherePicture::Kind::cube, face_size, 6 * face_size, Pinhole::with_fov(face_size, face_size, fov_deg),
            world_from_picture};
}
SpherePicture perspective_picture(const Pinhole& camera, const Mat3f& world_from_camera) {
    return {SpherePicture::Kind::perspective, camera.width, camera.height, camera, world_from_camera};
}

// Rows planned by one task; tasks' results are concatenated in order.
struct ResamplePlan::Build {
    const SpherePicture& source;
    const SpherePicture& target;
    Filter filter;
    float feather_deg;
    std::vector<std::vector<Tap>> rows;  // rows with arbitrary taps, in pixel order

    struct Samples {
        int nx, ny;
    };
    // Samples per side such that they are no farther apart than the source's pixels.
    Samples samples_at(int x, int y, Vec3f here) const {
        if (filter == Filter::point) return {1, 1};
        const Vec2f angle = pixel_angles(target, here);
        const float pitch = pitch_at(source, here);
        // A lens shows some directions with extreme density and would need any number of samples; a sphere does not.
        const int most_of_all = source.kind == SpherePicture::Kind::perspective
                                    ? kMostSamples
                                    : std::max(kMostSamples, 2 * std::max(source.width, source.height));
        const auto count = [&](float ratio) {
            // Area filtering needs several samples per pixel, an integer number for integer ratios.
            const float wanted = filter == Filter::area && ratio > 1.05f
                                     ? std::ceil(ratio - 0.05f) * (ratio < 4 ? 4.f : 2.f)
                                     : ratio;
            return static_cast<int>(std::clamp(std::ceil(wanted - 0.05f), 1.f, static_cast<float>(most_of_all)));
        };
        Samples n{count(angle.x / pitch), count(angle.y / pitch)};
        if (source.kind != SpherePicture::Kind::equirect) return n;
        // Towards the poles a panorama's columns are closer than its rows. One bilinear sample covers two of them.
        const bool whole = filter == Filter::area;
        if (!whole && crowding(source, here) * std::max(angle.x, angle.y) <= 2 * pitch) return n;
        const int most = std::max(kMostSamples, 2 * std::max(n.nx, n.ny));
        const Vec2f extent = columns_across(source, target, {static_cast<float>(x), static_cast<float>(y)});
        const auto enough = [&](int samples, float columns) {
            if (whole || columns > 2) samples = std::clamp(count(columns), samples, most);
            const int each = whole ? std::clamp(static_cast<int>(std::ceil(columns - 0.05f)), 1, samples) : 1;
            return (samples + each - 1) / each * each;
        };
        Samples more{enough(n.nx, extent.x), enough(n.ny, extent.y)};
        // Columns that cross a pixel diagonally are covered by samples in both directions.
        const float needed = 2 * std::max(extent.x, extent.y) * static_cast<float>(std::max(n.nx, n.ny));
        const float thinned = std::sqrt(needed / (static_cast<float>(more.nx) * static_cast<float>(more.ny)));
        if (whole || thinned >= 1) return more;
        return {std::max(n.nx, static_cast<int>(std::ceil(thinned * static_cast<float>(more.nx)))),
                std::max(n.ny, static_cast<int>(std::ceil(thinned * static_cast<float>(more.ny))))};
    }

    Quad plan_pixel(int x, int y) {
        const Vec3f here = direction_in(target, {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        const Samples n = samples_at(x, y, here);
        const bool one = n.nx == 1 && n.ny == 1;
        // With many samples per pixel, the filter of each no longer matters.
        const int side = filter == Filter::bicubic && n.nx * n.ny <= kCubicSamples ? 4
                         : filter == Filter::area && !one                          ? 1
                                                                                   : 2;
        std::array<SourcePlace, 6> places;
        if (one) {
            const int count = places_of(source, here, feather_deg, places);
            if (count == 1 && is_inside(source, places[0], side)) return quad_of(places[0], side);
        }
        std::vector<SourceTap> taps;
        std::size_t full = kTapsAtOnce;
        const float share = 1.f / (static_cast<float>(n.nx) * static_cast<float>(n.ny));
        for (int j = 0; j < n.ny; ++j)
            for (int i = 0; i < n.nx; ++i) {
                const Vec2f at{static_cast<float>(x) + (static_cast<float>(i) + 0.5f) / static_cast<float>(n.nx),
                               static_cast<float>(y) + (static_cast<float>(j) + 0.5f) / static_cast<float>(n.ny)};
                const int count = places_of(source, direction_in(target, at), feather_deg, places);
                for (int k = 0; k < count; ++k) {
                    SourcePlace place = places[static_cast<std::size_t>(k)];
                    place.weight *= share;
                    add_taps(source, place, side, taps);
                }
                if (taps.size() > full) {
                    merge(taps);
                    full = kTapsAtOnce + 2 * taps.size();
                }
            }
        merge(taps);
        rows.push_back(shares_of(taps));
        return {-static_cast<std::int32_t>(rows.size()), 0, 0};
    }

    Quad quad_of(const SourcePlace& place, int side) const {
        const int part_height = source.kind == SpherePicture::Kind::cube ? source.width : source.height;
        // Rounding may reach the next pixel; the neighbourhood must stay in the part even then.
        const auto fixed = [side](float v, int pixels) {
            const std::int64_t first = side / 2 - 1, end = static_cast<std::int64_t>(pixels) - side / 2;
            return std::clamp<std::int64_t>(std::lround((v - 0.5f) * kUnit), first * 65536, end * 65536 - 1);
        };
        const std::int64_t fx = fixed(place.pixel.x, source.width), fy = fixed(place.pixel.y, part_height);
        const auto x = static_cast<std::int32_t>(fx >> 16), y = static_cast<std::int32_t>(fy >> 16);
        return {(place.part * part_height + y) * source.width + x, static_cast<std::uint16_t>(fx & 0xffff),
                static_cast<std::uint16_t>(fy & 0xffff)};
    }

    // Merges duplicate taps.
    static void merge(std::vector<SourceTap>& taps) {
        std::stable_sort(taps.begin(), taps.end(),
                         [](const SourceTap& a, const SourceTap& b) { return a.pixel < b.pixel; });
        std::size_t count = 0;
        for (const SourceTap& tap : taps) {
            if (count > 0 && taps[count - 1].pixel == tap.pixel) taps[count - 1].weight += tap.weight;
            else taps[count++] = tap;
        }
        taps.resize(count);
    }
    // Normalized to sum 1, even if part of the pixel is not visible.
    static std::vector<Tap> shares_of(const std::vector<SourceTap>& taps) {
        double sum = 0;
        for (const SourceTap& tap : taps) sum += static_cast<double>(tap.weight);
        std::vector<Tap> out;
        out.reserve(taps.size());
        for (const SourceTap& tap : taps)
            out.push_back({tap.pixel, static_cast<float>(static_cast<double>(tap.weight) / sum)});
        return out;
    }
};

ResamplePlan::ResamplePlan(const SpherePicture& source, const SpherePicture& target, Filter filter, float feather_deg)
    : source_width_(source.width),
      source_height_(source.height),
      width_(target.width),
      height_(target.height),
      cubic_(filter == Filter::bicubic),
      quads_(static_cast<std::size_t>(target.width) * static_cast<std::size_t>(target.height)) {
    FASTSCENE_CHECK(source.width >= 1 && source.height >= 1 && target.width >= 1 && target.height >= 1);
    for (const SpherePicture* p : {&source, &target}) {
        if (p->kind == SpherePicture::Kind::equirect) continue;
        FASTSCENE_CHECK(p->camera.fx > 0 && p->camera.fy > 0);  // a field of view below 180 degrees
        // Faces with a smaller field of view leave gaps between them.
        FASTSCENE_CHECK(p->kind != SpherePicture::Kind::cube ||
                        2 * p->camera.fx <= 1.0001f * static_cast<float>(p->camera.width));
    }
    FASTSCENE_CHECK(static_cast<std::int64_t>(source.width) * source.height < std::numeric_limits<std::int32_t>::max());
    const std::size_t pieces = (static_cast<std::size_t>(height_) + kGrain - 1) / kGrain;
    std::vector<Build> builds(pieces, Build{source, target, filter, feather_deg, {}});
    parallel_for(height_, kGrain, [&](std::int64_t begin, std::int64_t end) {
        Build& build = builds[static_cast<std::size_t>(begin) / kGrain];
        for (int y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < width_; ++x)
                quads_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)] =
                    build.plan_pixel(x, y);
    });
    begin_.push_back(0);
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        const auto before = static_cast<std::int32_t>(begin_.size() - 1);
        for (const std::vector<Tap>& row : builds[piece].rows) {
            taps_.insert(taps_.end(), row.begin(), row.end());
            begin_.push_back(static_cast<std::uint32_t>(taps_.size()));
        }
        const std::size_t from = piece * kGrain * static_cast<std::size_t>(width_);
        const std::size_t to = std::min(quads_.size(), from + kGrain * static_cast<std::size_t>(width_));
        for (std::size_t i = from; i < to; ++i)
            if (quads_[i].first < 0) quads_[i].first -= before;
    }
}

template <class T>
[[gnu::noinline]] T ResamplePlan::general(const Image<T>& source, const Quad& quad) const {
    const auto pixel = [&](std::int64_t i) -> const T& { return source.pixels[static_cast<std::size_t>(i)]; };
    T sum{};
    if (quad.first < 0) {
        const auto row = static_cast<std::size_t>(-1 - quad.first);
        for (std::uint32_t k = begin_[row]; k < begin_[row + 1]; ++k)
            sum = sum + pixel(taps_[k].pixel) * taps_[k].weight;
        return sum;
    }
    const float u = static_cast<float>(quad.u) / kUnit, v = static_cast<float>(quad.v) / kUnit;
    const std::int64_t w = source_width_, first = quad.first;
    if (!cubic_) {
        const T top = pixel(first) + (pixel(first + 1) - pixel(first)) * u,
                low = pixel(first + w) + (pixel(first + w + 1) - pixel(first + w)) * u;
        return top + (low - top) * v;
    }
    const auto wu = catmull_rom(u), wv = catmull_rom(v);
    for (int j = 0; j < 4; ++j) {
        const std::int64_t row = first + (j - 1) * w - 1;
        const T line = pixel(row) * wu[0] + pixel(row + 1) * wu[1] + pixel(row + 2) * wu[2] + pixel(row + 3) * wu[3];
        sum = sum + line * wv[static_cast<std::size_t>(j)];
    }
    return sum;
}

namespace {
// Two adjacent three-channel pixels plus two unused lanes; and such pairs for two targets.
using Lanes = float __attribute__((vector_size(32)));
using TwoLanes = float __attribute__((vector_size(64)));
constexpr std::int64_t kLanePixels = 3;                                      // pixels touched by a load of Lanes
constexpr std::size_t kAtOnce = 4;                                           // targets processed at once
using Wholes = std::uint32_t __attribute__((vector_size(2 * kAtOnce * 4)));  // `first`, and v << 16 | u, of each target

inline Lanes lanes_at(const Vec3f* p) {
    Lanes out;
    std::memcpy(&out, p, sizeof out);
    return out;
}
inline TwoLanes two(const Vec3f* a, const Vec3f* b) {
    return __builtin_shufflevector(lanes_at(a), lanes_at(b), 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}
// Blends rows, then the two pixels in them; the targets are in lanes 0-2 and 8-10.
inline TwoLanes blend(TwoLanes top, TwoLanes low, TwoLanes u, TwoLanes v) {
    const TwoLanes left = top + (low - top) * v;
    const TwoLanes right = __builtin_shufflevector(left, left, 3, 4, 5, 6, 7, 7, 7, 7, 11, 12, 13, 14, 15, 15, 15, 15);
    return left + (right - left) * u;
}
// Four targets: eight wide loads, four blends, two stores.
template <class Quad>
inline void blend_four(const Quad* quads, const Vec3f* pixels, std::int64_t row, Vec3f* out) {
    Wholes words;
    std::memcpy(&words, quads, sizeof words);
    const Lanes u = __builtin_convertvector(words & 0xffffu, Lanes) * (1.f / kUnit);
    const Lanes v = __builtin_convertvector(words >> 16, Lanes) * (1.f / kUnit);
    const Vec3f *const a = pixels + quads[0].first, *const b = pixels + quads[1].first;
    const Vec3f *const c = pixels + quads[2].first, *const d = pixels + quads[3].first;
    const TwoLanes ab = blend(two(a, b), two(a + row, b + row),
                              __builtin_shufflevector(u, u, 1, 1, 1, 1, 1, 1, 1, 1, 3, 3, 3, 3, 3, 3, 3, 3),
                              __builtin_shufflevector(v, v, 1, 1, 1, 1, 1, 1, 1, 1, 3, 3, 3, 3, 3, 3, 3, 3));
    const TwoLanes cd = blend(two(c, d), two(c + row, d + row),
                              __builtin_shufflevector(u, u, 5, 5, 5, 5, 5, 5, 5, 5, 7, 7, 7, 7, 7, 7, 7, 7),
                              __builtin_shufflevector(v, v, 5, 5, 5, 5, 5, 5, 5, 5, 7, 7, 7, 7, 7, 7, 7, 7));
    const Lanes first = __builtin_shufflevector(ab, cd, 0, 1, 2, 8, 9, 10, 16, 17);
    const auto last = __builtin_shufflevector(ab, cd, 18, 24, 25, 26);
    std::memcpy(static_cast<void*>(out), &first, sizeof first);
    std::memcpy(static_cast<void*>(&out[2].z), &last, sizeof last);
}
}  // namespace

void ResamplePlan::apply_to(const ImageColor& source, ImageColor& out) const {
    FASTSCENE_CHECK(source.width == source_width_ && source.height == source_height_ && out.width == width_ &&
                    out.height == height_);
    // Wide loads must not read past the picture.
    const std::int64_t wide = cubic_ ? 0
                                     : std::max<std::int64_t>(
                                           0, static_cast<std::int64_t>(source.size()) - source_width_ - kLanePixels);
    const auto plain = [wide](const Quad& quad) { return quad.first >= 0 && quad.first < wide; };
    parallel_for(height_, kGrain, [&](std::int64_t begin, std::int64_t end) {
        const std::size_t from = static_cast<std::size_t>(begin) * static_cast<std::size_t>(width_),
                          to = static_cast<std::size_t>(end) * static_cast<std::size_t>(width_);
        const Vec3f* const pixels = source.pixels.data();
        const std::int64_t row = source_width_;
        std::size_t i = from;
        for (; i + kAtOnce <= to; i += kAtOnce) {
            const Quad* const quads = &quads_[i];
            if (i + kPrefetchAhead < to) {
                const std::int64_t ahead = std::max(0, quads[kPrefetchAhead].first);
                __builtin_prefetch(pixels + ahead);
                __builtin_prefetch(pixels + ahead + row);
            }
            if (plain(quads[0]) && plain(quads[1]) && plain(quads[2]) && plain(quads[3])) [[likely]]
                blend_four(quads, pixels, row, &out.pixels[i]);
            else
                for (std::size_t k = 0; k < kAtOnce; ++k) out.pixels[i + k] = general(source, quads[k]);
        }
        for (; i < to; ++i) out.pixels[i] = general(source, quads_[i]);
    });
}

ImageColor ResamplePlan::apply(const ImageColor& source) const {
    ImageColor out(width_, height_);
    apply_to(source, out);
    return out;
}

ImageF ResamplePlan::apply(const ImageF& source) const {
    FASTSCENE_CHECK(source.width == source_width_ && source.height == source_height_);
    ImageF out(width_, height_);
    parallel_for(height_, kGrain, [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t i = static_cast<std::size_t>(begin) * static_cast<std::size_t>(width_);
             i < static_cast<std::size_t>(end) * static_cast<std::size_t>(width_); ++i) {
            const float value = general(source, quads_[i]);
            out.pixels[i] = std::isfinite(value) ? value : heaviest(source, quads_[i]);
        }
    });
    return out;
}

float ResamplePlan::heaviest(const ImageF& source, const Quad& quad) const {
    if (quad.first >= 0)
        return source.pixels[static_cast<std::size_t>(
            quad.first + (quad.u >= kUnit / 2) + (quad.v >= kUnit / 2) * static_cast<std::int64_t>(source_width_))];
    const auto row = static_cast<std::size_t>(-1 - quad.first);
    const auto tap = std::max_element(taps_.begin() + begin_[row], taps_.begin() + begin_[row + 1],
                                      [](const Tap& a, const Tap& b) { return a.weight < b.weight; });
    return source.pixels[static_cast<std::size_t>(tap->pixel)];
}

ImageMask ResamplePlan::covered() const {
    ImageMask out(width_, height_);
    for (std::size_t i = 0; i < quads_.size(); ++i) {
        const std::int32_t first = quads_[i].first;
        out.pixels[i] = first >= 0 ||
                                begin_[static_cast<std::size_t>(-1 - first)] < begin_[static_cast<std::size_t>(-first)]
                            ? 255
                            : 0;
    }
    return out;
}

Vec2f ResamplePlan::place(int x, int y) const {
    const Quad quad =
        quads_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    if (quad.first < 0) return {std::nanf(""), std::nanf("")};
    return {static_cast<float>(quad.first % source_width_) + static_cast<float>(quad.u) / kUnit + 0.5f,
            static_cast<float>(quad.first / source_width_) + static_cast<float>(quad.v) / kUnit + 0.5f};
}

}  // namespace fastscene
