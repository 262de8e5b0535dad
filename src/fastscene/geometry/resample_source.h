// Projection of directions into spherical pictures, and the pixels that contribute to a sample. Private to geometry/.
#pragma once

#include "fastscene/geometry/resample.h"

namespace fastscene {

struct SourceTap {
    std::int32_t pixel;
    float weight;
};
// The position of a direction in the source.
struct SourcePlace {
    Vec2f pixel;   // picture point within the part, pixel centers at +0.5
    int part = 0;  // face of a cubemap, else 0
    float weight = 1;
};

// Unit direction (world) through a picture point of the target.
Vec3f direction_in(const SpherePicture& picture, Vec2f point);
// Positions of a world direction, at most six; none if a perspective source does not show it.
int places_of(const SpherePicture& source, Vec3f direction, float feather_deg, std::array<SourcePlace, 6>& out);
// Minimum angle between neighbouring pixels around a position, radians.
float pitch_at(const SpherePicture& source, Vec3f direction);
// How much closer neighbours in a row of an equirectangular source are than `pitch_at`: at least 1, unbounded at the
// poles.
float crowding(const SpherePicture& source, Vec3f direction);
// Number of columns of an equirectangular source that a target pixel (given by its top left corner) spans from left to
// right, and from top to bottom.
Vec2f columns_across(const SpherePicture& source, const SpherePicture& target, Vec2f corner);
// Angular width and height, in radians, of the target's pixel in the given direction.
Vec2f pixel_angles(const SpherePicture& target, Vec3f direction);
// Whether all pixels of the neighbourhood (side: 1 nearest, 2 bilinear, 4 bicubic) are in the part itself.
bool is_inside(const SpherePicture& source, const SourcePlace& place, int side);
// Appends the neighbourhood's pixels.
void add_taps(const SpherePicture& source, const SourcePlace& place, int side, std::vector<SourceTap>& taps);

// Catmull-Rom weights of the four pixels around a position t between the middle two.
inline std::array<float, 4> catmull_rom(float t) {
    return {t * (-0.5f + t * (1.f - 0.5f * t)), 1.f + t * t * (-2.5f + 1.5f * t), t * (0.5f + t * (2.f - 1.5f * t)),
            t * t * (-0.5f + 0.5f * t)};
}

}  // namespace fastscene
