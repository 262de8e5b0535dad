// The code that each stage runs, by hash: a finished stage is made again when any of it has changed. The table comes
// from the build (cmake/stage_code.cmake): of each module a stamp, which is the hash of its files, and the modules that
// it links; of each stage a stamp of what is its own in the pipeline, and the modules that it calls.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fastscene {

struct Code {
    std::string stamp;
    std::vector<std::string> uses;  // modules
};
struct StageCode {
    std::map<std::string, Code, std::less<>> modules, stages;
};

const StageCode& built_stage_code();

// Hash of everything that the stage's work runs: its own files and all modules in their link closure. `stage` is one of
// the table's.
std::string code_version(std::string_view stage, const StageCode& code = built_stage_code());

}  // namespace fastscene
