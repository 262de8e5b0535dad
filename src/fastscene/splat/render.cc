#include "fastscene/base/error.h"
#include "fastscene/splat/engine.h"
#include "fastscene/splat/reference.h"
#include "fastscene/splat/splat.h"
#include "fastscene/splat/vulkan/engine.h"

namespace fastscene {

struct SplatRenderer::Impl {
    virtual ~Impl() = default;
    virtual SplatPicture picture(const Pinhole& camera, const Rigid& world_from_camera, Vec3f background,
                                 CameraModel model) = 0;
};

namespace {

SplatPicture empty_picture(const Pinhole& camera) {
    SplatPicture out;
    out.color = ImageColor(camera.width, camera.height);
    out.alpha = ImageF(camera.width, camera.height);
    out.depth_z = ImageF(camera.width, camera.height);
    return out;
}

struct OnCpu : SplatRenderer::Impl {
    explicit OnCpu(const Splats& splats) : cloud(splats, false) {}
    SplatPicture picture(const Pinhole& camera, const Rigid& world_from_camera, Vec3f background,
                         CameraModel model) override {
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
    splat::Cloud cloud;
    splat::Engine engine{splat::choose_kernel()};
};

struct OnCard : SplatRenderer::Impl {
    OnCard(const Splats& splats, const std::string& device) : engine(device, "--device") {
        engine.load(splat::Cloud(splats, false));
    }
    SplatPicture picture(const Pinhole& camera, const Rigid& world_from_camera, Vec3f background,
                         CameraModel model) override {
        return engine.render(camera, world_from_camera, background, model);
    }
    splat::vulkan::VulkanEngine engine;
};

struct Slowly : SplatRenderer::Impl {
    explicit Slowly(const Splats& s) : splats(s) {}
    SplatPicture picture(const Pinhole& camera, const Rigid& world_from_camera, Vec3f background,
                         CameraModel model) override {
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
    const Splats& splats;
};

std::unique_ptr<SplatRenderer::Impl> make_renderer(const Splats& splats, const SplatBackend& backend) {
    if (backend.name == "cpu") return std::make_unique<OnCpu>(splats);
    if (backend.name == "vulkan") return std::make_unique<OnCard>(splats, backend.device);
    if (backend.name == "reference") return std::make_unique<Slowly>(splats);
    throw UsageError("splat: unknown backend \"{}\"; expected cpu, vulkan or reference", backend.name);
}

}  // namespace

SplatRenderer::SplatRenderer(const Splats& splats, const SplatBackend& backend)
    : impl_(make_renderer(splats, backend)) {}
SplatRenderer::~SplatRenderer() = default;
SplatRenderer::SplatRenderer(SplatRenderer&&) noexcept = default;

SplatPicture SplatRenderer::picture(const Pinhole& camera, const Rigid& world_from_camera, Vec3f background,
                                    CameraModel model) const {
    return impl_->picture(camera, world_from_camera, background, model);
}

}  // namespace fastscene
