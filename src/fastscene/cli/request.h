// The flags that say what scene is wanted, shared by make and the verbs of the stages.
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
    std::shared_ptr<Given> given = std::make_shared<Given>();
};

// For verbs that start a run from a prompt or a picture: make, panorama.
Verb add_starting_verb(CLI::App& app, const std::string& name, const std::string& sentence,
                       const std::string& last_stage);
// For verbs that go on with the run in a folder: depth, walk, views, splat. Settings that no flag changes are those of
// run.json. `first` adds what --help shall show before them.
Verb add_stage_verb(CLI::App& app, const std::string& name, const std::string& sentence,
                    std::shared_ptr<RequestFlags> flags = std::make_shared<RequestFlags>(),
                    const std::function<void(CLI::App&)>& first = {});

}  // namespace fastscene::cli
