// The walls of a room, found in its range map: large upright planes, kept where the picture's lines say that floor or
// ceiling meets a wall there.
#pragma once

#include <vector>

#include "fastscene/depth/room_lines.h"
#include "fastscene/image/image.h"

namespace fastscene {

// An upright plane, or the front of furniture as large. Its points p (x right, y down, z ahead; the camera at the
// origin) have p.x * sin(yaw) + p.z * cos(yaw) = distance_m.
struct Wall {
    float yaw = 0;         // radians, -pi..pi: where it is met at right angles; to the right is positive
    float distance_m = 0;  // of its plane
    float share = 0;       // of the sphere, by solid angle, whose range lies within a twentieth of the plane
    float line_m = 0;  // the distance at which lines of the picture run as its foot and its top would; 0: none is seen
};

// Of a range map in metres along each pixel's ray, equirectangular, with the floor `floor_m` below the camera and the
// ceiling `ceiling_m` above it (0: not known). The largest first; none with less than 3 % of the sphere. line_m is 0.
std::vector<Wall> upright_planes(const ImageF& range, float floor_m, float ceiling_m);

// Those of them along which the picture has lines where floor and ceiling meet them, with line_m.
std::vector<Wall> walls_with_lines(const ImageF& range, const RoomLines& lines, float floor_m, float ceiling_m);

}  // namespace fastscene
