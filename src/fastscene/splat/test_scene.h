// Small scenes for this module's tests.
#pragma once

#include <vector>

#include "fastscene/base/random.h"
#include "fastscene/scene/splats.h"
#include "fastscene/scene/view.h"
#include "fastscene/splat/engine.h"
#include "fastscene/splat/reference.h"

namespace fastscene::splat {

// Splats of all sizes, shapes and opacities in front of the camera at the origin, some partly outside.
inline Splats random_splats(int count, std::uint64_t seed) {
    Splats s;
    s.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        Random r(seed, "test.splats", static_cast<std::uint64_t>(i));
        const auto k = static_cast<std::size_t>(i);
        const float z = r.uniform(1.f, 4.f);
        s.mean_m[k] = {r.uniform(-1.1f, 1.1f) * z, r.uniform(-1.1f, 1.1f) * z, z};
        for (std::size_t a = 0; a < 3; ++a) s.log_scale[k][a] = r.uniform(-4.5f, -0.7f);
        s.rotation[k] = {r.normal(), r.normal(), r.normal(), r.normal()};
        s.opacity_logit[k] = r.uniform(-3.f, 2.5f);
        s.sh0[k] = {r.uniform(-1.f, 1.5f), r.uniform(-1.f, 1.5f), r.uniform(-1.f, 1.5f)};
    }
    return s;
}
// A non-square picture with its principal point off center: nothing may assume symmetry.
inline Pinhole test_camera(int width = 61, int height = 45) {
    return {width,
            height,
            0.55f * static_cast<float>(width),
            0.5f * static_cast<float>(width),
            0.43f * static_cast<float>(width),
            0.56f * static_cast<float>(height)};
}
inline Rigid test_pose() { return {rotation_about(normalize(Vec3f{0.3f, 1.f, -0.2f}), 0.2f), {0.1f, -0.05f, -0.2f}}; }
inline std::vector<Vec3d> random_color_gradient(const Pinhole& camera, std::uint64_t seed) {
    std::vector<Vec3d> v;
    Random r(seed, "test.v");
    for (int i = 0; i < camera.width * camera.height; ++i) v.push_back({r.normal(), r.normal(), r.normal()});
    return v;
}
template <class F>
F& parameter(Gaussian<F>& g, int p) {
    if (p < 3) return g.mean[static_cast<std::size_t>(p)];
    if (p < 6) return g.log_scale[static_cast<std::size_t>(p - 3)];
    if (p < 10) return p == 6 ? g.rotation.w : p == 7 ? g.rotation.x : p == 8 ? g.rotation.y : g.rotation.z;
    return p == 10 ? g.logit : g.sh0[static_cast<std::size_t>(p - 11)];
}
// |a - b| / |b| of two lists as vectors.
struct Distance {
    double difference2 = 0, size2 = 0;
    void add(double a, double b) { difference2 += (a - b) * (a - b), size2 += b * b; }
    double relative() const { return std::sqrt(difference2 / std::max(size2, 1e-300)); }
};
inline View noise_view(const Pinhole& camera, const Rigid& pose, std::uint64_t seed, bool weighted) {
    View view{"noise.png", camera, pose, ImageRgb8(camera.width, camera.height), {}};
    Random r(seed, "test.view");
    for (Rgb8& p : view.color.pixels)
        p = {static_cast<std::uint8_t>(r.index(256)), static_cast<std::uint8_t>(r.index(256)),
             static_cast<std::uint8_t>(r.index(256))};
    if (weighted) {
        view.weight = ImageMask(camera.width, camera.height);
        for (auto& w : view.weight.pixels) w = static_cast<std::uint8_t>(r.index(4) * 85);
    }
    return view;
}

}  // namespace fastscene::splat
