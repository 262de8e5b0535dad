// Plausibility check of a user's panorama, before minutes are spent on it.
#pragma once

#include <string>
#include <vector>

#include "fastscene/image/image.h"

namespace fastscene {

// Warnings for the user about what does not look like an equirectangular picture of a room: mismatched sides, poles
// with more than one color, black borders, a tripod or logo under the camera, no light at all. Empty if plausible.
std::vector<std::string> doubts_about_panorama(const ImageColor& color);

}  // namespace fastscene
