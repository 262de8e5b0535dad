// Flags of the sources, derived from visit_fields of each alternative.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "fastscene/pipeline/source.h"

namespace fastscene::cli {

// Given source flags: flag -> text.
using SourceTexts = std::map<std::string, std::string, std::less<>>;

// Adds the flags of all sources supported by `make`. `texts` must outlive the flags.
void add_source_flags(CLI::App& app, SourceTexts& texts);

// The source defined by the texts: generated if `painted`, else a picture if --panorama names one, else a prompt.
// Throws UsageError for a flag that does not apply to it.
SceneSource source_of(const SourceTexts& texts, bool painted);

}  // namespace fastscene::cli
