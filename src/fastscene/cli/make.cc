#include "fastscene/cli/request.h"

namespace fastscene::cli {

Verb add_make(CLI::App& app) {
    const Verb verb = add_starting_verb(
        app, "make", "From a sentence to a scene: all stages, and a page to walk through it.", "splat");
    verb.app->footer(
        "Example:\n  fastscene make \"a cozy bedroom with a red armchair and a large window\" -o out/bedroom");
    return verb;
}

}  // namespace fastscene::cli
