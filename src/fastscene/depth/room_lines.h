// Room lines in a panorama: edges where floor, ceiling and walls meet.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

// Edge strength across horizontal or vertical lines, 0..1, at an internal resolution (equirectangular).
struct RoomLines {
    ImageF level, upright;
};

// Linear color, any size.
RoomLines find_lines(const ImageColor& panorama);

// Strength at longitude and latitude (radians, up is positive): the maximum over the pixel and its two neighbours
// across the line, to tolerate small errors. `level`: horizontal lines.
float strength_at(const ImageF& lines, float lon, float lat, bool level);

}  // namespace fastscene
