// Houses, town buildings and street lamps: walls with windows set into them, roofs that overhang.
#pragma once

#include "fastscene/trace/outdoors_world.h"

namespace fastscene::outdoors {

// A detached house with a pitched roof, its ridge along x.
QuadMesh build_house(World& world, std::uint32_t seed);
// A town building of `floors` storeys over a ground floor of shops, with windows on all sides.
QuadMesh build_block(World& world, float wide_m, float deep_m, int floors, std::uint32_t seed);
// A distant building whose windows are paint.
QuadMesh build_tower(World& world, float wide_m, float deep_m, float high_m, std::uint32_t seed);
// A box without its lower face.
void add_box(QuadMesh& mesh, Vec3f low, Vec3f high, std::uint16_t paint);
// Lamp on a pole; its light hangs at kLampHeight_m.
QuadMesh build_lamp();
inline constexpr float kLampHeight_m = 5.2f;

}  // namespace fastscene::outdoors
