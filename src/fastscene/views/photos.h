// Photos: captures (photographs with cameras, scene/capture.h) become views that a trainer can use: pictures loaded,
// made smaller, lenses straightened, masks turned into weights; points with sizes, or made up where there are none.
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
    int max_size = 1600;  // the longer side of a picture
    int downscale = 1;
    std::string alpha = "black";  // what transparent pixels mean
    bool invert_masks = false;
    int random_points = 50000;  // where the capture has none
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

// A capture in the trainer's units: world_from_capture makes the seen place a few metres large around the origin, so
// that neither the units of a reconstruction nor single cameras far off matter. It turns nothing.
struct PhotoViews {
    ViewSet set;
    Similarity world_from_capture;
    Vec3f up;  // world, unit: the mean of the cameras' up, for showing the scene upright
};

// Photos whose file is missing, damaged or of another shape than its camera are left out, and it is said; Error when
// none are left, or when more than half of those that are there cannot be used.
PhotoViews views_of_capture(const Capture& capture, const PhotosParams& params, const Run& run);

// What they will take, in bytes. `views`: as long as they are used; `reading`: besides, until all are there.
struct PhotosMemory {
    std::int64_t views = 0, reading = 0;
};
// From the sizes of the cameras alone, or from those of the pictures, which may be smaller copies: each file's header
// is then read.
PhotosMemory memory_of_photos(const Capture& capture, const PhotosParams& params, bool from_headers);

}  // namespace fastscene
