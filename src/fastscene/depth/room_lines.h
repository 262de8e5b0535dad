// The lines of a room as its panorama shows them: where floor, ceiling and walls meet, the picture changes.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// How strongly the picture changes across a line that runs level or upright, 0..1, at a size of its own
// (equirectangular).
struct RoomLines {
    ImageF level, upright;
};

// Linear color, any size.
RoomLines find_lines(const ImageColor& panorama);

// Strength of one of the two at longitude and latitude (radians, up is positive): the best of the pixel and its two
// neighbours across the line, for a guess is never exact. `level`: it is the level ones.
float strength_at(const ImageF& lines, float lon, float lat, bool level);

}  // namespace fastscene
