// What differs between two versions of a room, as after an edit.
#pragma once

#include <string>

#include "fastscene/scene/room.h"

namespace fastscene {

struct RoomChange {
    // The meshes of either version that the other lacks: of a moved chair both places, of a painted one both colors.
    Room surfaces;
    // Lamps, openings, the outside or the room's bounds differ: all of the light does.
    bool lights = false;
};

// Hash of all that a room looks like: surfaces, materials, lamps, the outside.
std::string content_of(const Room& room);

// Meshes are compared by content: shape, material and pattern. Their order does not count.
RoomChange change_between(const Room& before, const Room& now);

}  // namespace fastscene
