// Users' range maps: unmeasured pixels become far background, or are interpolated if only a speck or the tripod is
// missing.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "fastscene/base/error.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/panorama.h"

namespace fastscene {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::infinity();
constexpr double kSpeckShare = 1.5e-4;  // share of the sphere: a patch 3 degrees across

using Pixels = std::vector<std::pair<int, int>>;

// Extracts the connected patch of unmeasured pixels that contains (x, y), across the seam too, and clears it in `left`.
Pixels patch_from(int x, int y, ImageMask& left) {
    Pixels patch{{x, y}};
    left.at(x, y) = 0;
    for (std::size_t k = 0; k < patch.size(); ++k) {
        const auto [px, py] = patch[k];
        for (const auto& [i, j] : {std::pair{px - 1, py}, {px + 1, py}, {px, py - 1}, {px, py + 1}}) {
            if (j < 0 || j >= left.height) continue;
            const int c = wrap_column(i, left.width);
            if (!left.at(c, j)) continue;
            left.at(c, j) = 0;
            patch.push_back({c, j});
        }
    }
    return patch;
}

double share_of_sphere(const Pixels& patch, EquirectSize size) {
    double sum = 0;
    for (const auto& [x, y] : patch) sum += pixel_solid_angle(y, size);
    return sum / (4 * std::numbers::pi);
}

// Median of the measured ranges around the patch, each mapped by `of(range, row)`.
template <class Of>
float median_beside(const ImageF& range, const Pixels& patch, Of of) {
    std::vector<float> beside;
    for (const auto& [x, y] : patch)
        for (const auto& [i, j] : {std::pair{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
            if (j < 0 || j >= range.height) continue;
            const float r = range.at(wrap_column(i, range.width), j);
            if (r > 0.f && std::isfinite(r)) beside.push_back(of(r, j));
        }
    if (beside.empty()) return kUnknown;
    const auto middle = beside.begin() + static_cast<std::ptrdiff_t>(beside.size() / 2);
    std::nth_element(beside.begin(), middle, beside.end());
    return *middle;
}

// Vertical component of a unit ray in this row, downwards.
float down_of(int y, int height) {
    return std::cos((static_cast<float>(y) + 0.5f) / static_cast<float>(height) * std::numbers::pi_v<float>) * -1.f;
}

}  // namespace

ImageF completed_range(ImageF range, RangeGaps& gaps) {
    const EquirectSize size{range.width, range.height};
    gaps = {};
    ImageMask left(range.width, range.height);
    for (std::size_t i = 0; i < range.size(); ++i) {
        left.pixels[i] = !(range.pixels[i] > 0.f);  // true for NaN
        gaps.unmeasured += left.pixels[i];
    }
    if (gaps.unmeasured == 0) return range;
    ImageF out = range;
    for (int y = 0; y < range.height; ++y)
        for (int x = 0; x < range.width; ++x) {
            if (!left.at(x, y)) continue;
            const Pixels patch = patch_from(x, y, left);
            const auto lowest = std::max_element(patch.begin(), patch.end(), [](const auto& a, const auto& b) {
                                    return a.second < b.second;
                                })->second;
            const auto highest = std::min_element(patch.begin(), patch.end(), [](const auto& a, const auto& b) {
                                     return a.second < b.second;
                                 })->second;
            const bool speck = share_of_sphere(patch, size) < kSpeckShare;
            // Below the horizon and down to the nadir: the camera's stand. The floor continues level.
            const bool tripod = lowest == range.height - 1 && highest > range.height * 2 / 3;
            const float floor = tripod ? median_beside(range, patch,
                                                       [&](float r, int j) { return r * down_of(j, range.height); })
                                       : 0;
            const float beside = speck && !tripod ? median_beside(range, patch, [](float r, int) { return r; }) : kUnknown;
            for (const auto& [px, py] : patch) out.at(px, py) = tripod ? floor / down_of(py, range.height) : beside;
            (tripod || speck ? gaps.closed : gaps.far) += static_cast<std::int64_t>(patch.size());
        }
    return out;
}

namespace {

// Plausible median range of rooms (half a metre to 200 m wide); otherwise the unit is probably millimetres, kilometres,
// or a normalized value.
constexpr float kNearestRoom = 0.15f, kFarthestRoom = 150.f;

// Millimetres or normalized ranges would give a valid but wrong walk, so they are reported.
void tell_other_units(const ImageF& range, const std::filesystem::path& map, const Run& run) {
    std::vector<float> measured;
    std::copy_if(range.pixels.begin(), range.pixels.end(), std::back_inserter(measured),
                 [](float r) { return r > 0.f && std::isfinite(r); });
    const auto middle = measured.begin() + static_cast<std::ptrdiff_t>(measured.size() / 2);
    std::nth_element(measured.begin(), middle, measured.end());
    if (*middle >= kNearestRoom && *middle <= kFarthestRoom) return;
    run.warn(
        fmt::format("{}: half of it is {} than {:.3g} m: expected the ranges of a room in metres (16-bit PNG and TIFF: "
                    "millimetres), are these in another unit?",
                    map.string(), *middle < kNearestRoom ? "nearer" : "farther", *middle));
}

}  // namespace

ImageF range_from_file(const std::filesystem::path& map, EquirectSize size, const Run& run) {
    const PictureInfo info = picture_info(map);
    if (info.width != size.width || info.height != size.height)
        throw Error("{}: expected a range map of the panorama's size, {} x {}, found {} x {}", map.string(), size.width,
                    size.height, info.width, info.height);
    const ImageF range = load_float(map);
    std::size_t measured = 0;
    for (int y = 0; y < range.height; ++y)
        for (int x = 0; x < range.width; ++x) {
            const float r = range.at(x, y);
            if (r < 0.f)
                throw Error("{}: expected ranges in metres, 0 or more, found {} at column {}, row {}", map.string(), r,
                            x, y);
            if (r > 0.f && std::isfinite(r)) ++measured;
        }
    if (measured == 0)
        throw Error("{}: expected ranges in metres, found no finite value above zero in the whole map", map.string());
    tell_other_units(range, map, run);
    RangeGaps gaps;
    ImageF out = completed_range(range, gaps);
    if (gaps.unmeasured > 0)
        run.warn(
            fmt::format("{}: {} pixels without a range (0 or NaN): {} kept as far background, {} filled from their "
                        "surroundings (specks, and straight below)",
                        map.string(), gaps.unmeasured, gaps.far, gaps.closed));
    return out;
}

}  // namespace fastscene
