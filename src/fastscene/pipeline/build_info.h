// What this program was built from: its version, its compiler, and a hash of the sources of each stage,
// so that a cached stage is made again when the code behind it has changed.
#pragma once

#include <string>
#include <string_view>

#include "fastscene/base/json.h"

namespace fastscene {

std::string_view program_version();
std::string_view source_dir();  // where the checkout was at build time
// Hash of the sources that the stage stands on: its own module and all lower layers.
std::string code_version(std::string_view stage);
// Versions and machine, for run.json, report.json and `fastscene version`.
Json build_json();

}  // namespace fastscene
