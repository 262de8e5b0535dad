// The subcommands of `inpaint`, one file each.
#pragma once

#include "fastscene/cli/verb.h"

namespace fastscene::cli {

Verb add_inpaint(CLI::App& app);
Verb add_inpaint_dataset(CLI::App& inpaint);
Verb add_inpaint_train(CLI::App& inpaint);

}  // namespace fastscene::cli
