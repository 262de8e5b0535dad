// Settings with "auto" resolved by what the scene is made from.
#pragma once

#include <string>

#include "fastscene/depth/depth.h"
#include "fastscene/math/vec.h"
#include "fastscene/pipeline/source.h"
#include "fastscene/walk/walk.h"

namespace fastscene {

// What tells the range of such a source: "auto" resolved as far as the source says. Throws UsageError for a backend
// that the source has nothing for.
std::string depth_backend(const SceneSource& source, const DepthParams& params);
// How the range of a further panorama (--more) without a map is estimated, at `position` in the first one's frame: its
// camera stands as high over the floor as that says, at least kLeastCameraHeight.
inline constexpr float kLeastCameraHeight = 0.2f;
DepthParams depth_of_further(DepthParams params, const Vec3f& position);
// The walk's settings: whether a room stands behind the panorama.
WalkParams walk_of(const SceneSource& source, const DepthParams& depth, const WalkParams& params);
// Whether that walk looks into the room.
bool looks_into_room(const WalkParams& resolved);
// Throws UsageError where --walk room or --walk-inpainter room has no room to look into.
void check_walk(const SceneSource& source, const DepthParams& depth, const WalkParams& params);

}  // namespace fastscene
