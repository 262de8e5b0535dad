// What a scene from a prompt costs, before it is made.
#pragma once

#include <string_view>

namespace fastscene {

struct SceneCost {
    double core_seconds = 0;      // CPU time of a bedroom on cores with AVX2
    double max_core_seconds = 0;  // rounded up, for any room: what time limits are made from
    double gib = 0;               // peak memory of any room, rounded up
};
// By quality; an unknown one costs what standard does.
SceneCost scene_cost(std::string_view quality);

}  // namespace fastscene
