// Flags that define a scene, shared by `make` and the stage commands.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "fastscene/cli/flags.h"
#include "fastscene/cli/source_flags.h"
#include "fastscene/cli/verb.h"
#include "fastscene/pipeline/pipeline.h"

namespace fastscene::cli {

struct RequestFlags {
    std::string out, assets;
    SourceTexts source;
    std::string quality = "standard";
    std::string seed = "0";
    bool force = false, strict = false, has_quality = false;
    std::vector<std::string> trusted;  // of --trust
    std::shared_ptr<Given> given = std::make_shared<Given>();
};

// Flags of the stages up to `last_stage`, and --quality.
void add_param_flags(CLI::App& app, const std::shared_ptr<RequestFlags>& flags, const std::string& last_stage);
// Overwrites the settings that flags were given for.
void apply_param_flags(SceneParams& params, const Given& given);

// For commands that start a run from a prompt or picture: make, panorama.
Verb add_starting_verb(CLI::App& app, const std::string& name, const std::string& sentence,
                       const std::string& last_stage);
// For commands that continue a run in a folder: depth, walk, views, splat. Settings without a flag come from run.json.
// `first` adds options that --help lists before them.
Verb add_stage_verb(CLI::App& app, const std::string& name, const std::string& sentence,
                    std::shared_ptr<RequestFlags> flags = std::make_shared<RequestFlags>(),
                    const std::function<void(CLI::App&)>& first = {});

}  // namespace fastscene::cli
