#include "fastscene/base/error.h"
#include "fastscene/splat/engine.h"
#include "fastscene/splat/reference.h"
#include "fastscene/splat/splat.h"
#include "fastscene/splat/vulkan/engine.h"

namespace fastscene {
namespace {

SplatPicture empty_picture(const Pinhole& camera) {
    SplatPicture out;
    out.color = ImageColor(camera.width, camera.height);
    out.alpha = ImageF(camera.width, camera.height);
    out.depth_z = ImageF(camera.width, camera.height);
    return out;
}

SplatPicture render_cpu(const Splats& splats, const Pinhole& camera, const Rigid& world_from_camera, Vec3f background,
                        CameraModel model) {
    const splat::Cloud cloud(splats, false);
    splat::Engine engine(splat::choose_kernel());
    engine.render(cloud, camera, world_from_camera, background, true, model);
    SplatPicture out = empty_picture(camera);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const float alpha = 1.f - engine.transmittance(x, y);
            out.color.at(x, y) = engine.color(x, y);
            out.alpha.at(x, y) = alpha;
            out.depth_z.at(x, y) = alpha > 0.f ? engine.depth_sum(x, y) / alpha : 0.f;
        }
    return out;
}

SplatPicture render_slowly(const Splats& splats, const Pinhole& camera, const Rigid& world_from_camera,
                           Vec3f background, CameraModel model) {
    const auto picture = splat::render_reference(
        splat::gaussians_of<double>(splats),
        splat::lens_over<double>(splat::lens_of(camera, world_from_camera, model, splats.antialias)), camera.width,
        camera.height, Vec3d{background.x, background.y, background.z}, splat::rest_of<double>(splats));
    SplatPicture out = empty_picture(camera);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const auto& p = picture.pixels[i];
        const double alpha = 1 - p.transmittance;
        out.color.pixels[i] = {static_cast<float>(p.color.x), static_cast<float>(p.color.y),
                               static_cast<float>(p.color.z)};
        out.alpha.pixels[i] = static_cast<float>(alpha);
        out.depth_z.pixels[i] = alpha > 0 ? static_cast<float>(picture.depth_sum[i] / alpha) : 0.f;
    }
    return out;
}

SplatPicture render_on_card(const Splats& splats, const Pinhole& camera, const Rigid& world_from_camera,
                            Vec3f background, CameraModel model, const std::string& device) {
    splat::vulkan::VulkanEngine engine(device);
    engine.load(splat::Cloud(splats, false));
    return engine.render(camera, world_from_camera, background, model);
}

}  // namespace

SplatPicture render_splats(const Splats& splats, const Pinhole& camera, const Rigid& world_from_camera,
                           Vec3f background, const std::string& backend, CameraModel model, const std::string& device) {
    if (backend == "cpu") return render_cpu(splats, camera, world_from_camera, background, model);
    if (backend == "vulkan") return render_on_card(splats, camera, world_from_camera, background, model, device);
    if (backend == "reference") return render_slowly(splats, camera, world_from_camera, background, model);
    throw UsageError("splat: unknown backend \"{}\"; expected cpu, vulkan or reference", backend);
}

}  // namespace fastscene
