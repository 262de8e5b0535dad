// Photos: turns captures (photographs with cameras, scene/capture.h) into training views: pictures are loaded,
// downsampled and undistorted, masks become weights, and points get a size, or are generated if there are none.
#pragma once

#include <cstdint>
#include <string>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/scene/capture.h"
#include "fastscene/scene/splat_edit.h"
#include "fastscene/scene/view.h"

namespace fastscene {

struct PhotosParams {
    int max_size = 1600;  // of a picture's longer side
    int downscale = 1;
    std::string alpha = "black";  // how to interpret transparent pixels
    bool invert_masks = false;
    int random_points = 50000;  // if the capture has none
};
template <class V>
void visit_fields(PhotosParams& p, V&& v) {
    v("max-size", p.max_size, Bounds{16, 16384},
      "Larger pictures are made smaller: their longer side in pixels; spheres may be twice as wide.");
    v("downscale", p.downscale, Bounds{1, 32},
      "Pictures this many times smaller; images_2, images_4 … are taken where they are.");
    v("alpha", p.alpha, Choices{{"black", "mask"}}, "Transparent pixels are black, or do not count.");
    v("invert-masks", p.invert_masks, "White in a mask means: does not count.");
    v("random-points", p.random_points, Bounds{1, 1e7},
      "Starting points where the capture has none: on what its pictures agree, else by lot.");
}

// A capture in the trainer's units: world_from_capture scales and centers the scene to a few metres around the origin,
// independent of the reconstruction's units and of distant outlier cameras. It does not rotate.
struct PhotoViews {
    ViewSet set;
    Similarity world_from_capture;
    Vec3f up;  // world, unit: the mean up direction of the cameras, for upright display
};

// Photos that are missing, damaged or of another aspect ratio than their camera are dropped with a warning; throws
// Error if none are left or more than half of the existing ones are unusable.
PhotoViews views_of_capture(const Capture& capture, const PhotosParams& params, const Run& run);

// Estimated memory in bytes. `views`: while they are in use; `reading`: additionally, while loading.
struct PhotosMemory {
    std::int64_t views = 0, reading = 0;
};
// Based on the cameras' sizes, or on those in the picture files' headers, if the files may be downsampled copies.
PhotosMemory memory_of_photos(const Capture& capture, const PhotosParams& params, bool from_headers);

}  // namespace fastscene
