// Stable names of a room's things, shared by all exported files.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fastscene/scene/room.h"

namespace fastscene {

// As an index of a vector.
inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

// "armchair-1", "armchair-2" …: the class and a number within the class, in the order of Room::objects.
std::vector<std::string> object_ids(const Room& room);

}  // namespace fastscene
