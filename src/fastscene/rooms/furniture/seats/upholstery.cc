// Padded bodies along a curve.
#include "fastscene/rooms/furniture/seats/upholstery.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace fastscene::furniture {

float eased(float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.f, 1.f);
    return t * t * (3 - 2 * t);
}

Mesh padded_body(const Padding& how) {
    // Rings close together where the ends are rounded.
    std::vector<float> at;
    const float length_m = [&] {
        float sum = 0;
        for (int i = 0; i < 40; ++i)
            sum += length(how.path(static_cast<float>(i + 1) / 40.f) - how.path(static_cast<float>(i) / 40.f));
        return sum;
    }();
    const float cap = std::min(0.3f, how.round_m / length_m);
    constexpr int kCap = 4;
    for (int i = 0; i < kCap; ++i) at.push_back(cap * (1.f - std::cos(0.5f * kPi * static_cast<float>(i) / kCap)));
    for (int i = 0; i <= how.steps; ++i)
        at.push_back(cap + (1.f - 2.f * cap) * static_cast<float>(i) / static_cast<float>(how.steps));
    for (int i = kCap - 1; i >= 0; --i) at.push_back(1.f - at[static_cast<std::size_t>(i)]);
    Mesh m;
    std::vector<std::uint32_t> rings;
    std::size_t sides = 0;
    for (const float t : at) {
        const Vec3f middle = how.path(t),
                    along = normalize(how.path(std::min(1.f, t + 0.01f)) - how.path(std::max(0.f, t - 0.01f))),
                    up = normalize(cross(along, how.across));
        const float from_end = std::min(t, 1.f - t) / cap,
                    in = from_end >= 1.f
                             ? 0.f
                             : how.round_m *
                                   (1.f - std::sqrt(std::max(0.f, 1.f - (1.f - from_end) * (1.f - from_end))));
        const Vec2f s = how.section(t);
        const float wide = std::max(0.02f, s.x - 2 * in), thick = std::max(0.012f, s.y - 2 * in);
        std::vector<Vec2f> outline = shapes::rounded_rectangle(wide, thick, std::min(how.round_m, 0.48f * thick), 4);
        // The long sides need points between their corners.
        std::vector<Vec2f> ring;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vec2f a = outline[i], b = outline[(i + 1) % outline.size()];
            ring.push_back(a);
            if (i % 5 == 4 && (i / 5) % 2 == 0)
                for (int j = 1; j < 6; ++j) ring.push_back(a + (b - a) * (static_cast<float>(j) / 6.f));
        }
        sides = ring.size();
        rings.push_back(static_cast<std::uint32_t>(m.positions.size()));
        for (const Vec2f q : ring) {
            const Vec3f p = middle + how.across * q.x + up * q.y;
            const float fold = shapes::wobble(p * 15.f, how.seed) + 0.5f * shapes::wobble(p * 34.f, how.seed + 7);
            m.positions.push_back(p + up * ((q.y > 0 ? 1.f : -1.f) * how.wrinkle_m * fold));
        }
    }
    const auto n = static_cast<std::uint32_t>(sides);
    for (std::size_t r = 0; r + 1 < rings.size(); ++r)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t j = (i + 1) % n, a = rings[r], b = rings[r + 1];
            m.triangles.insert(m.triangles.end(), {a + i, b + i, b + j, a + i, b + j, a + j});
        }
    for (const bool end : {false, true}) {
        const std::uint32_t ring = end ? rings.back() : rings.front(),
                            hub = static_cast<std::uint32_t>(m.positions.size());
        m.positions.push_back(how.path(end ? 1.f : 0.f));
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t j = (i + 1) % n;
            if (end) m.triangles.insert(m.triangles.end(), {hub, ring + j, ring + i});
            else m.triangles.insert(m.triangles.end(), {hub, ring + i, ring + j});
        }
    }
    m.normals.assign(m.positions.size(), Vec3f{0, 1, 0});
    if (shapes::signed_volume(m) < 0)
        for (std::size_t t = 0; t < m.triangles.size(); t += 3) std::swap(m.triangles[t + 1], m.triangles[t + 2]);
    shapes::smooth_normals(m);
    shapes::lay_grain(m);
    return m;
}

std::function<Vec3f(float)> curve_through(std::vector<Vec2f> points, std::function<Vec3f(Vec2f)> place) {
    const std::vector<Vec2f> fine = shapes::curve(points, 12);
    std::vector<float> run{0.f};
    for (std::size_t i = 1; i < fine.size(); ++i) run.push_back(run.back() + length(fine[i] - fine[i - 1]));
    return [=](float t) {
        const float want = t * run.back();
        std::size_t i = 1;
        while (i + 1 < fine.size() && run[i] < want) ++i;
        return place(fine[i - 1] +
                     (fine[i] - fine[i - 1]) * std::clamp((want - run[i - 1]) / (run[i] - run[i - 1]), 0.f, 1.f));
    };
}

void bolster(Kit& k, int mat, Vec3f from, float far, float r) {
    const std::array<Vec2f, 8> p{
        Vec2f{0.2f * r, 0}, {0.74f * r, 0.006f},      {0.95f * r, 0.03f},        {r, 0.09f},
        {r, far - 0.09f},   {0.95f * r, far - 0.03f}, {0.74f * r, far - 0.006f}, {0.2f * r, far}};
    Mesh roll = shapes::lathe(p, 24, true);
    shapes::turn(roll, {1, 0, 0}, 90);
    k.add(std::move(roll), mat, from);
}

}  // namespace fastscene::furniture
