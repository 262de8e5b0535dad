#include "fastscene/geometry/lens.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/base/check.h"
#include "fastscene/geometry/sphere.h"

namespace fastscene {
namespace {

constexpr LensModel kModels[] = {
    {"SIMPLE_PINHOLE", 0, 3}, {"PINHOLE", 1, 4},        {"SIMPLE_RADIAL", 2, 4}, {"RADIAL", 3, 5},
    {"OPENCV", 4, 8},         {"OPENCV_FISHEYE", 5, 8}, {"FULL_OPENCV", 6, 12},  {"FOV", 7, 5},
    {"SIMPLE_RADIAL_FISHEYE", 8, 4}, {"RADIAL_FISHEYE", 9, 5}, {"EQUIRECTANGULAR", 17, 2}};

// Distorted radius per undistorted radius (tangent of the angle) in a perspective lens.
double radial(const std::array<double, 6>& k, double r2) {
    return (1 + r2 * (k[0] + r2 * (k[1] + r2 * k[2]))) / (1 + r2 * (k[3] + r2 * (k[4] + r2 * k[5])));
}
double fisheye_radius(const std::array<double, 6>& k, double angle) {
    const double a2 = angle * angle;
    return angle * (1 + a2 * (k[0] + a2 * (k[1] + a2 * (k[2] + a2 * k[3]))));
}

}  // namespace

bool Lens::is_pinhole() const {
    return kind == LensKind::perspective && p1 == 0 && p2 == 0 && std::all_of(k.begin(), k.end(), [](double v) { return v == 0; });
}

Pinhole Lens::pinhole() const {
    return {width, height, static_cast<float>(fx), static_cast<float>(fy), static_cast<float>(cx), static_cast<float>(cy)};
}

Lens Lens::resized(int new_width, int new_height) const {
    Lens out = *this;
    const double sx = static_cast<double>(new_width) / width, sy = static_cast<double>(new_height) / height;
    out.width = new_width, out.height = new_height;
    out.fx *= sx, out.cx *= sx, out.fy *= sy, out.cy *= sy;
    return out;
}

double Lens::reach() const {
    constexpr double kFarthest = 20, kStep = 1e-3;  // 87 degrees
    if (is_pinhole() || kind == LensKind::equirectangular || kind == LensKind::field_of_view) return std::numeric_limits<double>::infinity();
    const auto radius = [&](double r) { return kind == LensKind::fisheye ? fisheye_radius(k, std::atan(r)) : r * radial(k, r * r); };
    double before = 0;
    for (double r = kStep; r < kFarthest; r += kStep * std::max(1.0, r)) {
        const double now = radius(r);
        if (!(now > before)) return r - kStep;
        before = now;
    }
    return std::numeric_limits<double>::infinity();
}

std::optional<Vec2d> Lens::pixel_of(Vec3d d, double reach) const {
    if (kind == LensKind::equirectangular) return pixel_of_direction(d, {width, height});
    if (!(d.z > 0)) return {};
    double u = d.x / d.z, v = d.y / d.z;
    const double r2 = u * u + v * v, r = std::sqrt(r2);
    if (!(r <= reach)) return {};
    if (kind == LensKind::perspective) {
        const double scale = radial(k, r2), x = u, y = v;
        u = x * scale + 2 * p1 * x * y + p2 * (r2 + 2 * x * x);
        v = y * scale + 2 * p2 * x * y + p1 * (r2 + 2 * y * y);
    } else if (r > 1e-12) {
        // The lens of Devernay and Faugeras: atan(2 r tan(omega / 2)) / omega.
        const double bent = kind == LensKind::fisheye ? fisheye_radius(k, std::atan(r))
                            : std::fabs(k[0]) < 1e-9  ? r
                                                      : std::atan(2 * r * std::tan(k[0] / 2)) / k[0];
        u *= bent / r, v *= bent / r;
    }
    return Vec2d{fx * u + cx, fy * v + cy};
}

std::optional<LensModel> lens_model(std::string_view name) {
    for (const LensModel& model : kModels)
        if (model.name == name) return model;
    return {};
}
std::optional<LensModel> lens_model(int id) {
    for (const LensModel& model : kModels)
        if (model.id == id) return model;
    return {};
}
std::string lens_model_names() {
    std::string out;
    for (const LensModel& model : kModels) out += (out.empty() ? "" : ", ") + std::string(model.name);
    return out;
}

Lens lens_of(const LensModel& model, int width, int height, const std::vector<double>& p) {
    FASTSCENE_CHECK_EQ(p.size(), model.parameters);
    Lens lens;
    lens.width = width, lens.height = height;
    const std::string_view name = model.name;
    if (name == "EQUIRECTANGULAR") return lens.kind = LensKind::equirectangular, lens;
    const bool one_focal = name.starts_with("SIMPLE") || name.starts_with("RADIAL");
    std::size_t at = 0;
    lens.fx = p[at++];
    lens.fy = one_focal ? lens.fx : p[at++];
    lens.cx = p[at++], lens.cy = p[at++];
    if (name.ends_with("FISHEYE")) lens.kind = LensKind::fisheye;
    if (name == "FOV") lens.kind = LensKind::field_of_view;
    if (name == "OPENCV" || name == "FULL_OPENCV") {
        lens.k[0] = p[at++], lens.k[1] = p[at++], lens.p1 = p[at++], lens.p2 = p[at++];
        for (std::size_t i = 2; at < p.size(); ++i) lens.k[i] = p[at++];
    } else {
        for (std::size_t i = 0; at < p.size(); ++i) lens.k[i] = p[at++];
    }
    return lens;
}

}  // namespace fastscene
