// Initial Gaussians from surface points.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fastscene/base/random.h"
#include "fastscene/image/color.h"
#include "fastscene/math/morton.h"
#include "fastscene/splat/splat.h"

namespace fastscene {
namespace {

constexpr float kThickness = 0.08f;  // relative to the disc's radius: thin, so that surfaces stay sharp from the side

bool usable(const SurfacePoint& p) {
    const float reach = std::fabs(p.position_m.x) + std::fabs(p.position_m.y) + std::fabs(p.position_m.z);
    return reach < 1e6f && p.radius_m > 0.f && p.radius_m < 1e3f && dot(p.normal, p.normal) < 4.f;
}

// `count` of the usable points, uniformly at random, in their original order.
std::vector<std::size_t> draw(const std::vector<SurfacePoint>& points, std::size_t count, const Run& run) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (usable(points[i])) chosen.push_back(i);
    if (chosen.size() <= count) return chosen;
    const auto key = [&](std::size_t i) { return Random(run.seed, "splat.draw", i).next_u64(); };
    std::nth_element(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(count), chosen.end(),
                     [&](std::size_t a, std::size_t b) {
                         const auto ka = key(a), kb = key(b);
                         return ka != kb ? ka < kb : a < b;
                     });
    chosen.resize(count);
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

// Neighbours in space become neighbours in memory (Morton order), so that the splats of one vector tend to be visible
// together.
std::uint64_t morton(Vec3f p, Vec3f low, float cell) {
    const auto step = [&](float v) { return static_cast<std::uint64_t>(std::clamp(v / cell, 0.f, 2097151.f)); };
    return morton_code(step(p.x - low.x), step(p.y - low.y), step(p.z - low.z));
}

void order_in_space(const std::vector<SurfacePoint>& points, std::vector<std::size_t>& chosen) {
    Vec3f low{1e9f, 1e9f, 1e9f};
    for (const std::size_t i : chosen) {
        const Vec3f p = points[i].position_m;
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    }
    constexpr float kCellM = 0.02f;
    std::vector<std::pair<std::uint64_t, std::size_t>> keyed;
    keyed.reserve(chosen.size());
    for (const std::size_t i : chosen) keyed.emplace_back(morton(points[i].position_m, low, kCellM), i);
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t k = 0; k < chosen.size(); ++k) chosen[k] = keyed[k].second;
}

}  // namespace

int count_for(const std::vector<SurfacePoint>& points, const SplatParams& params) {
    if (!(params.per_m2 > 0)) return params.count;
    constexpr float kOutside_m = 100.f;  // larger than any room: farther points are scenery
    constexpr double kLeast = 20'000;    // minimum count: even a closet has edges
    double area = 0;                     // surface area as the sum of squared point spacings
    for (const SurfacePoint& p : points)
        if (length(p.position_m) < kOutside_m)
            area += static_cast<double>(p.radius_m) * static_cast<double>(p.radius_m);
    return static_cast<int>(
        std::min<double>(params.count, std::max(kLeast, static_cast<double>(params.per_m2) * area)));
}

Splats initial_splats(const std::vector<SurfacePoint>& points, const SplatParams& params, const Run& run) {
    std::vector<std::size_t> chosen = draw(points, static_cast<std::size_t>(std::max(params.count, 0)), run);
    order_in_space(points, chosen);
    std::size_t all = 0;
    for (const SurfacePoint& p : points) all += usable(p);
    // Fewer discs must each cover more: the spacing grows with the square root of the thinning.
    const float thinning = chosen.empty() ? 1.f
                                          : std::sqrt(static_cast<float>(all) / static_cast<float>(chosen.size()));

    Splats out;
    out.resize(chosen.size());
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        const SurfacePoint& p = points[chosen[k]];
        const float sigma = std::max(params.start_overlap * p.radius_m * thinning, 1e-4f);
        const bool flat = dot(p.normal, p.normal) > 0.25f;
        out.mean_m[k] = p.position_m;
        out.log_scale[k] = {std::log(sigma), std::log(sigma), std::log(flat ? sigma * kThickness : sigma)};
        if (flat) {
            Vec3f s, t;
            const Vec3f n = normalize(p.normal);
            make_frame(n, s, t);
            out.rotation[k] = quaternion_of(Mat3f::from_columns(s, t, n));
        }
        out.opacity_logit[k] = std::log(params.start_opacity / (1.f - params.start_opacity));
        out.sh0[k] = (unit_from_srgb8(p.color) - Vec3f{0.5f, 0.5f, 0.5f}) / kSh0;
    }
    return out;
}

}  // namespace fastscene
