// Complete: gives every hole of a coarse view a surface and a color.
#pragma once

#include "fastscene/walk/coarse_view.h"
#include "fastscene/walk/plane_picture.h"

namespace fastscene {

// What is known about the world while walking; all in the frame of panorama 0.
struct WalkWorld {
    ImageF first_range;  // panorama 0's
    std::vector<PlanePicture> planes;
    ImageColor outside;  // outside_picture
    const Inpainter* inpainter = nullptr;
};

// Fills `hole` (nonzero) pixels of `view`, seen from `position`: where a plane of the scene goes on there, hidden
// from panorama 0, the nearest such plane; elsewhere the far side of the rim goes on. Other pixels stay as they are.
void complete_holes(CoarseView& view, const ImageMask& hole, Vec3f position, const WalkWorld& world, const Run& run);

}  // namespace fastscene
