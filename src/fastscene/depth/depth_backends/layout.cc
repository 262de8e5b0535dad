#include "fastscene/depth/box_layout.h"
#include "fastscene/depth/estimator.h"

namespace fastscene::depth_backends {
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

}  // namespace

DepthBackend layout() {
    return {.name = "layout",
            .about = "a box fitted to the picture's lines",
            .auto_rank = 1,
            .make = [](const DepthParams& params) -> std::unique_ptr<DepthEstimator> {
                return std::make_unique<LayoutEstimator>(params.camera_height_m);
            }};
}

}  // namespace fastscene::depth_backends
