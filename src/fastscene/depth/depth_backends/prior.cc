// A room of the usual size, whatever the picture shows. It is the baseline of `depth check`: a network that scores no
// better has learned nothing from pictures.
#include <algorithm>

#include "fastscene/depth/box_layout.h"
#include "fastscene/depth/estimator.h"

namespace fastscene::depth_backends {
namespace {

constexpr float kWall_m = 2.2f;           // half of a room of 4.4 m, the median of the room types' plans
constexpr float kRoomHeight_m = 2.6f;     // as most rooms are built
constexpr float kLeastHeadroom_m = 0.3f;  // over a camera on a high tripod

class PriorEstimator : public DepthEstimator {
  public:
    explicit PriorEstimator(float camera_height_m) {
        box_.wall_m.fill(kWall_m);
        box_.floor_m = camera_height_m;
        box_.ceiling_m = std::max(kLeastHeadroom_m, kRoomHeight_m - camera_height_m);
    }
    EstimatedRange estimate(const ImageColor& color, const Run& run) const override {
        run.check_stop();
        return {range_of_box(box_, {color.width, color.height}),
                {{"backend", "prior"}, {"camera_height_m", box_.floor_m}, {"walls_m", box_.wall_m}}};
    }

  private:
    BoxLayout box_;
};

}  // namespace

DepthBackend prior() {
    return {.name = "prior",
            .about = "a room of usual size, whatever the picture shows: the baseline for depth check",
            .make = [](const DepthParams& params) -> std::unique_ptr<DepthEstimator> {
                return std::make_unique<PriorEstimator>(params.camera_height_m);
            }};
}

}  // namespace fastscene::depth_backends
