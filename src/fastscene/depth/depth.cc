#include "fastscene/depth/depth.h"

#include <utility>

namespace fastscene {

ImageF exact_range(const TracedRoom& room, EquirectSize size, const Run& run) {
    return room.panorama({}, size, {.color = false, .range = true}, run).range;
}

ImageF exact_mirrored_range(const TracedRoom& room, EquirectSize size, const Run& run) {
    Shot shot = room.panorama({}, size, {.color = false, .range = true, .mirrored_range = true}, run);
    return shot.mirrored_range.pixels == shot.range.pixels ? ImageF{} : std::move(shot.mirrored_range);
}

}  // namespace fastscene
