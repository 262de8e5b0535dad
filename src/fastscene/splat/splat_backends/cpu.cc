// Tiles, SIMD and threads on the processor (engine.h).
#include "fastscene/splat/host_stepper.h"

namespace fastscene::splat_backends {
namespace {

using namespace splat;

class CpuStepper : public HostStepper {
    LossSums step_now(Cloud& cloud, const View& view, const ImageF* depth, const StepPlan& plan) override {
        engine_.render(cloud, view.camera, view.world_from_camera, plan.background, depth != nullptr, view.model);
        LossSums sums = engine_.differentiate(view, plan.lambda_dssim, plan.judge);
        if (depth) sums.loss += engine_.differentiate_depth(view, *depth, plan.depth_strength);
        if (plan.alpha_strength > 0) sums.loss += engine_.differentiate_transmittance(view, plan.alpha_strength);
        engine_.set_outside(plan.outside_m);
        engine_.step(cloud, plan.rates);
        return sums;
    }

    Engine engine_{choose_kernel()};
};

struct CpuRenderer : Renderer {
    explicit CpuRenderer(const Splats& splats) : cloud(splats, false) {}
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
    Cloud cloud;
    Engine engine{choose_kernel()};
};

}  // namespace

SplatBackendEntry cpu() {
    return {
        .name = "cpu",
        .about = "SIMD and threads on the processor",
        .make_stepper = [](const std::string&) -> std::unique_ptr<Stepper> { return std::make_unique<CpuStepper>(); },
        .make_renderer = [](const Splats& splats, const std::string&) -> std::unique_ptr<Renderer> {
            return std::make_unique<CpuRenderer>(splats);
        }};
}

}  // namespace fastscene::splat_backends
