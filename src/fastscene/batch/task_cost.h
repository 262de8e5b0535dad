// What scenes take, by quality: for planning, rounded up.
#pragma once

#include <string>
#include <vector>

#include "fastscene/batch/scene_list.h"

namespace fastscene {

double scene_gib(const std::string& quality);           // peak memory
double scene_core_seconds(const std::string& quality);  // seconds on one core

// What a task that makes some of these scenes, one after the other, is given by a scheduler: with a margin, so that the
// dearest of them fits.
struct TaskCost {
    int memory_mib = 0;
    double core_seconds = 0;
    int minutes(int cores) const;  // time limit
};
TaskCost task_cost(const std::vector<BatchScene>& scenes, const std::string& quality, int of_task);

}  // namespace fastscene
