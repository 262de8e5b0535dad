// Walk: one panorama with range becomes many, at exactly known positions. Paper: CVS (coarse view
// synthesis: warp to a new position, mark holes) and PNVI (progressive novel view inpainting).
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/inpaint/inpaint.h"
#include "fastscene/scene/panorama.h"

namespace fastscene {

struct WalkParams {
    int viewpoints = 14;          // new ones, besides panorama 0
    float reach_m = 0.7f;         // farthest viewpoint from panorama 0
    float clearance = 0.5f;       // never farther than this share of the free distance
    std::string inpainter = "harmonic";
};
template <class V>
void visit_fields(WalkParams& p, V&& v) {
    v("viewpoints", p.viewpoints, Bounds{0, 200}, "New viewpoints besides the first panorama.");
    v("reach", p.reach_m, Bounds{0.01, 10}, "Greatest distance in metres from the first viewpoint.");
    v("clearance", p.clearance, Bounds{0.05, 0.95}, "Greatest step as a share of the free distance in that direction.");
    v("inpainter", p.inpainter, Choices{inpainters()}, "What paints the holes.");
}

// Positions (world, metres) in the order in which they are visited: each close to the ones before it, spread over
// the free space around panorama 0, up and down too.
std::vector<Vec3f> choose_viewpoints(const Panorama& first, const WalkParams& params);

// Returns panorama 0 followed by one panorama a viewpoint, each complete in color and range, with `known` set.
std::vector<Panorama> walk_through(const Panorama& first, const WalkParams& params, const Run& run);

}  // namespace fastscene
