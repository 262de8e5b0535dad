// How an equirectangular picture (geometry/sphere.h) moves with the point it shows: exact first derivatives, and
// the second ones that the gradient of a splat's shape needs. With h = hypot(x, z), r = |p|:
//   px = cx + kx atan2(x, z),  py = cy - ky atan2(-y, h),  kx = W / 2 pi, ky = H / pi.
#pragma once

#include "fastscene/math/rigid.h"
#include "fastscene/splat/number.h"

namespace fastscene::splat {

template <class F>
struct CameraSlopes {
    Vec3<F> row_x, row_y;  // d px / d p, d py / d p
    F inv_h2{}, inv_r2{}, h{}, range{};
};

template <class F>
CameraSlopes<F> equirect_slopes(Vec3<F> p, F kx, F ky) {
    using std::sqrt;
    CameraSlopes<F> s;
    // At the poles the longitude's derivative diverges; the added 1e-6 m2 keeps it finite.
    const F h2 = p.x * p.x + p.z * p.z + F(1e-6), r2 = h2 + p.y * p.y;
    s.h = sqrt(h2), s.range = sqrt(r2);
    s.inv_h2 = F(1) / h2, s.inv_r2 = F(1) / r2;
    const F south = ky * s.inv_r2 * s.inv_h2 * s.h;  // ky / (r^2 h)
    s.row_x = {kx * s.inv_h2 * p.z, F(0), -(kx * s.inv_h2 * p.x)};
    s.row_y = {-(south * p.x * p.y), south * h2, -(south * p.y * p.z)};
    return s;
}

// Longitude and latitude, radians.
template <class F>
Vec2<F> equirect_angles(Vec3<F> p, const CameraSlopes<F>& s) {
    using std::atan2;
    return {atan2(p.x, p.z), atan2(-p.y, s.h)};
}

// Of L(row_x * M, row_y * M): from dL/d(row_x . M) = g0 and dL/d(row_y . M) = g1, the part of dL/dp that comes from the
// slopes changing with p; M = camera_from_local, n0 = row_x * M, n1 = row_y * M.
template <class F>
Vec3<F> slopes_grad(Vec3<F> p, const CameraSlopes<F>& s, F kx, F ky, const Mat3<F>& m, Vec3<F> n0, Vec3<F> n1,
                    Vec3<F> g0, Vec3<F> g1) {
    const F a0 = dot(g0, m.row0), a2 = dot(g0, m.row2), b0 = dot(g1, m.row0), b1 = dot(g1, m.row1),
            b2 = dot(g1, m.row2);
    const F east = kx * s.inv_h2, south = ky * s.inv_r2 * s.inv_h2 * s.h;
    const F e = F(2) * s.inv_h2 * dot(g0, n0), r = F(2) * s.inv_r2 * dot(g1, n1), h = s.inv_h2 * dot(g1, n1);
    return {-(east * a2) - e * p.x + south * (F(2) * p.x * b1 - p.y * b0) - (r + h) * p.x,
            -(south * (p.x * b0 + p.z * b2)) - r * p.y,
            east * a0 - e * p.z + south * (F(2) * p.z * b1 - p.y * b2) - (r + h) * p.z};
}

}  // namespace fastscene::splat
