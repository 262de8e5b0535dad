// Names of all files and folders in a run folder. Other tools rely on them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/folder_lock.h"

namespace fastscene {

// The stages that produce files, in pipeline order: names of directories and commands.
inline constexpr std::string_view kStages[] = {"panorama", "depth", "walk", "views", "splat"};

struct RunFolder {
    std::filesystem::path root;

    std::filesystem::path run_json() const { return root / "run.json"; }
    std::filesystem::path report_json() const { return root / "report.json"; }
    std::filesystem::path viewer_html() const { return root / "viewer.html"; }
    std::filesystem::path preview_jpg() const { return root / "preview.jpg"; }
    std::filesystem::path credits_txt() const { return root / "credits.txt"; }

    // Diffusion360's picture, 1.png, and its upscaled versions, 3.png, 6.png …: cached.
    std::filesystem::path painting() const { return root / "painting"; }
    std::filesystem::path stage(std::string_view name) const { return root / name; }
    std::filesystem::path panorama_color() const { return root / "panorama" / "color.png"; }
    // Where the user's picture had nothing: 255. Absent if it had everything.
    std::filesystem::path panorama_missing() const { return root / "panorama" / "missing.png"; }
    // The user's further panoramas, rotated to the first's orientation: NNN.png with poses.json, NNN.exr.
    std::filesystem::path more_panoramas() const { return root / "panorama" / "more"; }
    std::filesystem::path more_ranges() const { return root / "depth" / "more"; }
    std::filesystem::path prompt_json() const { return root / "panorama" / "prompt.json"; }
    std::filesystem::path room_json() const { return root / "panorama" / "room.json"; }
    // The light of a known room (TracedRoom::light).
    std::filesystem::path room_light() const { return root / "panorama" / "light.bin"; }
    std::filesystem::path depth_range() const { return root / "depth" / "range.exr"; }
    // Range through mirrors, where panorama 0 of a known room shows one.
    std::filesystem::path depth_mirrored_range() const { return root / "depth" / "mirrored-range.exr"; }
    std::filesystem::path walk() const { return root / "walk"; }
    // Where visitors may walk (scene/walkable_json.h).
    std::filesystem::path walkable_json() const { return root / "walk" / "walkable.json"; }
    std::filesystem::path views() const { return root / "views"; }
    // Checkpoint of an interrupted training; deleted when it is complete.
    std::filesystem::path splat_place() const { return root / ".splat.unfinished"; }
    // What the splats look like while they are trained; deleted when they are complete.
    std::filesystem::path training_jpg() const { return root / "training.jpg"; }
    std::filesystem::path scene_ply() const { return root / "splat" / "scene.ply"; }
    std::filesystem::path scene_compressed_ply() const { return root / "splat" / "scene.compressed.ply"; }
    std::filesystem::path metrics() const { return root / "metrics"; }

    // All of the above that belong to a run, relative to the root.
    static std::vector<std::string> owned();
};

// "A cozy bedroom, 3 chairs" -> "a-cozy-bedroom-3-chairs": letters and digits, at most 60 of them; "scene" if none are
// left.
std::string slug_of(std::string_view text);

}  // namespace fastscene
