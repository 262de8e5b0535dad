#include "fastscene/cli/request.h"

namespace fastscene::cli {

Verb add_panorama(CLI::App& app) {
    return add_starting_verb(app, "panorama", "Prompt -> equirectangular picture of a furnished room.", "panorama");
}

}  // namespace fastscene::cli
