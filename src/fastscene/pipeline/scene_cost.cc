#include "fastscene/pipeline/scene_cost.h"

#include <utility>

namespace fastscene {

SceneCost scene_cost(std::string_view quality) {
    // Measured for draft and standard (docs/benchmarks.md); high is estimated from its pixels and its number of splats.
    constexpr std::pair<std::string_view, SceneCost> kCosts[] = {
        {"draft", {.core_seconds = 66, .max_core_seconds = 90, .gib = 1.2}},
        {"standard", {.core_seconds = 222, .max_core_seconds = 400, .gib = 2.2}},
        {"high", {.core_seconds = 1200, .max_core_seconds = 3600, .gib = 7}}};
    for (const auto& [name, cost] : kCosts)
        if (name == quality) return cost;
    return kCosts[1].second;
}

}  // namespace fastscene
