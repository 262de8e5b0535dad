// Projection of a Gaussian (Zwicker et al. 2001, EWA splatting; Kerbl et al. 2023, section 4), written once as a
// template over the number type F: double and Jet in tests, Lanes (16 Gaussians at a time) in production.
#pragma once

#include "fastscene/geometry/pinhole.h"
#include "fastscene/math/rigid.h"
#include "fastscene/scene/splats.h"
#include "fastscene/scene/view.h"
#include "fastscene/splat/camera_slopes.h"
#include "fastscene/splat/number.h"

namespace fastscene::splat {

inline constexpr float kNearM = 0.1f;          // near plane: closer splats are culled, as the linearization breaks down
inline constexpr double kLeastArea2 = 1e-12;   // px^4: keeps the logarithm finite for vanishing splats
inline constexpr float kMinAlpha = 1.f / 255;  // weaker contributions are invisible in 8 bits
inline constexpr float kMaxAlpha = 0.99f;      // bounds 1 / (1 - alpha) in the backward pass
inline constexpr double kLog2E = 1.4426950408889634;
inline constexpr double kLog2Of255 = 7.9943534368588579;

template <class F>
struct Gaussian {
    Vec3<F> mean, log_scale;
    Quat<F> rotation;
    F logit{};
    Vec3<F> sh0;
};
inline constexpr int kParameters = 14;
inline constexpr int kLogit = 10;  // index of the opacity among them

// camera_from_world and the intrinsics. Pinhole: the slopes x/z used in the linearization are clamped to [min_u,
// max_u], because far outside the picture the tangent plane is a poor approximation. Equirectangular: fx and fy are
// pixels per radian of longitude and latitude, (cx, cy) the picture's center.
template <class F>
struct Lens {
    Mat3<F> rotation;
    Vec3<F> translation;
    F fx, fy, cx, cy;
    F min_u, max_u, min_v, max_v;
    CameraModel model = CameraModel::pinhole;
    // Compensates the opacity for the low-pass dilation (Mip-Splatting's 2D filter, Yu et al. 2024): splats smaller
    // than a pixel do not get brighter with distance.
    bool antialias = false;
    F low_pass_px2 = F(FootprintFilter{}.low_pass_px2);

    bool equirect() const { return model == CameraModel::equirectangular; }
    Vec3<F> camera_center() const { return -(transpose(rotation) * translation); }
};

// What blending needs: alpha(px, py) = exp2(log2_opacity + a dx^2 + b dx dy + c dy^2).
template <class F>
struct Footprint {
    F x, y;  // pixels
    F a, b, c;
    F log2_opacity;
    Vec3<F> color;
    F depth_z;  // for equirectangular pictures the range along the ray
};

// The projection with its intermediates, which the gradient reuses.
template <class F>
struct Projection {
    Vec3<F> p_camera;
    F inv_z, u, v, u_held, v_held;  // pinhole
    CameraSlopes<F> slopes;         // rows of J = d(px, py) / d(p_camera)
    F depth;                        // sort key: depth_z, or range for equirectangular pictures
    F x, y;                         // pixels
    Mat3<F> camera_from_local;
    Vec3<F> scale;
    Vec3<F> n0, n1;               // rows of J * camera_from_local
    Vec3<F> m0, m1;               // the same scaled: covariance = m m^T + low-pass
    F cov_xx, cov_xy, cov_yy;     // pixels^2
    F conic_a, conic_b, conic_c;  // its inverse
    Vec3<F> area;                 // m0 x m1
    F opacity, log2_opacity;      // the latter includes the antialiasing compensation
    Vec3<F> color_raw, color;     // before and after clamping at 0
};

template <class F>
F held(F x, F low, F high) {
    return select(x < low, low, select(x > high, high, x));
}

namespace detail {

template <class F>
void project_pinhole(Projection<F>& o, const Lens<F>& lens) {
    o.inv_z = F(1) / o.p_camera.z;
    o.u = o.p_camera.x * o.inv_z;
    o.v = o.p_camera.y * o.inv_z;
    o.u_held = held(o.u, lens.min_u, lens.max_u);
    o.v_held = held(o.v, lens.min_v, lens.max_v);
    o.x = lens.fx * o.u + lens.cx;
    o.y = lens.fy * o.v + lens.cy;
    o.depth = o.p_camera.z;
    const Mat3<F>& w = o.camera_from_local;
    o.n0 = (w.row0 - w.row2 * o.u_held) * (lens.fx * o.inv_z);
    o.n1 = (w.row1 - w.row2 * o.v_held) * (lens.fy * o.inv_z);
}

template <class F>
void project_equirect(Projection<F>& o, const Lens<F>& lens) {
    o.slopes = equirect_slopes(o.p_camera, lens.fx, lens.fy);
    const Vec2<F> at = equirect_angles(o.p_camera, o.slopes);
    o.x = lens.cx + lens.fx * at.x;
    o.y = lens.cy - lens.fy * at.y;
    o.depth = o.slopes.range;
    o.n0 = o.slopes.row_x.x * o.camera_from_local.row0 + o.slopes.row_x.z * o.camera_from_local.row2;
    o.n1 = o.slopes.row_y.x * o.camera_from_local.row0 + o.slopes.row_y.y * o.camera_from_local.row1 +
           o.slopes.row_y.z * o.camera_from_local.row2;
}

}  // namespace detail

// `more_color` is the contribution of SH degrees >= 1 (sh_color.h).
template <class F>
Projection<F> project(const Gaussian<F>& g, const Lens<F>& lens, Vec3<F> more_color = {}) {
    using std::exp;
    using std::log2;
    Projection<F> o;
    o.p_camera = lens.rotation * g.mean + lens.translation;
    o.camera_from_local = lens.rotation * matrix_of(g.rotation);
    o.scale = {exp(g.log_scale.x), exp(g.log_scale.y), exp(g.log_scale.z)};
    if (lens.equirect()) detail::project_equirect(o, lens);
    else detail::project_pinhole(o, lens);
    o.m0 = o.n0 * o.scale;
    o.m1 = o.n1 * o.scale;
    const F low_pass = lens.low_pass_px2;
    o.cov_xx = dot(o.m0, o.m0) + low_pass;
    o.cov_xy = dot(o.m0, o.m1);
    o.cov_yy = dot(o.m1, o.m1) + low_pass;

    // det(m m^T) as a squared cross product is exact even for needles, where xx yy - xy^2 cancels.
    o.area = cross(o.m0, o.m1);
    const F trace = o.cov_xx + o.cov_yy - F(2) * low_pass;
    const F area2 = dot(o.area, o.area);
    const F det = area2 + low_pass * trace + low_pass * low_pass;
    const F inv_det = F(1) / det;
    o.conic_a = o.cov_yy * inv_det;
    o.conic_b = -(o.cov_xy * inv_det);
    o.conic_c = o.cov_xx * inv_det;

    const F odds_against = exp(-g.logit);
    o.opacity = F(1) / (F(1) + odds_against);
    o.log2_opacity = -log2(F(1) + odds_against);
    if (lens.antialias) o.log2_opacity = o.log2_opacity + F(0.5) * log2((area2 + F(kLeastArea2)) * inv_det);
    o.color_raw = g.sh0 * F(kSh0) + Vec3<F>{F(0.5), F(0.5), F(0.5)} + more_color;
    o.color = {select(o.color_raw.x > F(0), o.color_raw.x, F(0)), select(o.color_raw.y > F(0), o.color_raw.y, F(0)),
               select(o.color_raw.z > F(0), o.color_raw.z, F(0))};
    return o;
}

template <class F>
Footprint<F> footprint_of(const Projection<F>& p, const Lens<F>& lens) {
    (void)lens;
    return {p.x,
            p.y,
            F(-0.5 * kLog2E) * p.conic_a,
            F(-kLog2E) * p.conic_b,
            F(-0.5 * kLog2E) * p.conic_c,
            p.log2_opacity,
            p.color,
            p.depth};
}

// Squared Mahalanobis radius at which alpha falls to kMinAlpha; not positive for splats that are too faint to be
// visible.
template <class F>
F reach2_of(const Projection<F>& p) {
    return F(2 / kLog2E) * (p.log2_opacity + F(kLog2Of255));
}

// Whether the splat can be drawn. Written so that NaN, infinity and degenerate rotations fail.
template <class F>
auto is_drawable(const Gaussian<F>& g, const Projection<F>& p) {
    const Quat<F>& q = g.rotation;
    const F q2 = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    const F color = p.color_raw.x * p.color_raw.x + p.color_raw.y * p.color_raw.y + p.color_raw.z * p.color_raw.z;
    return (p.depth > F(kNearM)) & (p.depth < F(1e6f)) & (q2 > F(1e-20f)) & (q2 < F(1e20f)) & (p.cov_xx < F(1e10f)) &
           (p.cov_yy < F(1e10f)) & (p.conic_a > F(0)) & (p.conic_c > F(0)) & (reach2_of(p) > F(0)) & (color < F(1e8f));
}

}  // namespace fastscene::splat
