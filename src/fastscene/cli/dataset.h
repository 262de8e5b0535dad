// The subcommands of `dataset`, one file each.
#pragma once

#include "fastscene/cli/verb.h"

namespace fastscene::cli {

Verb add_dataset_export(CLI::App& dataset);
Verb add_dataset_verify(CLI::App& dataset);
Verb add_dataset_stats(CLI::App& dataset);
Verb add_dataset_card(CLI::App& dataset);

}  // namespace fastscene::cli
