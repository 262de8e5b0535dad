// Resolves "auto" settings by the scene's source.
#pragma once

#include <string>

#include "fastscene/depth/depth.h"
#include "fastscene/math/vec.h"
#include "fastscene/pipeline/source.h"
#include "fastscene/walk/walk.h"

namespace fastscene {

// The depth backend for a source: "auto" resolved as far as the source determines it. Throws UsageError for a backend
// that needs something the source does not have.
std::string depth_backend(const SceneSource& source, const DepthParams& params);
// Whether a backend estimates the range from the picture.
bool is_estimated(const SceneSource& source, const DepthParams& params);
// Depth settings for a further panorama (--more) without range map, at `position` in the first one's frame: its camera
// height above the floor follows from that, at least kLeastCameraHeight.
inline constexpr float kLeastCameraHeight = 0.2f;
DepthParams depth_of_further(DepthParams params, const Vec3f& position);
// The walk's settings, with "auto" resolved by whether the room is known.
WalkParams walk_of(const SceneSource& source, const DepthParams& depth, const WalkParams& params);
// Whether that walk renders the room.
bool looks_into_room(const WalkParams& resolved);
// Throws UsageError if --walk room or --walk-inpainter room is used without a known room.
void check_walk(const SceneSource& source, const DepthParams& depth, const WalkParams& params);

}  // namespace fastscene
