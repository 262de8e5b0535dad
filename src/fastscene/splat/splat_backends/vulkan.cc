// Graphics cards (vulkan/engine.h).
#include "fastscene/base/random.h"
#include "fastscene/splat/backend.h"
#include "fastscene/splat/vulkan/engine.h"

namespace fastscene::splat_backends {
namespace {

using namespace splat;

class VulkanStepper : public Stepper {
  public:
    explicit VulkanStepper(const std::string& device) : engine_(device) {}
    std::string device() const override {
        return fmt::format("{} ({})", engine_.device().info().name, engine_.device().info().driver);
    }
    void load(const Cloud& cloud) override { engine_.load(cloud); }
    void set_views(std::vector<const View*> views, DepthOf depth_of) override { engine_.set_views(views, depth_of); }
    void step(Cloud&, std::size_t view, const StepPlan& plan) override { engine_.step(view, plan); }
    bool relocate(float growth, const Relocation& how, std::uint64_t seed, int step) override {
        if (how.useless_fraction > 0) return false;
        engine_.relocate(growth, Random(seed, "splat.relocate", static_cast<std::uint64_t>(step)).next_u32());
        return true;
    }
    std::vector<LossSums> losses() override { return engine_.losses(); }
    void store(Cloud& cloud) override { engine_.store(cloud); }

  private:
    vulkan::VulkanEngine engine_;
};

struct VulkanRenderer : Renderer {
    VulkanRenderer(const Splats& splats, const std::string& device) : engine(device, "--device") {
        engine.load(Cloud(splats, false));
    }
    SplatPicture picture(const Pinhole& camera, const Rigid& world_from_camera, Vec3f background,
                         CameraModel model) override {
        return engine.render(camera, world_from_camera, background, model);
    }
    vulkan::VulkanEngine engine;
};

}  // namespace

SplatBackendEntry vulkan() {
    return {.name = "vulkan",
            .about = "a graphics card",
            .check_device = [](const std::string& device,
                               const std::string& flag) { (void)gpu::choose_device(device, flag); },
            .make_stepper = [](const std::string& device) -> std::unique_ptr<Stepper> {
                return std::make_unique<VulkanStepper>(device);
            },
            .make_renderer = [](const Splats& splats, const std::string& device) -> std::unique_ptr<Renderer> {
                return std::make_unique<VulkanRenderer>(splats, device);
            }};
}

}  // namespace fastscene::splat_backends
