// Metrics: how good is a scene? Here: truth. A scene from a prompt has a real room behind it; pictures
// traced at poses that no stage has seen are compared with the splats (PSNR, SSIM), in all and split
// into what panorama 0 saw and what it did not. The published figures of this field mostly compare
// with the source picture itself; this is the harder and the more useful question.
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
      "Where the poses lie: room, wherever a visitor can stand, eyes 1.2 to 1.8 m above the floor; near, in a ball "
      "about panorama 0.");
    v("views", p.views, Bounds{1, 10000}, "Number of poses never trained on.");
    v("size", p.size_px, Bounds{64, 4096}, "Width and height of a pose's picture in pixels, 75 degrees wide.");
    v("radius", p.radius_m, Bounds{0.01, 10}, "Near: the radius of that ball in metres.");
    v("samples", p.samples, Bounds{256, 65536},
      "Light samples behind every pixel of the truth: paths gathered in each irradiance cell.");
    v("bounds", p.bounds, "Also train on panorama 0 alone (B) and on true panoramas at the walked poses (A).");
}

// A pose to be judged at, in the world frame.
struct TruthPose {
    Rigid world_from_camera;
};
// Near: uniform in the ball, clear of furniture by 0.15 m and in sight of panorama 0. Room: uniform over the standable
// floor (standable.h), eyes 1.2 to 1.8 m above it and 0.25 m clear of everything. Any yaw, pitch within +-30 degrees,
// no roll. Deterministic in `seed`. Throws Error when the room leaves no space.
std::vector<TruthPose> truth_poses(const TracedRoom& room, const TruthParams& params, std::uint64_t seed);

// The truth at one pose, traced twice: `size` x `size` pixels, 75 degrees; `unseen`: nonzero where panorama 0 (at the
// origin) did not see the surface.
struct TruthPicture {
    ImageRgb8 color;
    ImageRgb8 again;  // traced with other camera rays: what both have in common is no noise. Empty: `color` is exact
    ImageMask unseen;
};
TruthPicture truth_picture(const TracedRoom& room, const TruthPose& pose, int size, const Run& run);

// The truth of one room within one radius: whatever splats are judged, it stays the same.
struct TruthSet {
    std::vector<TruthPose> poses;
    std::vector<TruthPicture> pictures;  // one a pose
    double floor_db = 0;  // of `color` against `again`, the mean: the noise that PSNR is free of and SSIM is not
};
// `seed` of the run chooses the poses. Needs the room's light.
TruthSet make_truth_set(const TracedRoom& room, const TruthParams& params, const Run& run);
// poses.json, NN.png and NN-unseen.png. Load throws Error naming a file that is absent or not of that kind.
void save_truth_set(const std::filesystem::path& dir, const TruthSet& set);
TruthSet load_truth_set(const std::filesystem::path& dir);

struct Likeness {
    double psnr = 0, ssim = 0, psnr_seen = 0, psnr_unseen = 0;  // NaN where there is nothing to compare
};
// PSNR without the truth's own noise: the mean of (picture - color) (picture - again), whose noise is independent, is
// an unbiased estimate of the squared error against a truth of endlessly many rays. SSIM is against `color`.
Likeness compare(const ImageRgb8& picture, const TruthPicture& truth);

// The splats as a truth-sized picture, and the share of its pixels that they leave more than 2 % open.
struct SplatSight {
    ImageRgb8 color;
    double low_alpha_share = 0;
};
SplatSight splat_sight(const Splats& splats, const TruthPose& pose, int size);

// What is judged, and what the bounds are made from.
struct TruthInputs {
    TruthSet truth;
    std::function<const TracedRoom&()> room;  // its light gathered; asked for only when bounds have to be trained
    Panorama first;                           // panorama 0 as the walk saw it, with range
    std::vector<Rigid> world_from_pano;       // the walked poses, panorama 0 first
    std::function<std::vector<ImageRgb8>()> walked;  // the walk's pictures there; asked for only with bounds
    Splats splats;
    ViewsParams views;  // for the bounds: the same cutting …
    SplatParams splat;  // … and the same trainer
    ShotParts shot;     // how panorama 0 was shot: true panoramas are shot alike
    std::string key;    // names these inputs: bounds trained before under the same key are used again
};
// Judges the splats and writes `dir`/truth/NN.png (truth, ours, [A, B,] 4 x difference of the first two) and, with
// bounds, `dir`/bounds/{A,B}.ply. Returns the section "truth" of metrics/report.json: where, psnr_mean, ssim_mean,
// psnr_worst, psnr_worst5_mean (of the worst twentieth of the poses), low_alpha_share, psnr_seen_mean,
// psnr_unseen_mean, floor_db, by_distance (from panorama 0), views, and with bounds bounds.{A,B}.{psnr_mean,ssim_mean},
// gap_to_a_db, closed_share = (ours - B) / (A - B), and
// walked_poses.{count,walk_psnr_mean,splats_psnr_mean,a_psnr_mean,splat_stage_loses_db}: against the true panoramas at
// the walked poses (panorama 0, which is true, left out) the walk's pictures, the splats and A's seen all around from
// there; the last is the mean of what the splats have less than the walk.
//   A: trained on true panoramas at the walked poses. B: trained on panorama 0 alone.
// True panoramas are kept as `dir`/bounds/panoramas/NN.png.
Json measure_truth(const TruthInputs& inputs, const TruthParams& params, const std::filesystem::path& dir,
                   const Run& run);

// Pictures in a row, and the amplified difference of the first two at the end; for people to look at.
ImageRgb8 side_by_side(const std::vector<ImageRgb8>& pictures);

}  // namespace fastscene
