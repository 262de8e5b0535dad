#include "fastscene/cli/request.h"

namespace fastscene::cli {

Verb add_splat(CLI::App& app) {
    return add_stage_verb(app, "splat", "Views -> 3D Gaussians, and a page to walk through them.");
}

}  // namespace fastscene::cli
