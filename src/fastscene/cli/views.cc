#include "fastscene/cli/request.h"

namespace fastscene::cli {

Verb add_views(CLI::App& app) {
    return add_stage_verb(app, "views", "Panoramas -> perspective views, cameras and starting points.");
}

}  // namespace fastscene::cli
