// Path tracing on a graphics card: the same pictures as Embree's, with the same random numbers, up to rounding.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/gpu/device.h"
#include "fastscene/scene/room.h"
#include "fastscene/trace/lights.h"
#include "fastscene/trace/picture.h"
#include "fastscene/trace/vulkan/kernels.h"
#include "fastscene/trace/vulkan/scene.h"

namespace fastscene::vulkan {

// `seed`: picture_key or path_picture_key.
Camera camera_data(const RayCamera& camera, std::uint64_t seed);

class Tracer {
  public:
    // `device` as in gpu::choose_device(). Throws UsageError naming `flag`.
    // `room` must live as long.
    Tracer(const std::string& device, const std::string& flag, const Room& room, const Lights& lights);

    gpu::Device& device() { return device_; }
    const gpu::Device& device() const { return device_; }
    void set_look(const Look& look, const Sky& sky);

    // The sums of the radiance of `samples` paths a pixel: path_traced_picture.
    ImageColor path_sums(const RayCamera& camera, const ShotParts& parts, int samples, const Run& run);

    // For what else runs on the card.
    void clear(const gpu::Buffer& buffer);
    CardScene& scene() { return scene_; }
    Kernels& kernels() { return kernels_; }
    const Material& material(std::size_t i) const { return room_.materials[i]; }
    // Runs `kernel` on items [0, count), a submission after the other. push(first, items) is what it is given.
    template <class PushOf>
    void run_in_pieces(LazyKernel& kernel, std::int64_t count, const Run& run, const PushOf& push) {
        const gpu::Kernel& made = kernel.on(device_, patterns_);
        Pace& pace = kernel.pace();
        for (std::int64_t first = 0; first < count;) {
            run.check_stop();
            const std::int64_t items = pace.next(count - first);
            const auto pushed = push(first, static_cast<std::uint32_t>(items));
            commands_.begin();
            commands_.run(made, {static_cast<std::uint32_t>((items + kGroup - 1) / kGroup)}, pushed);
            commands_.submit();
            commands_.wait();
            // The first one includes the driver's work on the kernel.
            const double took_s = pace.done();
            if (!kernel.is_new()) longest_s_ = std::max(longest_s_, took_s);
            first += items;
        }
    }

    // For tests: the first hits.
    struct Query {
        Vec3f origin, direction;
        float far_m = kFar;
        bool lit = false;
    };
    std::vector<RayHit> hits(const std::vector<Query>& rays);
    // The longest submission so far, in seconds.
    double longest_submission_s() const { return longest_s_; }

  private:
    static constexpr std::int64_t kGroup = 64;  // invocations of a workgroup

    const Room& room_;
    gpu::Device device_;
    PatternsInUse patterns_{};
    Kernels kernels_;
    gpu::Commands commands_;
    CardScene scene_;
    double longest_s_ = 0;
};

}  // namespace fastscene::vulkan
