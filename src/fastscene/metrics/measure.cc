#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "fastscene/base/file.h"
#include "fastscene/image/color.h"
#include "fastscene/image/ssim.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/metrics/metrics.h"
#include "fastscene/splat/splat.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

std::string picture_name(std::size_t i) { return fmt::format("{:02}.png", i); }

// `path` was made from the inputs with the key in NAME.key next to it.
fs::path key_file_of(const fs::path& path) { return fs::path(path).replace_extension(".key"); }
bool is_kept(const fs::path& path, const std::string& key) {
    return fs::exists(path) && fs::exists(key_file_of(path)) && read_file(key_file_of(path)) == key;
}

// Bounds: splats trained on other panoramas with the same settings, cached on disk since training is slow.
Splats trained_once(const fs::path& ply, const std::function<std::vector<Panorama>()>& panoramas,
                    const TruthInputs& inputs, const Run& run) {
    if (is_kept(ply, inputs.key)) return load_splat_ply(ply);
    const ViewSet views = project_views(panoramas(), inputs.views, run);
    SplatParams sized = inputs.splat;
    sized.count = count_for(views.points, sized);
    const Splats splats = fit_splats(views, sized, run).splats;
    save_splat_ply(ply, splats);
    write_file(key_file_of(ply), inputs.key);
    return splats;
}

// True panoramas at the walked poses, quantized to 8 bits like all stage inputs.
std::vector<Panorama> true_panoramas(const TruthInputs& inputs, const Run& run) {
    std::vector<Panorama> panoramas{inputs.first};
    ShotParts parts = inputs.shot;
    parts.mirrored_range = true;
    const TracedRoom& room = inputs.room();
    Progress progress(run, "true panoramas", static_cast<std::int64_t>(inputs.world_from_pano.size()) - 1);
    for (std::size_t i = 1; i < inputs.world_from_pano.size(); ++i) {
        run.check_stop();
        const Run quiet{run.seed + i, nullptr, run.stop};
        const Shot shot = room.panorama(inputs.world_from_pano[i], inputs.first.size(), parts, quiet);
        panoramas.push_back(
            {linear_from_srgb8(srgb8_from_linear(shot.color)), shot.mirrored_range, {}, inputs.world_from_pano[i], {}});
        progress.advance();
    }
    return panoramas;
}

// The same, with their colors cached in `dir`.
std::vector<Panorama> kept_true_panoramas(const fs::path& dir, const TruthInputs& inputs, const Run& run) {
    std::vector<Panorama> panoramas = true_panoramas(inputs, run);
    make_directories(dir);
    for (std::size_t i = 1; i < panoramas.size(); ++i)
        save_png(dir / picture_name(i), srgb8_from_linear(panoramas[i].color));
    write_file(key_file_of(dir), inputs.key);
    return panoramas;
}

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    int count = 0;
    for (const double v : values)
        if (std::isfinite(v)) sum += v, ++count;
    return count ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

// Compares the walk's panoramas, and the splats (ours and bound A), with the true panoramas at the walked poses.
Json at_walked_poses(const TruthInputs& inputs, const Splats& a, const fs::path& true_panoramas, const Run& run) {
    const std::vector<ImageRgb8> walked = inputs.walked();
    FASTSCENE_CHECK(walked.size() == inputs.world_from_pano.size());
    std::vector<double> walk, ours, bound, lost;
    const SplatRenderer renderer(inputs.splats, inputs.backend), bound_renderer(a, inputs.backend);
    Progress progress(run, "walked poses", static_cast<std::int64_t>(walked.size()) - 1);
    for (std::size_t i = 1; i < walked.size(); ++i) {
        run.check_stop();
        const ImageRgb8 truth = load_rgb8(true_panoramas / picture_name(i));
        const auto likeness = [&](const SplatRenderer& splats) {
            return psnr(sphere_of(splats, truth.width, inputs.world_from_pano[i]).color, truth);
        };
        walk.push_back(psnr(walked[i], truth));
        ours.push_back(likeness(renderer));
        bound.push_back(likeness(bound_renderer));
        lost.push_back(walk.back() - ours.back());
        progress.advance();
    }
    return {{"count", walk.size()},
            {"walk_psnr_mean", mean_of(walk)},
            {"splats_psnr_mean", mean_of(ours)},
            {"a_psnr_mean", mean_of(bound)},
            {"splat_stage_loses_db", mean_of(lost)}};
}

// Means over the views; NaN (nothing to compare) is skipped.
class Means {
  public:
    void add(const Likeness& l) {
        psnr_.push_back(l.psnr);
        ssim_.push_back(l.ssim);
        seen_.push_back(l.psnr_seen);
        unseen_.push_back(l.psnr_unseen);
    }
    double psnr() const { return mean_of(psnr_); }
    double ssim() const { return mean_of(ssim_); }
    std::size_t count() const { return psnr_.size(); }
    Json json() const {
        return {{"psnr_mean", mean_of(psnr_)},
                {"ssim_mean", mean_of(ssim_)},
                {"psnr_worst", *std::min_element(psnr_.begin(), psnr_.end())},
                {"psnr_worst5_mean", worst_mean()},
                {"psnr_seen_mean", mean_of(seen_)},
                {"psnr_unseen_mean", mean_of(unseen_)}};
    }

  private:
    // Mean of the worst twentieth, at least one.
    double worst_mean() const {
        constexpr std::size_t kTwentieth = 20;
        std::vector<double> sorted = psnr_;
        std::sort(sorted.begin(), sorted.end());
        sorted.resize((sorted.size() + kTwentieth - 1) / kTwentieth);
        return mean_of(sorted);
    }
    std::vector<double> psnr_, ssim_, seen_, unseen_;
};

// Similarity by distance from panorama 0.
class ByDistance {
  public:
    void add(const Rigid& pose, const Likeness& likeness) {
        const auto metre = static_cast<std::size_t>(length(pose.translation));
        bins_[std::min(metre, bins_.size() - 1)].add(likeness);
    }
    Json json() const {
        Json out = Json::array();
        for (std::size_t m = 0; m < bins_.size(); ++m) {
            if (bins_[m].count() == 0) continue;
            Json bin{{"from_m", m},
                     {"views", bins_[m].count()},
                     {"psnr_mean", bins_[m].psnr()},
                     {"ssim_mean", bins_[m].ssim()}};
            if (m + 1 < bins_.size()) bin["to_m"] = m + 1;
            out.push_back(std::move(bin));
        }
        return out;
    }

  private:
    std::array<Means, 6> bins_;  // one metre each; the last is open-ended
};

Json view_json(const TruthPose& pose, const Likeness& l, const SplatSight& sight) {
    constexpr float kDegrees = 180.f / kPi;
    const Vec3f p = pose.world_from_camera.translation, forward = pose.world_from_camera.rotation * Vec3f{0, 0, 1};
    return {{"position_m", {p.x, p.y, p.z}},
            {"yaw_deg", std::atan2(forward.x, forward.z) * kDegrees},
            {"pitch_deg", std::asin(std::clamp(-forward.y, -1.f, 1.f)) * kDegrees},
            {"psnr", l.psnr},
            {"ssim", l.ssim},
            {"low_alpha_share", sight.low_alpha_share},
            {"psnr_seen", l.psnr_seen},
            {"psnr_unseen", l.psnr_unseen}};
}

}  // namespace

Json measure_truth(const TruthInputs& inputs, const TruthParams& params, const fs::path& dir, const Run& run) {
    const std::vector<TruthPose>& poses = inputs.truth.poses;
    make_directories(dir / "truth");

    std::optional<Splats> a, b;
    Json walked_poses;
    if (params.bounds) {
        const fs::path bounds = dir / "bounds", panoramas = bounds / "panoramas";
        make_directories(bounds);
        a = trained_once(
            bounds / "A.ply", [&] { return kept_true_panoramas(panoramas, inputs, run); }, inputs, run);
        b = trained_once(
            bounds / "B.ply", [&] { return std::vector{inputs.first}; }, inputs, run);
        if (!is_kept(panoramas, inputs.key)) kept_true_panoramas(panoramas, inputs, run);
        walked_poses = at_walked_poses(inputs, *a, panoramas, run);
    }

    const SplatRenderer renderer(inputs.splats, inputs.backend);
    std::optional<SplatRenderer> renderer_a, renderer_b;
    if (a) renderer_a.emplace(*a, inputs.backend), renderer_b.emplace(*b, inputs.backend);
    Means ours, bound_a, bound_b;
    ByDistance by_distance;
    double low_alpha = 0;
    Json views = Json::array();
    for (std::size_t i = 0; i < poses.size(); ++i) {
        run.check_stop();
        const TruthPicture& truth = inputs.truth.pictures[i];
        const SplatSight sight = splat_sight(renderer, poses[i], params.size_px);
        std::vector<ImageRgb8> row{truth.color, sight.color};
        const Likeness likeness = compare(sight.color, truth);
        ours.add(likeness);
        by_distance.add(poses[i].world_from_camera, likeness);
        low_alpha += sight.low_alpha_share / static_cast<double>(poses.size());
        Json view = view_json(poses[i], likeness, sight);
        if (a) {
            row.push_back(splat_sight(*renderer_a, poses[i], params.size_px).color);
            row.push_back(splat_sight(*renderer_b, poses[i], params.size_px).color);
            const Likeness of_a = compare(row[2], truth), of_b = compare(row[3], truth);
            bound_a.add(of_a);
            bound_b.add(of_b);
            view["psnr_a"] = of_a.psnr;
            view["psnr_b"] = of_b.psnr;
        }
        save_png(dir / "truth" / picture_name(i), side_by_side(row));
        views.push_back(std::move(view));
    }

    Json truth = {{"where", params.where}, {"samples", params.samples}};
    if (params.where == "near") truth["radius_m"] = params.radius_m;
    truth.update(ours.json());
    truth["low_alpha_share"] = low_alpha;
    truth["by_distance"] = by_distance.json();
    truth["floor_db"] = inputs.truth.floor_db;
    if (a) {
        truth["bounds"] = {{"A", bound_a.json()}, {"B", bound_b.json()}};
        truth["gap_to_a_db"] = bound_a.psnr() - ours.psnr();
        truth["closed_share"] = (ours.psnr() - bound_b.psnr()) / (bound_a.psnr() - bound_b.psnr());
        truth["walked_poses"] = std::move(walked_poses);
    }
    truth["views"] = std::move(views);
    return truth;
}

}  // namespace fastscene
