#include "fastscene/walk/ready.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/geometry/range_edges.h"

namespace fastscene {
namespace {

constexpr float kNearest_m = 0.001f;  // metres: smaller ranges are measurement errors
// metres: if the median range is smaller, the camera is inside an object or the units are wrong
constexpr float kNoRoom_m = 0.1f;
constexpr float kTooFar_m = 1000.f;  // metres: no room is this large, so the units are wrong

// Median over the sphere of the known ranges.
float median_range(const ImageF& range) {
    const EquirectSize size{range.width, range.height};
    std::vector<std::pair<float, double>> seen;
    double all = 0;
    for (int y = 0; y < range.height; ++y)
        for (int x = 0; x < range.width; ++x)
            if (std::isfinite(range.at(x, y))) {
                seen.push_back({range.at(x, y), pixel_solid_angle(y, size)});
                all += seen.back().second;
            }
    std::sort(seen.begin(), seen.end());
    double sum = 0;
    for (const auto& [r, angle] : seen)
        if ((sum += angle) >= 0.5 * all) return r;
    return seen.back().first;
}

}  // namespace

Panorama ready_to_walk(Panorama first, const Run& run) {
    const int w = first.color.width, h = first.color.height;
    if (first.range.empty() || !first.range.same_size(first.color))
        throw Error("walk: expected a range map of the panorama's size {} x {}, found {} x {}", w, h, first.range.width,
                    first.range.height);
    if (w != 2 * h || h < 8) throw Error("walk: expected a panorama twice as wide as high, found {} x {}", w, h);
    std::int64_t without = 0, sky = 0;
    for (float& r : first.range.pixels) {
        if (r >= kNearest_m && r < kFarthestRange) continue;
        ++sky;
        without += !(r >= kNearest_m);  // true for NaN
        r = std::numeric_limits<float>::infinity();
    }
    if (!first.mirrored_range.empty()) {
        if (!first.mirrored_range.same_size(first.range))
            throw Error("walk: expected a map of what mirrors show of the range map's size {} x {}, found {} x {}", w,
                        h, first.mirrored_range.width, first.mirrored_range.height);
        for (float& r : first.mirrored_range.pixels)
            if (!(r > 0.f && r < kFarthestRange)) r = std::numeric_limits<float>::infinity();
    }
    if (sky == static_cast<std::int64_t>(first.range.size()))
        throw Error("walk: expected a range map in metres, found no range in any of its {} x {} pixels", w, h);
    if (without > 0)
        run.warn(
            fmt::format("walk: {} pixels of the range map have no range (0, negative, NaN or less than a millimetre); "
                        "they are kept as far background",
                        without));
    const float median = median_range(first.range);
    if (!(median >= kNoRoom_m))
        throw Error(
            "walk: expected free space around the first viewpoint, found half of all surfaces nearer than {:.3g} m; it "
            "stands inside a thing, "
            "or the range map is not in metres",
            median);
    if (median > kTooFar_m)
        run.warn(
            fmt::format("walk: half of all surfaces lie farther than {:.0f} m; is the range map in metres?", median));
    if (first.known.empty()) first.known = Image<Known>(w, h, Known::original);
    return first;
}

}  // namespace fastscene
