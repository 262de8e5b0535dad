// Numbers of things in maps and in labels of splats.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/scene/room.h"

namespace fastscene {

// 0 is the outside of the room; 1, 2 … are the things, in the order of Room::objects; then come floor, ceiling, walls.
struct Instance {
    std::string id, kind;  // "armchair-1", "armchair"
    int nyu40 = 0;
};
std::vector<Instance> instances_of(const Room& room);
std::vector<std::uint16_t> instance_by_mesh(const Room& room);  // of Room::meshes

// [{"instance": 1, "id": "armchair-1", "class": "armchair", "nyu40": 5}, …]
Json instances_json(const std::vector<Instance>& instances);
std::vector<Instance> instances_from_json(const Json& json, const std::string& where);

// The numbers of the instances that have one of the ids, or are of one of the classes: their own, or NYU40's. Throws
// UsageError for an unknown id or class, naming the nearest one and all there are.
std::vector<std::uint16_t> numbers_of(const std::vector<Instance>& instances, const std::vector<std::string>& ids,
                                      const std::vector<std::string>& classes);

}  // namespace fastscene
