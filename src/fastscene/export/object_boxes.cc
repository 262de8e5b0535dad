#include "fastscene/export/object_boxes.h"

#include <algorithm>

#include "fastscene/export/identities.h"

namespace fastscene {

std::vector<ObjectBox> object_boxes(const Room& room) {
    std::vector<ObjectBox> boxes(room.objects.size());
    for (const Mesh& mesh : room.meshes) {
        if (mesh.object < 0) continue;
        ObjectBox& box = boxes[at(mesh.object)];
        const Rigid object_from_world = inverse(room.objects[at(mesh.object)].world_from_object);
        for (const std::uint32_t v : mesh.triangles) {
            const Vec3f p = object_from_world * mesh.positions[v];
            if (box.empty) box.low = box.high = p, box.empty = false;
            for (std::size_t a = 0; a < 3; ++a)
                box.low[a] = std::min(box.low[a], p[a]), box.high[a] = std::max(box.high[a], p[a]);
        }
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
            const Vec3f a = mesh.positions[mesh.triangles[t]], b = mesh.positions[mesh.triangles[t + 1]],
                        c = mesh.positions[mesh.triangles[t + 2]];
            box.area_m2 += 0.5f * length(cross(b - a, c - a));
        }
    }
    return boxes;
}

}  // namespace fastscene
