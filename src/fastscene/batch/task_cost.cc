#include "fastscene/batch/task_cost.h"

#include <algorithm>
#include <cmath>

#include "fastscene/pipeline/scene_cost.h"

namespace fastscene {
namespace {

constexpr double kMemoryMargin = 1.25;  // of the estimate: a task that takes more is killed
constexpr double kTimeMargin = 4;       // nodes differ, and file systems are busy
constexpr int kLeastMinutes = 15;       // of a time limit
constexpr int kMibOfGib = 1024;

}  // namespace

int TaskCost::minutes(int cores) const {
    return std::max(kLeastMinutes, static_cast<int>(std::ceil(core_seconds / cores / 60)));
}

TaskCost task_cost(const std::vector<BatchScene>& scenes, const std::string& quality, int of_task) {
    double gib = 0, seconds = 0;
    for (const BatchScene& scene : scenes) {
        const SceneCost cost = scene_cost(scene.quality.empty() ? quality : scene.quality);
        gib = std::max(gib, cost.gib), seconds = std::max(seconds, cost.max_core_seconds);
    }
    return {static_cast<int>(std::ceil(kMemoryMargin * gib * kMibOfGib)), kTimeMargin * seconds * of_task};
}

}  // namespace fastscene
