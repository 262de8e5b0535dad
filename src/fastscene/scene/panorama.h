// Panorama: what one viewpoint sees all around.
#pragma once

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"
#include "fastscene/math/rigid.h"

namespace fastscene {

// How a pixel of a panorama came to be (the values in walk/NNN/known.png).
enum class Known : std::uint8_t {
    invented = 0,    // painted here, for the first time
    carried = 128,   // seen from here, but painted or looked at from an earlier viewpoint
    looked = 192,    // looked at in a room that is known, from here: as true as what panorama 0 observed
    original = 255,  // observed by panorama 0
};

struct Panorama {
    ImageColor color;       // W x H, W = 2H; linear, display-referred: 0..1 is black..white of the file
    ImageF range;           // metres along each pixel's ray; empty until the depth stage; +inf = sky
    Image<Known> known;     // empty = all original
    Rigid world_from_pano;  // panorama 0: identity
    // As `range`, but a flat mirror is looked into as through a window: there it is the distance of the virtual image,
    // wherever one stands. Empty: no mirror is known of.
    ImageF mirrored_range{};

    const ImageF& seen_range() const { return mirrored_range.empty() ? range : mirrored_range; }
    EquirectSize size() const { return {color.width, color.height}; }
};

}  // namespace fastscene
