#include "fastscene/depth/depth.h"

namespace fastscene {

ImageF exact_range(const TracedRoom& room, EquirectSize size, const Run& run) {
    return room.panorama({}, size, {.color = false, .range = true}, run).range;
}

}  // namespace fastscene
