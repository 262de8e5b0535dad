#include "fastscene/export/view_maps.h"

namespace fastscene {

ViewMaps view_maps(const TracedRoom& room, const Pinhole& camera, const Rigid& world_from_camera, const Run& run) {
    const Shot shot = room.perspective(world_from_camera, camera,
                                       {.color = false, .range = true, .normal = true, .mesh = true}, run);
    const std::vector<std::uint16_t> by_mesh = instance_by_mesh(room.room());
    const Mat3f camera_from_world = transpose(world_from_camera.rotation);
    ViewMaps maps{ImageF(camera.width, camera.height), ImageColor(camera.width, camera.height),
                  Image<std::uint16_t>(camera.width, camera.height)};
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const Vec3f ray = normalize(
                camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
            maps.depth_z.at(x, y) = shot.range.at(x, y) * ray.z;
            const int mesh = shot.mesh.at(x, y);
            if (mesh < 0) continue;
            maps.normal.at(x, y) = camera_from_world * shot.normal.at(x, y);
            maps.instance.at(x, y) = by_mesh[static_cast<std::size_t>(mesh)];
        }
    return maps;
}

ImageMask class_map(const Image<std::uint16_t>& instance, const std::vector<Instance>& instances) {
    ImageMask out(instance.width, instance.height);
    for (std::size_t i = 0; i < instance.size(); ++i)
        out.pixels[i] = static_cast<std::uint8_t>(instances.at(instance.pixels[i]).nyu40);
    return out;
}

}  // namespace fastscene
