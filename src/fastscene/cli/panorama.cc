#include "fastscene/cli/request.h"

namespace fastscene::cli {

Verb add_panorama(CLI::App& app) {
    const Verb verb = add_starting_verb(app, "panorama", "Prompt -> equirectangular picture of a furnished room.",
                                        "panorama");
    verb.app->footer(
        "Example:\n  fastscene panorama \"an art deco study at night\" --panorama-width 1024 -o out/study");
    return verb;
}

}  // namespace fastscene::cli
