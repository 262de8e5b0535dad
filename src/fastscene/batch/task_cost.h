// What a task of a scheduler needs: memory and time, with a margin.
#pragma once

#include <string>
#include <vector>

#include "fastscene/batch/scene_list.h"

namespace fastscene {

// Of a task that makes some of these scenes, one after the other; sized for the most expensive of them.
struct TaskCost {
    int memory_mib = 0;
    double core_seconds = 0;
    int minutes(int cores) const;  // time limit
};
TaskCost task_cost(const std::vector<BatchScene>& scenes, const std::string& quality, int of_task);

}  // namespace fastscene
