#include "fastscene/pipeline/scene_cost.h"

#include <utility>

namespace fastscene {

SceneCost scene_cost(std::string_view quality) {
    constexpr std::pair<std::string_view, SceneCost> kCosts[] = {
        {"draft", {1.1, 1.2}}, {"standard", {3.7, 2.2}}, {"high", {20, 7}}};
    for (const auto& [name, cost] : kCosts)
        if (name == quality) return cost;
    return kCosts[1].second;
}

}  // namespace fastscene
