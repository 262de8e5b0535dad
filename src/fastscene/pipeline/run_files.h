// Reads the outputs of stages from a run's folder: panoramas with ranges and poses.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/scene/outside.h"
#include "fastscene/scene/panorama.h"

namespace fastscene {

// Panorama 0 with range, those of --more with theirs, and the whole walk, as stored.
Panorama load_first_panorama(const RunFolder& folder);
std::vector<Panorama> load_more_panoramas(const RunFolder& folder);
// The outside of a known room's windows: walk/outside/color.png, seen.png. Empty if the walk wrote none.
inline constexpr const char* kOutsideName = "outside";
Outside load_outside(const RunFolder& folder);
std::vector<Panorama> load_walk(const RunFolder& folder);
// world_from_pano of every panorama of the walk, without loading pictures.
std::vector<Rigid> load_walk_poses(const RunFolder& folder);

// What a stage tells of itself; "device": the graphics card that it ran on, if any.
inline constexpr const char* kAboutName = "about.json";
// An empty object if it tells nothing.
Json about_of_stage(const std::filesystem::path& stage);
std::string device_of_stage(const std::filesystem::path& stage);

// An 8-bit picture in linear color.
ImageColor load_color(const std::filesystem::path& path);

// An entry of poses.json in a folder of panoramas.
struct Viewpoint {
    std::string name;  // base name of its files, or its folder
    Rigid world_from_pano;
};
std::string name_of_viewpoint(std::size_t index);  // "007"
void save_viewpoints(const std::filesystem::path& path, const std::vector<Viewpoint>& viewpoints);
std::vector<Viewpoint> load_viewpoints(const std::filesystem::path& path);

}  // namespace fastscene
