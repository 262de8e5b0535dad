#include "fastscene/cli/request.h"

namespace fastscene::cli {

Verb add_walk(CLI::App& app) {
    return add_stage_verb(app, "walk", "One panorama with range -> many, at exactly known positions, holes filled.");
}

}  // namespace fastscene::cli
