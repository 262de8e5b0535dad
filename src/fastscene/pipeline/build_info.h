// Build information: version and compiler.
#pragma once

#include <string_view>

#include "fastscene/base/json.h"

namespace fastscene {

std::string_view program_version();
// Versions and machine, for run.json, report.json and `fastscene version`.
Json build_json();

}  // namespace fastscene
