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

class Tracer {
  public:
    // `device` as in gpu::choose_device(). Throws UsageError naming `flag`.
    Tracer(const std::string& device, const std::string& flag, const Room& room, const Lights& lights);

    gpu::Device& device() { return device_; }
    const gpu::Device& device() const { return device_; }
    void set_look(const Look& look, const Sky& sky);

    // The sums of the radiance of `samples` paths a pixel: path_traced_picture.
    ImageColor path_sums(const RayCamera& camera, const ShotParts& parts, int samples, const Run& run);

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
    // Runs `kernel` on items [0, count), a submission after the other. push(first, items) is what it is given.
    template <class PushOf>
    void run_in_pieces(LazyKernel& kernel, std::int64_t count, const Run& run, const PushOf& push);

    gpu::Device device_;
    Kernels kernels_;
    gpu::Commands commands_;
    CardScene scene_;
    double longest_s_ = 0;
};

}  // namespace fastscene::vulkan
