// Rotations and rigid transforms. A transform is named target_from_source, so that products read right: x_b = b_from_a
// * x_a and c_from_a = c_from_b * b_from_a.
#pragma once

#include <cmath>

#include "fastscene/math/vec.h"

namespace fastscene {

template <class F>
struct Mat3 {
    // Rows; default: identity.
    Vec3<F> row0{F(1), F(0), F(0)}, row1{F(0), F(1), F(0)}, row2{F(0), F(0), F(1)};

    static constexpr Mat3 from_columns(Vec3<F> a, Vec3<F> b, Vec3<F> c) {
        return {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}};
    }
    constexpr Vec3<F> column(std::size_t i) const { return {row0[i], row1[i], row2[i]}; }
    friend constexpr Vec3<F> operator*(const Mat3& m, Vec3<F> v) {
        return {dot(m.row0, v), dot(m.row1, v), dot(m.row2, v)};
    }
    friend constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
        return from_columns(a * b.column(0), a * b.column(1), a * b.column(2));
    }
    friend constexpr bool operator==(const Mat3&, const Mat3&) = default;
};
template <class F>
constexpr Mat3<F> transpose(const Mat3<F>& m) {
    return Mat3<F>::from_columns(m.row0, m.row1, m.row2);
}
using Mat3f = Mat3<float>;
using Mat3d = Mat3<double>;

// A quaternion, w first; a rotation if it has unit length.
template <class F>
struct Quat {
    F w{1}, x{}, y{}, z{};
    friend constexpr Quat operator*(Quat a, Quat b) {
        return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
    }
    friend constexpr bool operator==(const Quat&, const Quat&) = default;
};
using Quatf = Quat<float>;
using Quatd = Quat<double>;

// The rotation matrix of q / |q|; q must not be zero.
template <class F>
constexpr Mat3<F> matrix_of(Quat<F> q) {
    const F s = F(2) / (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    const F xx = q.x * q.x * s, yy = q.y * q.y * s, zz = q.z * q.z * s;
    const F xy = q.x * q.y * s, xz = q.x * q.z * s, yz = q.y * q.z * s;
    const F wx = q.w * q.x * s, wy = q.w * q.y * s, wz = q.w * q.z * s;
    return {{F(1) - yy - zz, xy - wz, xz + wy}, {xy + wz, F(1) - xx - zz, yz - wx}, {xz - wy, yz + wx, F(1) - xx - yy}};
}

// The unit quaternion of a rotation matrix, with w >= 0 (Shepperd's method).
template <class F>
Quat<F> quaternion_of(const Mat3<F>& m) {
    using std::sqrt;
    const F a = m.row0.x, b = m.row1.y, c = m.row2.z;
    Quat<F> q;
    if (a + b + c > F(0)) {
        const F s = sqrt(a + b + c + F(1)) * F(2);
        q = {s / F(4), (m.row2.y - m.row1.z) / s, (m.row0.z - m.row2.x) / s, (m.row1.x - m.row0.y) / s};
    } else if (a > b && a > c) {
        const F s = sqrt(F(1) + a - b - c) * F(2);
        q = {(m.row2.y - m.row1.z) / s, s / F(4), (m.row0.y + m.row1.x) / s, (m.row0.z + m.row2.x) / s};
    } else if (b > c) {
        const F s = sqrt(F(1) + b - a - c) * F(2);
        q = {(m.row0.z - m.row2.x) / s, (m.row0.y + m.row1.x) / s, s / F(4), (m.row1.z + m.row2.y) / s};
    } else {
        const F s = sqrt(F(1) + c - a - b) * F(2);
        q = {(m.row1.x - m.row0.y) / s, (m.row0.z + m.row2.x) / s, (m.row1.z + m.row2.y) / s, s / F(4)};
    }
    return q.w < F(0) ? Quat<F>{-q.w, -q.x, -q.y, -q.z} : q;
}

// Right-handed rotation about a unit axis, radians.
template <class F>
Mat3<F> rotation_about(Vec3<F> axis, F angle) {
    using std::cos;
    using std::sin;
    const F s = sin(angle / F(2));
    return matrix_of(Quat<F>{cos(angle / F(2)), axis.x * s, axis.y * s, axis.z * s});
}

// p_b = rotation * p_a + translation.
template <class F>
struct RigidT {
    Mat3<F> rotation{};
    Vec3<F> translation{};

    friend constexpr Vec3<F> operator*(const RigidT& b_from_a, Vec3<F> p_a) {
        return b_from_a.rotation * p_a + b_from_a.translation;
    }
    friend constexpr RigidT operator*(const RigidT& c_from_b, const RigidT& b_from_a) {
        return {c_from_b.rotation * b_from_a.rotation, c_from_b * b_from_a.translation};
    }
    friend constexpr bool operator==(const RigidT&, const RigidT&) = default;
};
template <class F>
constexpr RigidT<F> inverse(const RigidT<F>& b_from_a) {
    const Mat3<F> r = transpose(b_from_a.rotation);
    return {r, -(r * b_from_a.translation)};
}
using Rigid = RigidT<float>;
using Rigidd = RigidT<double>;

}  // namespace fastscene
