#include "fastscene/splat/stepper.h"

#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/splat/reference.h"

namespace fastscene::splat {
namespace {

class CpuStepper : public Stepper {
  public:
    LossSums step(Cloud& cloud, const View& view, float lambda, const std::array<float, kParameters>& rates, int adam_step) override {
        engine_.render(cloud, view.camera, view.world_from_camera, {}, false);
        const LossSums sums = engine_.differentiate(view, lambda);
        engine_.step(cloud, rates, adam_step);
        return sums;
    }

  private:
    Engine engine_{choose_kernel()};
};

// Adam as in the paper, in double precision but for what is stored.
void adam(Cloud& cloud, std::size_t at, double gradient, double rate, int step) {
    const double m = 0.9 * cloud.first_moment[at] + 0.1 * gradient;
    const double v = 0.999 * cloud.second_moment[at] + 0.001 * gradient * gradient;
    cloud.first_moment[at] = static_cast<float>(m);
    cloud.second_moment[at] = static_cast<float>(v);
    const double move = rate * (m / (1 - std::pow(0.9, step))) / (std::sqrt(v / (1 - std::pow(0.999, step))) + 1e-15);
    cloud.parameters[at] = static_cast<float>(cloud.parameters[at] - move);
}

class ReferenceStepper : public Stepper {
  public:
    LossSums step(Cloud& cloud, const View& view, float lambda, const std::array<float, kParameters>& rates, int adam_step) override {
        const auto splats = gaussians_of<double>(cloud.splats());
        const auto lens = lens_over<double>(lens_of(view.camera, view.world_from_camera));
        const auto picture = render_reference(splats, lens, view.camera.width, view.camera.height, Vec3d{});
        std::vector<Vec3d> colors;
        for (const auto& p : picture.pixels) colors.push_back(p.color);
        const ReferenceLoss loss = loss_reference(colors, view, lambda);
        const auto gradients = gradients_reference(splats, lens, picture, loss.v);
        for (std::int64_t i = 0; i < cloud.count; ++i) {
            const Gaussian<double>& g = gradients[static_cast<std::size_t>(i)];
            const double all[kParameters] = {g.mean.x,     g.mean.y,     g.mean.z,     g.log_scale.x, g.log_scale.y, g.log_scale.z, g.rotation.w,
                                             g.rotation.x, g.rotation.y, g.rotation.z, g.logit,       g.sh0.x,       g.sh0.y,       g.sh0.z};
            for (int p = 0; p < kParameters; ++p)
                adam(cloud, cloud.at(i, p), all[p], rates[static_cast<std::size_t>(p)], adam_step);
        }
        return {loss.loss, loss.squared_error};
    }
};

}  // namespace

std::unique_ptr<Stepper> make_stepper(const std::string& backend) {
    if (backend == "cpu") return std::make_unique<CpuStepper>();
    if (backend == "reference") return std::make_unique<ReferenceStepper>();
    throw UsageError("splat: unknown backend \"{}\"; expected cpu or reference", backend);
}

}  // namespace fastscene::splat
