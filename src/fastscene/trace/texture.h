// Procedural materials: every Pattern of scene/room.h as a function of Mesh::coords.
#pragma once

#include "fastscene/scene/room.h"

namespace fastscene {

// Where a pattern is asked for, in the mesh's coords space.
struct TexturePoint {
    Vec3f coords;           // metres
    Vec2f flat;             // the two coordinates flat patterns use (flat_coords)
    float footprint_m = 0;  // width of what one sample stands for; finer detail fades to its mean
};
struct TextureValue {
    Vec3f albedo;            // linear, each channel in [0, 1]
    float roughness = 0.6f;  // in [0.02, 1]
    float height = 0.f;      // relief in [0, 1], to be multiplied by Material::bump_m
};

// The axes of the plane a flat pattern lies in, by the dominant axis of the surface's normal in coords space:
// 2 -> (x, y), 1 -> (x, z), 0 -> (z, y).
int dominant_axis(Vec3f coords_normal);
Vec2f flat_coords(Vec3f coords, int axis);

TextureValue sample_texture(const Material& material, const TexturePoint& point);

// Gradient of the relief (metres a metre) along the two flat coordinates, by central differences;
// zero where the relief is finer than the footprint.
Vec2f texture_slope(const Material& material, const TexturePoint& point, int axis);

// Albedo averaged over a few units of the pattern: what light that bounces off the material sees.
Vec3f mean_albedo(const Material& material);

}  // namespace fastscene
