// Film: radiance becomes a picture. One exposure, white and curve a room, so that all its views agree.
#pragma once

#include "fastscene/image/image.h"
#include "fastscene/scene/room.h"

namespace fastscene {

// Exposure and white for a room from a small panorama of radiances as seen from its first viewpoint.
Look automatic_look(const Look& wish, const Sky& sky, const ImageColor& panorama);

// Radiance -> linear display-referred color in 0..1.
Vec3f develop(const Look& look, Vec3f radiance);

}  // namespace fastscene
