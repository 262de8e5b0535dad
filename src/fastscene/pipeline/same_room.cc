#include "fastscene/pipeline/same_room.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/geometry/sphere.h"

namespace fastscene {

void check_same_room(const TracedRoom& room, const ImageF& range, const std::filesystem::path& run_dir) {
    const EquirectSize size{range.width, range.height};
    int looked = 0, other = 0;
    for (int y = size.height / 16; y < size.height; y += std::max(1, size.height / 12))
        for (int x = size.width / 32; x < size.width; x += std::max(1, size.width / 24)) {
            const float true_range = room.distance({}, direction_of_pixel(x, y, size)), recorded = range.at(x, y);
            ++looked;
            other += std::isfinite(true_range) != std::isfinite(recorded) ||
                     (std::isfinite(recorded) && !(std::fabs(true_range - recorded) < 0.02f * recorded));
        }
    if (20 * other > looked)
        throw Error(
            "the room of {} does not match its range map ({} of {} rays differ): it was made by another version; make "
            "it again",
            run_dir.string(), other, looked);
}

}  // namespace fastscene
