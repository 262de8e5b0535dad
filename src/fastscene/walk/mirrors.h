// Mirrors: what a flat mirror shows to who stands elsewhere. Panorama 0 saw but a part of that in the glass, and most
// of the rest in the room itself: a mirror's image of the room is the room, mirrored, as if panorama 0 had been taken
// from behind the glass.
#pragma once

#include <vector>

#include "fastscene/walk/coarse_view.h"

namespace fastscene {

struct Mirror {
    Vec3f normal;      // of the glass, towards panorama 0, in its frame
    float offset = 0;  // normal . p = offset on the glass, < 0
    ImageMask glass;   // panorama 0's pixels in which it shows
    std::vector<WarpSource>
        image;       // the mirrored room; one source, of which each look uses what shows through the glass
    ImageMask room;  // all of it that is worth looking at
    Vec3f middle;    // of the glass, and how far its pixels lie from there at most, metres
    float reach = 0;
    Vec3f tint{1, 1, 1};  // times a color of the room: what of it the glass shows
};
// Those of a panorama whose mirrored_range is known, the largest first.
std::vector<Mirror> find_mirrors(const Panorama& first);

// Where `view`, seen from `position`, has nothing known (Known::invented) and looks into a mirror whose image has
// something to show, that is drawn and becomes Known::carried.
void look_into(std::vector<Mirror>& mirrors, Vec3f position, CoarseView& view, Image<Known>& known);

}  // namespace fastscene
