#include "fastscene/nn/da2.h"

#include <filesystem>
#include <utility>

#include "fastscene/depth/estimator.h"

namespace fastscene::depth_backends {
namespace {

constexpr int kTurns = 2;  // half a turn apart: closes the seam at the least cost

class Da2Estimator : public DepthEstimator {
  public:
    Da2Estimator(Da2 network, std::string name, const DepthParams& params)
        : network_(std::move(network)),
          name_(std::move(name)),
          resize_(params.da2_resize),
          precision_(params.da2_precision),
          camera_height_m_(params.camera_height_m),
          turns_(params.tta > 0 ? params.tta : kTurns) {}
    EstimatedRange estimate(const ImageColor& color, const Run& run) const override {
        run.check_stop();
        const ImageF relative = network_.relative_range(
            color, resize_ == "inference" ? Da2Resize::inference : Da2Resize::evaluation, turns_, run);
        return in_metres(
            relative, color, camera_height_m_, UnknownOfRange::scale,
            {{"backend", "da2"}, {"weights", name_}, {"resize", resize_}, {"precision", precision_}, {"tta", turns_}},
            run);
    }

  private:
    Da2 network_;
    std::string name_, resize_, precision_;
    float camera_height_m_;
    int turns_;
};

std::unique_ptr<DepthEstimator> make_da2(const DepthParams& params) {
    const std::filesystem::path file = params.weights;
    if (file.empty())
        throw UsageError(
            "--depth-backend da2: expected --depth-weights FILE, or the model in the cache (fastscene models pull "
            "da2), found neither");
    const DeviceChoice device{params.device, "--depth-device"};
    const bool bf16 = params.da2_precision == "bf16";
    if (bf16 && !Da2::gains_by_bf16(device))
        throw UsageError(
            "--depth-da2-precision bf16: expected a graphics card, or a processor with AVX-512 BF16, found neither");
    return std::make_unique<Da2Estimator>(Da2::load(file, device, bf16), file.filename().string(), params);
}

}  // namespace

DepthBackend da2() {
    return {.name = "da2",
            .about = "Depth Anything in Any Direction, the most accurate (1.4 GB of weights)",
            .model = "da2",
            .auto_rank = 3,
            .ready = [](const DepthParams& params) { return !params.weights.empty() && Da2::is_in(params.weights); },
            .make = make_da2};
}

}  // namespace fastscene::depth_backends
