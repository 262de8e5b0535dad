#include "fastscene/splat/splat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fastscene/geometry/cubemap.h"
#include "fastscene/image/color.h"

namespace fastscene {
namespace {

Still still_from(const ImageColor& color, const ImageF& alpha, ImageF distance) {
    Still out{srgb8_from_unit(color), ImageMask(color.width, color.height), std::move(distance)};
    std::transform(alpha.pixels.begin(), alpha.pixels.end(), out.alpha.pixels.begin(), byte_from_unit);
    return out;
}

}  // namespace

Still still_of(const SplatRenderer& splats, const Pinhole& camera, const Rigid& world_from_camera, Vec3f background) {
    SplatPicture picture = splats.picture(camera, world_from_camera, background);
    return still_from(picture.color, picture.alpha, std::move(picture.depth_z));
}

Still sphere_of(const SplatRenderer& splats, int width, const Rigid& world_from_pano, Vec3f background) {
    const EquirectSize size{width, width / 2};
    // 90 degrees plus a margin, so that no bilinear sample falls outside a cube face.
    constexpr float kFovDeg = 94.f;
    // The low-pass draws every splat at least about a pixel wide. Panoramas are mostly coarser
    // than the training views, so faces at the panorama's resolution would blur: they are rendered twice as fine, then
    // averaged.
    constexpr int kWidestAveraged = 4096;  // above that, six supersampled faces would take gigabytes
    const double finer = width <= kWidestAveraged ? 2 : 1;
    const double side = finer * width / std::numbers::pi *
                        std::tan(static_cast<double>(kFovDeg) * std::numbers::pi / 360);
    const Pinhole camera = Pinhole::with_fov(std::max(8, static_cast<int>(std::ceil(side))),
                                             std::max(8, static_cast<int>(std::ceil(side))), kFovDeg);
    std::array<ImageColor, 6> colors, others;  // others: alpha and range
    for (std::size_t f = 0; f < kCubeFaces.size(); ++f) {
        const Rigid world_from_face{world_from_pano.rotation * pano_from_face(kCubeFaces[f]),
                                    world_from_pano.translation};
        const SplatPicture picture = splats.picture(camera, world_from_face, background);
        colors[f] = picture.color;
        others[f] = ImageColor(camera.width, camera.height);
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x) {
                const float slant = length(
                    camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
                const float alpha = picture.alpha.at(x, y);
                others[f].at(x, y) = {alpha, picture.depth_z.at(x, y) * slant * alpha, 0};
            }
    }
    const ImageColor color = equirect_from_faces(colors, camera, size),
                     other = equirect_from_faces(others, camera, size);
    ImageF alpha(size.width, size.height), range(size.width, size.height);
    for (std::size_t i = 0; i < other.size(); ++i) {
        alpha.pixels[i] = other.pixels[i].x;
        range.pixels[i] = other.pixels[i].x > 0 ? other.pixels[i].y / other.pixels[i].x : 0.f;
    }
    return still_from(color, alpha, std::move(range));
}

}  // namespace fastscene
