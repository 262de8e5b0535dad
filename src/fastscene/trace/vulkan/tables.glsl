// What all kernels share: a room's tables on the card (tables.h is the host's side), and how they are read. Members are
// read whole: some drivers get single components of vectors behind pointers wrong (Mesa 22's lavapipe).
#extension GL_GOOGLE_include_directive : enable
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_control_flow_attributes : enable
#include "fastscene/trace/kernel/texture.h"
#include "fastscene/trace/kernel/response.h"
#include "fastscene/trace/kernel/sampler.h"

const float kFar = 1e30;            // no hit
const float kSurfaceOffset = 4e-4;  // as in scene_bvh.h
const uint kNone = 0xffffffffu;

layout(buffer_reference, std430, buffer_reference_align = 16) readonly buffer Vec4s { vec4 at[]; };
layout(buffer_reference, std430, buffer_reference_align = 16) readonly buffer Uvec4s { uvec4 at[]; };
layout(buffer_reference, std430, buffer_reference_align = 16) readonly buffer Words { uint at[]; };
layout(buffer_reference, std430, buffer_reference_align = 16) readonly buffer Floats { float at[]; };
layout(buffer_reference, std430, buffer_reference_align = 16) writeonly buffer OutVec4s { vec4 at[]; };
layout(buffer_reference, std430, buffer_reference_align = 16) buffer InOutVec4s { vec4 at[]; };
layout(buffer_reference, std430, buffer_reference_align = 16) buffer InOutWords { uint at[]; };

layout(buffer_reference, std430, buffer_reference_align = 16) readonly buffer World {
    vec4 sun;       // direction; share of it that cameras see
    vec4 sun_light; // irradiance; clouds
    vec4 zenith;    // w: share of the outside that cameras see
    vec4 horizon;   // w: 1 at night
    vec4 ground;    // w: exposure_ev of the look
    vec4 sunward;   // w: unused
    vec4 look;      // white; saturation
    vec4 curve;     // of the film: slope (0: linear), unused
    vec4 band;      // of the outside: width of the full circle (0: none), height, stretch, top
    vec4 cache;     // origin and size of the irradiance cache's cells
    Uvec4s nodes;      // five a node (bvh.h)
    Vec4s triangles;   // three a triangle: corners; id, mesh, clear
    Uvec4s corners;    // by triangle id: vertices; mesh
    Vec4s vertices;    // three a vertex: position, normal, texture coordinates
    Uvec4s meshes;     // material, flags, first emitter, first triangle id
    Materials materials;
    Vec4s emitters;    // three an emitter: corners of a lamp's triangle, or corner and edges of a window; material,
                       // flags, area
    Vec4s light_nodes;   // four a node (LightTree::Node)
    Words light_heads;
    Uvec4s light_places; // by emitter: head, depth, path
    Vec4s outside_table; // 512 x 256
    Vec4s band_pixels;
    Words band_columns;
    Vec4s dome;          // 33 x 33
    Vec4s cells;         // four an entry of the irradiance cache
    Uvec4s slots;        // key; entry + 1
    Vec4s coats;         // three a material: mean reflectance, and the coat for the sun's reflection
    Vec4s sun_patches;   // two a patch
    Vec4s sun_places;    // two a place
    Floats sun_powers;   // cumulative
    uint heads, emitter_count, windows, slot_mask, patches, has_table, band_pitch, sky_seed;
};

const uint kClosed = 1, kLarge = 2;  // flags of meshes
const uint kWindow = 1, kSolid = 2, kFlame = 4;  // flags of emitters

// A ray of one of these kinds meets everything but clear glass and flames.
const uint kLit = 1;
const uint kAny = 2;  // whether there is anything in between

vec4 world_sun(World w) { return w.sun; }
vec4 world_sun_light(World w) { return w.sun_light; }
vec4 world_zenith(World w) { return w.zenith; }
vec4 world_horizon(World w) { return w.horizon; }
vec4 world_ground(World w) { return w.ground; }
vec4 world_sunward(World w) { return w.sunward; }
vec4 world_look(World w) { return w.look; }
vec4 world_curve(World w) { return w.curve; }
vec4 world_band(World w) { return w.band; }
vec4 world_cache(World w) { return w.cache; }
vec3 emission_of(World w, uint material) {
    Material m = w.materials.at[material];
    return mean_emission(m);
}
