// What the pack_*.cc files share.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fastscene/rooms/pack.h"

namespace fastscene::packs {

// Java's .properties: key = value, '#' comments, '\' continues a line, \uXXXX; Latin-1 in, UTF-8 out.
std::map<std::string, std::string> read_properties(const std::string& text);

// A class of ours that is never taken from the pack: the builder is better.
bool keeps_builder(const std::string& kind);
// The classes of the catalogue that serve for a class, best first; at least the class itself.
std::vector<std::string> catalogue_classes(const std::string& kind);
// Neither a door nor larger than a room.
bool fits_a_room(const PackModel& model);

// How a model stands: on the floor, on a piece, on the wall, from the ceiling.
Mount mount_of(const PackModel& model);

// Triangles and materials of a model in the object frame of furniture.h, without wishes.
Piece load_model(const ZipFile& zip, const PackModel& model);

}  // namespace fastscene::packs
