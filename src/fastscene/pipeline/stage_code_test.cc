// No edit may leave a stale stage: everything that a stage's sources include must be covered by its key.
#include "fastscene/pipeline/stage_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "fastscene/pipeline/run_folder.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;
const fs::path kSources = fs::path(FASTSCENE_SOURCE_DIR) / "src/fastscene";

// Project headers included by a file: "walk/walk.h".
std::vector<std::string> includes_of(const fs::path& file) {
    static const std::regex form(R"re(^\s*#\s*include\s*"fastscene/([a-z0-9_]+/[^"]+)".*)re");
    std::vector<std::string> found;
    std::ifstream in(file);
    std::smatch match;
    for (std::string line; std::getline(in, line);)
        if (std::regex_match(line, match, form)) found.push_back(match[1]);
    return found;
}

// All modules whose code a source may run: those of all headers it reaches, and of those headers' own sources, file by
// file.
std::set<std::string> modules_behind(const std::string& source) {
    std::set<std::string> seen{source}, modules;
    std::vector<std::string> todo{source};
    while (!todo.empty()) {
        const fs::path file = todo.back();
        todo.pop_back();
        modules.insert(file.begin()->string());
        for (const std::string& header : includes_of(kSources / file))
            for (const fs::path& next : {fs::path(header), fs::path(header).replace_extension(".cc")})
                if (fs::exists(kSources / next) && seen.insert(next.string()).second) todo.push_back(next.string());
    }
    return modules;
}

const std::vector<std::pair<std::string, std::string>> kStarts{
    {"panorama", "pipeline/stage_panorama.cc"}, {"depth", "pipeline/stage_depth.cc"},
    {"walk", "pipeline/stage_walk.cc"},         {"views", "pipeline/stage_views.cc"},
    {"splat", "pipeline/stage_splat.cc"},       {"capture", "pipeline/capture_run.cc"},
    {"metrics", "pipeline/truth.cc"},           {"scores", "evaluate/scores.cc"},
    {"measures", "evaluate/measures.cc"}};

// The stages whose version changes if a module is edited.
std::set<std::string> stages_behind(const std::string& module) {
    StageCode edited = built_stage_code();
    edited.modules.at(module).stamp += "'";
    std::set<std::string> changed;
    for (const auto& [stage, code] : edited.stages)
        if (code_version(stage, edited) != code_version(stage)) changed.insert(stage);
    return changed;
}

TEST(StageCode, EveryStageOfARunHasItsOwn) {
    for (const std::string_view stage : kStages) EXPECT_TRUE(built_stage_code().stages.contains(stage)) << stage;
    std::set<std::string> versions, listed;
    for (const auto& [stage, code] : built_stage_code().stages) versions.insert(code_version(stage));
    for (const auto& [stage, source] : kStarts) listed.insert(stage);
    EXPECT_EQ(versions.size(), built_stage_code().stages.size());
    for (const auto& [stage, code] : built_stage_code().stages) EXPECT_TRUE(listed.contains(stage)) << stage;
}

TEST(StageCode, AnEditOfAModuleReachesEveryStageThatRunsIt) {
    std::map<std::string, std::set<std::string>> run_by;  // module -> stages
    for (const auto& [stage, source] : kStarts)
        for (const std::string& module : modules_behind(source)) run_by[module].insert(stage);
    for (const auto& [module, code] : built_stage_code().modules) {
        if (module == "pipeline" || module == "evaluate") continue;  // counted per file, below
        const std::set<std::string> without_stage{"batch", "dataset", "export", "studio", "film"};
        if (without_stage.contains(module)) continue;
        const std::set<std::string> changed = stages_behind(module);
        EXPECT_FALSE(changed.empty()) << module;
        for (const std::string& stage : run_by[module])
            EXPECT_TRUE(changed.contains(stage)) << stage << " runs code of " << module;
    }
}

TEST(StageCode, AnEditLeavesTheStagesBeforeItAlone) {
    EXPECT_EQ(stages_behind("base").size(), built_stage_code().stages.size());
    const std::set<std::string> of_splat = stages_behind("splat"), of_rooms = stages_behind("rooms");
    for (const char* stage : {"panorama", "depth", "walk", "views"}) EXPECT_FALSE(of_splat.contains(stage)) << stage;
    for (const char* stage : {"splat", "capture"}) EXPECT_TRUE(of_splat.contains(stage)) << stage;
    for (const char* stage : {"panorama", "depth", "walk"}) EXPECT_TRUE(of_rooms.contains(stage)) << stage;
    EXPECT_FALSE(of_rooms.contains("splat"));
    EXPECT_TRUE(stages_behind("inpaint").contains("walk"));
    EXPECT_TRUE(stages_behind("inpaint").contains("panorama"));  // fills what a partial one lacks
    EXPECT_FALSE(stages_behind("walk").contains("panorama"));
}

TEST(StageCode, AnEditOfAStagesOwnFilesReachesItAlone) {
    StageCode edited = built_stage_code();
    edited.stages.at("views").stamp += "'";
    for (const auto& [stage, code] : edited.stages)
        EXPECT_EQ(code_version(stage, edited) == code_version(stage), stage != "views") << stage;
}

}  // namespace
}  // namespace fastscene
