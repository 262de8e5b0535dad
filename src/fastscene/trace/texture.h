// Procedural materials: every Pattern of scene/room.h as a function of Mesh::coords.
#pragma once

#include "fastscene/scene/room.h"

namespace fastscene {

// A sample point, in the mesh's texture space.
struct TexturePoint {
    Vec3f coords;           // metres
    Vec2f flat;             // the two coordinates that flat patterns use (flat_coords)
    float footprint_m = 0;  // width of the sample; finer detail fades to its mean
};
struct TextureValue {
    Vec3f albedo;            // linear, each channel in [0, 1]
    float roughness = 0.6f;  // in [0.02, 1]
    float height = 0.f;      // relief, in units of Material::bump_m
};

// The axis of the plane that a flat pattern lies in, by the dominant axis of the normal in texture space: 2 -> (x, y),
// 1 -> (x, z), 0 -> (z, y).
int dominant_axis(Vec3f coords_normal);
Vec2f flat_coords(Vec3f coords, int axis);

TextureValue sample_texture(const Material& material, const TexturePoint& point);

// Gradient of the relief (dimensionless slope) along the two flat coordinates. Relief finer than the footprint fades,
// as in the pattern itself.
Vec2f texture_slope(const Material& material, const TexturePoint& point, int axis);

// Mean albedo over several units of the pattern: what bounced light sees.
Vec3f mean_albedo(const Material& material);

}  // namespace fastscene
