// Procedural materials: every Pattern of scene/room.h as a function of Mesh::coords.
#pragma once

#include "fastscene/scene/room.h"
#include "fastscene/trace/kernel/material.h"

namespace fastscene {
namespace kernel {

// Defined in kernel/texture.h, which kernels on graphics cards share.
int dominant_axis(Vec3f coords_normal);
Vec2f flat_coords(Vec3f coords, int axis);
TextureValue sample_texture(const Material& material, const TexturePoint& point);
SurfaceTexture texture_with_slope(const Material& material, const TexturePoint& point, int axis, bool relief);
Vec3f mean_emission(const Material& material);

}  // namespace kernel

using kernel::TexturePoint, kernel::TextureValue, kernel::SurfaceTexture, kernel::dominant_axis, kernel::flat_coords,
    kernel::sample_texture, kernel::texture_with_slope, kernel::mean_emission;

// Mean albedo over several units of the pattern: what bounced light sees.
Vec3f mean_albedo(const Material& material);
float mean_metal(const Material& material);

}  // namespace fastscene
