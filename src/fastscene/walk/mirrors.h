// Mirrors: what a flat mirror shows from other viewpoints. Panorama 0 saw only part of that in the glass, but most of
// the rest directly in the room: a mirror image is the room, reflected, as if panorama 0 had been taken from behind the
// glass.
#pragma once

#include <vector>

#include "fastscene/walk/coarse_view.h"

namespace fastscene {

struct Mirror {
    Vec3f normal;      // of the glass, facing panorama 0, in its frame
    float offset = 0;  // normal . p = offset on the glass, < 0
    ImageMask glass;   // panorama 0's pixels that show it
    std::vector<WarpSource>
        image;       // the mirrored room, as a warp source; each view uses the part visible through the glass
    ImageMask room;  // all pixels of it that may be used
    Vec3f middle;    // center of the glass, and the maximum distance of its pixels from there, metres
    float reach = 0;
    Vec3f tint{1, 1, 1};  // reflectance by channel
};
// The mirrors of a panorama with mirrored_range, largest first.
std::vector<Mirror> find_mirrors(const Panorama& first);

// Renders mirror images into pixels of `view`, seen from `position`, that have no known content (Known::invented); they
// become Known::carried.
void look_into(std::vector<Mirror>& mirrors, Vec3f position, CoarseView& view, Image<Known>& known);

}  // namespace fastscene
