// Cloth over a mattress.
#pragma once

#include <vector>

#include "fastscene/rooms/drape.h"
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

inline constexpr float kMattressEdge_m = 0.06f;  // radius of its edges

struct Bedding {
    Vec3f mattress;                     // its width, its top above the floor, its length
    float frame_m = 0.03f;              // the bed's frame stands out by this much on each side
    std::vector<DrapeSolid> more = {};  // posts and rails
};

struct Covers {
    float drop_m;                    // hangs down by this much at the sides
    float lift_m = 0, beside_m = 0;  // thickness of what lies below it already: on top, at the sides
    float thick_m = 0.03f;
    float slack = 0.05f, stiffness = 0.3f;  // of Cloth
};

// Cloth that was thrown over the mattress between two places along its length; past the foot it hangs down.
DrapedCloth over_mattress(const Bedding& bedding, float from_z, float to_z, Covers covers, std::uint32_t seed);

// A cover of the same mattress that lies over this one, between two places along it, rests on it.
void lay_over(const Bedding& bedding, const DrapedCloth& below, float from_z, float to_z, Covers& covers);

}  // namespace fastscene::furniture
