#include "fastscene/export/shell.h"

#include <algorithm>
#include <cmath>

namespace fastscene {

Shell shell_of(const Room& room, const Mesh& mesh) {
    constexpr float kSlack_m = 0.02f;
    float low = 1e9f, high = -1e9f;  // y points down
    for (const Vec3f p : mesh.positions) low = std::min(low, p.y), high = std::max(high, p.y);
    if (low > room.max_corner.y - kSlack_m) return Shell::floor;
    return high < room.min_corner.y + kSlack_m ? Shell::ceiling : Shell::walls;
}

Mat3f plan_from_world(const Room& room) {
    float sine = 0, cosine = 0;
    for (const Mesh& mesh : room.meshes) {
        if (mesh.object >= 0 || shell_of(room, mesh) != Shell::walls) continue;
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
            const Vec3f a = mesh.positions[mesh.triangles[t]];
            const Vec3f n = cross(mesh.positions[mesh.triangles[t + 1]] - a, mesh.positions[mesh.triangles[t + 2]] - a);
            const float flat = std::hypot(n.x, n.z), angle = 4 * std::atan2(n.x, n.z);
            sine += flat * std::sin(angle), cosine += flat * std::cos(angle);
        }
    }
    return rotation_about(Vec3f{0, 1, 0}, -0.25f * std::atan2(sine, cosine));
}

}  // namespace fastscene
