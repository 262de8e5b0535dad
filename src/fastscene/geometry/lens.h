// Lens: the camera models that reconstruction programs write (COLMAP's names and formulas), seen as one: where on its
// picture does a direction land? Undistorting a picture needs nothing more. Camera frame: x right, y down, z forward.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/geometry/pinhole.h"

namespace fastscene {

enum class LensKind {
    perspective,  // Brown's radial and tangential distortion; all zero: a pinhole
    fisheye,      // equidistant: the angle to the axis, with a polynomial; tangential and prism distortion of the angle
    fisheye_radial_first,  // the same, but what is tangential and prism comes after the polynomial (Project Aria's
                           // Fisheye624)
    field_of_view,         // Devernay and Faugeras' one parameter
    division,              // Fitzgibbon's one parameter
    unified,               // Khomutenko, Garcia and Martinet's two: EUCM
    equirectangular,       // the whole sphere (geometry/sphere.h)
};

struct Lens {
    LensKind kind = LensKind::perspective;
    int width = 0, height = 0;
    double fx = 0, fy = 0, cx = 0, cy = 0;  // pixels
    // Radial. Perspective: k1 k2 k3 over k4 k5 k6; fisheye: k1 … k6; field of view: omega; division: k; unified: alpha,
    // beta.
    std::array<double, 6> k{};
    double p1 = 0, p2 = 0;      // tangential
    std::array<double, 4> s{};  // thin prism: s0 r^2 + s1 r^4 to the right, s2 r^2 + s3 r^4 down

    bool is_pinhole() const;
    // The ideal camera of the same focal lengths and center.
    Pinhole pinhole() const;
    // The same lens on a picture of another size.
    Lens resized(int new_width, int new_height) const;
    // Tangent of the angle to the axis up to which the distortion grows: beyond it a direction would land where another
    // one does. Found by walking outward, by what is radial in it alone; infinite for a pinhole.
    double reach() const;
    // Picture point of a direction. Nothing behind a perspective camera, or beyond `reach` (as reach() says), lands.
    std::optional<Vec2d> pixel_of(Vec3d direction, double reach) const;
    friend bool operator==(const Lens&, const Lens&) = default;
};

// COLMAP's camera models by name or by number, each with its number of parameters. Absent: an unknown or unsupported
// one.
struct LensModel {
    std::string_view name;
    int id;
    std::size_t parameters;
};
std::optional<LensModel> lens_model(std::string_view name);
std::optional<LensModel> lens_model(int id);
// All names, for a message.
std::string lens_model_names();
// `parameters` in COLMAP's order, as many as the model has.
Lens lens_of(const LensModel& model, int width, int height, const std::vector<double>& parameters);

}  // namespace fastscene
