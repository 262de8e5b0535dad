#include "fastscene/pipeline/build_info.h"

#include "fastscene/build_sources.h"  // generated: cmake/build_sources.cmake

namespace fastscene {

std::string_view program_version() { return generated::kVersion; }

Json build_json() {
    Json json;
    json["fastscene"] = program_version();
    json["compiler"] = generated::kCompiler;
    json["build"] = generated::kBuildType;
    return json;
}

}  // namespace fastscene
