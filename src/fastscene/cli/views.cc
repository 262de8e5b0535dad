#include "fastscene/cli/request.h"

namespace fastscene::cli {

Verb add_views(CLI::App& app) {
    const Verb verb = add_stage_verb(app, "views", "Panoramas -> perspective views, cameras and initial points.");
    verb.app->footer("Example:\n  fastscene views out/bedroom --views-size 800");
    return verb;
}

}  // namespace fastscene::cli
