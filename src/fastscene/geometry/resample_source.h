// Where a direction lands in a picture of the sphere, and which pixels make up its color there. Private to geometry/.
#pragma once

#include "fastscene/geometry/resample.h"

namespace fastscene {

struct SourceTap {
    std::int32_t pixel;
    float weight;
};
// A direction's place in the source.
struct SourcePlace {
    Vec2f pixel;   // picture point in the part, pixel centers at +0.5
    int part = 0;  // face of a cube, else 0
    float weight = 1;
};

// Unit direction (world) through a picture point of the target.
Vec3f direction_in(const SpherePicture& picture, Vec2f point);
// Places of a world direction, at most six; none where a perspective source does not look.
int places_of(const SpherePicture& source, Vec3f direction, float feather_deg, std::array<SourcePlace, 6>& out);
// Smallest angle between neighbouring pixels about a place, radians.
float pitch_at(const SpherePicture& source, Vec3f direction);
// How much closer than `pitch_at` says neighbours in a row of an equirectangular source lie there: at least 1, very
// many at the poles.
float crowding(const SpherePicture& source, Vec3f direction);
// How many columns of an equirectangular source a target's pixel (its left top corner) spans from its left to its right
// side, and from top to bottom.
Vec2f columns_across(const SpherePicture& source, const SpherePicture& target, Vec2f corner);
// Width and height of a target's pixel as angles, radians, where it looks along `direction`.
Vec2f pixel_angles(const SpherePicture& target, Vec3f direction);
// All pixels of the place's neighbourhood (side: 1 nearest, 2 bilinear, 4 bicubic) are in the part itself.
bool is_inside(const SpherePicture& source, const SourcePlace& place, int side);
// Appends the neighbourhood's pixels.
void add_taps(const SpherePicture& source, const SourcePlace& place, int side, std::vector<SourceTap>& taps);

// Catmull-Rom weights of the four pixels about a place t between the middle two.
inline std::array<float, 4> catmull_rom(float t) {
    return {t * (-0.5f + t * (1.f - 0.5f * t)), 1.f + t * t * (-2.5f + 1.5f * t), t * (0.5f + t * (2.f - 1.5f * t)),
            t * t * (-0.5f + 0.5f * t)};
}

}  // namespace fastscene
