// Annealing: after every piece has its slot, whole groups of furniture (a bed with its nightstands, lamps, rug and
// picture) are moved about until the room stands better. The slot scan sees one piece at a time; this sees the room.
//
// The cost and the search follow Yu et al. 2011 ("Make it Home", simulated annealing over poses with moves that
// translate, rotate and swap; terms for accessibility, visibility, pathways, distance and angle to walls, pairwise
// constraints) and Merrell et al. 2011
// ("Interactive Furniture Layout Using Interior Design Guidelines": clearance, circulation, conversation, balance,
// alignment). Ours, each about 1 where a visitor would be annoyed:
//   clearance  what stands in the room that a piece wants before it or at its sides, by depth over 0.6 m
//   walkway    what stands within 1.2 m of a door or doorway; gaps too wide to touch and too narrow to walk through
//   (0.12 to 0.55 m) facing     a sofa and what it looks at: angle, offset to the side, distance beyond 1.8 … 4 m;
//   armchairs and the middle of the talk alignment  main pieces off the middle of their part of the wall; tables that
//   stand askew wall       tall pieces before windows; main pieces on the wall of the door; plants, lamps and baskets
//   far from any corner; a floor
//              whose furniture stands all on one side
//   asked      4 for every piece that does not stand where the prompt says
// A state in which pieces overlap, leave the room, hang on no wall or block an opening is never entered.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/rooms/layout.h"

namespace fastscene {

struct LayoutCost {
    float clearance = 0, walkway = 0, facing = 0, alignment = 0, wall = 0, asked = 0;
    float sum() const { return clearance + walkway + facing + alignment + wall + asked; }
};
LayoutCost layout_cost(const Plan& plan, const std::vector<Placed>& placed);

// A pose of a piece.
struct Stand {
    Vec3f position;
    float yaw = 0;
};
// States that were each the best so far, the last one the best of all; empty: no move made it better. Deterministic in
// `seed`. `placed` may come without meshes.
std::vector<std::vector<Stand>> anneal(const Plan& plan, std::vector<Placed> placed, const AnnealParams& params,
                                       std::uint64_t seed);

}  // namespace fastscene
