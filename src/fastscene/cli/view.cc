#include "fastscene/base/file.h"
#include "fastscene/cli/checks.h"
#include "fastscene/cli/server.h"
#include "fastscene/cli/verb.h"
#include "fastscene/pipeline/share.h"

namespace fastscene::cli {

Verb add_view(CLI::App& app) {
    struct Flags {
        std::string folder;
        int port = 8080;
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = app.add_subcommand("view",
                                        "Serves a scene to a browser on this machine (127.0.0.1) until Ctrl-C.");
    verb->add_option("folder", flags->folder, "Folder of a finished run.")->type_name("DIR")->required();
    verb->add_option("--port", flags->port, "Port; 0 = any free one.")
        ->type_name("N")
        ->check(whole_number_within(0, 65535))
        ->capture_default_str();
    verb->footer("Example:\n  fastscene view out/bedroom");
    return {verb, [flags](const Session& session) {
                const RunFolder folder{flags->folder};
                if (!std::filesystem::exists(folder.scene_compressed_ply()))
                    throw UsageError("{}: expected a finished run, found no splat/scene.compressed.ply", flags->folder);
                serve_scene(folder, find_viewer_dir(), flags->port, session.stop, [&](const std::string& address) {
                    session.print(address, {{"address", address}});
                    session.run(0).note("Ctrl-C ends it");
                });
            }};
}

}  // namespace fastscene::cli
