#include "fastscene/geometry/cubemap.h"

#include <cmath>
#include <numbers>

#include "fastscene/geometry/averaged.h"

namespace fastscene {

std::string_view name_of(CubeFace face) {
    static constexpr std::array<std::string_view, 6> kNames{"front", "right", "back", "left", "up", "down"};
    return kNames[static_cast<std::size_t>(face)];
}

Mat3f pano_from_face(CubeFace face) {
    const Vec3f x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    switch (face) {
        case CubeFace::front: return Mat3f::from_columns(x, y, z);
        case CubeFace::right: return Mat3f::from_columns(-z, y, x);
        case CubeFace::back: return Mat3f::from_columns(-x, y, -z);
        case CubeFace::left: return Mat3f::from_columns(z, y, -x);
        case CubeFace::up: return Mat3f::from_columns(x, z, -y);
        case CubeFace::down: return Mat3f::from_columns(x, -z, y);
    }
    return {};
}

CubeFace face_of_direction(Vec3f d) {
    const float x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
    if (z >= x && z >= y) return d.z > 0 ? CubeFace::front : CubeFace::back;
    if (x >= y) return d.x > 0 ? CubeFace::right : CubeFace::left;
    return d.y > 0 ? CubeFace::down : CubeFace::up;
}

ImageColor face_from_equirect(const ImageColor& equirect, CubeFace face, const Pinhole& camera) {
    return pinhole_from_equirect(equirect, camera, pano_from_face(face));
}

ImageColor equirect_from_faces(const std::array<ImageColor, 6>& faces, const Pinhole& camera, EquirectSize size) {
    const int n = samples_a_side(2 * std::numbers::pi / size.width, 1.0 / static_cast<double>(camera.fx));
    return averaged(size.width, size.height, n, [&](Vec2f at) {
        const Vec3f d = direction_at(at, size);
        const CubeFace face = face_of_direction(d);
        return sample_flat(faces[static_cast<std::size_t>(face)], *camera.project(transpose(pano_from_face(face)) * d));
    });
}

}  // namespace fastscene
