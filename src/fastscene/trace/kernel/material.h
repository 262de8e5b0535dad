// Materials as patterns see them, and what a pattern is asked for. Material itself is scene/room.h's in C++ and
// material.glsl's in GLSL: the same fields by the same names.
#ifndef FASTSCENE_TRACE_KERNEL_MATERIAL_H
#define FASTSCENE_TRACE_KERNEL_MATERIAL_H

#include "fastscene/trace/kernel/language.h"

#ifdef __cplusplus
#include "fastscene/scene/room.h"
#define PATTERN(name) Pattern::name
#define IN_USE(name) true
#else
#include "fastscene/trace/kernel/material.glsl"
#define PATTERN(name) Pattern_##name
#define IN_USE(name) is_in_use(Pattern_##name)
#endif

KERNEL_BEGIN

// A sample point, in the mesh's texture space.
struct TexturePoint {
    Vec3f coords;       // metres
    Vec2f plane;        // the two coordinates that flat patterns use (flat_coords)
    float footprint_m;  // width of the sample; finer detail fades to its mean
};
struct TextureValue {
    Vec3f albedo;     // linear, each channel in [0, 1]
    float roughness;  // in [0.02, 1]
    float height;     // relief, in units of Material::bump_m
    float metal;      // 1: the albedo is the mirror's color; only Pattern::image sets it, as a share of Material::metal
    Vec3f shown;      // factors of Material::emission; only Pattern::screen sets them
};

struct SurfaceTexture {
    TextureValue value;
    Vec2f slope;  // gradient of the relief (dimensionless) along the two flat coordinates
};

inline TextureValue texture_value(Vec3f albedo, float roughness, float height) {
    TextureValue v;
    v.albedo = albedo;
    v.roughness = roughness;
    v.height = height;
    v.metal = 1;
    v.shown = vec3(1, 1, 1);
    return v;
}

KERNEL_END

#endif
