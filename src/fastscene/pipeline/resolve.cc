#include "fastscene/pipeline/resolve.h"

#include <algorithm>

namespace fastscene {

std::string depth_backend(const SceneSource& source, const DepthParams& params) {
    const bool known = has_room(source), has_map = !range_map_of(source).empty();
    if (params.backend == kAutoDepth && known) return kExactDepth;
    if (params.backend == kAutoDepth && has_map) return kMapDepth;
    if (params.backend == kExactDepth && !known)
        throw UsageError("--depth-backend exact: expected a prompt with the rooms backend; {} has no known room",
                         what_is_behind(source));
    if (params.backend == kMapDepth && !has_map)
        throw UsageError("--depth-backend image: expected --range FILE, found none");
    return params.backend;
}

bool is_estimated(const SceneSource& source, const DepthParams& params) {
    const std::string backend = depth_backend(source, params);
    return backend != kExactDepth && backend != kMapDepth;
}

DepthParams depth_of_further(DepthParams params, const Vec3f& position) {
    if (params.backend == kMapDepth) params.backend = kAutoDepth;  // the given range map belongs to the first panorama
    params.camera_height_m = std::max(kLeastCameraHeight, params.camera_height_m - position.y);  // y points down
    return params;
}

WalkParams walk_of(const SceneSource& source, const DepthParams& depth, const WalkParams& params) {
    return resolved(params, has_room(source) && depth_backend(source, depth) == kExactDepth);
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
    if (!has_room(source))
        refuse("a prompt with the rooms backend", what_is_behind(source) + ", which has no known room");
    if (const std::string backend = depth_backend(source, depth); backend != kExactDepth)
        refuse("the room's own range", "--depth-backend " + backend);
    if (params.kind != "ours" && params.kind != kRoomWalk) refuse("--walk ours", params.kind);
}

}  // namespace fastscene
