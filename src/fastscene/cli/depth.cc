#include "fastscene/cli/request.h"

namespace fastscene::cli {

Verb add_depth(CLI::App& app) {
    return add_stage_verb(app, "depth", "Panorama -> range along each ray.");
}

}  // namespace fastscene::cli
