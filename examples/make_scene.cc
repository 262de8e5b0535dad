// The whole stream: a sentence becomes a scene in a folder, as `fastscene make` does.     make_scene "a sentence"
// FOLDER
#include <fastscene/fastscene.h>

#include <iostream>

using namespace fastscene;

struct PrintProgress : EventSink {
    void tell(const Event& event) override {
        if (const auto* progress = std::get_if<ProgressEvent>(&event); progress && progress->done == progress->total)
            std::cerr << progress->work << ": done\n";
    }
};

int main(int argc, char** argv) try {
    if (argc != 3) throw UsageError("usage: make_scene \"a sentence\" FOLDER");
    PrintProgress progress;
    Run run;
    run.seed = 1;
    run.events = &progress;

    // Start from a preset and change what should be otherwise. These sizes are for trying it out.
    SceneRequest request;
    request.quality = "draft";
    request.params = params_of_quality("draft");
    request.source = PromptSource{argv[1]};
    request.params.panorama.width = 256;
    request.params.views.size = 64;
    request.params.views.points = 5000;
    request.params.splat.count = 5000;
    request.params.splat.steps = 50;

    // Called again after a crash or a stop, it goes on after the last finished stage.
    const RunFolder folder{argv[2]};
    const Json report = make_scene(request, folder, run);
    std::cout << folder.scene_ply().string() << '\n';
} catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
}
