#include "fastscene/pipeline/stage_code.h"

#include <set>
#include <sstream>

#include "fastscene/base/check.h"
#include "fastscene/base/hash.h"
#include "fastscene/build_sources.h"  // generated: cmake/build_sources.cmake

namespace fastscene {
namespace {

Code code_of(const generated::Code& built) {
    Code code{std::string(built.stamp), {}};
    std::istringstream names{std::string(built.uses)};
    for (std::string name; names >> name;) code.uses.push_back(name);
    return code;
}

void collect(const std::vector<std::string>& uses, const StageCode& code, std::set<std::string>& closure) {
    for (const std::string& name : uses)
        if (closure.insert(name).second) collect(code.modules.at(name).uses, code, closure);
}

}  // namespace

const StageCode& built_stage_code() {
    static const StageCode code = [] {
        StageCode out;
        for (const generated::Code& module : generated::kModules)
            out.modules[std::string(module.name)] = code_of(module);
        for (const generated::Code& stage : generated::kStages) out.stages[std::string(stage.name)] = code_of(stage);
        return out;
    }();
    return code;
}

std::string code_version(std::string_view stage, const StageCode& code) {
    const auto found = code.stages.find(stage);
    FASTSCENE_CHECK(found != code.stages.end());
    std::set<std::string> closure;
    collect(found->second.uses, code, closure);
    Hash hash;
    hash.add(found->second.stamp);
    for (const std::string& module : closure) hash.add(module).add(code.modules.at(module).stamp);
    return hash.hex();
}

}  // namespace fastscene
