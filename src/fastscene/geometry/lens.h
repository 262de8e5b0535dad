// Lens models of reconstruction programs (COLMAP's names and formulas) behind one interface: the projection of a
// direction to the picture, which is all that undistortion needs. Camera frame: x right, y down, z forward.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/geometry/pinhole.h"

namespace fastscene {

enum class LensKind {
    perspective,  // Brown-Conrady: radial and tangential distortion; all zero: a pinhole
    fisheye,      // equidistant with a polynomial in the angle; tangential and prism distortion of the angle
    // the same, but tangential and prism distortion follow the polynomial (Project Aria's Fisheye624)
    fisheye_radial_first,
    field_of_view,    // FOV model, one parameter (Devernay and Faugeras)
    division,         // division model, one parameter (Fitzgibbon)
    unified,          // EUCM, two parameters (Khomutenko, Garcia and Martinet)
    equirectangular,  // the whole sphere (geometry/sphere.h)
};

struct Lens {
    LensKind kind = LensKind::perspective;
    int width = 0, height = 0;
    double fx = 0, fy = 0, cx = 0, cy = 0;  // pixels
    // Radial parameters. Perspective: k1 k2 k3 over k4 k5 k6; fisheye: k1 … k6; field of view: omega; division: k;
    // unified: alpha, beta.
    std::array<double, 6> k{};
    double p1 = 0, p2 = 0;      // tangential
    std::array<double, 4> s{};  // thin prism: s0 r^2 + s1 r^4 to the right, s2 r^2 + s3 r^4 down

    bool is_pinhole() const;
    // The undistorted camera with the same focal lengths and principal point.
    Pinhole pinhole() const;
    // The same lens for a resized picture.
    Lens resized(int new_width, int new_height) const;
    // Tangent of the maximum angle to the axis up to which the radial distortion is monotonic; beyond, projections are
    // ambiguous. Found by a linear search; infinite for a pinhole.
    double reach() const;
    // Projects a direction. None behind a perspective camera, or beyond `reach` (from reach()).
    std::optional<Vec2d> pixel_of(Vec3d direction, double reach) const;
    friend bool operator==(const Lens&, const Lens&) = default;
};

// COLMAP's camera models by name or id, with their number of parameters. Empty: unknown or unsupported.
struct LensModel {
    std::string_view name;
    int id;
    std::size_t parameters;
};
std::optional<LensModel> lens_model(std::string_view name);
std::optional<LensModel> lens_model(int id);
// All names, for messages.
std::string lens_model_names();
// `parameters` in COLMAP's order, as many as the model has.
Lens lens_of(const LensModel& model, int width, int height, const std::vector<double>& parameters);

}  // namespace fastscene
