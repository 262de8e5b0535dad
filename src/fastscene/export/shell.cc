#include "fastscene/export/shell.h"

#include <algorithm>

namespace fastscene {

Shell shell_of(const Room& room, const Mesh& mesh) {
    constexpr float kSlack_m = 0.02f;
    float low = 1e9f, high = -1e9f;  // y points down
    for (const Vec3f p : mesh.positions) low = std::min(low, p.y), high = std::max(high, p.y);
    if (low > room.max_corner.y - kSlack_m) return Shell::floor;
    return high < room.min_corner.y + kSlack_m ? Shell::ceiling : Shell::walls;
}

}  // namespace fastscene
