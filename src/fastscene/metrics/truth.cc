#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "fastscene/base/random.h"
#include "fastscene/image/color.h"
#include "fastscene/image/ssim.h"
#include "fastscene/metrics/metrics.h"
#include "fastscene/splat/splat.h"
#include "fastscene/trace/standable.h"

namespace fastscene {
namespace {

constexpr float kFovDeg = 75.f;
// About the width of a head: visitors are never closer to a surface.
constexpr float kClearance = 0.15f;

constexpr int kSamples = 16;  // per pixel, in each of the two pictures: more poses are more informative than less noise
constexpr std::uint64_t kOtherRays = 0x5eed;

Pinhole truth_camera(int size) { return Pinhole::with_fov(size, size, kFovDeg); }

Vec3f uniform_in_ball(Random& random) {
    for (;;) {
        const Vec3f p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        if (dot(p, p) <= 1.f) return p;
    }
}

// Yaw turns right about the world's down axis, pitch looks up.
Mat3f looking(float yaw, float pitch) {
    return rotation_about(Vec3f{0, 1, 0}, yaw) * rotation_about(Vec3f{1, 0, 0}, pitch);
}

bool stands_free(const TracedRoom& room, Vec3f p) {
    const float far = length(p);
    if (far > 0.f && !(room.distance({}, p / far) > far)) return false;  // occluded
    return room.clearance(p, kClearance) >= kClearance;
}

// Any yaw, pitch within 30 degrees.
Mat3f looking_anywhere(Random& random) {
    const float yaw = random.uniform(-1, 1) * std::numbers::pi_v<float>;
    return looking(yaw, random.uniform(-1, 1) * std::numbers::pi_v<float> / 6);
}

// Where visitors stand.
std::vector<TruthPose> poses_in_room(const TracedRoom& room, const TruthParams& params, Random random) {
    constexpr float kLow_m = 1.2f, kHigh_m = 1.8f, kAir_m = 0.25f;
    constexpr int kTriesAPose = 1000;
    const StandableFloor floor = standable_floor(room, {.clear_m = kAir_m});
    const std::vector<FloorCell> cells = standable_cells(floor);
    std::vector<TruthPose> poses;
    for (int tries = 0; static_cast<int>(poses.size()) < params.views; ++tries) {
        if (cells.empty() || tries > kTriesAPose * params.views)
            throw Error(
                "--where room: expected floor to stand on with {} m of clearance, found {} poses; --where near needs "
                "less",
                kAir_m, poses.size());
        const FloorCell cell = cells[static_cast<std::size_t>(random.index(static_cast<int>(cells.size())))];
        const Vec2f middle = floor.center(cell.column, cell.row),
                    off{random.uniform(-0.5f, 0.5f), random.uniform(-0.5f, 0.5f)};
        const Vec2f at = middle + off * floor.cell_m;
        const Vec3f eye{at.x, floor.level_at(cell.column, cell.row) - random.uniform(kLow_m, kHigh_m), at.y};
        const Mat3f rotation = looking_anywhere(random);
        if (has_air(room, eye, kAir_m)) poses.push_back({{rotation, eye}});
    }
    return poses;
}

// Product of the errors, in units of 0..1, averaged over the channels.
double error_product(Rgb8 picture, Rgb8 a, Rgb8 b) {
    const auto channel = [](int p, int x, int y) { return (p - x) * (p - y); };
    const int sum = channel(picture.r, a.r, b.r) + channel(picture.g, a.g, b.g) + channel(picture.b, a.b, b.b);
    return sum / (3. * 255 * 255);
}

class SquaredError {
  public:
    void add(double error) { sum_ += error, ++count_; }
    // NaN without pixels; limited to 8-bit resolution, since the estimate may be arbitrarily small by chance.
    double psnr() const {
        constexpr double kLeast = 1. / (12 * 255 * 255);
        if (count_ == 0) return std::numeric_limits<double>::quiet_NaN();
        if (sum_ == 0) return std::numeric_limits<double>::infinity();
        return -10 * std::log10(std::max(kLeast, sum_ / static_cast<double>(count_)));
    }

  private:
    double sum_ = 0;
    std::int64_t count_ = 0;
};

}  // namespace

std::vector<TruthPose> truth_poses(const TracedRoom& room, const TruthParams& params, std::uint64_t seed) {
    Random random(seed, params.pose_seed);
    if (params.where == "room") return poses_in_room(room, params, random);
    std::vector<TruthPose> poses;
    for (int tries = 0; static_cast<int>(poses.size()) < params.views; ++tries) {
        if (tries > 1000 * params.views)
            throw Error("--radius {}: expected free space for {} poses around the first viewpoint, found {}",
                        params.radius_m, params.views, poses.size());
        const Vec3f p = uniform_in_ball(random) * params.radius_m;
        const Mat3f rotation = looking_anywhere(random);
        if (stands_free(room, p)) poses.push_back({{rotation, p}});
    }
    return poses;
}

TruthPicture truth_picture(const TracedRoom& room, const TruthPose& pose, int size, const Run& run) {
    const Pinhole camera = truth_camera(size);
    const ShotParts parts{
        .color = true, .range = true, .pixel_samples = kSamples, .contacts = true, .frugal = true, .denoise = true};
    ShotParts color_only = parts;
    color_only.range = false;
    const Shot shot = room.perspective(pose.world_from_camera, camera, parts, run);
    const Shot again = room.perspective(pose.world_from_camera, camera, color_only,
                                        Run{run.seed ^ kOtherRays, nullptr, run.stop});
    TruthPicture truth{srgb8_from_linear(shot.color), srgb8_from_linear(again.color), ImageMask(size, size)};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const float range = shot.range.at(x, y);
            if (!std::isfinite(range)) continue;  // the sky is visible from everywhere
            const Vec3f dir = normalize(
                camera.direction_at({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
            const Vec3f p = pose.world_from_camera * (dir * range);
            const float far = length(p);
            // 2 cm and 1 %: tolerance for rounded edges and grazing rays.
            truth.unseen.at(x, y) = room.distance({}, p / far) < far * 0.99f - 0.02f ? 255 : 0;
        }
    return truth;
}

Likeness compare(const ImageRgb8& picture, const TruthPicture& truth) {
    const ImageRgb8& again = truth.again.empty() ? truth.color : truth.again;
    FASTSCENE_CHECK(picture.same_size(truth.color) && picture.same_size(again) && picture.same_size(truth.unseen));
    SquaredError all, seen, unseen;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const double error = error_product(picture.pixels[i], truth.color.pixels[i], again.pixels[i]);
        all.add(error);
        (truth.unseen.pixels[i] ? unseen : seen).add(error);
    }
    return {all.psnr(), ssim_of_noisy_truth(picture, truth.color, again), seen.psnr(), unseen.psnr()};
}

SplatSight splat_sight(const SplatRenderer& splats, const TruthPose& pose, int size) {
    constexpr float kOpaque = 0.98f;
    const SplatPicture seen = splats.picture(truth_camera(size), pose.world_from_camera);
    const auto open = std::count_if(seen.alpha.pixels.begin(), seen.alpha.pixels.end(),
                                    [](float a) { return !(a >= kOpaque); });
    return {srgb8_from_unit(seen.color), static_cast<double>(open) / static_cast<double>(seen.alpha.size())};
}

ImageRgb8 side_by_side(const std::vector<ImageRgb8>& pictures) {
    FASTSCENE_CHECK(pictures.size() >= 2);
    const ImageRgb8 &a = pictures[0], &b = pictures[1];
    const int columns = static_cast<int>(pictures.size()) + 1;
    ImageRgb8 out(a.width * columns, a.height);
    const auto amplified = [](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>(std::min(255, 4 * std::abs(x - y)));
    };
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            for (int i = 0; i + 1 < columns; ++i)
                out.at(i * a.width + x, y) = pictures[static_cast<std::size_t>(i)].at(x, y);
            const Rgb8 p = a.at(x, y), q = b.at(x, y);
            out.at((columns - 1) * a.width + x, y) = {amplified(p.r, q.r), amplified(p.g, q.g), amplified(p.b, q.b)};
        }
    return out;
}

}  // namespace fastscene
