// Stills: pictures of a scene for no-reference measures. Three sets with the same directions isolate the cost of each
// step:
// walked: rendered from the splats, from positions around panorama 0 (what a visitor sees; the paper's "30 images of
// each scene");
// origin: rendered from the splats at panorama 0's position;
// input: cut from panorama 0 with the same cameras, the splats' training target.
#pragma once

#include <vector>

#include "fastscene/evaluate/suite.h"
#include "fastscene/geometry/pinhole.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/scene/splats.h"

namespace fastscene {

// Directions all around, level, down and up in turn; positions in a ball of radius_m, limited to the free space by
// `range` (empty: unknown). The same for every scene and system.
std::vector<Rigid> still_poses(const StillsParams& params, const ImageF& range);
// Square; params.size_px, or the resolution of a panorama of this width at the picture's center, rounded to 64 pixels.
Pinhole still_camera(const StillsParams& params, int panorama_width);

// Writes NN.png each.
void save_walked_stills(const std::filesystem::path& folder, const Splats& splats, const StillsParams& params,
                        const Pinhole& camera, const ImageF& range, const Run& run);
void save_origin_stills(const std::filesystem::path& folder, const Splats& splats, const StillsParams& params,
                        const Pinhole& camera, const Run& run);
void save_input_stills(const std::filesystem::path& folder, const Panorama& first, const StillsParams& params,
                       const Pinhole& camera, const Run& run);

}  // namespace fastscene
