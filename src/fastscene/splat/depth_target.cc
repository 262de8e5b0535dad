#include "fastscene/splat/depth_target.h"

#include "fastscene/splat/splat.h"

namespace fastscene::splat {

DepthTarget::DepthTarget(const ViewSet& set, int count, const Run& run)
    : points_(initial_splats(set.points, count, run), false), engine_(choose_kernel()) {}

const ImageF& DepthTarget::of(const View& view) {
    constexpr float kCovered = 0.9f;
    engine_.render(points_, view.camera, view.world_from_camera, {}, true, view.model);
    depth_ = ImageF(view.camera.width, view.camera.height);
    for (int y = 0; y < depth_.height; ++y)
        for (int x = 0; x < depth_.width; ++x) {
            const float alpha = 1.f - engine_.transmittance(x, y);
            depth_.at(x, y) = alpha > kCovered ? engine_.depth_sum(x, y) / alpha : 0.f;
        }
    return depth_;
}

}  // namespace fastscene::splat
