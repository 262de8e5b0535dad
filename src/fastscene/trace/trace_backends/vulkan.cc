// Graphics cards (vulkan/tracer.h).
#include <fmt/format.h>

#include "fastscene/trace/backend.h"
#include "fastscene/trace/vulkan/card_gatherer.h"
#include "fastscene/trace/vulkan/card_pixels.h"

namespace fastscene::trace_backends {
namespace {

class CardRoom : public RoomTracer {
  public:
    CardRoom(const std::string& device, const Room& room, const Lights& lights)
        : tracer_(device, "--trace-device", room, lights), gatherer_(tracer_) {}
    std::string device() const override {
        return fmt::format("{} ({})", tracer_.device().info().name, tracer_.device().info().driver);
    }
    Gatherer& gatherer() override { return gatherer_; }
    void set_look(const Look& look, const Sky& sky) override { tracer_.set_look(look, sky); }
    MakePixelTracer pixels(const ShotParts& parts) override {
        return [this, options = vulkan::ShadeOptions{parts.contacts, parts.frugal, parts.min_alpha}](
                   const PixelPlan& plan) { return std::make_unique<vulkan::CardPixels>(tracer_, options, plan); };
    }
    ImageColor path_sums(const RayCamera& camera, const ShotParts& parts, int samples, const Run& run) override {
        return tracer_.path_sums(camera, parts, samples, run);
    }

  private:
    vulkan::Tracer tracer_;
    vulkan::CardGatherer gatherer_;
};

}  // namespace

TraceBackendEntry vulkan() {
    return {
        .name = "vulkan",
        .about = "a graphics card",
        .check_device = [](const std::string& device,
                           const std::string& flag) { (void)gpu::choose_device(device, flag); },
        .make = [](const std::string& device, const Room& room, const Lights& lights) -> std::unique_ptr<RoomTracer> {
            return std::make_unique<CardRoom>(device, room, lights);
        }};
}

}  // namespace fastscene::trace_backends
