#include "fastscene/evaluate/stills.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/geometry/reproject.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/pipeline/share.h"
#include "fastscene/splat/splat.h"

namespace fastscene {
namespace {

// Minimum distance of a camera from any surface, metres.
constexpr float kClearance = 0.3f;
constexpr float kPitchesDeg[] = {0.f, -15.f, 10.f};

// Free distance in a direction: the minimum range around it, less the clearance.
float free_way(const ImageF& range, Vec3f direction) {
    const Vec2f at = pixel_of_direction(direction, {range.width, range.height});
    const int x = static_cast<int>(at.x), y = std::min(static_cast<int>(at.y), range.height - 1),
              reach = std::max(1, range.width / 64);
    float least = 1e9f;
    for (int v = std::max(0, y - reach); v <= std::min(range.height - 1, y + reach); ++v)
        for (int u = x - reach; u <= x + reach; ++u) least = std::min(least, range.at(wrap_column(u, range.width), v));
    return std::max(0.f, least - kClearance);
}

void save_all(const std::filesystem::path& folder, const std::string& work, const std::vector<Rigid>& poses,
              const Run& run, const std::function<ImageRgb8(const Rigid&)>& picture) {
    make_directories(folder);
    Progress progress(run, work, static_cast<std::int64_t>(poses.size()));
    for (std::size_t i = 0; i < poses.size(); ++i) {
        run.check_stop();
        save_png(folder / fmt::format("{:02}.png", i), picture(poses[i]));
        progress.advance();
    }
}

StillsParams at_origin(StillsParams params) {
    params.radius_m = 0;
    return params;
}

}  // namespace

std::vector<Rigid> still_poses(const StillsParams& params, const ImageF& range) {
    std::vector<Rigid> poses;
    for (int i = 0; i < params.count; ++i) {
        Random random(static_cast<std::uint64_t>(i), "stills");
        Vec3f p;
        do p = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        while (!(dot(p, p) <= 1.f && dot(p, p) > 1e-6f));
        float far = length(p) * static_cast<float>(params.radius_m);
        const Vec3f direction = normalize(p);
        if (!range.empty()) far = std::min(far, free_way(range, direction));
        poses.push_back(world_from_camera_at(
            direction * far, 360.f * static_cast<float>(i) / static_cast<float>(params.count), kPitchesDeg[i % 3]));
    }
    return poses;
}

Pinhole still_camera(const StillsParams& params, int panorama_width) {
    const double focal = panorama_width / (2 * std::numbers::pi);
    const double native = 2 * focal * std::tan(params.fov_deg * std::numbers::pi / 360);
    const int side = params.size_px > 0 ? params.size_px
                                        : std::max(64, 64 * static_cast<int>(std::lround(native / 64)));
    return Pinhole::with_fov(side, side, static_cast<float>(params.fov_deg));
}

void save_walked_stills(const std::filesystem::path& folder, const Splats& splats, const StillsParams& params,
                        const Pinhole& camera, const ImageF& range, const Run& run) {
    const SplatRenderer renderer(splats);
    save_all(folder, "stills", still_poses(params, range), run,
             [&](const Rigid& pose) { return still_of(renderer, camera, pose).color; });
}
void save_origin_stills(const std::filesystem::path& folder, const Splats& splats, const StillsParams& params,
                        const Pinhole& camera, const Run& run) {
    const SplatRenderer renderer(splats);
    save_all(folder, "stills at the origin", still_poses(at_origin(params), {}), run,
             [&](const Rigid& pose) { return still_of(renderer, camera, pose).color; });
}
void save_input_stills(const std::filesystem::path& folder, const Panorama& first, const StillsParams& params,
                       const Pinhole& camera, const Run& run) {
    save_all(folder, "the panorama's own crops", still_poses(at_origin(params), {}), run, [&](const Rigid& pose) {
        return srgb8_from_linear(pinhole_from_equirect(first.color, camera, pose.rotation));
    });
}

}  // namespace fastscene
