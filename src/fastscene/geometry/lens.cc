#include "fastscene/geometry/lens.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/base/check.h"
#include "fastscene/geometry/sphere.h"

namespace fastscene {
namespace {

constexpr LensModel kModels[] = {{"SIMPLE_PINHOLE", 0, 3},
                                 {"PINHOLE", 1, 4},
                                 {"SIMPLE_RADIAL", 2, 4},
                                 {"RADIAL", 3, 5},
                                 {"OPENCV", 4, 8},
                                 {"OPENCV_FISHEYE", 5, 8},
                                 {"FULL_OPENCV", 6, 12},
                                 {"FOV", 7, 5},
                                 {"SIMPLE_RADIAL_FISHEYE", 8, 4},
                                 {"RADIAL_FISHEYE", 9, 5},
                                 {"THIN_PRISM_FISHEYE", 10, 12},
                                 {"RAD_TAN_THIN_PRISM_FISHEYE", 11, 16},
                                 {"SIMPLE_DIVISION", 12, 4},
                                 {"DIVISION", 13, 5},
                                 {"SIMPLE_FISHEYE", 14, 3},
                                 {"FISHEYE", 15, 4},
                                 {"EUCM", 16, 6},
                                 {"EQUIRECTANGULAR", 17, 2}};

// Ratio of distorted to undistorted radius (tangent of the angle) in a perspective lens.
double radial(const std::array<double, 6>& k, double r2) {
    return (1 + r2 * (k[0] + r2 * (k[1] + r2 * k[2]))) / (1 + r2 * (k[3] + r2 * (k[4] + r2 * k[5])));
}
double fisheye_radius(const std::array<double, 6>& k, double angle) {
    double factor = 1, power = 1;
    for (const double coefficient : k) factor += coefficient * (power *= angle * angle);
    return angle * factor;
}

// Tangential and thin prism distortion at a point. p1 and p2 in OpenCV's order.
Vec2d sideways(const Lens& lens, Vec2d at) {
    const double r2 = at.x * at.x + at.y * at.y, r4 = r2 * r2;
    return {2 * lens.p1 * at.x * at.y + lens.p2 * (r2 + 2 * at.x * at.x) + lens.s[0] * r2 + lens.s[1] * r4,
            2 * lens.p2 * at.x * at.y + lens.p1 * (r2 + 2 * at.y * at.y) + lens.s[2] * r2 + lens.s[3] * r4};
}

// Distorted radius of a ray whose angle to the axis has the tangent r, by radial distortion alone.
double bent_radius(const Lens& lens, double r) {
    const std::array<double, 6>& k = lens.k;
    switch (lens.kind) {
        case LensKind::perspective: return r * radial(k, r * r);
        case LensKind::fisheye:
        case LensKind::fisheye_radial_first: return fisheye_radius(k, std::atan(r));
        case LensKind::field_of_view: return std::fabs(k[0]) < 1e-9 ? r : std::atan(2 * r * std::tan(k[0] / 2)) / k[0];
        case LensKind::division: return 2 * r / (1 + std::sqrt(std::max(0.0, 1 - 4 * k[0] * r * r)));
        case LensKind::unified: return r / (k[0] * std::sqrt(k[1] * r * r + 1) + 1 - k[0]);
        case LensKind::equirectangular: break;
    }
    return r;
}

}  // namespace

bool Lens::is_pinhole() const {
    const auto none = [](const auto& values) {
        return std::all_of(values.begin(), values.end(), [](double v) { return v == 0; });
    };
    return kind == LensKind::perspective && p1 == 0 && p2 == 0 && none(k) && none(s);
}

Pinhole Lens::pinhole() const {
    return {
        width, height, static_cast<float>(fx), static_cast<float>(fy), static_cast<float>(cx), static_cast<float>(cy)};
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
    constexpr double kAll = std::numeric_limits<double>::infinity();
    // the square root is undefined beyond
    if (kind == LensKind::division) return k[0] > 0 ? 0.5 / std::sqrt(k[0]) : kAll;
    if (is_pinhole() || kind == LensKind::equirectangular || kind == LensKind::field_of_view ||
        kind == LensKind::unified)
        return kAll;
    double before = 0;
    for (double r = kStep; r < kFarthest; r += kStep * std::max(1.0, r)) {
        const double now = bent_radius(*this, r);
        if (!(now > before)) return r - kStep;
        before = now;
    }
    return kAll;
}

std::optional<Vec2d> Lens::pixel_of(Vec3d d, double reach) const {
    if (kind == LensKind::equirectangular) return pixel_of_direction(d, {width, height});
    if (!(d.z > 0)) return {};
    const Vec2d straight{d.x / d.z, d.y / d.z};
    const double r = std::sqrt(straight.x * straight.x + straight.y * straight.y);
    if (!(r <= reach)) return {};
    const Vec2d radially = r > 1e-12 ? straight * (bent_radius(*this, r) / r) : straight;
    Vec2d at = radially;
    if (kind == LensKind::perspective) at = at + sideways(*this, straight);
    if (kind == LensKind::fisheye) at = at + sideways(*this, r > 1e-12 ? straight * (std::atan(r) / r) : straight);
    if (kind == LensKind::fisheye_radial_first) at = at + sideways(*this, radially);
    return Vec2d{fx * at.x + cx, fy * at.y + cy};
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
    const bool one_focal = name.starts_with("SIMPLE") || name == "RADIAL" || name == "RADIAL_FISHEYE";
    std::size_t at = 0;
    lens.fx = p[at++];
    lens.fy = one_focal ? lens.fx : p[at++];
    lens.cx = p[at++], lens.cy = p[at++];
    if (name.ends_with("FISHEYE")) lens.kind = LensKind::fisheye;
    if (name == "FOV") lens.kind = LensKind::field_of_view;
    if (name.ends_with("DIVISION")) lens.kind = LensKind::division;
    if (name == "EUCM") lens.kind = LensKind::unified;
    if (name == "RAD_TAN_THIN_PRISM_FISHEYE") {  // k0 … k5 p0 p1 s0 … s3; its p0 is OpenCV's p2
        lens.kind = LensKind::fisheye_radial_first;
        for (double& k : lens.k) k = p[at++];
        lens.p2 = p[at++], lens.p1 = p[at++];
        for (double& s : lens.s) s = p[at++];
    } else if (name == "OPENCV" || name == "FULL_OPENCV" || name == "THIN_PRISM_FISHEYE") {
        lens.k[0] = p[at++], lens.k[1] = p[at++], lens.p1 = p[at++], lens.p2 = p[at++];
        const bool prism = name == "THIN_PRISM_FISHEYE";  // k3 k4 sx1 sy1
        for (std::size_t i = 2; at < p.size() && !(prism && i == 4); ++i) lens.k[i] = p[at++];
        if (prism) lens.s[0] = p[at++], lens.s[2] = p[at++];
    } else {
        for (std::size_t i = 0; at < p.size(); ++i) lens.k[i] = p[at++];
    }
    return lens;
}

}  // namespace fastscene
