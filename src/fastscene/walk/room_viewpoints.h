// RoomViewpoints: from where to look at a known room so that all of it is seen well, wherever a visitor will stand.
//
// What visitors see is sampled first: rays from random eyes over the standable floor meet surfaces, each as often as
// visitors look at it. RoomViewpoints are then chosen one after the other, always the one that adds most to how well
// those samples are seen (the greedy choice for a submodular cover: at least 1 - 1/e of what any choice of as many
// could reach; Nemhauser, Wolsey, Fisher 1978).
#pragma once

#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/trace/standable.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

struct RoomViewpointParams {
    int most = 24;              // besides panorama 0
    float least_gain = 0.003f;  // of all that can be gained: what adds less is not worth a panorama
};

struct RoomViewpoints {
    std::vector<Vec3f> positions_m;  // world; panorama 0, at the origin, is not among them
    // Of what visitors see of the room, in [0, 1]:
    double unseen_share = 0;     // no viewpoint sees it
    double coarse_share = 0;     // the best viewpoint sees it at less than half the visitor's own resolution
    double one_sided_share = 0;  // seen by one viewpoint only
    std::size_t samples = 0;
};

// Deterministic in run.seed; needs no light. No positions where nobody can stand.
RoomViewpoints choose_room_viewpoints(const TracedRoom& room, const StandableFloor& floor,
                                      const RoomViewpointParams& params, const Run& run);

}  // namespace fastscene
