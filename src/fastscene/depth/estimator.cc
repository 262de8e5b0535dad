#include "fastscene/depth/estimator.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "fastscene/depth/align.h"
#include "fastscene/depth/box_layout.h"
#include "fastscene/depth/metric_range.h"
#include "fastscene/depth/room_lines.h"
#include "fastscene/depth/walls.h"
#include "fastscene/geometry/reproject.h"
#include "fastscene/nn/egformer.h"
#include "fastscene/nn/shipped.h"

namespace fastscene {
namespace {

class LayoutEstimator : public DepthEstimator {
  public:
    explicit LayoutEstimator(float camera_height_m) : camera_height_m_(camera_height_m) {}
    EstimatedRange estimate(const ImageColor& color, const Run& run) const override {
        run.check_stop();
        const BoxLayout box = fit_box(color, camera_height_m_);
        return {range_of_box(box, {color.width, color.height}),
                {{"backend", "layout"},
                 {"camera_height_m", box.floor_m},
                 {"ceiling_above_camera_m", box.ceiling_m},
                 {"walls_m", box.wall_m},
                 {"yaw_deg", box.yaw * 57.29578f},
                 {"edge_score", box.score}}};
    }

  private:
    float camera_height_m_;
};

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
        const MetricFit fit = fit_metres(relative, camera_height_m_);
        if (!fit.sure)
            run.warn(fmt::format(
                "depth: expected a level floor {} m below the camera, found too little of it: the scale is a guess",
                camera_height_m_));
        const ImageF range = metric_range(relative, fit);
        return {aligned_to_picture(range, color),
                {{"backend", "egformer"},
                 {"weights", name_},
                 {"tta", augmentations_},
                 {"camera_height_m", fit.camera_height_m},
                 {"ceiling_above_camera_m", fit.ceiling_m},
                 {"scale", fit.scale},
                 {"shift", fit.shift},
                 {"floor_share", fit.floor_share},
                 {"floor_found", fit.sure},
                 {"walls", walls_of(range, color, fit)}}};
    }

  private:
    static Json walls_of(const ImageF& range, const ImageColor& color, const MetricFit& fit) {
        Json out = Json::array();
        for (const Wall& wall : walls_with_lines(range, find_lines(color), fit.camera_height_m, fit.ceiling_m))
            out.push_back({{"yaw_deg", wall.yaw * 57.29578f},
                           {"distance_m", wall.distance_m},
                           {"share", wall.share},
                           {"line_m", wall.line_m}});
        return out;
    }

    static constexpr int kSmallNetwork = 128;  // rows: below this, eight augmentations take only a few seconds
    std::vector<Egformer> networks_;
    std::string name_;
    float camera_height_m_;
    int augmentations_;
};

}  // namespace

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

std::unique_ptr<DepthEstimator> make_depth_estimator(const DepthParams& params) {
    FASTSCENE_CHECK(params.backend == "layout" || params.backend == "auto" || params.backend == "egformer");
    const float height = params.camera_height_m;
    if (params.backend == "layout") return std::make_unique<LayoutEstimator>(height);
    std::vector<Egformer> networks;
    if (const std::filesystem::path file = params.weights; !file.empty()) {
        networks.push_back(Egformer::load(file));
        return std::make_unique<EgformerEstimator>(std::move(networks), file.filename().string(), params);
    }
    if (std::all_of(kShippedDepth.begin(), kShippedDepth.end(), is_shipped)) {
        for (const char* name : kShippedDepth) networks.push_back(Egformer::shipped(name));
        return std::make_unique<EgformerEstimator>(std::move(networks),
                                                   fmt::format("{}", fmt::join(kShippedDepth, ", ")), params);
    }
    if (params.backend == "egformer")
        throw UsageError(
            "--depth-backend egformer: expected --depth-weights FILE (fastscene models pull egformer says where to get "
            "it), found none");
    return std::make_unique<LayoutEstimator>(height);
}

}  // namespace fastscene
