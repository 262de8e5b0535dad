// One photograph as a view. Private to views/.
#pragma once

#include "fastscene/scene/capture.h"
#include "fastscene/scene/view.h"
#include "fastscene/views/photos.h"

namespace fastscene {

// Loads the picture and its mask; a lens other than a pinhole is straightened to one of the same focal length, pixels
// that it did not see weigh 0; a sphere stays one. world_from_camera is already the trainer's. Throws Error naming the
// file: not readable, or of another shape than its camera.
View view_of_photo(const Photo& photo, const Rigid& world_from_camera, const PhotosParams& params);

// How large the view of a picture of this size becomes.
struct PictureSize {
    int width, height;
};
PictureSize size_of_view(const Photo& photo, PictureSize stored, const PhotosParams& params);

}  // namespace fastscene
