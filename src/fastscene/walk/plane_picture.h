// Plane picture: what panorama 0 saw of a plane, head on, its hidden parts painted by the inpainter. Every
// viewpoint looks the hidden part of a wall up in the same picture, so the world stays one.
#pragma once

#include <vector>

#include "fastscene/inpaint/inpaint.h"
#include "fastscene/walk/openings.h"

namespace fastscene {

struct PlanePicture {
    ScenePlane plane;
    float metres_per_pixel = 0.01f;
    ImageColor color;
    ImageF unseen_m;  // metres, in the plane, to the nearest place where it was seen, around what panorama 0 saw to be
                      // empty
    Openings openings;  // walls only
    ImageMask face;     // not of walls: nonzero where it was seen, close by, and between
    bool empty() const { return color.empty(); }
    // Bilinear; beyond the picture, its border.
    Vec3f color_at(Vec3f point) const;
    // Lies the point (in the plane) within what was seen of it, with a margin? Walls have no end.
    bool reaches(Vec3f point) const;
    // How far from what was seen of it (metres); beyond the picture, as at its border.
    float unseen_at(Vec3f point) const;
    // Is there wall at the point (its foot on the plane)?
    Wall wall_at(Vec3f point) const;
};
// `label`: label_planes. `color`: silhouettes cleaned.
std::vector<PlanePicture> paint_planes(const ImageColor& color, const ImageF& range, const Image<std::int16_t>& label,
                                       const ImageMask& cuts, const std::vector<ScenePlane>& planes,
                                       const Inpainter& inpainter, const Run& run);

}  // namespace fastscene
