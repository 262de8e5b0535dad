// The room's shell, the meshes of no thing, by what they are.
#pragma once

#include <array>

#include "fastscene/scene/room.h"

namespace fastscene {

enum class Shell { floor, ceiling, walls };
inline constexpr std::array kShellNames{"floor", "ceiling", "walls"};
// By height: the floor is what does not rise above the room's interior, the ceiling what does not reach down into it.
// Everything else, slopes and mouldings too, counts as walls.
Shell shell_of(const Room& room, const Mesh& mesh);

// A rotation about the vertical into a frame whose x and z run along the walls: the mean direction of upright surfaces,
// where quarter turns count as one direction.
Mat3f plan_from_world(const Room& room);

}  // namespace fastscene
