// Splat: views become 3D Gaussians (Kerbl et al. 2023), loss (1 - lambda) L1 + lambda D-SSIM, lambda = 0.2.
// Backends: "reference" (slow, readable, double precision possible) and "cpu" (tiles, SIMD, threads).
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/geometry/pinhole.h"
#include "fastscene/image/image.h"
#include "fastscene/math/rigid.h"
#include "fastscene/scene/splats.h"
#include "fastscene/scene/view.h"

namespace fastscene {

struct SplatParams {
    std::string backend = "cpu";
    int count = 200000;                // Gaussians; fixed: memory is known in advance
    int steps = 3000;
    float lambda_dssim = 0.2f;
    float learning_rate_mean_m = 1.5e-3f;  // metres a step at first, decaying; scene-sized, not camera-sized
};
template <class V>
void visit_fields(SplatParams& p, V&& v) {
    v("backend", p.backend, Choices{{"cpu", "reference"}}, "What renders and differentiates the splats.");
    v("count", p.count, Bounds{1, 2e7}, "Number of Gaussians.");
    v("steps", p.steps, Bounds{0, 1e6}, "Training steps; each looks at one view.");
    v("lambda", p.lambda_dssim, Bounds{0, 1}, "Weight of D-SSIM in the loss.");
    v("lr-mean", p.learning_rate_mean_m, Bounds{0, 1}, "First step size of the positions, in metres.");
}

struct CurvePoint {
    int step;
    float loss, psnr;   // mean over the last steps' training views
};
struct FittedSplats {
    Splats splats;
    std::vector<CurvePoint> curve;
};

// Starting Gaussians: flat discs on the surfaces, `count` of them drawn from the points.
Splats initial_splats(const std::vector<SurfacePoint>& points, int count, const Run& run);
FittedSplats fit_splats(const ViewSet& views, const SplatParams& params, const Run& run);

// A picture of the splats: sRGB-encoded floats 0..1 on `background` (sRGB), and if asked the expected depth.
struct SplatPicture {
    ImageColor color;     // sRGB-encoded (what 3DGS stores), NOT linear
    ImageF alpha;
    ImageF depth_z;       // alpha-weighted mean, metres along the optical axis; 0 where alpha is 0
};
SplatPicture render_splats(const Splats& splats, const Pinhole& camera, const Rigid& world_from_camera,
                           Vec3f background = {}, const std::string& backend = "cpu");

}  // namespace fastscene
