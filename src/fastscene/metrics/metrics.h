// Metrics: scene quality against ground truth. A scene from a prompt is based on a known room; renderings of it at
// unseen poses are compared with the splats (PSNR, SSIM), in total and separately for surfaces that panorama 0 saw or
// did not see. Published figures in this field mostly compare with the source picture itself, which is easier and less
// informative.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fastscene/base/fields.h"
#include "fastscene/base/run.h"
#include "fastscene/scene/splats.h"
#include "fastscene/splat/splat.h"
#include "fastscene/trace/trace.h"
#include "fastscene/views/views.h"

namespace fastscene {

struct TruthParams {
    std::string where = "room";
    int views = 30;
    int size_px = 512;
    float radius_m = 0.3f;
    int samples = 256;
    bool bounds = false;
    std::string pose_seed = "truth";
};
template <class V>
void visit_fields(TruthParams& p, V&& v) {
    v("where", p.where, Choices{{"room", "near"}},
      "Sampling of the poses. room: wherever a visitor can stand, 1.2 to 1.8 m above the floor; near: in a ball around "
      "panorama 0.");
    v("views", p.views, Bounds{1, 10000}, "Number of poses never trained on.");
    v("size", p.size_px, Bounds{64, 4096}, "Width and height of a pose's picture in pixels, 75 degrees wide.");
    v("radius", p.radius_m, Bounds{0.01, 10}, "near: radius of that ball in metres.");
    v("samples", p.samples, Bounds{256, 65536},
      "Light samples of the ground truth: paths gathered per irradiance cell.");
    v("bounds", p.bounds,
      "Also train two bounds: on panorama 0 alone (B), and on true panoramas at the walked poses (A).");
}

// An evaluation pose, in the world frame.
struct TruthPose {
    Rigid world_from_camera;
};
// Near: uniform in a ball, at least 0.15 m from furniture and visible from panorama 0. Room: uniform over the standable
// floor (standable.h), 1.2 to 1.8 m above it and 0.25 m from everything. Any yaw, pitch within +-30 degrees, no roll.
// Deterministic in `seed`. Throws Error if the room has no free space.
std::vector<TruthPose> truth_poses(const TracedRoom& room, const TruthParams& params, std::uint64_t seed);

// Ground truth at one pose, rendered twice: `size` x `size` pixels, 75 degrees; `unseen`: nonzero where the surface is
// hidden from panorama 0 (at the origin).
struct TruthPicture {
    ImageRgb8 color;
    // rendered with independent camera rays, so that its noise is uncorrelated. Empty: `color` is exact
    ImageRgb8 again;
    ImageMask unseen;
};
TruthPicture truth_picture(const TracedRoom& room, const TruthPose& pose, int size, const Run& run);

// Ground truth of one room and radius, independent of the splats to be evaluated.
struct TruthSet {
    std::vector<TruthPose> poses;
    std::vector<TruthPicture> pictures;  // one per pose
    // mean PSNR of `color` against `again`: the noise that PSNR and SSIM are corrected for
    double floor_db = 0;
};
// run.seed selects the poses. Needs the room's light.
TruthSet make_truth_set(const TracedRoom& room, const TruthParams& params, const Run& run);
// poses.json, NN.png and NN-unseen.png. Loading throws Error naming a missing or invalid file.
void save_truth_set(const std::filesystem::path& dir, const TruthSet& set);
TruthSet load_truth_set(const std::filesystem::path& dir);

struct Likeness {
    double psnr = 0, ssim = 0, psnr_seen = 0, psnr_unseen = 0;  // NaN if there is nothing to compare
};
// PSNR corrected for the ground truth's noise: the mean of (picture - color) (picture - again), whose noise is
// independent, is an unbiased estimate of the squared error against a noise-free truth. SSIM is corrected likewise
// (ssim_of_noisy_truth).
Likeness compare(const ImageRgb8& picture, const TruthPicture& truth);

// A rendering of the splats at the truth's size, and the share of its pixels with an alpha below 98 %.
struct SplatSight {
    ImageRgb8 color;
    double low_alpha_share = 0;
};
SplatSight splat_sight(const SplatRenderer& splats, const TruthPose& pose, int size);

// What is evaluated, and the inputs of the bounds.
struct TruthInputs {
    TruthSet truth;
    std::function<const TracedRoom&()> room;         // its light gathered; called only if bounds have to be trained
    Panorama first;                                  // panorama 0 with range, as given to the walk
    std::vector<Rigid> world_from_pano;              // walked poses, panorama 0 first
    std::function<std::vector<ImageRgb8>()> walked;  // the walk's panoramas there; called only with bounds
    Splats splats;
    ViewsParams views;     // for the bounds: the same views settings …
    SplatParams splat;     // … and the same trainer
    ShotParts shot;        // render settings of panorama 0, used for true panoramas too
    SplatBackend backend;  // renders the splats
    std::string key;       // identifies these inputs; bounds are cached under this key
};
// Evaluates the splats and writes `dir`/truth/NN.png (truth, ours, [A, B,] 4 x difference of the first two) and, with
// bounds, `dir`/bounds/{A,B}.ply. Returns the section "truth" of metrics/report.json: where, psnr_mean, ssim_mean,
// psnr_worst, psnr_worst5_mean (of the worst twentieth of the poses), low_alpha_share, psnr_seen_mean,
// psnr_unseen_mean, floor_db, by_distance (from panorama 0), views; with bounds also
// bounds.{A,B}.{psnr_mean,ssim_mean}, gap_to_a_db, closed_share = (ours - B) / (A - B), and
// walked_poses.{count,walk_psnr_mean,splats_psnr_mean,a_psnr_mean,splat_stage_loses_db}: the walk's panoramas and
// panoramas rendered from our splats and A's, against true panoramas at the walked poses (without panorama 0, which is
// exact); the last is the mean PSNR that the splat stage loses relative to the walk.
// A: upper bound, trained on true panoramas at the walked poses. B: lower bound, trained on panorama 0 alone. True
// panoramas are cached as `dir`/bounds/panoramas/NN.png.
Json measure_truth(const TruthInputs& inputs, const TruthParams& params, const std::filesystem::path& dir,
                   const Run& run);

// Pictures in a row, followed by the amplified difference of the first two, for visual inspection.
ImageRgb8 side_by_side(const std::vector<ImageRgb8>& pictures);

}  // namespace fastscene
