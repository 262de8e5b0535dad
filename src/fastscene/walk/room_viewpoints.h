// Viewpoint selection for a known room, such that all of it is seen well from wherever a visitor may stand.
//
// First, what visitors see is sampled: rays from random positions over the standable floor hit surfaces as often as
// visitors look at them. Then viewpoints are chosen greedily, each maximizing the gain in how well the samples are
// seen. For this submodular objective, greedy selection reaches at least 1 - 1/e of the optimum (Nemhauser, Wolsey,
// Fisher 1978).
#pragma once

#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/trace/standable.h"
#include "fastscene/trace/trace.h"

namespace fastscene {

struct RoomViewpointParams {
    int most = 24;              // besides panorama 0
    float least_gain = 0.003f;  // share of the total possible gain: viewpoints that add less are not worth a panorama
    // Of an edited room, those of before: they come first, unless something stands there now.
    std::vector<Vec3f> earlier_m = {};
};

struct RoomViewpoints {
    std::vector<Vec3f> positions_m;  // world; panorama 0, at the origin, is not included
    std::vector<int> earlier;        // of each, its index in earlier_m; -1: a new one
    // Shares of what visitors see of the room, in [0, 1]:
    double unseen_share = 0;     // seen by no viewpoint
    double coarse_share = 0;     // at best seen at less than half the visitor's resolution
    double one_sided_share = 0;  // seen by a single viewpoint
    std::size_t samples = 0;
};

// Deterministic in run.seed; needs no light. Empty if nobody can stand in the room.
RoomViewpoints choose_room_viewpoints(const TracedRoom& room, const StandableFloor& floor,
                                      const RoomViewpointParams& params, const Run& run);

}  // namespace fastscene
