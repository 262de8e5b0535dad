// One photograph as a view. Private to views/.
#pragma once

#include "fastscene/scene/capture.h"
#include "fastscene/scene/view.h"
#include "fastscene/views/photos.h"

namespace fastscene {

// Loads the picture and its mask; a lens other than a pinhole is straightened to one of the same focal length, pixels that it did
// not see weigh 0; a sphere stays one. world_from_camera is already the trainer's.
View view_of_photo(const Photo& photo, const Rigid& world_from_camera, const PhotosParams& params);

}  // namespace fastscene
