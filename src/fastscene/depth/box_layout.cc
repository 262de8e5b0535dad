#include "fastscene/depth/box_layout.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/base/parallel.h"
#include "fastscene/depth/room_lines.h"

namespace fastscene {
namespace {

constexpr int kDistances = 40;
constexpr float kNearest = 0.5f, kFarthest = 14.f;  // distance of a wall in metres: rooms from a closet to a hall
float distance_of(int i) { return kNearest * std::pow(kFarthest / kNearest, static_cast<float>(i) / (kDistances - 1)); }
constexpr int kSlices = 80;  // of the 180 degrees in front of a wall
float azimuth_of(int slice) { return (static_cast<float>(slice) / kSlices - 0.5f) * kPi; }
int slice_of(float azimuth) { return std::clamp(static_cast<int>((azimuth / kPi + 0.5f) * kSlices), 0, kSlices); }

// For one wall direction and one floor or ceiling height: prefix sums of line strength over azimuth, per distance, so
// that the strength between two corners is a subtraction.
struct EdgeSums {
    std::array<std::array<float, kSlices + 1>, kDistances> sum{};
    float between(int distance, float from, float to) const {
        const auto& s = sum[static_cast<std::size_t>(distance)];
        return s[static_cast<std::size_t>(slice_of(to))] - s[static_cast<std::size_t>(slice_of(from))];
    }
};

EdgeSums level_sums(const ImageF& lines, float yaw, float height_m, float sign) {
    EdgeSums sums;
    for (int i = 0; i < kDistances; ++i) {
        float total = 0;
        for (int s = 0; s < kSlices; ++s) {
            sums.sum[static_cast<std::size_t>(i)][static_cast<std::size_t>(s)] = total;
            const float azimuth = azimuth_of(s) + 0.5f * kPi / kSlices;
            const float lat = sign * std::atan(height_m * std::cos(azimuth) / distance_of(i));
            total += strength_at(lines, yaw + azimuth, lat, true);
        }
        sums.sum[static_cast<std::size_t>(i)][kSlices] = total;
    }
    return sums;
}

using Walls = std::array<int, 4>;  // distance index of each wall

class BoxScore {
  public:
    BoxScore(const RoomLines& lines, float yaw, float floor_m, float ceiling_m)
        : lines_(lines), yaw_(yaw), floor_m_(floor_m), ceiling_m_(ceiling_m) {
        for (std::size_t i = 0; i < 4; ++i) {
            const float facing = yaw + static_cast<float>(i) * kPi / 2;
            floor_[i] = level_sums(lines.level, facing, floor_m, -1);
            ceiling_[i] = level_sums(lines.level, facing, ceiling_m, 1);
        }
    }
    // Mean strength per slice over 360 degrees.
    float operator()(const Walls& walls) const {
        float level = 0, upright = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto d = [&](std::size_t w) { return distance_of(walls[w % 4]); };
            const float left = -std::atan(d(i + 3) / d(i)), right = std::atan(d(i + 1) / d(i));
            // The floor edge counts less: furniture hides it, while the ceiling edge is mostly visible.
            level += 0.6f * floor_[i].between(walls[i], left, right) +
                     1.4f * ceiling_[i].between(walls[i], left, right);
            upright += corner(yaw_ + static_cast<float>(i) * kPi / 2 + right, std::hypot(d(i), d(i + 1)));
        }
        return (level / (2 * kSlices) + 0.5f * upright / 4) / 2.5f;
    }

  private:
    float corner(float lon, float distance) const {
        const float bottom = -std::atan(floor_m_ / distance), top = std::atan(ceiling_m_ / distance);
        constexpr int kSteps = 12;
        float sum = 0;
        for (int i = 0; i < kSteps; ++i)
            sum += strength_at(lines_.upright, lon, bottom + (top - bottom) * (static_cast<float>(i) + 0.5f) / kSteps,
                               false);
        return sum / kSteps;
    }
    const RoomLines& lines_;
    float yaw_, floor_m_, ceiling_m_;
    std::array<EdgeSums, 4> floor_, ceiling_;
};

struct Fit {
    float score = -1, yaw = 0, ceiling_m = 0;
    Walls walls{};
};

Fit best_walls(const RoomLines& lines, float yaw, float floor_m, float ceiling_m) {
    const BoxScore score(lines, yaw, floor_m, ceiling_m);
    Fit best;
    // Coordinate ascent from a small, a medium and a large room, to avoid local maxima.
    for (const int start : {12, 18, 25}) {
        Walls walls{start, start, start, start};
        float value = score(walls);
        for (bool moved = true; moved;) {
            moved = false;
            for (std::size_t i = 0; i < 4; ++i)
                for (int d = 0; d < kDistances; ++d) {
                    Walls tried = walls;
                    tried[i] = d;
                    const float v = score(tried);
                    if (v > value + 1e-6f) value = v, walls = tried, moved = true;
                }
        }
        if (value > best.score) best = {value, yaw, ceiling_m, walls};
    }
    return best;
}

}  // namespace

BoxLayout fit_box(const ImageColor& panorama, float camera_height_m) {
    FASTSCENE_CHECK(camera_height_m > 0.f);
    const RoomLines lines = find_lines(panorama);
    constexpr int kYaws = 30;  // every 3 degrees
    constexpr float kCeilings[] = {0.35f, 0.5f, 0.62f, 0.75f,
                                   0.9f,  1.1f, 1.4f,  1.9f};  // above the camera, in camera heights
    constexpr int kHeights = static_cast<int>(std::size(kCeilings));
    std::vector<Fit> fits(kYaws * kHeights);
    parallel_for(static_cast<std::int64_t>(fits.size()), 4, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const float yaw = static_cast<float>(i / kHeights) * (kPi / 2) / kYaws;
            fits[static_cast<std::size_t>(i)] = best_walls(lines, yaw, camera_height_m,
                                                           kCeilings[i % kHeights] * camera_height_m);
        }
    });
    const Fit best = *std::max_element(fits.begin(), fits.end(),
                                       [](const Fit& a, const Fit& b) { return a.score < b.score; });
    BoxLayout box{best.yaw, {}, camera_height_m, best.ceiling_m, best.score};
    for (std::size_t i = 0; i < 4; ++i) box.wall_m[i] = distance_of(best.walls[i]);
    return box;
}

ImageF range_of_box(const BoxLayout& box, EquirectSize size) {
    ImageF range(size.width, size.height);
    const float c = std::cos(box.yaw), s = std::sin(box.yaw);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Vec3f d = direction_of_pixel(x, y, size);
            const float ahead = d.z * c + d.x * s, right = d.x * c - d.z * s;
            float inverse = d.y > 0 ? d.y / box.floor_m : -d.y / box.ceiling_m;
            inverse = std::max(inverse, ahead > 0 ? ahead / box.wall_m[0] : -ahead / box.wall_m[2]);
            inverse = std::max(inverse, right > 0 ? right / box.wall_m[1] : -right / box.wall_m[3]);
            range.at(x, y) = 1.f / inverse;
        }
    return range;
}

}  // namespace fastscene
