// The subcommands of `metrics`, one file each.
#pragma once

#include "fastscene/cli/verb.h"

namespace fastscene::cli {

Verb add_metrics_depth(CLI::App& metrics);
Verb add_metrics_images(CLI::App& metrics);
Verb add_metrics_labels(CLI::App& metrics);
Verb add_niqe_fit(CLI::App& metrics);

}  // namespace fastscene::cli
