#include "fastscene/nn/egformer.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "fastscene/depth/align.h"
#include "fastscene/depth/estimator.h"
#include "fastscene/geometry/reproject.h"
#include "fastscene/weights/shipped.h"

namespace fastscene {

ImageF mean_depth(std::span<const Egformer> networks, const ImageColor& color, int augmentations, const Run& run) {
    const EgformerShape& finest = networks.front().shape();
    ImageF mean(finest.width, finest.height);
    for (const Egformer& network : networks) {
        run.check_stop();
        ImageF found = network.relative_depth(color, augmentations);
        if (!found.same_size(mean))
            found = aligned_to_picture(found, equirect_from_equirect(color, {finest.width, finest.height}));
        for (std::size_t i = 0; i < mean.size(); ++i)
            mean.pixels[i] += found.pixels[i] / static_cast<float>(networks.size());
    }
    return mean;
}

namespace depth_backends {
namespace {

bool are_shipped() { return std::all_of(kShippedDepth.begin(), kShippedDepth.end(), is_shipped); }

class EgformerEstimator : public DepthEstimator {
  public:
    EgformerEstimator(std::vector<Egformer> networks, std::string name, const DepthParams& params)
        : networks_(std::move(networks)),
          name_(std::move(name)),
          camera_height_m_(params.camera_height_m),
          augmentations_(params.tta > 0                                      ? params.tta
                         : networks_.front().shape().height <= kSmallNetwork ? 8
                                                                             : 1) {}
    EstimatedRange estimate(const ImageColor& color, const Run& run) const override {
        const ImageF relative = mean_depth(networks_, color, augmentations_, run);
        run.check_stop();
        return in_metres(relative, color, camera_height_m_, UnknownOfRange::scale_and_shift,
                         {{"backend", "egformer"}, {"weights", name_}, {"tta", augmentations_}}, run);
    }

  private:
    static constexpr int kSmallNetwork = 128;  // rows: below this, eight augmentations take only a few seconds
    std::vector<Egformer> networks_;
    std::string name_;
    float camera_height_m_;
    int augmentations_;
};

std::unique_ptr<DepthEstimator> make_egformer(const DepthParams& params) {
    std::vector<Egformer> networks;
    const DeviceChoice device{params.device, "--depth-device"};
    if (const std::filesystem::path file = params.weights; !file.empty()) {
        networks.push_back(Egformer::load(file, device));
        return std::make_unique<EgformerEstimator>(std::move(networks), file.filename().string(), params);
    }
    if (!are_shipped())
        throw UsageError(
            "--depth-backend egformer: expected --depth-weights FILE (fastscene models pull egformer says where to get "
            "it), found none");
    for (const char* name : kShippedDepth) networks.push_back(Egformer::shipped(name, device));
    return std::make_unique<EgformerEstimator>(std::move(networks), fmt::format("{}", fmt::join(kShippedDepth, ", ")),
                                               params);
}

}  // namespace

DepthBackend egformer() {
    return {.name = "egformer",
            .about = "the paper's network, with its shipped weights or --depth-weights",
            .model = "egformer",
            .auto_rank = 2,
            .ready = [](const DepthParams& params) { return !params.weights.empty() || are_shipped(); },
            .make = make_egformer};
}

}  // namespace depth_backends
}  // namespace fastscene
