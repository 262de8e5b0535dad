#include "fastscene/splat/backend.h"

namespace fastscene {
namespace splat {

SplatPicture empty_picture(const Pinhole& camera) {
    SplatPicture out;
    out.color = ImageColor(camera.width, camera.height);
    out.alpha = ImageF(camera.width, camera.height);
    out.depth_z = ImageF(camera.width, camera.height);
    return out;
}

std::unique_ptr<Stepper> make_stepper(const SplatBackend& backend) {
    return registered_entry<SplatBackendEntry>("--splat-backend", backend.name).make_stepper(backend.device);
}

}  // namespace splat

std::vector<std::string> splat_backend_names() { return registered_names<SplatBackendEntry>(); }

const std::string& about_splat_backends() {
    static const std::string text = [] {
        std::string out = "Renderer of splats.";
        for (const SplatBackendEntry& e : registered<SplatBackendEntry>())
            out += " " + e.name + ": " + e.about + (&e == &registered<SplatBackendEntry>().back() ? "." : ";");
        return out;
    }();
    return text;
}

void check_device(const SplatBackend& backend, const std::string& flag) {
    for (const SplatBackendEntry& e : registered<SplatBackendEntry>())
        if (e.check_device && (e.name == backend.name || backend.device == "list"))
            e.check_device(backend.device, flag);
}

SplatRenderer::SplatRenderer(const Splats& splats, const SplatBackend& backend)
    : renderer_(registered_entry<SplatBackendEntry>("--backend", backend.name).make_renderer(splats, backend.device)) {}
SplatRenderer::~SplatRenderer() = default;
SplatRenderer::SplatRenderer(SplatRenderer&&) noexcept = default;

SplatPicture SplatRenderer::picture(const Pinhole& camera, const Rigid& world_from_camera, Vec3f background,
                                    CameraModel model) const {
    return renderer_->picture(camera, world_from_camera, background, model);
}

}  // namespace fastscene
