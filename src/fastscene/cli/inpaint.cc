#include "fastscene/cli/inpaint.h"

namespace fastscene::cli {

Verb add_inpaint(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("inpaint",
                                        "Works on the network that paints holes: its training data, its training.");
    verb->require_subcommand(1);
    verb->footer(
        "Example:\n  fastscene inpaint dataset data/rooms -o data/holes\n  fastscene inpaint train data/holes -o "
        "out/inpainter");
    const std::vector<Verb> parts{add_inpaint_dataset(*verb), add_inpaint_train(*verb)};
    for (const Verb& part : parts) part.app->fallthrough();  // common flags belong to `inpaint`
    return {verb, [parts](const Session& session) {
                for (const Verb& part : parts)
                    if (part.app->parsed()) part.act(session);
            }};
}

}  // namespace fastscene::cli
