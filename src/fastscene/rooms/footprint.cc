#include "fastscene/rooms/footprint.h"

#include <algorithm>
#include <cmath>

namespace fastscene {

Vec3f front_of(float yaw) { return {std::sin(yaw), 0, std::cos(yaw)}; }
Vec3f right_of(float yaw) { return {std::cos(yaw), 0, -std::sin(yaw)}; }
float yaw_of(Vec3f front) { return std::atan2(front.x, front.z); }

std::array<Vec2f, 2> axes_of(const Footprint& f) { return {flat(right_of(f.yaw)), flat(front_of(f.yaw))}; }

std::array<Vec2f, 4> corners_of(const Footprint& f) {
    const auto [x, z] = axes_of(f);
    const Vec2f a = x * f.half.x, b = z * f.half.y;
    return {f.center + a + b, f.center + a - b, f.center - a + b, f.center - a - b};
}

float extent(const Footprint& f, Vec2f axis) {
    const auto a = axes_of(f);
    return std::abs(dot(a[0], axis)) * f.half.x + std::abs(dot(a[1], axis)) * f.half.y;
}

bool overlap(const Footprint& a, const Footprint& b) {
    constexpr float kTouch = 0.004f;  // standing side by side is no overlap
    if (a.y0 >= b.y1 - kTouch || b.y0 >= a.y1 - kTouch) return false;
    const Vec2f between = b.center - a.center;
    for (const Footprint* f : {&a, &b})
        for (const Vec2f axis : axes_of(*f))
            if (std::abs(dot(between, axis)) >= extent(a, axis) + extent(b, axis) - kTouch) return false;
    return true;
}

float distance_to(const Footprint& box, Vec2f point) { return distance_to(box, axes_of(box), point); }

float distance_to(const Footprint& box, const std::array<Vec2f, 2>& axes, Vec2f point) {
    const Vec2f d = point - box.center;
    const float x = std::max(0.f, std::abs(dot(d, axes[0])) - box.half.x),
                y = std::max(0.f, std::abs(dot(d, axes[1])) - box.half.y);
    return std::hypot(x, y);
}

Footprint shrunk(Footprint f, float by) {
    f.half = {std::max(0.f, f.half.x - by), std::max(0.f, f.half.y - by)};
    f.y0 += by;
    f.y1 = std::max(f.y0, f.y1 - by);
    return f;
}

bool passes(const Footprint& box, Vec3f a, Vec3f b) {
    // Slabs in the box's own frame.
    const auto axes = axes_of(box);
    float t0 = 0, t1 = 1;
    const auto slab = [&](float from, float to, float low, float high) {
        const float d = to - from;
        if (std::abs(d) < 1e-6f) {
            if (from < low || from > high) t0 = 2;
            return;
        }
        const float u = (low - from) / d, v = (high - from) / d;
        t0 = std::max(t0, std::min(u, v));
        t1 = std::min(t1, std::max(u, v));
    };
    for (std::size_t k = 0; k < 2; ++k) {
        const float half = k == 0 ? box.half.x : box.half.y;
        slab(dot(flat(a) - box.center, axes[k]), dot(flat(b) - box.center, axes[k]), -half, half);
    }
    slab(a.y, b.y, box.y0, box.y1);
    return t0 < t1;
}

}  // namespace fastscene
