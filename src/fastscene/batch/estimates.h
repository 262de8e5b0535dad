// What one scene takes, by quality: for planning, rounded up.
#pragma once

#include <string>

namespace fastscene {

double scene_gib(const std::string& quality);           // peak memory
double scene_core_seconds(const std::string& quality);  // seconds on one core

}  // namespace fastscene
