// The stages as they meet the disk: each reads what the stages before it wrote and writes its own files.
// A stage always starts from the files, even right after they were made: a color that went through 8 bits is
// not the color before it, and a resumed run must end in the same bytes.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "fastscene/pipeline/quality.h"
#include "fastscene/pipeline/run_folder.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

// What a scene is made from: a sentence, or a panorama of the user's, with or without a range map.
struct SceneSource {
    std::string prompt;
    std::filesystem::path picture;  // empty: the prompt is furnished and traced, or painted
    std::filesystem::path range_map;
    std::filesystem::path weights;  // of Diffusion360, which paints the prompt or, where there is a picture, makes it
                                    // larger; empty: neither
    std::filesystem::path photo;    // that Diffusion360 continues all around; empty: it has the prompt alone
    std::filesystem::path more;  // list of further panoramas with their poses (panorama/more_panoramas.h); empty: the
                                 // picture is the only one
    bool is_painted() const { return picture.empty() && !weights.empty(); }
    bool has_room() const {
        return picture.empty() && weights.empty();
    }  // a room of which all is known stands behind the panorama
};

// Each writes the files of its stage into `out` (run_folder.h has their names).
// Returns the room that was traced, lit, for a walk that wants to look into it; null where there is none.
std::shared_ptr<const TracedRoom> make_panorama(const SceneSource& source, const PanoramaParams& params,
                                                const std::filesystem::path& out, const Run& run);
void make_depth(const SceneSource& source, const PanoramaParams& panorama, const DepthParams& params,
                const RunFolder& folder, const std::filesystem::path& out, const Run& run);
// What tells the range of such a source: "auto" resolved as far as the source says. Throws UsageError for a backend
// that the source has nothing for.
std::string depth_backend(const SceneSource& source, const DepthParams& params);
// How the range of a further panorama (--more) without a map is estimated, at `position` in the first one's frame: its
// camera stands as high over the floor as that says, at least kLeastCameraHeight.
inline constexpr float kLeastCameraHeight = 0.2f;
DepthParams depth_of_further(DepthParams params, const Vec3f& position);
// The walk's settings with "auto" resolved: whether a room stands behind the panorama.
WalkParams walk_of(const SceneSource& source, const DepthParams& depth, const WalkParams& params);
// The trainer's settings with "automatic" resolved: reflections are worth harmonics where views of a known room show
// them as they are; what was warped or painted knows nothing of them.
SplatParams splat_of(const SceneSource& source, const DepthParams& depth, const WalkParams& walk, SplatParams params);
// Whether that walk looks into the room.
bool looks_into_room(const WalkParams& resolved);
// Throws UsageError where --walk room or --walk-inpainter room has no room to look into.
void check_walk(const SceneSource& source, const DepthParams& depth, const WalkParams& params);
// The published walks estimate range anew after each step where the depth stage estimated it; `depth` says how. `room`:
// what make_panorama returned; null: it is made and lit again where it is needed, and is the same.
void make_walk(const SceneSource& source, const PanoramaParams& panorama, const DepthParams& depth,
               const RunFolder& folder, const WalkParams& params, std::shared_ptr<const TracedRoom> room,
               const std::filesystem::path& out, const Run& run);
void make_views(const RunFolder& folder, const ViewsParams& params, const std::filesystem::path& out, const Run& run);
void make_splat(const RunFolder& folder, const SplatParams& params, const std::filesystem::path& out, const Run& run);
// As fit_splats, but where the user named no checkpoint a stopped training goes on from one in the run's folder: until
// its splats are saved, which a full disk may prevent, and the place is forgotten.
FittedSplats fit_and_keep_place(const ViewSet& views, SplatParams params, const RunFolder& folder, const Run& run);
void forget_place(const RunFolder& folder);

// scene.ply, scene.compressed.ply and curve.json.
void save_fit(const FittedSplats& fitted, const std::filesystem::path& out);

// Panorama 0 with its range, those of --more with theirs, and the whole walk, as the files have them.
Panorama load_first_panorama(const RunFolder& folder);
std::vector<Panorama> load_more_panoramas(const RunFolder& folder);
std::vector<Panorama> load_walk(const RunFolder& folder);
// world_from_pano of every panorama of the walk, without the pictures.
std::vector<Rigid> load_walk_poses(const RunFolder& folder);

}  // namespace fastscene
