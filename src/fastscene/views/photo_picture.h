// A photograph as a training view. Private to views/.
#pragma once

#include "fastscene/scene/capture.h"
#include "fastscene/scene/view.h"
#include "fastscene/views/photos.h"

namespace fastscene {

// Loads the picture and its mask. Lenses other than a pinhole are undistorted to one of the same focal length, and
// pixels that they did not see get weight 0; equirectangular pictures stay so. world_from_camera is in the trainer's
// world. Throws Error naming the file if it is unreadable or has another aspect ratio than its camera.
View view_of_photo(const Photo& photo, const Rigid& world_from_camera, const PhotosParams& params);

// Size of the view for a picture of this size.
struct PictureSize {
    int width, height;
};
PictureSize size_of_view(const Photo& photo, PictureSize stored, const PhotosParams& params);

}  // namespace fastscene
