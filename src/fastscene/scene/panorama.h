// Panorama: the full 360 degree view from one viewpoint.
#pragma once

#include "fastscene/geometry/sphere.h"
#include "fastscene/image/image.h"
#include "fastscene/math/rigid.h"

namespace fastscene {

// Origin of a panorama's pixel (the values in walk/NNN/known.png).
enum class Known : std::uint8_t {
    invented = 0,    // inpainted here
    carried = 128,   // visible here, but inpainted or rendered at an earlier viewpoint
    looked = 192,    // rendered from a known room at this viewpoint: as accurate as an observed pixel
    original = 255,  // observed by panorama 0
};

struct Panorama {
    ImageColor color;       // W x H, W = 2H; linear, display-referred: 0..1 is black..white of the file
    ImageF range;           // metres along each pixel's ray; empty before the depth stage; +inf = sky
    Image<Known> known;     // empty = all original
    Rigid world_from_pano;  // panorama 0: identity
    // Like `range`, but through flat mirrors: there it is the distance to the virtual image, which is view-independent.
    // Empty: no mirrors known.
    ImageF mirrored_range{};

    const ImageF& seen_range() const { return mirrored_range.empty() ? range : mirrored_range; }
    EquirectSize size() const { return {color.width, color.height}; }
};

}  // namespace fastscene
