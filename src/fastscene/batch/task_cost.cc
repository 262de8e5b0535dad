#include "fastscene/batch/estimates.h"

#include <algorithm>
#include <cmath>

namespace fastscene {
namespace {

constexpr double kMemoryMargin = 1.25;  // of the estimate: a task that takes more is killed
constexpr double kTimeMargin = 4;       // nodes differ, and file systems are busy
constexpr int kLeastMinutes = 15;       // of a time limit
constexpr int kMibOfGib = 1024;

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

int TaskCost::minutes(int cores) const {
    return std::max(kLeastMinutes, static_cast<int>(std::ceil(core_seconds / cores / 60)));
}

TaskCost task_cost(const std::vector<BatchScene>& scenes, const std::string& quality, int of_task) {
    double gib = 0, seconds = 0;
    for (const BatchScene& scene : scenes) {
        const std::string& its = scene.quality.empty() ? quality : scene.quality;
        gib = std::max(gib, scene_gib(its)), seconds = std::max(seconds, scene_core_seconds(its));
    }
    return {static_cast<int>(std::ceil(kMemoryMargin * gib * kMibOfGib)), kTimeMargin * seconds * of_task};
}

}  // namespace fastscene
