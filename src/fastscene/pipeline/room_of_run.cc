#include "fastscene/pipeline/room_of_run.h"

#include <algorithm>

#include "fastscene/io/image_io.h"
#include "fastscene/pipeline/resolve.h"
#include "fastscene/pipeline/same_room.h"

namespace fastscene {

PanoramaParams panorama_of_run(const RecordedRun& recorded, int least_cell_samples) {
    PanoramaParams panorama = recorded.request.params.panorama;
    panorama.trace.cell_samples = std::max(panorama.trace.cell_samples, least_cell_samples);
    return panorama;
}

std::shared_ptr<const TracedRoom> room_of_run(const RunFolder& folder, const RecordedRun& recorded,
                                              int least_cell_samples, const Run& run) {
    const SceneRequest& request = recorded.request;
    if (!has_room(request.source))
        throw UsageError("{}: expected a scene from a prompt, found one from a picture, which has no known room",
                         folder.root.string());
    const PanoramaParams panorama = panorama_of_run(recorded, least_cell_samples);
    PromptSpec prompt = read_prompt(prompt_of(request.source), panorama);
    auto room = make_traced_room(prompt, panorama, Run{recorded.seed, run.events, run.stop});
    // An estimated range cannot verify the room.
    if (depth_backend(request.source, request.params.depth) == kExactDepth)
        check_same_room(*room, load_float(folder.depth_range()), folder.root);
    return room;
}

}  // namespace fastscene
