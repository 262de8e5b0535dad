// Further panoramas of the same place, with poses: `make --panorama A --more LIST.json`. The list is untrusted input.
#pragma once

#include <filesystem>
#include <vector>

#include "fastscene/scene/panorama.h"

namespace fastscene {

struct MorePanorama {
    std::filesystem::path color, range;  // range: empty = to be estimated
    Rigid world_from_pano;               // the world is the first panorama's frame: x right, y down, z forward, metres
};

// {"panoramas": [{"color": FILE, "range": FILE, "world_from_pano": 4 x 4, or "position": [x, y, z] and "yaw_deg":
// degrees to the right}]}; file names relative to the list. Throws Error naming the list and the entry for invalid
// input: an unknown key, a matrix that is not a rotation, a value that is not a number.
std::vector<MorePanorama> read_more_panoramas(const std::filesystem::path& list);

// Rotated to the first panorama's orientation, at `size`: color is area-averaged, range uses nearest neighbours.
Panorama in_first_orientation(const Panorama& panorama, EquirectSize size);
// The same for a range map. `turn`: the rotation of world_from_pano.
ImageF range_in_first_orientation(const ImageF& range, const Mat3f& turn, EquirectSize size);

}  // namespace fastscene
