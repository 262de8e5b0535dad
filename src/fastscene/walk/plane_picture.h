// Plane pictures: what panorama 0 saw of a plane, rectified, with its hidden parts inpainted. All viewpoints look up
// the hidden part of a wall in the same picture, which keeps them consistent.
#pragma once

#include <vector>

#include "fastscene/inpaint/inpaint.h"
#include "fastscene/walk/openings.h"

namespace fastscene {

struct PlanePicture {
    ScenePlane plane;
    float metres_per_pixel = 0.01f;
    ImageColor color;
    ImageF unseen_m;    // metres within the plane to the nearest seen position, on paths around known empty space
    Openings openings;  // walls only
    ImageMask face;     // not for walls: nonzero where it was seen, close to that, and in narrow gaps
    bool empty() const { return color.empty(); }
    // Bilinear; clamped at the picture's border.
    Vec3f color_at(Vec3f point) const;
    // Whether a point in the plane is within the seen part of it, with a margin. Walls are unbounded.
    bool reaches(Vec3f point) const;
    // Metres from the seen part of the plane; beyond the picture, the value at its border.
    float unseen_at(Vec3f point) const;
    // Whether there is wall at the point (projected to the plane).
    Wall wall_at(Vec3f point) const;
};
// `label`: from label_planes. `color`: with clean silhouettes.
std::vector<PlanePicture> paint_planes(const ImageColor& color, const ImageF& range, const Image<std::int16_t>& label,
                                       const ImageMask& cuts, const std::vector<ScenePlane>& planes,
                                       const Inpainter& inpainter, const Run& run);

}  // namespace fastscene
