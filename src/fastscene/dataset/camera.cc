#include "fastscene/dataset/camera.h"

#include "fastscene/scene/pose_json.h"

namespace fastscene::dataset {

Vec3f Camera::ray(int x, int y) const {
    if (panorama) return direction_of_pixel(x, y, size());
    return normalize(pinhole.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
}

std::optional<Vec2f> Camera::seen_at(Vec3f point) const {
    const Vec3f p = inverse(world_from_camera) * point;
    if (panorama) return pixel_of_direction(p, size());
    const std::optional<Vec2f> pixel = pinhole.project(p);
    const bool is_inside = pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x < static_cast<float>(pinhole.width) &&
                           pixel->y < static_cast<float>(pinhole.height);
    return is_inside ? pixel : std::nullopt;
}

Json lens_json(const Camera& camera) {
    if (camera.panorama) return {{"model", "EQUIRECTANGULAR"}};
    const Pinhole& p = camera.pinhole;
    return {{"model", "PINHOLE"}, {"fx", p.fx}, {"fy", p.fy}, {"cx", p.cx}, {"cy", p.cy}};
}

Camera camera_from_json(const Json& about, int width, int height) {
    const Json& lens = about.at("camera");
    Camera camera{
        pose_from_json(about.at("world_from_camera")), {width, height}, lens.at("model") == "EQUIRECTANGULAR"};
    if (!camera.panorama) camera.pinhole = {width, height, lens.at("fx"), lens.at("fy"), lens.at("cx"), lens.at("cy")};
    return camera;
}

}  // namespace fastscene::dataset
