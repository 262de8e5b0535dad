// The gradient of project(): from a splat's footprint back to its 14 parameters.
#pragma once

#include "fastscene/splat/project.h"

namespace fastscene::splat {

// Sums over a splat's pixels, the input of its gradient. With g = dL/d(ln alpha) at a pixel and (dx, dy) = pixel center
// - splat center:
template <class F>
struct PixelSums {
    F g{}, g_dx{}, g_dy{}, g_dxdx{}, g_dxdy{}, g_dydy{};
    Vec3<F> color;  // sum of blending weight * dL/d(pixel color)
    F depth{};      // sum of blending weight * dL/d(depth sum)
};

namespace detail {

// From dL/d(rotation matrix) to dL/dq, where the matrix is that of q / |q|.
template <class F>
Quat<F> quaternion_grad(const Quat<F>& q, const Mat3<F>& g) {
    using std::sqrt;
    const F inv = F(1) / sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    const F w = q.w * inv, x = q.x * inv, y = q.y * inv, z = q.z * inv;
    const F a = g.row2.y - g.row1.z, b = g.row0.z - g.row2.x, c = g.row1.x - g.row0.y;
    const F d = g.row0.y + g.row1.x, e = g.row0.z + g.row2.x, f = g.row1.z + g.row2.y;
    const F gw = F(2) * (x * a + y * b + z * c);
    const F gx = F(2) * (w * a + y * d + z * e - F(2) * x * (g.row1.y + g.row2.z));
    const F gy = F(2) * (w * b + x * d + z * f - F(2) * y * (g.row0.x + g.row2.z));
    const F gz = F(2) * (w * c + x * e + y * f - F(2) * z * (g.row0.x + g.row1.y));
    // Only the component orthogonal to q rotates; the parallel one changes q's length.
    const F along = gw * w + gx * x + gy * y + gz * z;
    return {(gw - along * w) * inv, (gx - along * x) * inv, (gy - along * y) * inv, (gz - along * z) * inv};
}

// From n to the rotation (through g_camera_from_local) and to the point.
template <class F>
Vec3<F> pinhole_grad(const Lens<F>& lens, const Projection<F>& p, Vec2<F> screen, Vec3<F> gn0, Vec3<F> gn1,
                     Mat3<F>& g_camera_from_local) {
    const F sx = lens.fx * p.inv_z, sy = lens.fy * p.inv_z;
    const Vec3<F>& w2 = p.camera_from_local.row2;
    const Vec3<F> gw0 = gn0 * sx, gw1 = gn1 * sy;
    const Vec3<F> gw2 = -(gw0 * p.u_held + gw1 * p.v_held);
    g_camera_from_local = {gw0, gw1, gw2};
    const auto u_free = (p.u >= lens.min_u) & (p.u <= lens.max_u);
    const auto v_free = (p.v >= lens.min_v) & (p.v <= lens.max_v);
    const F gu = lens.fx * screen.x - select(u_free, dot(gw0, w2), F(0));
    const F gv = lens.fy * screen.y - select(v_free, dot(gw1, w2), F(0));
    // u = x / z, v = y / z, n ~ 1 / z.
    return {gu * p.inv_z, gv * p.inv_z, -(p.inv_z * (gu * p.u + gv * p.v + dot(gn0, p.n0) + dot(gn1, p.n1)))};
}
template <class F>
Vec3<F> equirect_grad(const Lens<F>& lens, const Projection<F>& p, Vec2<F> screen, Vec3<F> gn0, Vec3<F> gn1,
                      Mat3<F>& g_camera_from_local) {
    const Vec3<F>&jx = p.slopes.row_x, &jy = p.slopes.row_y;
    g_camera_from_local = {gn0 * jx.x + gn1 * jy.x, gn1 * jy.y, gn0 * jx.z + gn1 * jy.z};
    return jx * screen.x + jy * screen.y +
           slopes_grad(p.p_camera, p.slopes, lens.fx, lens.fy, p.camera_from_local, p.n0, p.n1, gn0, gn1);
}

}  // namespace detail

// dL/d(screen position), pixels.
template <class F>
Vec2<F> screen_grad(const Projection<F>& p, const PixelSums<F>& s) {
    return {p.conic_a * s.g_dx + p.conic_b * s.g_dy, p.conic_b * s.g_dx + p.conic_c * s.g_dy};
}

template <class F>
Gaussian<F> project_grad(const Gaussian<F>& in, const Lens<F>& lens, const Projection<F>& p, const PixelSums<F>& s) {
    Gaussian<F> out;
    const Vec2<F> screen = screen_grad(p, s);

    // Conic to covariance: dL/dcov = -K (dL/dK) K with K the (symmetric) conic.
    const F ka = F(-0.5) * s.g_dxdx, kb = F(-0.5) * s.g_dxdy, kc = F(-0.5) * s.g_dydy;
    const F a = p.conic_a, b = p.conic_b, c = p.conic_c;
    const F t00 = ka * a + kb * b, t01 = ka * b + kb * c, t10 = kb * a + kc * b, t11 = kb * b + kc * c;
    F h00 = -(a * t00 + b * t10), h01 = -(a * t01 + b * t11), h11 = -(b * t01 + c * t11);
    Vec3<F> g_area;
    if (lens.antialias) {  // ln alpha holds ln(area / sqrt(det)); d ln sqrt(det) / dcov = conic / 2
        const F half = F(-0.5) * s.g;
        h00 = h00 + half * a, h01 = h01 + half * b, h11 = h11 + half * c;
        g_area = p.area * (s.g / (dot(p.area, p.area) + F(kLeastArea2)));
    }

    // Covariance to its factor m = n * scale.
    Vec3<F> gm0 = (p.m0 * h00 + p.m1 * h01) * F(2);
    Vec3<F> gm1 = (p.m0 * h01 + p.m1 * h11) * F(2);
    if (lens.antialias) gm0 += cross(p.m1, g_area), gm1 += cross(g_area, p.m0);
    out.log_scale = gm0 * p.m0 + gm1 * p.m1;
    const Vec3<F> gn0 = gm0 * p.scale, gn1 = gm1 * p.scale;

    Mat3<F> g_camera_from_local;
    Vec3<F> gp = lens.equirect() ? detail::equirect_grad(lens, p, screen, gn0, gn1, g_camera_from_local)
                                 : detail::pinhole_grad(lens, p, screen, gn0, gn1, g_camera_from_local);
    if (lens.equirect()) gp += p.p_camera * (s.depth / p.depth);
    else gp.z = gp.z + s.depth;
    const Mat3<F> world_from_camera = transpose(lens.rotation);
    out.mean = world_from_camera * gp;

    out.rotation = detail::quaternion_grad(in.rotation, world_from_camera * g_camera_from_local);
    out.logit = s.g * (F(1) - p.opacity);
    out.sh0 = {select(p.color_raw.x > F(0), s.color.x * F(kSh0), F(0)),
               select(p.color_raw.y > F(0), s.color.y * F(kSh0), F(0)),
               select(p.color_raw.z > F(0), s.color.z * F(kSh0), F(0))};
    return out;
}

}  // namespace fastscene::splat
