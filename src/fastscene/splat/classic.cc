#include "fastscene/splat/classic.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/random.h"

namespace fastscene::splat {
namespace {

constexpr float kGone = -30.f;        // logit of a removed splat: never drawn
constexpr float kSplitShrink = 1.6f;  // Kerbl et al.'s value

float median(std::vector<float> v) {
    if (v.empty()) return 0;
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
}

float logit_of(double opacity) { return static_cast<float>(std::log(opacity / (1 - opacity))); }

void clear_moments(Cloud& c, std::int64_t i) {
    for (int p = 0; p < kParameters; ++p) c.first_moment[c.at(i, p)] = c.second_moment[c.at(i, p)] = 0;
    for (int k = 0; k < 3 * rest_functions(c.degree); ++k)
        c.rest_first_moment[c.rest_at(i, k)] = c.rest_second_moment[c.rest_at(i, k)] = 0;
}
void copy_splat(Cloud& c, std::int64_t from, std::int64_t to) {
    for (int p = 0; p < kParameters; ++p) c.parameters[c.at(to, p)] = c.parameters[c.at(from, p)];
    for (int k = 0; k < 3 * rest_functions(c.degree); ++k) c.rest[c.rest_at(to, k)] = c.rest[c.rest_at(from, k)];
    clear_moments(c, to);
}
// Moves splat i to a random position drawn from the Gaussian `shape`.
void move_within(Cloud& c, std::int64_t i, const Cloud& shape, std::int64_t as, Random& random) {
    const auto get = [&](int p) { return shape.parameters[shape.at(as, p)]; };
    const Mat3f turn = matrix_of(Quatf{get(6), get(7), get(8), get(9)});
    Vec3f local;
    for (std::size_t a = 0; a < 3; ++a) local[a] = random.normal() * std::exp(get(3 + static_cast<int>(a)));
    const Vec3f by = turn * local;
    for (int a = 0; a < 3; ++a) c.parameters[c.at(i, a)] += by[static_cast<std::size_t>(a)];
}

}  // namespace

SceneExtent scene_extent(const ViewSet& set) {
    std::vector<float> x, y, z;
    for (const View& v : set.views)
        x.push_back(v.world_from_camera.translation.x), y.push_back(v.world_from_camera.translation.y),
            z.push_back(v.world_from_camera.translation.z);
    const Vec3f middle{median(x), median(y), median(z)};
    std::vector<float> cameras, points;
    for (const View& v : set.views) cameras.push_back(length(v.world_from_camera.translation - middle));
    for (const SurfacePoint& p : set.points) points.push_back(length(p.position_m - middle));
    return {middle, std::max({1.1f * median(cameras), median(points), 1e-3f})};
}

std::int64_t densify(Cloud& c, const Classic& how, float extent_m, std::uint64_t seed, int step) {
    const float faint = logit_of(how.faint);
    std::vector<std::int64_t> free, wanted;
    const std::int64_t before = c.count;
    for (std::int64_t i = 0; i < before; ++i) {
        const auto k = static_cast<std::size_t>(i);
        float& logit = c.parameters[c.at(i, kLogit)];
        if (!(logit >= faint)) {
            logit = kGone;
            clear_moments(c, i);
            free.push_back(i);
        } else if (c.seen_steps[k] > 0 && c.seen_move[k] / c.seen_steps[k] > how.move) {
            wanted.push_back(i);
        }
    }
    std::size_t next_free = 0;
    std::int64_t made = 0;
    for (const std::int64_t from : wanted) {
        if (next_free == free.size() && c.count == c.capacity) break;
        const std::int64_t to = next_free < free.size() ? free[next_free++] : c.count++;
        copy_splat(c, from, to);
        float widest = 0;
        for (int a = 3; a < 6; ++a) widest = std::max(widest, std::exp(c.parameters[c.at(from, a)]));
        if (widest > how.large * extent_m) {
            Random random(seed, "splat.densify",
                          static_cast<std::uint64_t>(step) << 32 | static_cast<std::uint64_t>(from));
            move_within(c, to, c, from, random);
            move_within(c, from, c, from, random);
            for (const std::int64_t i : {from, to})
                for (int a = 3; a < 6; ++a) c.parameters[c.at(i, a)] -= std::log(kSplitShrink);
            clear_moments(c, from);
        }
        ++made;
    }
    for (AlignedFloats* sums : {&c.seen_weight, &c.seen_error, &c.seen_move, &c.seen_steps})
        std::fill(sums->begin(), sums->end(), 0.f);
    return made;
}

void reset_opacities(Cloud& c) {
    for (std::int64_t i = 0; i < c.count; ++i) {
        float& logit = c.parameters[c.at(i, kLogit)];
        logit = std::min(logit, logit_of(0.01));
        c.first_moment[c.at(i, kLogit)] = c.second_moment[c.at(i, kLogit)] = 0;
    }
}

Splats alive(const Splats& s, float faint) {
    Splats out;
    out.sh_degree = s.sh_degree, out.filter = s.filter;
    const auto n = static_cast<std::size_t>(3 * s.rest_coefficients());
    for (std::size_t i = 0; i < s.size(); ++i) {
        if (!(s.opacity_logit[i] >= logit_of(faint))) continue;
        out.mean_m.push_back(s.mean_m[i]);
        out.log_scale.push_back(s.log_scale[i]);
        out.rotation.push_back(s.rotation[i]);
        out.opacity_logit.push_back(s.opacity_logit[i]);
        out.sh0.push_back(s.sh0[i]);
        out.sh_rest.insert(out.sh_rest.end(), s.sh_rest.begin() + static_cast<std::ptrdiff_t>(i * n),
                           s.sh_rest.begin() + static_cast<std::ptrdiff_t>((i + 1) * n));
    }
    return out;
}

}  // namespace fastscene::splat
