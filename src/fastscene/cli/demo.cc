// A first look at the program: one command, no arguments.
#include <cstdlib>

#include "fastscene/base/program.h"
#include "fastscene/cli/checks.h"
#include "fastscene/cli/server.h"
#include "fastscene/cli/verb.h"
#include "fastscene/pipeline/pipeline.h"
#include "fastscene/pipeline/quality.h"
#include "fastscene/pipeline/share.h"

namespace fastscene::cli {
namespace {

constexpr const char* kPrompt = "a small cozy study with a red armchair, a desk and a bookshelf";

// draft, made in half its time: a small room needs fewer viewpoints.
SceneRequest demo_request(const std::string& prompt) {
    SceneRequest request;
    request.source = PromptSource{prompt};
    request.quality = "draft";
    request.params = params_of_quality(request.quality);
    request.params.panorama.trace.cell_samples = 128;
    request.params.walk.room_viewpoints = 8;
    request.params.splat.steps = 700;
    return request;
}

// Opens the page if there is a display; on a server the address is printed.
bool opened(const std::string& address, std::stop_token stop) {
    const bool screen = std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY");
    const auto opener = find_program("xdg-open");
    return screen && opener && run_program(*opener, {address}, {{}, {}, stop}) == 0;
}

std::string next_steps(const std::string& folder) {
    return fmt::format(
        "Next:\n"
        "  fastscene make \"your own room in a sentence\"            your own scene; --quality high for the best one\n"
        "  fastscene edit {0} \"make the armchair green\"  change it\n"
        "  fastscene render {0} --path tour -o tour.mp4    a film\n"
        "  fastscene export {0} room.glb                   the room for Blender and game engines\n"
        "  fastscene convert {0} scene.spz                 the splats for other viewers",
        folder);
}

}  // namespace

Verb add_demo(CLI::App& app) {
    struct Flags {
        std::string out = "out/demo", prompt = kPrompt;
        int port = 0;
        bool no_view = false;
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = app.add_subcommand("demo", "Makes a small scene in about a minute, and opens it in a browser.");
    verb->add_option("prompt", flags->prompt, "The room in a sentence.")->type_name("PROMPT")->capture_default_str();
    verb->add_option("-o,--out", flags->out, "Folder of the scene.")->type_name("DIR")->capture_default_str();
    verb->add_option("--port", flags->port, "Port of the page; 0 = any free one.")
        ->type_name("N")
        ->check(whole_number_within(0, 65535))
        ->capture_default_str();
    verb->add_flag("--no-view", flags->no_view, "Only make the scene.");
    verb->footer("Example:\n  fastscene demo");
    return {verb, [flags](const Session& session) {
                const RunFolder folder{flags->out};
                const Run run = session.run(0);
                make_scene(demo_request(flags->prompt), folder, run);
                const std::string next = next_steps(flags->out);
                if (flags->no_view) return session.print(flags->out + "\n" + next, {{"scene", flags->out}});
                serve_scene(folder, find_viewer_dir(), flags->port, session.stop, [&](const std::string& address) {
                    session.print(address + "\n" + next, {{"scene", flags->out}, {"address", address}});
                    run.note(opened(address, session.stop) ? "Ctrl-C ends it"
                                                           : "open this address in a browser; Ctrl-C ends it");
                });
            }};
}

}  // namespace fastscene::cli
