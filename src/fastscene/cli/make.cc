#include "fastscene/cli/request.h"

namespace fastscene::cli {

Verb add_make(CLI::App& app) {
    return add_starting_verb(app, "make", "From a sentence to a scene: all stages, and a page to walk through it.", "splat");
}

}  // namespace fastscene::cli
