// The host's side of tables.glsl and camera.glsl: the same structures, field by field. Addresses are of gpu::Buffer.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fastscene/math/vec.h"

namespace fastscene::vulkan {

struct Vec4 {
    float x = 0, y = 0, z = 0, w = 0;
};
inline Vec4 vec4(Vec3f v, float w = 0) { return {v.x, v.y, v.z, w}; }
struct Uvec4 {
    std::uint32_t x = 0, y = 0, z = 0, w = 0;
};

struct World {
    Vec4 sun, sun_light, zenith, horizon, ground, sunward, look, curve, band, cache;
    std::uint64_t nodes, triangles, corners, vertices, meshes, materials, emitters, light_nodes, light_heads,
        light_places, outside_table, band_pixels, band_columns, dome, cells, slots, coats, sun_patches, sun_places,
        sun_powers;
    std::uint32_t heads, emitter_count, windows, slot_mask, patches, has_table, band_pitch, sky_seed;
};
static_assert(offsetof(World, nodes) == 160 && sizeof(World) == 352);

inline constexpr std::uint32_t kPictured = 2;  // World::has_table: the outside is a photograph (Sky::picture)
enum MeshFlag : std::uint32_t { kClosed = 1, kLarge = 2 };
enum EmitterFlag : std::uint32_t { kWindow = 1, kSolid = 2, kFlame = 4 };
enum RayKind : std::uint32_t { kLit = 1, kAny = 2 };

struct Camera {
    Vec4 row_x, row_y, row_z, lens;
    std::uint32_t panorama = 0, unused = 0;
    std::uint64_t seed = 0;
};

}  // namespace fastscene::vulkan
