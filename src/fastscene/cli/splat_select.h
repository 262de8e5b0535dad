#pragma once

#include "fastscene/cli/verb.h"

namespace fastscene::cli {

// The subcommand of `splat` that cuts things out.
Verb add_splat_select(CLI::App& splat);

}  // namespace fastscene::cli
