// Small vectors over any number type F (float, double, a dual number, SIMD lanes).
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

namespace fastscene {

inline constexpr float kPi = std::numbers::pi_v<float>;

template <class F>
struct Vec2 {
    F x{}, y{};
    friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vec2 operator*(Vec2 a, F s) { return {a.x * s, a.y * s}; }
    friend constexpr Vec2 operator*(F s, Vec2 a) { return {a.x * s, a.y * s}; }
    friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

template <class F>
struct Vec3 {
    F x{}, y{}, z{};
    constexpr F& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }
    constexpr const F& operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }
    friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vec3 operator*(Vec3 a, F s) { return {a.x * s, a.y * s, a.z * s}; }
    friend constexpr Vec3 operator*(F s, Vec3 a) { return {a.x * s, a.y * s, a.z * s}; }
    friend constexpr Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }  // per component
    friend constexpr Vec3 operator/(Vec3 a, F s) { return {a.x / s, a.y / s, a.z / s}; }
    constexpr Vec3& operator+=(Vec3 b) { return *this = *this + b; }
    constexpr Vec3& operator-=(Vec3 b) { return *this = *this - b; }
    constexpr Vec3& operator*=(F s) { return *this = *this * s; }
    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

using Vec2f = Vec2<float>;
using Vec2d = Vec2<double>;
using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

template <class F>
constexpr F dot(Vec2<F> a, Vec2<F> b) {
    return a.x * b.x + a.y * b.y;
}
template <class F>
constexpr F dot(Vec3<F> a, Vec3<F> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class F>
constexpr Vec3<F> cross(Vec3<F> a, Vec3<F> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class F>
F length(Vec3<F> a) {
    using std::sqrt;
    return sqrt(dot(a, a));
}
template <class F>
F length(Vec2<F> a) {
    using std::sqrt;
    return sqrt(dot(a, a));
}
// The zero vector stays zero.
template <class F>
Vec3<F> normalize(Vec3<F> a) {
    const F l = length(a);
    return l > F(0) ? a / l : a;
}
template <class F>
constexpr Vec3<F> lerp(Vec3<F> a, Vec3<F> b, F t) {
    return a + (b - a) * t;
}
inline float max_component(Vec3f a) { return std::fmax(a.x, std::fmax(a.y, a.z)); }
inline float min_component(Vec3f a) { return std::fmin(a.x, std::fmin(a.y, a.z)); }
// Rec. 709 luminance of a linear color.
inline float luminance(Vec3f c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

// Completes the unit vector n to a right-handed orthonormal frame (s, t, n) (Duff et al. 2017).
inline void make_frame(Vec3f n, Vec3f& s, Vec3f& t) {
    const float sign = std::copysign(1.f, n.z);
    const float a = -1.f / (sign + n.z), b = n.x * n.y * a;
    s = {1.f + sign * n.x * n.x * a, sign * b, -sign * n.x};
    t = {b, sign + n.y * n.y * a, -n.y};
}

}  // namespace fastscene
