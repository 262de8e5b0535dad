#include "fastscene/pipeline/room_of_run.h"

#include <algorithm>
#include <filesystem>

#include "fastscene/base/file.h"
#include "fastscene/io/image_io.h"
#include "fastscene/pipeline/resolve.h"
#include "fastscene/pipeline/same_room.h"

namespace fastscene {

PanoramaParams panorama_of_run(const RecordedRun& recorded, int least_cell_samples) {
    PanoramaParams panorama = recorded.request.params.panorama;
    panorama.trace.cell_samples = std::max(panorama.trace.cell_samples, least_cell_samples);
    return panorama;
}

namespace {

RoomOrigin origin_of_run(const RunFolder& folder, const SceneRequest& request) {
    if (!has_room(request.source))
        throw UsageError("{}: expected a scene from a prompt, found one from a picture, which has no known room",
                         folder.root.string());
    return origin_of(request.source);
}

// An estimated range cannot verify the room, and a run that ended with its panorama has none.
void check_room(const TracedRoom& room, const RunFolder& folder, const SceneRequest& request) {
    if (depth_backend(request.source, request.params.depth) == kExactDepth &&
        std::filesystem::exists(folder.depth_range()))
        check_same_room(room, load_float(folder.depth_range()), folder.root);
}

// The run's room, built for these settings and verified; without its light.
TracedRoom verified_room(const RunFolder& folder, const RecordedRun& recorded, const PanoramaParams& panorama,
                         const Run& run) {
    TracedRoom room = make_unlit_room(origin_of_run(folder, recorded.request), panorama,
                                      {recorded.seed, run.events, run.stop});
    check_room(room, folder, recorded.request);
    return room;
}

// `light`: the file of its light; empty: gathered.
std::shared_ptr<const TracedRoom> lit_room(const RunFolder& folder, const RecordedRun& recorded,
                                           const PanoramaParams& panorama, const std::filesystem::path& light,
                                           const Run& run) {
    auto room = std::make_shared<TracedRoom>(verified_room(folder, recorded, panorama, run));
    light_room(*room, panorama, light, {recorded.seed, run.events, run.stop});
    return room;
}

}  // namespace

std::shared_ptr<const TracedRoom> room_of_run(const RunFolder& folder, const RecordedRun& recorded, const Run& run) {
    return lit_room(folder, recorded, recorded.request.params.panorama, folder.room_light(), run);
}

std::shared_ptr<const TracedRoom> newly_lit_room_of_run(const RunFolder& folder, const RecordedRun& recorded,
                                                        int least_cell_samples, const Run& run) {
    return lit_room(folder, recorded, panorama_of_run(recorded, least_cell_samples), {}, run);
}

std::shared_ptr<const TracedRoom> room_with_kept_light(const RunFolder& folder, const RecordedRun& recorded,
                                                       const Run& run) {
    const PanoramaParams& panorama = recorded.request.params.panorama;
    auto room = std::make_shared<TracedRoom>(verified_room(folder, recorded, panorama, run));
    const std::string file = folder.room_light().string();
    if (!room->take_light(panorama.trace, read_file(file), file))
        throw Error("{}: kept light is not used with a graphics card", file);
    return room;
}

std::shared_ptr<const TracedRoom> unlit_room_of_run(const RunFolder& folder, const RecordedRun& recorded,
                                                    const Run& run) {
    return std::make_shared<const TracedRoom>(verified_room(folder, recorded, recorded.request.params.panorama, run));
}

}  // namespace fastscene
