// The line of a cord that hangs in bows.
#include "fastscene/rooms/furniture/decor/bows.h"

#include <algorithm>
#include <cmath>

namespace fastscene::furniture {

Vec3f on_bows(float t, int bows, float width, float top, float sag) {
    const float in = t * static_cast<float>(bows) - std::floor(std::min(t, 0.9999f) * static_cast<float>(bows));
    return {(t - 0.5f) * width, top - sag * 4 * in * (1 - in), 0};
}

}  // namespace fastscene::furniture
