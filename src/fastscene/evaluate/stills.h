// Stills: the pictures of a scene that are judged without a reference. Three sets with the same directions tell what
// each step costs:
//   walked: the splats, from around panorama 0's place (what a visitor sees; the paper's "30 images of each scene");
//   origin: the splats, from panorama 0's place itself;
//   input:  panorama 0 cut by the same cameras: what the splats were trained to look like.
#pragma once

#include <vector>

#include "fastscene/evaluate/suite.h"
#include "fastscene/geometry/pinhole.h"
#include "fastscene/scene/panorama.h"
#include "fastscene/scene/splats.h"

namespace fastscene {

// Directions all around, level, down and up in turn; places in a ball of radius_m, where `range` (empty: unknown)
// leaves free space. The same for every scene and system.
std::vector<Rigid> still_poses(const StillsParams& params, const ImageF& range);
// Square; params.size_px, or as fine as a panorama of this width at the middle of the picture, to 64 pixels.
Pinhole still_camera(const StillsParams& params, int panorama_width);

// NN.png each.
void save_walked_stills(const std::filesystem::path& folder, const Splats& splats, const StillsParams& params,
                        const Pinhole& camera, const ImageF& range, const Run& run);
void save_origin_stills(const std::filesystem::path& folder, const Splats& splats, const StillsParams& params,
                        const Pinhole& camera, const Run& run);
void save_input_stills(const std::filesystem::path& folder, const Panorama& first, const StillsParams& params,
                       const Pinhole& camera, const Run& run);

}  // namespace fastscene
