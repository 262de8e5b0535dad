#include "fastscene/pipeline/stage_walk.h"

#include <optional>
#include <vector>

#include "fastscene/base/file.h"
#include "fastscene/depth/estimator.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/pipeline/earlier_run.h"
#include "fastscene/pipeline/resolve.h"
#include "fastscene/pipeline/run_files.h"
#include "fastscene/pipeline/same_room.h"
#include "fastscene/scene/walkable_json.h"
#include "fastscene/trace/standable.h"
#include "fastscene/walk/room_outside.h"
#include "fastscene/walk/room_walk.h"
#include "fastscene/walk/walkable_walk.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

ImageMask mask_from_known(const Image<Known>& known, int width, int height) {
    ImageMask mask(width, height, static_cast<std::uint8_t>(Known::original));
    for (std::size_t i = 0; i < known.pixels.size(); ++i) mask.pixels[i] = static_cast<std::uint8_t>(known.pixels[i]);
    return mask;
}

// Writes nothing if the outside is not visible from anywhere.
void save_outside(const fs::path& walk, const Outside& outside) {
    if (outside.color.empty()) return;
    make_directories(walk / kOutsideName);
    save_png(walk / kOutsideName / "color.png", srgb8_from_linear(outside.color));
    save_png(walk / kOutsideName / "seen.png", outside.seen);
}

// Nothing if the earlier run did not get so far.
std::optional<EarlierWalk> walk_of(const EarlierRun& earlier) {
    const fs::path walk = earlier.folder.walk();
    if (!fs::exists(walk / "poses.json")) return {};
    EarlierWalk out{earlier.room, {}, {}};
    std::vector<fs::path> folders;
    for (const Viewpoint& viewpoint : load_viewpoints(walk / "poses.json")) {
        folders.push_back(walk / viewpoint.name);
        if (folders.size() > 1) out.positions_m.push_back(viewpoint.world_from_pano.translation);
    }
    out.panorama = [folders](std::size_t index) {
        const fs::path& folder = folders.at(index + 1);  // after panorama 0
        Panorama panorama;
        panorama.color = load_color(folder / "color.png");
        panorama.range = load_float(folder / "range.exr");
        return panorama;
    };
    return out;
}

}  // namespace

void make_walk(const SceneSource& source, const PanoramaParams& panorama, const DepthParams& depth,
               const RunFolder& folder, const WalkParams& asked, std::shared_ptr<const TracedRoom> room,
               const EarlierRun* earlier, const fs::path& out, const Run& run) {
    check_walk(source, depth, asked);
    const WalkParams params = walk_of(source, depth, asked);
    if (looks_into_room(params) && !room) {
        auto made = std::make_shared<TracedRoom>(make_unlit_room(origin_of(source), panorama, run));
        check_same_room(*made, load_float(folder.depth_range()), folder.root);
        light_room(*made, panorama, folder.room_light(), run);
        room = std::move(made);
    }
    WalkAdvice advice;
    if (is_estimated(source, depth)) {
        DepthParams published = depth;  // after each of 48 steps: a single evaluation, as published
        if (published.tta == 0) published.tta = 1;
        advice.range = [estimator = std::shared_ptr<DepthEstimator>(make_depth_estimator(published))](
                           const ImageColor& color, const Run& r) { return estimator->estimate(color, r).range; };
    }
    if (params.inpainter == kLookIntoRoom) {
        advice.room = [&room, &panorama](const Rigid& world_from_pano, const ImageMask& mask, const Run& r) {
            ShotParts parts = panorama_parts(panorama.trace);  // as for panorama 0
            parts.range = parts.object = false;
            parts.mirrored_range = true;
            parts.only = &mask;
            Shot shot = room->panorama(world_from_pano, {mask.width, mask.height}, parts, r);
            return RoomSight{std::move(shot.color), std::move(shot.mirrored_range)};
        };
    }
    std::vector<Viewpoint> viewpoints;
    std::vector<Invention> inventions;
    const auto save = [&](const Panorama& seen) {
        run.check_stop();
        const std::string name = name_of_viewpoint(viewpoints.size());
        inventions.push_back(invention_of(seen));
        make_directories(out / name);
        save_png(out / name / "color.png", srgb8_from_linear(seen.color));
        save_exr(out / name / "range.exr", seen.range);
        save_png(out / name / "known.png", mask_from_known(seen.known, seen.color.width, seen.color.height));
        viewpoints.push_back({name, seen.world_from_pano});
    };
    const Panorama first = load_first_panorama(folder);
    const StandableFloor floor = params.kind == kRoomWalk ? passable_floor(*room) : StandableFloor{};
    std::optional<EarlierWalk> again;
    // If all of the light changed, so did nearly every pixel.
    const bool keeps = earlier && params.kind == kRoomWalk &&
                       about_of_stage(folder.stage("panorama")).value("kept_light", 0.) > 0;
    if (keeps) again = walk_of(*earlier);
    Json about = params.kind == kRoomWalk
                     ? walk_through_room(first, *room, floor, params, panorama_parts(panorama.trace), run, save,
                                         again ? &*again : nullptr)
                     : walk_through(first, params, run, save, advice, load_more_panoramas(folder));
    if (params.kind == kRoomWalk)
        save_outside(out, outside_of_room(*room, floor, first.world_from_pano.rotation, first.size(), run));
    about["invented"] = to_json(inventions);
    const bool stands = !standable_cells(floor).empty();
    write_json(out / folder.walkable_json().filename(),
               walkable_json(stands ? walkable_room(floor) : walkable_of(inventions, floor_below(first))));
    save_viewpoints(out / "poses.json", viewpoints);
    if (room && looks_into_room(params) && !room->device().empty()) about["device"] = room->device();
    write_json(out / kAboutName, about);
}

}  // namespace fastscene
