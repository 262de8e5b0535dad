// The reference implementation (reference.h), in double precision.
#include <algorithm>
#include <cmath>

#include "fastscene/splat/host_stepper.h"
#include "fastscene/splat/reference.h"

namespace fastscene::splat_backends {
namespace {

using namespace splat;

// Adam as published, in double precision except for what is stored.
struct AdamSlot {
    float &x, &first_moment, &second_moment;
};
void adam(AdamSlot slot, double gradient, double rate, int step) {
    const double m = 0.9 * slot.first_moment + 0.1 * gradient;
    const double v = 0.999 * slot.second_moment + 0.001 * gradient * gradient;
    slot.first_moment = static_cast<float>(m);
    slot.second_moment = static_cast<float>(v);
    slot.x = static_cast<float>(slot.x - rate * (m / (1 - std::pow(0.9, step))) /
                                             (std::sqrt(v / (1 - std::pow(0.999, step))) + kAdamEpsilon));
}

class ReferenceStepper : public HostStepper {
    LossSums step_now(Cloud& cloud, const View& view, const ImageF* depth, const StepPlan& plan) override {
        const Splats now = cloud.splats();
        const auto splats = gaussians_of<double>(now);
        const auto rest = rest_of<double>(now);
        const auto lens = lens_over<double>(lens_of(view.camera, view.world_from_camera, view.model, cloud.filter));
        const Vec3d background{plan.background.x, plan.background.y, plan.background.z};
        auto picture = render_reference(splats, lens, view.camera.width, view.camera.height, background, rest);
        std::vector<Vec3d> colors;
        for (const auto& p : picture.pixels) colors.push_back(p.color);
        ReferenceLoss loss = loss_reference(colors, view, plan.lambda_dssim);
        std::vector<double> v_depth;
        if (depth)
            loss.loss += depth_loss_reference(picture, view, *depth, static_cast<double>(plan.depth_strength), v_depth);
        std::vector<double> v_transmittance;
        if (plan.alpha_strength > 0)
            loss.loss += transmittance_loss_reference(picture, view, static_cast<double>(plan.alpha_strength),
                                                      v_transmittance);
        std::vector<double> rest_gradient;
        const auto gradients = gradients_reference(splats, lens, picture, loss.v, rest, &rest_gradient, v_depth,
                                                   v_transmittance, static_cast<double>(plan.outside_m));
        const int n = 3 * rest_functions(cloud.degree);
        for (std::int64_t i = 0; i < cloud.count; ++i) {
            const Gaussian<double>& g = gradients[static_cast<std::size_t>(i)];
            double all[kParameters] = {g.mean.x,      g.mean.y,     g.mean.z,     g.log_scale.x, g.log_scale.y,
                                       g.log_scale.z, g.rotation.w, g.rotation.x, g.rotation.y,  g.rotation.z,
                                       g.logit,       g.sh0.x,      g.sh0.y,      g.sh0.z};
            add_regularizers(splats[static_cast<std::size_t>(i)], plan.rates, cloud.count, all);
            bool seen = false;
            for (const double x : all) seen |= x != 0;
            const Vec3d m = splats[static_cast<std::size_t>(i)].mean;
            const double far = std::max(
                1.0, length(m - Vec3d{plan.rates.middle.x, plan.rates.middle.y, plan.rates.middle.z}) /
                         static_cast<double>(plan.rates.reach_m));
            for (int p = 0; p < kParameters; ++p) {
                const std::size_t at = cloud.at(i, p);
                adam({cloud.parameters[at], cloud.first_moment[at], cloud.second_moment[at]}, all[p],
                     plan.rates.rates[static_cast<std::size_t>(p)] * (p < 3 ? far : 1.0), plan.rates.adam_step);
            }
            for (int k = 0; k < n && seen && plan.rates.rest_rate > 0; ++k) {
                const std::size_t at = cloud.rest_at(i, k);
                adam({cloud.rest[at], cloud.rest_first_moment[at], cloud.rest_second_moment[at]},
                     rest_gradient[static_cast<std::size_t>(i * n + k)], plan.rates.rest_rate,
                     plan.rates.rest_adam_step);
            }
        }
        return {loss.loss, loss.squared_error};
    }

    static void add_regularizers(const Gaussian<double>& g, const StepRates& rates, std::int64_t count, double* all) {
        const auto n = static_cast<double>(count);
        const double opacity = 1 / (1 + std::exp(-g.logit));
        all[10] += rates.opacity_reg / n * opacity * (1 - opacity);
        for (std::size_t a = 0; a < 3; ++a) all[3 + a] += rates.scale_reg / (3 * n) * std::exp(g.log_scale[a]);
    }
};

struct ReferenceRenderer : Renderer {
    explicit ReferenceRenderer(const Splats& s) : splats(s) {}
    SplatPicture picture(const Pinhole& camera, const Rigid& world_from_camera, Vec3f background,
                         CameraModel model) override {
        const auto picture = render_reference(
            gaussians_of<double>(splats), lens_over<double>(lens_of(camera, world_from_camera, model, splats.filter)),
            camera.width, camera.height, Vec3d{background.x, background.y, background.z}, rest_of<double>(splats));
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

}  // namespace

SplatBackendEntry reference() {
    return {.name = "reference",
            .about = "slow and readable, the measure of the others",
            .make_stepper = [](const std::string&) -> std::unique_ptr<Stepper> {
                return std::make_unique<ReferenceStepper>();
            },
            .make_renderer = [](const Splats& splats, const std::string&) -> std::unique_ptr<Renderer> {
                return std::make_unique<ReferenceRenderer>(splats);
            }};
}

}  // namespace fastscene::splat_backends
