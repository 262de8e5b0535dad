#include "fastscene/cli/verb.h"
#include "fastscene/pipeline/build_info.h"

namespace fastscene::cli {

Verb add_version(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("version", "Prints version and build information.");
    return {verb, [](const Session& session) {
                session.print(fmt::format("fastscene {}", program_version()), build_json());
            }};
}

}  // namespace fastscene::cli
