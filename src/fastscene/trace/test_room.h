// For tests: the corners of a small room and a matt material.
#pragma once

#include "fastscene/scene/room.h"

namespace fastscene {

inline constexpr Vec3f kLow{-2, -1.1f, -2.5f}, kHigh{2, 1.5f, 2.5f};

inline Material diffuse(Vec3f albedo, Vec3f emission = {}) {
    Material m;
    m.color_a = m.color_b = m.color_c = albedo;
    m.emission = emission;
    m.specular = 0;
    m.roughness = 1;
    return m;
}

}  // namespace fastscene
