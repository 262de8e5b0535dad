// Further panoramas of the place that the first one shows, with their poses: `make --panorama A --more LIST.json`. The
// list is from outside and believed in nothing.
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
// degrees to the right}]}; files relative to the list. Throws Error naming the list and the entry for what is not so:
// an unknown key, a matrix that is no rotation, a number that is none.
std::vector<MorePanorama> read_more_panoramas(const std::filesystem::path& list);

// As it is seen from the same place in the first panorama's orientation, at `size`: color averaged over areas, range
// picked.
Panorama in_first_orientation(const Panorama& panorama, EquirectSize size);
// Of a range map alone. `turn`: world_from_pano's.
ImageF range_in_first_orientation(const ImageF& range, const Mat3f& turn, EquirectSize size);

}  // namespace fastscene
