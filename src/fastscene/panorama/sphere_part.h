// Where a user's picture lies on the sphere: a whole sphere, a crop of one, a cylinder, a cube. Resamples any of them
// to a whole level sphere, whose parts without picture are holes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/base/fields.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"
#include "fastscene/io/gpano.h"
#include "fastscene/math/rigid.h"

namespace fastscene {

// What the user says about the picture; all optional.
struct PictureLayout {
    std::string projection = "auto";
    double fov_deg = 0, vertical_fov_deg = 0;  // 0: from the file, or by the shape
    bool keep_tilt = false;
};
template <class V>
void visit_fields(PictureLayout& p, V&& v) {
    v("projection", p.projection, Choices{{"auto", "sphere", "cylinder", "cube"}},
      "--panorama FILE: its projection. sphere: equirectangular; cylinder; cube: six faces in a row, a 4x3 cross, or a "
      "folder of six files; auto: by the file's XMP and shape.");
    v("fov-deg", p.fov_deg, Bounds{0, 360},
      "--panorama FILE: horizontal angle that it covers, for parts of a panorama without XMP; 0: all around, or by the "
      "XMP.");
    v("vertical-fov-deg", p.vertical_fov_deg, Bounds{0, 180},
      "--panorama FILE: vertical angle that it covers, half above and half below the horizon; 0: by its shape and the "
      "horizontal angle, or by the XMP.");
    v("keep-tilt", p.keep_tilt, "--panorama FILE: do not level it by the pitch and roll in its XMP.");
}

struct SpherePart {
    enum class Kind { sphere, cylinder, row, column, cross } kind = Kind::sphere;
    int width = 0, height = 0;  // of the picture, upright
    // sphere and cylinder: longitude at the left edge, angle from edge to edge, rightward.
    double left = 0, across = 0;
    // sphere: latitude at the upper edge, angle from edge to edge, downward.
    double top = 0, down = 0;
    double horizon_px = 0, focal_px = 0;  // cylinder: row of the horizon, and pixels a unit of the latitude's tangent
    Mat3d level_from_picture;             // turns the picture's directions upright
    std::vector<std::string> remarks;

    bool is_cube() const { return kind == Kind::row || kind == Kind::column || kind == Kind::cross; }
    // The picture is the whole level sphere already.
    bool is_whole() const;
    // Of the whole sphere at the picture's resolution; even.
    EquirectSize size() const;
};

// Throws Error naming the file and its size if nothing says where it lies. `size`: upright, from the header.
SpherePart sphere_part(const std::filesystem::path& file, EquirectSize size, const std::optional<GPano>& gpano,
                       const PictureLayout& layout);

// A whole sphere. `missing`: nonzero where the picture has nothing; empty if it covers everything.
template <class Pixel>
struct WholeSphere {
    Image<Pixel> color;
    ImageMask missing;
};
WholeSphere<Rgb8> whole_sphere(const ImageRgb8& picture, const SpherePart& part);
WholeSphere<Vec3f> whole_sphere(const ImageColor& picture, const SpherePart& part);

// Whether the corners of a 4x3 picture are blank, as around the cross of a cube.
bool has_blank_corners(const ImageRgb8& picture);
// Two round pictures side by side, unstitched.
bool looks_like_two_fisheyes(const ImageRgb8& picture);
// Parts that nobody photographed, as masks: where alpha says so, and black borders of a sphere. Empty: none.
ImageMask black_borders(const ImageRgb8& picture);

}  // namespace fastscene
