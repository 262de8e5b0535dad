// Training steps on a graphics card.
#include "fastscene/splat/stepper.h"
#include "fastscene/splat/vulkan/engine.h"

namespace fastscene::splat {
namespace {

class VulkanStepper : public Stepper {
  public:
    explicit VulkanStepper(const std::string& device) : engine_(device) {}
    void load(const Cloud& cloud) override { engine_.load(cloud); }
    void set_views(std::vector<const View*> views, DepthOf depth_of) override { engine_.set_views(views, depth_of); }
    void step(Cloud&, std::size_t view, const StepPlan& plan) override { engine_.step(view, plan); }
    std::vector<LossSums> losses() override { return engine_.losses(); }
    void store(Cloud& cloud) override { engine_.store(cloud); }

  private:
    vulkan::VulkanEngine engine_;
};

}  // namespace

std::unique_ptr<Stepper> make_vulkan_stepper(const std::string& device) {
    return std::make_unique<VulkanStepper>(device);
}

}  // namespace fastscene::splat
