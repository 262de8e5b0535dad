#include "fastscene/pipeline/stages.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "fastscene/base/events.h"
#include "fastscene/base/file.h"
#include "fastscene/base/shortest.h"
#include "fastscene/depth/depth.h"
#include "fastscene/depth/estimator.h"
#include "fastscene/image/color.h"
#include "fastscene/image/colormap.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/view_io.h"
#include "fastscene/pipeline/build_info.h"
#include "fastscene/pipeline/fit_report.h"
#include "fastscene/panorama/more_panoramas.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/pipeline/same_room.h"
#include "fastscene/pipeline/sfm.h"
#include "fastscene/scene/walkable_json.h"
#include "fastscene/trace/standable.h"
#include "fastscene/walk/agreement.h"
#include "fastscene/walk/room_walk.h"
#include "fastscene/walk/walkable_walk.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

ImageColor load_color(const fs::path& path) { return linear_from_srgb8(load_rgb8(path)); }

ImageMask mask_from_known(const Image<Known>& known, int width, int height) {
    ImageMask mask(width, height, static_cast<std::uint8_t>(Known::original));
    for (std::size_t i = 0; i < known.pixels.size(); ++i) mask.pixels[i] = static_cast<std::uint8_t>(known.pixels[i]);
    return mask;
}
Image<Known> known_from_mask(const ImageMask& mask) {
    Image<Known> known(mask.width, mask.height);
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) known.pixels[i] = static_cast<Known>(mask.pixels[i]);
    return known;
}

// Row by row, 4 x 4; read back they are the same floats.
Json json_from_pose(const Rigid& pose) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3f row = i == 0 ? pose.rotation.row0 : i == 1 ? pose.rotation.row1 : pose.rotation.row2;
        rows.push_back({shortest(row.x), shortest(row.y), shortest(row.z), shortest(pose.translation[i])});
    }
    rows.push_back({0, 0, 0, 1});
    return rows;
}
Rigid pose_from_json(const Json& rows) {
    const auto row = [&](std::size_t i) { return Vec3f{rows.at(i).at(0), rows.at(i).at(1), rows.at(i).at(2)}; };
    return {{row(0), row(1), row(2)}, {rows.at(0).at(3), rows.at(1).at(3), rows.at(2).at(3)}};
}

// For people: near is blue, far is red, what has no range is black. A window's far view does not stretch the colors.
ImageRgb8 picture_of_range(const ImageF& range) {
    std::vector<float> known;
    for (const float r : range.pixels)
        if (r > 0.f && std::isfinite(r)) known.push_back(r);
    if (known.empty()) return ImageRgb8(range.width, range.height);
    const auto at = known.begin() + static_cast<std::ptrdiff_t>(known.size() * 98 / 100);
    std::nth_element(known.begin(), at, known.end());
    return colored(reduced_range(range, 1024), 0.f, *at);
}

std::string name_of_viewpoint(std::size_t i) { return fmt::format("{:03}", i); }

struct Viewpoint {
    std::string name;
    Rigid world_from_pano;
};

void save_viewpoints(const fs::path& path, const std::vector<Viewpoint>& viewpoints) {
    Json poses = Json::array();
    for (const auto& [name, pose] : viewpoints)
        poses.push_back({{"name", name}, {"world_from_pano", json_from_pose(pose)}});
    write_json(path, {{"panoramas", poses}});
}

std::vector<Viewpoint> load_viewpoints(const fs::path& path) {
    const Json json = read_json(path);
    std::vector<Viewpoint> viewpoints;
    try {
        for (const Json& entry : json.at("panoramas"))
            viewpoints.push_back({entry.at("name").get<std::string>(), pose_from_json(entry.at("world_from_pano"))});
    } catch (const Json::exception& e) {
        throw Error("{}: expected panoramas with name and world_from_pano: {}", path.string(), e.what());
    }
    return viewpoints;
}

void save_more_panoramas(const fs::path& list, EquirectSize size, const fs::path& out, const Run& run) {
    make_directories(out);
    std::vector<Viewpoint> viewpoints;
    for (const MorePanorama& more : read_more_panoramas(list)) {
        run.check_stop();
        Panorama one = panorama_from_image(more.color);
        one.world_from_pano = more.world_from_pano;
        one = in_first_orientation(one, size);
        viewpoints.push_back({name_of_viewpoint(viewpoints.size() + 1), one.world_from_pano});
        save_png(out / (viewpoints.back().name + ".png"), srgb8_from_linear(one.color));
    }
    save_viewpoints(out / "poses.json", viewpoints);
}

// Passes on what is said of one of several pictures, with its file's name before it.
class SaidOfPicture : public EventSink {
  public:
    SaidOfPicture(const fs::path& picture, EventSink* sink) : picture_(picture.string()), sink_(sink) {}
    void tell(const Event& event) override {
        if (!sink_) return;
        if (const auto* note = std::get_if<NoteEvent>(&event)) sink_->tell(NoteEvent{picture_ + ": " + note->text});
        else if (const auto* warning = std::get_if<WarningEvent>(&event))
            sink_->tell(WarningEvent{picture_ + ": " + warning->text});
        else sink_->tell(event);
    }

  private:
    std::string picture_;
    EventSink* sink_;
};

// The range of each further panorama: its own map, or estimated and scaled until it agrees with the first's. What was
// assumed and found, each.
Json save_more_ranges(const SceneSource& source, const DepthParams& params, const RunFolder& folder,
                      const ImageF& first_range, const fs::path& out, const Run& run) {
    make_directories(out);
    const Panorama first{load_color(folder.panorama_color()), first_range, {}, {}};
    const std::vector<Viewpoint> viewpoints = load_viewpoints(folder.more_panoramas() / "poses.json");
    const std::vector<MorePanorama> given = read_more_panoramas(source.more);
    Json about = Json::array();
    for (std::size_t i = 0; i < viewpoints.size(); ++i) {
        run.check_stop();
        const auto& [name, pose] = viewpoints[i];
        Panorama one{load_color(folder.more_panoramas() / (name + ".png")), {}, {}, pose};
        Json entry{{"name", name}, {"picture", given[i].color.filename().string()}};
        if (!given[i].range.empty()) {
            Panorama measured = panorama_from_image(given[i].color);
            measured.range = range_from_file(given[i].range, measured.size(), run);
            measured.world_from_pano = given[i].world_from_pano;
            one.range = in_first_orientation(measured, one.size()).range;
            entry["backend"] = "image";
        } else {
            SaidOfPicture said(given[i].color, run.events);
            EstimatedRange found = make_depth_estimator(depth_of_further(params, pose.translation))
                                       ->estimate(one.color, {run.seed, &said, run.stop});
            one.range = std::move(found.range);
            const float scale = scale_to_agree(first, one);
            for (float& r : one.range.pixels) r *= scale;
            entry.update(found.assumptions);
            entry["scaled_to_agree_by"] = scale;
        }
        save_exr(out / (name + ".exr"), one.range);
        about.push_back(std::move(entry));
    }
    return about;
}

}  // namespace

std::shared_ptr<const TracedRoom> make_panorama(const SceneSource& source, const PanoramaParams& params,
                                                const fs::path& out, const Run& run) {
    std::shared_ptr<const TracedRoom> traced;
    Json prompt, room;
    Panorama panorama;
    const PaintingSource painting{source.prompt, source.weights, source.photo};
    const PaintingMemory memory{RunFolder{out.parent_path()}.painting(), code_version("panorama")};
    if (source.is_painted()) {
        const fs::path look = out.parent_path() / "painting.png";  // people may look while it is painted
        const auto shown = [&](const ImageRgb8& preview) {
            if (!fs::exists(look)) run.note(fmt::format("a first look: {}", look.string()));
            save_png(look, preview);
        };
        panorama.color = linear_from_srgb8(panorama_by_diffusion360(painting, params, run, shown, memory));
        fs::remove(look);
        prompt = {{"text", source.prompt}, {"made_by", "diffusion360"}};
        if (!source.photo.empty()) prompt["photo"] = source.photo.filename().string();
        room = {{"objects", Json::array()}};
    } else if (source.picture.empty()) {
        RoomPanorama made = panorama_from_prompt(source.prompt, params, run);
        panorama = std::move(made.panorama);
        prompt = to_json(made.prompt);
        room = room_json(made.room->room(), made.object_of_pixel);
        traced = std::move(made.room);
    } else {
        panorama = reduced_panorama(panorama_from_image(source.picture), params.width);
        if (!source.weights.empty() && params.diffusion.upscale != "none")
            panorama.color = linear_from_srgb8(
                enlarged_by_diffusion360(srgb8_from_linear(panorama.color), painting, params, run, memory));
        prompt = {{"text", source.prompt}, {"picture", source.picture.filename().string()}};
        room = {{"objects", Json::array()}};
    }
    save_png(out / "color.png", srgb8_from_linear(panorama.color));
    if (!source.more.empty()) save_more_panoramas(source.more, panorama.size(), out / "more", run);
    write_json(out / "prompt.json", prompt);
    write_json(out / "room.json", room);
    return traced;
}

void make_depth(const SceneSource& source, const PanoramaParams& panorama, const DepthParams& params,
                const RunFolder& folder, const fs::path& out, const Run& run) {
    const PictureInfo info = picture_info(folder.panorama_color());
    const EquirectSize size{info.width, info.height};
    const std::string backend = depth_backend(source, params);
    EstimatedRange found{{}, {{"backend", backend}}};
    if (backend == "exact") {
        // The room is laid out again rather than kept: that is quick, and it is what a resumed run would do.
        PromptSpec prompt = read_prompt(source.prompt, panorama);
        const TracedRoom room(make_room(prompt, run));
        found.range = exact_range(room, size, run);
        if (const ImageF mirrored = exact_mirrored_range(room, size, run); !mirrored.empty())
            save_exr(out / folder.depth_mirrored_range().filename(), mirrored);
    } else if (backend == "image") {
        found.range = reduced_range(range_from_file(source.range_map, panorama_size(source.picture), run), size.width);
    } else {
        found = make_depth_estimator(params)->estimate(load_color(folder.panorama_color()), run);
    }
    save_exr(out / "range.exr", found.range);
    if (!source.more.empty())
        found.assumptions["more"] = save_more_ranges(source, params, folder, found.range, out / "more", run);
    save_png(out / "range.png", picture_of_range(found.range));
    write_json(out / "about.json", found.assumptions);
}

std::string depth_backend(const SceneSource& source, const DepthParams& params) {
    const bool has_room = source.has_room(), has_map = !source.range_map.empty();
    if (params.backend == "auto" && has_room) return "exact";
    if (params.backend == "auto" && has_map) return "image";
    if (params.backend == "exact" && !has_room)
        throw UsageError(
            "--depth-backend exact: expected a prompt and the rooms' maker; behind {} there is no room to ask",
            source.picture.empty() ? "a painted panorama" : "the picture " + source.picture.string());
    if (params.backend == "image" && !has_map)
        throw UsageError("--depth-backend image: expected --range FILE, found none");
    return params.backend;
}

DepthParams depth_of_further(DepthParams params, const Vec3f& position) {
    if (params.backend == "image") params.backend = "auto";  // the map was the first panorama's
    params.camera_height_m = std::max(kLeastCameraHeight, params.camera_height_m - position.y);  // y points down
    return params;
}

Panorama load_first_panorama(const RunFolder& folder) {
    Panorama panorama;
    panorama.color = load_color(folder.panorama_color());
    panorama.range = load_float(folder.depth_range());
    if (fs::exists(folder.depth_mirrored_range())) panorama.mirrored_range = load_float(folder.depth_mirrored_range());
    return panorama;
}

std::vector<Panorama> load_more_panoramas(const RunFolder& folder) {
    std::vector<Panorama> more;
    if (!fs::exists(folder.more_panoramas())) return more;
    for (const auto& [name, pose] : load_viewpoints(folder.more_panoramas() / "poses.json"))
        more.push_back({load_color(folder.more_panoramas() / (name + ".png")),
                        load_float(folder.more_ranges() / (name + ".exr")),
                        {},
                        pose});
    return more;
}

WalkParams walk_of(const SceneSource& source, const DepthParams& depth, const WalkParams& params) {
    return resolved(params, source.has_room() && depth_backend(source, depth) == "exact");
}

SplatParams splat_of(const SceneSource& source, const DepthParams& depth, const WalkParams& walk, SplatParams params) {
    constexpr int kReflections = 2;
    if (params.sh_degree == kAutomaticShDegree)
        params.sh_degree = walk_of(source, depth, walk).kind == kRoomWalk ? kReflections : 0;
    return params;
}

bool looks_into_room(const WalkParams& walk) { return walk.kind == kRoomWalk || walk.inpainter == kLookIntoRoom; }

void check_walk(const SceneSource& source, const DepthParams& depth, const WalkParams& asked) {
    const WalkParams params = walk_of(source, depth, asked);
    if (!looks_into_room(params)) return;
    const std::string flag = params.kind == kRoomWalk ? fmt::format("--walk {}", kRoomWalk)
                                                      : fmt::format("--walk-inpainter {}", kLookIntoRoom);
    const auto refuse = [&](std::string_view expected, std::string_view found) {
        throw UsageError("{}: expected {}, found {}", flag, expected, found);
    };
    if (!source.has_room())
        refuse("a prompt and the rooms' maker",
               source.picture.empty() ? "a painted panorama, behind which there is no room"
                                      : "the picture " + source.picture.string() + ", behind which there is no room");
    if (const std::string backend = depth_backend(source, depth); backend != "exact")
        refuse("the room's own range", "--depth-backend " + backend);
    if (params.kind != "ours" && params.kind != kRoomWalk) refuse("--walk ours", params.kind);
}

void make_walk(const SceneSource& source, const PanoramaParams& panorama, const DepthParams& depth,
               const RunFolder& folder, const WalkParams& asked, std::shared_ptr<const TracedRoom> room,
               const fs::path& out, const Run& run) {
    check_walk(source, depth, asked);
    const WalkParams params = walk_of(source, depth, asked);
    if (looks_into_room(params) && !room) {
        PromptSpec prompt = read_prompt(source.prompt, panorama);
        room = make_traced_room(prompt, panorama, run);
        check_same_room(*room, load_float(folder.depth_range()), folder.root);
    }
    WalkAdvice advice;
    if (const std::string backend = depth_backend(source, depth); backend != "exact" && backend != "image") {
        DepthParams published = depth;  // after each of 48 steps: one look, as published
        if (published.looks == 0) published.looks = 1;
        advice.range = [estimator = std::shared_ptr<DepthEstimator>(make_depth_estimator(published))](
                           const ImageColor& color, const Run& r) { return estimator->estimate(color, r).range; };
    }
    if (params.inpainter == kLookIntoRoom) {
        advice.room = [&room, &panorama](const Rigid& world_from_pano, const ImageMask& mask, const Run& r) {
            ShotParts parts = panorama_parts(panorama.trace);  // as panorama 0 was shot
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
    Json about = params.kind == kRoomWalk
                     ? walk_through_room(first, *room, floor, params, panorama_parts(panorama.trace), run, save)
                     : walk_through(first, params, run, save, advice, load_more_panoramas(folder));
    about["invented"] = to_json(inventions);
    const bool stands = !standable_cells(floor).empty();
    write_json(out / folder.walkable_json().filename(),
               walkable_json(stands ? walkable_room(floor) : walkable_of(inventions, floor_below(first))));
    save_viewpoints(out / "poses.json", viewpoints);
    write_json(out / "about.json", about);
}

std::vector<Rigid> load_walk_poses(const RunFolder& folder) {
    std::vector<Rigid> poses;
    for (const Viewpoint& viewpoint : load_viewpoints(folder.walk() / "poses.json"))
        poses.push_back(viewpoint.world_from_pano);
    return poses;
}

std::vector<Panorama> load_walk(const RunFolder& folder) {
    std::vector<Panorama> panoramas;
    for (const Viewpoint& viewpoint : load_viewpoints(folder.walk() / "poses.json")) {
        const fs::path directory = folder.walk() / viewpoint.name;
        panoramas.push_back({load_color(directory / "color.png"), load_float(directory / "range.exr"),
                             known_from_mask(load_mask_png(directory / "known.png")), viewpoint.world_from_pano});
    }
    return panoramas;
}

void make_views(const RunFolder& folder, const ViewsParams& params, const fs::path& out, const Run& run) {
    const ViewSet known = project_views(load_walk(folder), params, run);
    save_views(out, known);
    if (params.sfm == "known") return;
    // The model that the splats are trained from is COLMAP's; the known one stays beside it.
    const SfmResult found = structure_from_motion(out, known, params.sfm, run);
    make_directories(out / "known");
    fs::rename(out / "sparse", out / "known" / "sparse");
    fs::rename(out / "transforms.json", out / "known" / "transforms.json");
    save_views(out, found.set);
    write_json(out / "sfm.json", to_json(found.report));
    write_file(out / "sfm.txt", table_of(found.report));
    const SfmReport& r = found.report;
    run.note(
        fmt::format("COLMAP: {} of {} views registered, {} points, {:.0f} s; position off by {:.4f} m (median), "
                    "rotation by {:.3f} degrees; views/sfm.txt has all",
                    r.registered, r.views, r.points, r.seconds, r.position_median_m, r.rotation_median_deg));
    if (r.registered < r.views)
        run.warn(fmt::format("COLMAP did not register {} of {} views: the splats are trained without them",
                             r.views - r.registered, r.views));
}

void make_splat(const RunFolder& folder, const SplatParams& params, const fs::path& out, const Run& run) {
    const ViewSet views = load_views(folder.views());
    SplatParams sized = params;
    sized.count = count_for(views.points, params);
    if (const int fit = most_that_fit(params); params.per_m2 > 0 && fit < sized.count) {
        run.warn(fmt::format("splat: the room wants {} Gaussians and there is memory for {}: it will look coarser",
                             sized.count, fit));
        sized.count = fit;
    } else if (sized.count < params.count)
        run.note(fmt::format("splat: {} Gaussians for the size of the room", sized.count));
    else if (params.per_m2 > 0)
        run.note(fmt::format("splat: {} Gaussians, the most that --splat-count allows", sized.count));
    save_fit(fit_and_keep_place(views, sized, folder, run), out);
    forget_place(folder);
}

FittedSplats fit_and_keep_place(const ViewSet& views, SplatParams params, const RunFolder& folder, const Run& run) {
    if (!params.checkpoint.empty()) return fit_splats(views, params, run);
    const fs::path place = folder.splat_place();  // a folder, so that what a kill leaves half written goes with it
    params.checkpoint = (place / "checkpoint").string();
    if (!is_checkpoint_of(params.checkpoint, views, params, run.seed)) fs::remove_all(place);  // of other settings
    make_directories(place);
    return fit_splats(views, params, run);
}

void forget_place(const RunFolder& folder) { fs::remove_all(folder.splat_place()); }

void save_fit(const FittedSplats& fitted, const fs::path& out) {
    save_splat_ply(out / "scene.ply", fitted.splats);
    save_compressed_ply(out / "scene.compressed.ply", fitted.splats);
    save_curves(out, fitted);
}

}  // namespace fastscene
