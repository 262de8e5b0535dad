#include "fastscene/pipeline/share.h"

#include <algorithm>
#include <cstdlib>
#include <numbers>
#include <set>

#include "fastscene/base/data_files.h"
#include "fastscene/base/file.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/base/json.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/pipeline/best_view.h"
#include "fastscene/pipeline/build_info.h"
#include "fastscene/pipeline/film_of_run.h"
#include "fastscene/pipeline/run_files.h"
#include "fastscene/rooms/user_assets.h"
#include "fastscene/scene/walkable_json.h"
#include "fastscene/splat/splat.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

constexpr int kPreviewWidth = 1280, kPreviewHeight = 720;
constexpr float kViewerFovDeg = 75;

std::set<std::string> sources_of(const RunFolder& folder) {
    std::set<std::string> sources;
    if (!fs::exists(folder.room_json())) return sources;  // splats of photographs
    for (const Json& object : read_json(folder.room_json()).value("objects", Json::array()))
        if (const std::string source = object.value("source", ""); !source.empty()) sources.insert(source);
    // Skies and textures of the user's.
    if (const fs::path prompt = folder.stage("panorama") / "prompt.json"; fs::exists(prompt))
        for (const Json& choice : read_json(prompt).value("assumed", Json::array()))
            if (is_one_of(choice.value("what", ""), {kSkyUsed, kTextureUsed}))
                sources.insert(choice.value("value", ""));
    return sources;
}

std::string credits_of(const RunFolder& folder, const std::optional<fs::path>& viewer_dir) {
    std::string text = fmt::format("This scene was made by fastscene {}.\n", program_version());
    const std::set<std::string> sources = sources_of(folder);
    if (!sources.empty()) text += "\nFurniture and surfaces:\n";
    for (const std::string& source : sources)
        text += source == "built-in" ? "  built-in: part of fastscene (Apache-2.0)\n" : "  " + source + "\n";
    if (std::any_of(sources.begin(), sources.end(),
                    [](const std::string& s) { return s.find("CC BY") != std::string::npos; }))
        text +=
            "\nCC BY 3.0 (https://creativecommons.org/licenses/by/3.0/): name the authors above wherever you show this "
            "scene, and say\n"
            "that the models were changed: they were scaled, lit and partly recolored.\n";
    if (!fs::exists(folder.viewer_html())) return text;
    text += "\nviewer.html contains the SuperSplat viewer and the PlayCanvas engine (MIT).\n";
    if (viewer_dir)
        if (const fs::path license = viewer_dir->parent_path() / "LICENSE"; fs::exists(license))
            text += "\n" + read_file(license);
    return text;
}

// Around a room of ours; of other rooms it is not known what stands where.
std::optional<CameraPath> tour_of(const RunFolder& folder, const std::optional<WalkableArea>& area, const Run& run) {
    if (!area || !fs::exists(folder.room_json())) return {};
    FilmWish wish;
    wish.fps = 10;  // of its keys: the viewer interpolates
    wish.fov_deg = kViewerFovDeg;
    try {
        return film_of_run(folder, *area, wish, run);
    } catch (const Error&) {
        return {};  // too little floor to go anywhere
    }
}

// A scene around panorama 0, first seen from `start`.
ViewerScene scene_of(const RunFolder& folder, const std::string& title, const Rigid& start, const Run& run) {
    ViewerScene scene{title, {}, start * Vec3f{0, 0, 1}, kViewerFovDeg, walkable_in(folder)};
    scene.tour = tour_of(folder, scene.walkable, run);
    return scene;
}

}  // namespace

ImageRgb8 picture_of(const Splats& splats, const Pinhole& camera, const Rigid& world_from_camera) {
    return srgb8_from_unit(render_splats(splats, camera, world_from_camera).color);
}

std::optional<fs::path> find_viewer_dir() {
    std::vector<fs::path> places;
    if (const char* place = std::getenv("FASTSCENE_VIEWER_DIR"); place && *place) places.emplace_back(place);
    if (const auto place = find_data("supersplat-viewer/public")) places.push_back(*place);
    for (const fs::path& place : places)
        if (fs::exists(place / "index.html") && fs::exists(place / "index.js")) return place;
    return {};
}

std::string viewer_remedy() {
    return "the viewer's files are missing: run `npm ci --ignore-scripts` in the folder web/ of the sources, or name "
           "their folder in FASTSCENE_VIEWER_DIR";
}

PictureCamera preview_camera(const RunFolder& folder, int width, int height) {
    const float yaw_deg = best_yaw_deg(load_first_panorama(folder), requested_directions(folder));
    return {Pinhole::with_fov(width, height, kPreviewFovDeg), world_from_camera_at({}, yaw_deg, kPreviewPitchDeg)};
}

ViewerScene viewer_scene(const RunFolder& folder, const std::string& title, const Run& run) {
    if (const auto glance = first_glance_of_capture(folder))
        return {title, glance->position_m, glance->position_m + normalize(glance->forward), glance->fov_deg};
    return scene_of(folder, title, preview_camera(folder, kPreviewWidth, kPreviewHeight).world_from_camera, run);
}

void share_scene(const RunFolder& folder, const std::string& title, const Run& run) {
    const Splats splats = load_splat_ply(folder.scene_ply());
    const auto [lens, world_from_camera] = preview_camera(folder, kPreviewWidth, kPreviewHeight);
    save_jpeg(folder.preview_jpg(), picture_of(splats, lens, world_from_camera));

    const auto viewer_dir = find_viewer_dir();
    if (viewer_dir)
        save_viewer_html(folder.viewer_html(), splats, scene_of(folder, title, world_from_camera, run), *viewer_dir);
    else run.warn("viewer.html was not made: " + viewer_remedy() + "; then run the same command again");
    write_credits(folder);
}

std::optional<WalkableArea> walkable_in(const RunFolder& folder) {
    if (!fs::exists(folder.walkable_json())) return {};
    return walkable_from_json(read_json(folder.walkable_json()), folder.walkable_json().string());
}

void write_credits(const RunFolder& folder) { write_file(folder.credits_txt(), credits_of(folder, find_viewer_dir())); }

std::optional<FirstGlance> first_glance_of_capture(const RunFolder& folder) {
    const fs::path file = folder.stage("splat") / "viewer.json";
    if (!fs::exists(file)) return {};
    const Json json = read_json(file);
    try {
        const auto three = [&](const char* name) {
            return Vec3f{json.at(name).at(0), json.at(name).at(1), json.at(name).at(2)};
        };
        return FirstGlance{three("position_m"), three("forward"), json.at("fov_deg")};
    } catch (const Json::exception& e) {
        throw Error("{}: expected position_m, forward and fov_deg: {}", file.string(), e.what());
    }
}

void share_capture(const RunFolder& folder, const std::string& title, const Run& run) {
    const auto glance = first_glance_of_capture(folder);
    if (!glance) throw Error("{}: expected splat/viewer.json, found none", folder.root.string());
    const Splats splats = load_splat_ply(folder.stage("splat") / "viewer.compressed.ply");
    const Vec3f f = normalize(glance->forward);
    constexpr float kDegrees = 180.f / std::numbers::pi_v<float>;
    const Rigid pose = world_from_camera_at(glance->position_m, std::atan2(f.x, f.z) * kDegrees,
                                            std::asin(std::clamp(-f.y, -1.f, 1.f)) * kDegrees);
    save_jpeg(folder.preview_jpg(),
              picture_of(splats, Pinhole::with_fov(kPreviewWidth, kPreviewHeight, glance->fov_deg), pose));
    const auto viewer_dir = find_viewer_dir();
    if (viewer_dir) save_viewer_html(folder.viewer_html(), splats, viewer_scene(folder, title, run), *viewer_dir);
    else run.warn("viewer.html was not made: " + viewer_remedy() + "; then run the same command again");
    write_credits(folder);
}

}  // namespace fastscene
