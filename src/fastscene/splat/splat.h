// Splat: views become 3D Gaussians (Kerbl et al. 2023), loss (1 - lambda) L1 + lambda D-SSIM, lambda = 0.2.
// Backends are registered by their files in splat_backends/.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
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

namespace splat {
struct Renderer;  // backend.h
}

inline constexpr int kAutomaticShDegree = -1;

// The backends that there are (splat/splat_backends/), and a sentence about each for --help.
std::vector<std::string> splat_backend_names();
const std::string& about_splat_backends();

// What renders and trains splats.
struct SplatBackend {
    std::string name = "cpu";
    std::string device = "auto";  // of vulkan (gpu::choose_device)
};
template <class V>
void visit_fields(SplatBackend& b, V&& v) {
    v("backend", b.name, Choices{splat_backend_names()}, about_splat_backends());
    v("device", b.device,
      "vulkan: the graphics card, by number or part of its name; auto: the one with the most memory; list: names "
      "them.");
}

struct SplatParams {
    SplatBackend backend;
    int count = 200000;  // maximum number of Gaussians; fixed, so memory is known in advance
    float per_m2 = 0;    // Gaussians per square metre of surface, if that gives fewer
    int steps = 3000;
    float start_opacity = 0.6f;  // high enough to cover, low enough that occluded splats still get gradients
    float start_overlap = 0.6f;  // standard deviations per point spacing: neighbours close the surface
    float coarse = 0;            // share of the steps
    float lambda_dssim = 0.2f;
    float learning_rate_logit = 0.03f;
    // metres per step at first, decaying; proportional to the scene, not to the camera baseline
    float learning_rate_mean_m = 1.5e-3f;
    std::string strategy = "mcmc";  // density control: where useless splats go and new ones appear
    // SH degree of view-dependent color; kAutomaticShDegree must be resolved before, fit_splats takes it as 0
    int sh_degree = 0;
    float opacity_reg = 0, scale_reg = 0;
    float depth = 0;      // weight of the depth regularizer
    float opaque = 0;     // weight of the transmittance loss
    float outside_m = 0;  // depth beyond which splats belong to the outside; 0: none do
    bool antialias = false;
    float low_pass_px2 = FootprintFilter{}.low_pass_px2;
    bool random_background = false;
    int eval_every = 0;
    int holdout = 8;
    int patience = 0;
    int until = 0;
    float begun = 0;  // how far through a full training the starting splats are, 0 to 1: sets the learning rates
    std::string checkpoint;
    int checkpoint_every = 500;

    FootprintFilter filter() const { return {low_pass_px2, antialias}; }
};
template <class V>
void visit_fields(SplatParams& p, V&& v) {
    visit_fields(p.backend, v);
    v("count", p.count, Bounds{1, 2e7}, "Number of Gaussians; never exceeded, whatever the strategy.");
    v("per-m2", p.per_m2, Bounds{0, 1e6},
      "Gaussians per square metre of surface, up to --splat-count with those of the outside; 0: always that count.");
    v("steps", p.steps, Bounds{0, 1e6}, "Training steps, one view each.");
    v("start-opacity", p.start_opacity, Bounds{0.01, 0.999}, "Initial opacity.");
    v("start-overlap", p.start_overlap, Bounds{0.05, 5}, "Initial standard deviation, relative to the point spacing.");
    v("lr-logit", p.learning_rate_logit, Bounds{0, 1}, "Initial learning rate of the opacity logits.");
    v("coarse", p.coarse, Bounds{0, 1}, "Share of the steps, at the beginning, that use half-size views.");
    v("lambda", p.lambda_dssim, Bounds{0, 1}, "Weight of D-SSIM in the loss.");
    v("lr-mean", p.learning_rate_mean_m, Bounds{0, 1}, "Initial learning rate of the positions, in metres.");
    v("strategy", p.strategy, Choices{{"mcmc", "classic", "none"}},
      "Density control. mcmc: dead splats move to where the error is, and new ones are added there; classic: clone, "
      "split, prune and reset opacities; none: fixed.");
    v("sh-degree", p.sh_degree, Bounds{-1, 3},
      "Degree of the spherical harmonics for view-dependent color. -1: 2 if the views are renderings of a known room, "
      "else 0.");
    v("opacity-reg", p.opacity_reg, Bounds{0, 10}, "Weight of the mean opacity in the loss.");
    v("scale-reg", p.scale_reg, Bounds{0, 10}, "Weight of the mean scale, in metres, in the loss.");
    v("depth", p.depth, Bounds{0, 10},
      "Weight of the depth regularizer: relative error of the rendered depth against that of the initial points.");
    v("opaque", p.opaque, Bounds{0, 10}, "Weight of the mean remaining transmittance in the loss, for closed scenes.");
    v("outside", p.outside_m, Bounds{0, 1e6},
      "Depth in metres beyond which a splat belongs to the outside and is trained only where it is visible. 0: none.");
    v("antialias", p.antialias,
      "Antialiasing: splats smaller than a pixel are dimmed instead of enlarged (Mip-Splatting's 2D filter); recorded "
      "in files.");
    v("low-pass", p.low_pass_px2, Bounds{kLeastLowPassPx2, kMostLowPassPx2},
      "Low-pass: variance in square pixels that is added to every splat's footprint. 0.3: as in Kerbl et al.'s program "
      "and in viewers; 0.1: as sharp as a pixel that averages its area; recorded in .ply files.");
    v("random-background", p.random_background,
      "A random background color in every step, so that dark transparent areas are penalized.");
    v("eval-every", p.eval_every, Bounds{0, 1e6}, "Evaluate held-out views every N steps; 0 = train on all views.");
    v("holdout", p.holdout, Bounds{2, 1e6}, "With eval-every: every Nth view is held out.");
    v("patience", p.patience, Bounds{0, 1e6},
      "With eval-every: stop after N evaluations without improvement; 0 = never.");
    v("until", p.until, Bounds{0, 1e6},
      "Stop at this step, or continue to it beyond `steps` with the final learning rates; 0 = at `steps`.");
    v("checkpoint", p.checkpoint, "Checkpoint file: resumed from if it exists, and written during training.");
    v("checkpoint-every", p.checkpoint_every, Bounds{1, 1e6}, "Steps between checkpoints.");
}

struct CurvePoint {
    int step;
    float loss, psnr;  // means over the training views since the last point
};
// Means over the held-out views.
struct EvalPoint {
    int step;
    float psnr, ssim;
};
struct EvalPicture {
    std::string view;
    ImageRgb8 picture, truth;
};
struct FittedSplats {
    Splats splats;
    std::vector<CurvePoint> curve;
    std::vector<EvalPoint> evals;            // empty without eval_every
    std::vector<EvalPicture> eval_pictures;  // at the end
    int steps = 0;                           // steps taken, including those before a resumed checkpoint
    std::string device;                      // what trained them: "processor", or a graphics card's name and driver
};

// Throws UsageError naming a flag that is out of bounds or contradicts another.
void check_splat_params(const SplatParams& params);

// Peak bytes of training besides its views, for `points` starting points.
std::int64_t splat_memory(const SplatParams& params, std::size_t points);
// The largest number of Gaussians that fits in memory; params.count if the available memory is unknown.
int most_that_fit(const SplatParams& params);
// Throws Error if training needs more memory than available, with `beside_bytes` reserved for other uses.
void check_splat_memory(const SplatParams& params, std::size_t points, std::int64_t beside_bytes = 0);

// params.count, or less if params.per_m2 times the surface area of the points, plus one for each point of the scenery
// outside, is less.
int count_for(const std::vector<SurfacePoint>& points, const SplatParams& params);

// Initial Gaussians: flat discs on the surfaces, at params.count randomly chosen points. With params.per_m2 those of
// the outside are kept, as many as count_for counts, since their number is chosen by what can be seen of it.
Splats initial_splats(const std::vector<SurfacePoint>& points, const SplatParams& params, const Run& run);
inline Splats initial_splats(const std::vector<SurfacePoint>& points, int count, const Run& run) {
    SplatParams params;
    params.count = count;
    return initial_splats(points, params, run);
}
// Trains. Throws Error if the views are inconsistent, memory is insufficient, or a checkpoint is damaged, has other
// settings or cannot be written (once training runs, a full disk only warns); throws Stopped when asked to stop, after
// writing the checkpoint if one is configured. Resuming from a checkpoint gives the same bytes as an uninterrupted run.
// `on_step` is called after every step whose loss is known, in order and by the calling thread; a graphics card's come
// some steps late.
struct StepReport {
    int step, steps;                 // from 1; of how many
    float loss, psnr;                // of the step's view
    std::function<Splats()> splats;  // as trained so far; a graphics card first completes its steps
};
using StepListener = std::function<void(const StepReport&)>;
// `begin`: splats to continue from, instead of initial ones at the views' points; params.begun tells how far they are.
FittedSplats fit_splats(const ViewSet& views, const SplatParams& params, const Run& run,
                        const StepListener& on_step = {}, const Splats* begin = nullptr);
// Whether `file` is a checkpoint of these views, settings and seed. Reads its header only, so it may still be damaged.
bool is_checkpoint_of(const std::string& file, const ViewSet& views, const SplatParams& params, std::uint64_t seed,
                      const Splats* begin = nullptr);

// A rendering: sRGB-encoded floats 0..1 on `background` (sRGB), and the expected depth if requested.
struct SplatPicture {
    ImageColor color;  // sRGB-encoded, as 3DGS stores color; NOT linear
    ImageF alpha;
    ImageF depth_z;  // alpha-weighted mean, metres along the optical axis (equirectangular: range along the ray); 0
                     // where alpha is 0
};

// Renders pictures of the same splats, which must live as long; for one picture, splats convert to it. Throws
// UsageError for an unknown backend or device. Not thread safe.
class SplatRenderer {
  public:
    SplatRenderer(const Splats& splats, const SplatBackend& backend = {});
    ~SplatRenderer();
    SplatRenderer(SplatRenderer&&) noexcept;

    // On `background` (sRGB, 0..1). Throws Error if a graphics card has too little memory or stops answering.
    SplatPicture picture(const Pinhole& camera, const Rigid& world_from_camera, Vec3f background = {},
                         CameraModel model = CameraModel::pinhole) const;

  private:
    std::unique_ptr<splat::Renderer> renderer_;
};
inline SplatPicture render_splats(const SplatRenderer& splats, const Pinhole& camera, const Rigid& world_from_camera,
                                  Vec3f background = {}, CameraModel model = CameraModel::pinhole) {
    return splats.picture(camera, world_from_camera, background, model);
}

// A still: one picture, perspective or panoramic.
struct Still {
    ImageRgb8 color;
    ImageMask alpha;  // opacity, 0..255
    ImageF
        distance;  // metres; perspective: along the optical axis (depth_z), panorama: along the ray (range); 0 = empty
};
// On `background` (sRGB, 0..1).
Still still_of(const SplatRenderer& splats, const Pinhole& camera, const Rigid& world_from_camera,
               Vec3f background = {});
// Equirectangular, width = 2 height: resampled from six perspective pictures.
Still sphere_of(const SplatRenderer& splats, int width, const Rigid& world_from_pano, Vec3f background = {});

}  // namespace fastscene
