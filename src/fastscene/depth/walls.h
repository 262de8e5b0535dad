// Wall detection in a range map: large vertical planes, kept if the picture has matching lines at floor or ceiling.
#pragma once

#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/depth/room_lines.h"
#include "fastscene/image/image.h"

namespace fastscene {

// A vertical plane, or the front of furniture of similar size. Its points p (x right, y down, z forward; the camera at
// the origin) satisfy p.x * sin(yaw) + p.z * cos(yaw) = distance_m.
struct Wall {
    float yaw = 0;         // radians, -pi..pi: longitude of its normal; positive to the right
    float distance_m = 0;  // of its plane
    float share = 0;       // share of the sphere, by solid angle, with a range within a twentieth of the plane's
    float line_m = 0;      // distance at which the picture's lines match its foot and top; 0: none found
};

// From an equirectangular range map in metres along each ray, with the floor `floor_m` below the camera and the ceiling
// `ceiling_m` above it (0: unknown). Largest first; only those with at least 3 % of the sphere. line_m is 0.
std::vector<Wall> upright_planes(const ImageF& range, float floor_m, float ceiling_m);

// The subset with matching lines at floor and ceiling, with line_m set.
std::vector<Wall> walls_with_lines(const ImageF& range, const RoomLines& lines, float floor_m, float ceiling_m);
// The same as a backend tells them (EstimatedRange::assumptions).
Json json_of_walls(const ImageF& range, const ImageColor& color, float floor_m, float ceiling_m);

}  // namespace fastscene
