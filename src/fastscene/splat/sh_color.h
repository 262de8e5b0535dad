// View-dependent color of a splat: spherical harmonics of degrees 1 to 3 (basis in scene/sh.h), and the gradient.
// Coefficients are accessed as at(i), i in the order of Splats::sh_rest.
#pragma once

#include "fastscene/scene/sh.h"
#include "fastscene/splat/project.h"

namespace fastscene::splat {

inline constexpr int rest_functions(int degree) { return (degree + 1) * (degree + 1) - 1; }
inline constexpr int kMostRest = 3 * (kShFunctions - 1);

// Direction from the camera to the splat; `inv_distance` is needed for the gradient.
template <class F>
struct Sight {
    Vec3<F> direction;
    F inv_distance;
};
template <class F>
Sight<F> sight_of(Vec3<F> mean, Vec3<F> camera_center) {
    using std::sqrt;
    const Vec3<F> d = mean - camera_center;
    const F inv = F(1) / sqrt(dot(d, d) + F(1e-20));
    return {d * inv, inv};
}

template <class F, class At>
Vec3<F> more_color(int degree, const Sight<F>& sight, At&& at) {
    Vec3<F> sum;
    if (degree == 0) return sum;
    const auto basis = sh_basis(sight.direction);
    const int n = rest_functions(degree);
    for (int k = 0; k < n; ++k) {
        const F b = basis[static_cast<std::size_t>(k + 1)];
        sum += Vec3<F>{at(k) * b, at(n + k) * b, at(2 * n + k) * b};
    }
    return sum;
}

// Gradient with respect to the direction of sum over k of w[k] * basis[k + 1].
template <class F>
Vec3<F> sh_slope(int degree, Vec3<F> d, const F* w) {
    const F x = d.x, y = d.y, z = d.z, xx = x * x, yy = y * y, zz = z * z;
    const auto c = [](double v) { return F(v); };
    Vec3<F> g{-(c(0.4886025119029199) * w[2]), -(c(0.4886025119029199) * w[0]), c(0.4886025119029199) * w[1]};
    if (degree >= 2) {
        const F a = c(1.0925484305920792) * w[3], b = c(-1.0925484305920792) * w[4], e = c(0.31539156525252005) * w[5];
        const F f = c(-1.0925484305920792) * w[6], h = c(0.5462742152960396) * w[7], two = F(2);
        g += Vec3<F>{a * y - two * e * x + f * z + two * h * x, a * x + b * z - two * e * y - two * h * y,
                     b * y + F(4) * e * z + f * x};
    }
    if (degree >= 3) {
        const F a = c(-0.5900435899266435) * w[8], b = c(2.890611442640554) * w[9], e = c(-0.4570457994644658) * w[10];
        const F f = c(0.3731763325901154) * w[11], h = c(-0.4570457994644658) * w[12], i = c(1.445305721320277) * w[13];
        const F j = c(-0.5900435899266435) * w[14], two = F(2), three = F(3), four = F(4), six = F(6), eight = F(8);
        g += Vec3<F>{
            six * a * x * y + b * y * z - two * e * x * y - six * f * x * z + h * (four * zz - three * xx - yy) +
                two * i * x * z + three * j * (xx - yy),
            three * a * (xx - yy) + b * x * z + e * (four * zz - xx - three * yy) - six * f * y * z - two * h * x * y -
                two * i * y * z - six * j * x * y,
            b * x * y + eight * e * y * z + three * f * (two * zz - xx - yy) + eight * h * x * z + i * (xx - yy)};
    }
    return g;
}

// From dL/d(color before clamping): dL/d(coefficients) into out[0 .. 3 n); returns the contribution to dL/d(mean).
template <class F, class At>
Vec3<F> more_color_grad(int degree, const Sight<F>& sight, Vec3<F> g_color, At&& at, F* out) {
    const auto basis = sh_basis(sight.direction);
    const int n = rest_functions(degree);
    F w[kShFunctions - 1];
    for (int k = 0; k < n; ++k) {
        const F b = basis[static_cast<std::size_t>(k + 1)];
        out[k] = g_color.x * b, out[n + k] = g_color.y * b, out[2 * n + k] = g_color.z * b;
        w[k] = g_color.x * at(k) + g_color.y * at(n + k) + g_color.z * at(2 * n + k);
    }
    const Vec3<F> slope = sh_slope(degree, sight.direction, w);
    // Only the component orthogonal to the line of sight changes the direction.
    return (slope - sight.direction * dot(slope, sight.direction)) * sight.inv_distance;
}

}  // namespace fastscene::splat
