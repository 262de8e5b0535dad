#include "fastscene/pipeline/run_files.h"

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/scene/pose_json.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

Image<Known> known_from_mask(const ImageMask& mask) {
    Image<Known> known(mask.width, mask.height);
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) known.pixels[i] = static_cast<Known>(mask.pixels[i]);
    return known;
}

}  // namespace

ImageColor load_color(const fs::path& path) { return linear_from_srgb8(load_rgb8(path)); }

std::string name_of_viewpoint(std::size_t i) { return fmt::format("{:03}", i); }

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

Panorama load_first_panorama(const RunFolder& folder) {
    Panorama panorama;
    panorama.color = load_color(folder.panorama_color());
    panorama.range = load_float(folder.depth_range());
    if (fs::exists(folder.depth_mirrored_range())) panorama.mirrored_range = load_float(folder.depth_mirrored_range());
    // At another size it is that of a picture before it was enlarged.
    if (fs::exists(folder.panorama_missing())) {
        const ImageMask missing = load_mask_png(folder.panorama_missing());
        if (!missing.same_size(panorama.color)) return panorama;
        panorama.known = Image<Known>(missing.width, missing.height, Known::original);
        for (std::size_t i = 0; i < missing.size(); ++i)
            if (missing.pixels[i]) panorama.known.pixels[i] = Known::invented;
    }
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

std::vector<Rigid> load_walk_poses(const RunFolder& folder) {
    std::vector<Rigid> poses;
    for (const Viewpoint& viewpoint : load_viewpoints(folder.walk() / "poses.json"))
        poses.push_back(viewpoint.world_from_pano);
    return poses;
}

Outside load_outside(const RunFolder& folder) {
    const fs::path directory = folder.walk() / kOutsideName;
    if (!fs::exists(directory)) return {};
    return {load_color(directory / "color.png"), load_mask_png(directory / "seen.png")};
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

Json about_of_stage(const std::filesystem::path& stage) {
    return std::filesystem::exists(stage / kAboutName) ? read_json(stage / kAboutName) : Json::object();
}

std::string device_of_stage(const std::filesystem::path& stage) { return about_of_stage(stage).value("device", ""); }

}  // namespace fastscene
