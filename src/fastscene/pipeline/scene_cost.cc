#include "fastscene/pipeline/scene_cost.h"

#include <utility>

namespace fastscene {

SceneCost scene_cost(std::string_view quality) {
    // Measured for draft and standard (docs/benchmarks.md); high is estimated from its pixels and its number of splats.
    constexpr std::pair<std::string_view, SceneCost> kCosts[] = {
        {"draft", {.core_seconds = 112, .max_core_seconds = 160, .gib = 1.2}},
        {"standard", {.core_seconds = 484, .max_core_seconds = 800, .gib = 2.2}},
        {"high", {.core_seconds = 4000, .max_core_seconds = 8000, .gib = 7}}};
    for (const auto& [name, cost] : kCosts)
        if (name == quality) return cost;
    return kCosts[1].second;
}

}  // namespace fastscene
