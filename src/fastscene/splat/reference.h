// The reference implementation: the same mathematics, one splat and one pixel at a time, over any number type. Slow,
// without tiles, early termination or approximations. The kernels' results and gradients are tested against it.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "fastscene/scene/splats.h"
#include "fastscene/scene/view.h"
#include "fastscene/splat/blend_grad.h"
#include "fastscene/splat/project_grad.h"
#include "fastscene/splat/sh_color.h"

namespace fastscene::splat {

template <class F>
struct ReferencePicture {
    int width = 0, height = 0;
    std::vector<PixelState<F>> pixels;
    std::vector<F> depth_sum;
};

// SH coefficients of degrees >= 1, 3 * rest_functions(degree) per splat, in the order of Splats::sh_rest.
template <class F>
struct RestBands {
    int degree = 0;
    std::vector<F> values;
    auto of(std::size_t splat) const {
        return [this, at = splat * 3 * static_cast<std::size_t>(rest_functions(degree))](int i) {
            return values[at + static_cast<std::size_t>(i)];
        };
    }
};

namespace detail {
template <class F>
struct Drawn {
    std::size_t splat;
    Projection<F> projection;
    Footprint<F> footprint;
    double half_x, half_y;  // of the box outside of which alpha < kMinAlpha
};
inline double plain(double x) { return x; }
template <class F>
double plain(F x) {
    return x.value;
}
// Drawable splats, front to back, stable.
template <class F>
std::vector<Drawn<F>> draw_order(const std::vector<Gaussian<F>>& splats, const Lens<F>& lens,
                                 const RestBands<F>& rest) {
    std::vector<Drawn<F>> out;
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const Projection<F> p = project(
            splats[i], lens, more_color(rest.degree, sight_of(splats[i].mean, lens.camera_center()), rest.of(i)));
        if (!is_drawable(splats[i], p)) continue;
        const double reach2 = plain(reach2_of(p));
        out.push_back(
            {i, p, footprint_of(p, lens), std::sqrt(reach2 * plain(p.cov_xx)), std::sqrt(reach2 * plain(p.cov_yy))});
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const auto& a, const auto& b) { return a.footprint.depth_z < b.footprint.depth_z; });
    return out;
}
// Calls visit(pixel index, dx, dy) for every pixel in the splat's box, shifted right by `aside` pixels.
template <class F, class Visit>
void each_pixel_aside(const Drawn<F>& d, int width, int height, double aside, Visit&& visit) {
    const double x = plain(d.footprint.x) + aside, y = plain(d.footprint.y);
    const auto first = [](double v) { return static_cast<int>(std::max(0.0, std::floor(v - 0.5))); };
    const auto last = [](double v, int size) { return static_cast<int>(std::min(size - 1.0, std::ceil(v - 0.5))); };
    for (int py = first(y - d.half_y); py <= last(y + d.half_y, height); ++py)
        for (int px = first(x - d.half_x); px <= last(x + d.half_x, width); ++px)
            visit(static_cast<std::size_t>(py) * static_cast<std::size_t>(width) + static_cast<std::size_t>(px),
                  F(px + 0.5 - aside) - d.footprint.x, F(py + 0.5) - d.footprint.y);
}
template <class F, class Visit>
void each_pixel(const Drawn<F>& d, int width, int height, bool wraps, Visit&& visit) {
    each_pixel_aside(d, width, height, 0, visit);
    const double x = plain(d.footprint.x);
    if (!wraps) return;
    if (x - d.half_x < 0.5) each_pixel_aside(d, width, height, width, visit);
    else if (x + d.half_x > width - 0.5) each_pixel_aside(d, width, height, -width, visit);
}
}  // namespace detail

template <class F>
ReferencePicture<F> render_reference(const std::vector<Gaussian<F>>& splats, const Lens<F>& lens, int width, int height,
                                     Vec3<F> background, const RestBands<F>& rest = {}) {
    ReferencePicture<F> out{width, height, {}, {}};
    const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    out.pixels.assign(size, PixelState<F>{F(1), {}});
    out.depth_sum.assign(size, F(0));
    for (const auto& d : detail::draw_order(splats, lens, rest))
        detail::each_pixel(d, width, height, lens.equirect(), [&](std::size_t i, F dx, F dy) {
            out.depth_sum[i] += blend(out.pixels[i], d.footprint, raw_alpha(d.footprint, dx, dy)) * d.footprint.depth_z;
        });
    for (auto& pixel : out.pixels) pixel.color += background * pixel.transmittance;
    return out;
}

// dL/d(parameters) from v = dL/d(pixel color) and, if not empty, v_depth = dL/d(depth sum) and v_transmittance =
// dL/d(remaining transmittance). Splats deeper than `outside_m` get gradients only where the outside is visible.
template <class F>
std::vector<Gaussian<F>> gradients_reference(const std::vector<Gaussian<F>>& splats, const Lens<F>& lens,
                                             const ReferencePicture<F>& picture, const std::vector<Vec3<F>>& v,
                                             const RestBands<F>& rest = {}, std::vector<F>* rest_out = nullptr,
                                             const std::vector<F>& v_depth = {},
                                             const std::vector<F>& v_transmittance = {},
                                             F outside_m = std::numeric_limits<F>::infinity()) {
    std::vector<Gaussian<F>> out(splats.size());
    const auto n = static_cast<std::size_t>(3 * rest_functions(rest.degree));
    if (rest_out) rest_out->assign(splats.size() * n, F(0));
    for (auto& g : out) g.rotation.w = F(0);  // a gradient, not the identity rotation
    std::vector<PixelGradState<F>> state(v.size());
    for (std::size_t i = 0; i < v.size(); ++i) {
        const F z = v_depth.empty() ? F(0) : v_depth[i];
        const F open = v_transmittance.empty() ? F(0) : v_transmittance[i] * picture.pixels[i].transmittance;
        state[i] = {F(1), dot(v[i], picture.pixels[i].color) + z * picture.depth_sum[i] + open, v[i], z};
    }
    std::vector<F> shows;  // 1 or 0 a pixel, from the first splat of the outside on
    for (const auto& d : detail::draw_order(splats, lens, rest)) {
        if (shows.empty() && d.footprint.depth_z > outside_m)
            for (const auto& pixel : state) shows.push_back(pixel.transmittance > F(kOutsideVisible) ? F(1) : F(0));
        PixelSums<F> sums;
        detail::each_pixel(d, picture.width, picture.height, lens.equirect(), [&](std::size_t i, F dx, F dy) {
            const F alpha = shown_alpha(raw_alpha(d.footprint, dx, dy));
            BlendGrad<F> b = blend_grad<true>(state[i], d.footprint, alpha, odds_of(alpha));
            if (!shows.empty()) b.g *= shows[i], b.weight *= shows[i];
            sums.g += b.g;
            sums.g_dx += b.g * dx;
            sums.g_dy += b.g * dy;
            sums.g_dxdx += b.g * dx * dx;
            sums.g_dxdy += b.g * dx * dy;
            sums.g_dydy += b.g * dy * dy;
            sums.color += v[i] * b.weight;
            sums.depth += state[i].v_depth * b.weight;
        });
        out[d.splat] = project_grad(splats[d.splat], lens, d.projection, sums);
        if (rest.degree == 0) continue;
        F slopes[kMostRest];
        out[d.splat].mean += more_color_grad(rest.degree, sight_of(splats[d.splat].mean, lens.camera_center()),
                                             out[d.splat].sh0 / F(kSh0), rest.of(d.splat), slopes);
        if (rest_out) std::copy(slopes, slopes + n, rest_out->begin() + static_cast<std::ptrdiff_t>(d.splat * n));
    }
    return out;
}

template <class F>
std::vector<Gaussian<F>> gaussians_of(const Splats& s) {
    std::vector<Gaussian<F>> out;
    const auto wide = [](Vec3f a) { return Vec3<F>{F(a.x), F(a.y), F(a.z)}; };
    for (std::size_t i = 0; i < s.size(); ++i) {
        const Quatf q = s.rotation[i];
        out.push_back({wide(s.mean_m[i]),
                       wide(s.log_scale[i]),
                       {F(q.w), F(q.x), F(q.y), F(q.z)},
                       F(s.opacity_logit[i]),
                       wide(s.sh0[i])});
    }
    return out;
}
template <class F>
RestBands<F> rest_of(const Splats& s) {
    return {s.sh_degree, {s.sh_rest.begin(), s.sh_rest.end()}};
}
template <class F>
Lens<F> lens_over(const Lens<float>& l) {
    const auto wide = [](Vec3f a) { return Vec3<F>{F(a.x), F(a.y), F(a.z)}; };
    return {{wide(l.rotation.row0), wide(l.rotation.row1), wide(l.rotation.row2)},
            wide(l.translation),
            F(l.fx),
            F(l.fy),
            F(l.cx),
            F(l.cy),
            F(l.min_u),
            F(l.max_u),
            F(l.min_v),
            F(l.max_v),
            l.model,
            l.antialias,
            F(l.low_pass_px2)};
}

struct ReferenceLoss {
    double loss = 0, squared_error = 0;  // means over pixels and channels
    std::vector<Vec3d> v;                // dL/d(pixel color)
};
// (1 - lambda) L1 + lambda (1 - SSIM), windows summed directly: O(121) per pixel.
ReferenceLoss loss_reference(const std::vector<Vec3d>& picture, const View& view, double lambda);
// The depth regularizer (depth_loss.h); places the target behind the picture's depth sums. v_depth = dL/d(depth sum).
double depth_loss_reference(ReferencePicture<double>& picture, const View& view, const ImageF& depth, double strength,
                            std::vector<double>& v_depth);
// `strength` times the mean remaining transmittance.
double transmittance_loss_reference(const ReferencePicture<double>& picture, const View& view, double strength,
                                    std::vector<double>& v_transmittance);

}  // namespace fastscene::splat
