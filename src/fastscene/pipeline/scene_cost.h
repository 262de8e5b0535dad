// What a scene from a prompt costs, before it is made.
#pragma once

#include <string_view>

namespace fastscene {

struct SceneCost {
    double cpu_minutes = 0;  // of a bedroom on one core with AVX-512
    double gib = 0;          // peak memory, rounded up
};
// Measured for draft and standard; high is estimated from its pixels and its number of splats. An unknown quality costs
// what standard does.
SceneCost scene_cost(std::string_view quality);

}  // namespace fastscene
