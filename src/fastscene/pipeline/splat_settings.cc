#include "fastscene/pipeline/splat_settings.h"

#include "fastscene/pipeline/resolve.h"

namespace fastscene {

SplatParams splat_of(const SceneSource& source, const DepthParams& depth, const WalkParams& walk, SplatParams params) {
    constexpr int kReflections = 2;
    if (params.sh_degree == kAutomaticShDegree)
        params.sh_degree = walk_of(source, depth, walk).kind == kRoomWalk ? kReflections : 0;
    return params;
}

}  // namespace fastscene
