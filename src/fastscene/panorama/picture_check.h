// Is this picture what it says it is? A panorama from outside is looked at before minutes are spent on it.
#pragma once

#include <string>
#include <vector>

#include "fastscene/image/image.h"

namespace fastscene {

// What speaks against an equirectangular picture of a room, in sentences for the user; empty when nothing does:
// sides that do not meet, poles that are not one color, black borders, a tripod or logo under the camera, no light at
// all.
std::vector<std::string> doubts_about_panorama(const ImageColor& color);

}  // namespace fastscene
