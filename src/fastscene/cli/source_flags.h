// The flags of the sources: what visit_fields says of each alternative, once.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "fastscene/pipeline/source.h"

namespace fastscene::cli {

// What the user said of the source: flag -> text.
using SourceTexts = std::map<std::string, std::string, std::less<>>;

// Adds the flags of all sources that `make` starts from, each once. `texts` outlives the program's flags.
void add_source_flags(CLI::App& app, SourceTexts& texts);

// The source that the texts are of: painted where `painted` says so, else a picture where --panorama names one, else a
// prompt. Throws UsageError for a flag that such a source does not have.
SceneSource source_of(const SourceTexts& texts, bool painted);

}  // namespace fastscene::cli
