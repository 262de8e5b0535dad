// Completion: assigns a surface and a color to every hole of a coarse view.
#pragma once

#include "fastscene/walk/coarse_view.h"
#include "fastscene/walk/plane_picture.h"

namespace fastscene {

// What the walk knows about the world; all in panorama 0's frame.
struct WalkWorld {
    ImageF first_range;  // panorama 0's
    std::vector<PlanePicture> planes;
    ImageColor outside;  // outside_picture
    const Inpainter* inpainter = nullptr;
};

// Fills the pixels of `view`, seen from `position`, where `hole` is nonzero: with the nearest plane of the scene that
// continues there hidden from panorama 0, or else by extending the far side of the rim. Other pixels stay unchanged.
void complete_holes(CoarseView& view, const ImageMask& hole, Vec3f position, const WalkWorld& world, const Run& run);

}  // namespace fastscene
