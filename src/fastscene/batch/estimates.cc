#include "fastscene/batch/estimates.h"

namespace fastscene {
namespace {

struct SceneCost {
    const char* quality;
    double gib, core_seconds;
};
// Measured and rounded up (docs/benchmarks.md); "high" is estimated from its number of splats.
constexpr SceneCost kSceneCosts[] = {{"draft", 1.2, 90}, {"standard", 2.2, 400}, {"high", 7, 3600}};

const SceneCost& cost_of(const std::string& quality) {
    for (const SceneCost& cost : kSceneCosts)
        if (quality == cost.quality) return cost;
    return kSceneCosts[1];
}

}  // namespace

double scene_gib(const std::string& quality) { return cost_of(quality).gib; }
double scene_core_seconds(const std::string& quality) { return cost_of(quality).core_seconds; }

}  // namespace fastscene
