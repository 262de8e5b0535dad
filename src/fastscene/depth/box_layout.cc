#include "fastscene/depth/box_layout.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/base/parallel.h"
#include "fastscene/geometry/reproject.h"
#include "fastscene/image/color.h"

namespace fastscene {
namespace {

constexpr EquirectSize kLook{512, 256};  // lines of a room are found at this size; finer is furniture

// How strongly the picture changes across a line that runs level (down) or upright (across), 0..1.
struct Lines {
    ImageF level, upright;
};

// A change counts against the strongest tenth of its picture: a dim room has edges too. The root makes the
// faint line between two white walls count nearly as much as the frame of a window.
void normalize(ImageF& lines) {
    std::vector<float> sorted = lines.pixels;
    const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 9 / 10);
    std::nth_element(sorted.begin(), at, sorted.end());
    const float strong = std::max(*at, 1e-4f);
    for (float& v : lines.pixels) v = std::sqrt(std::min(1.f, v / strong));
}

Lines find_lines(const ImageColor& panorama) {
    const ImageColor small = equirect_from_equirect(panorama, kLook);
    Image<Vec3f> seen(kLook.width, kLook.height);  // as the eye has it
    for (std::size_t i = 0; i < small.size(); ++i)
        seen.pixels[i] = {srgb_from_linear(small.pixels[i].x), srgb_from_linear(small.pixels[i].y), srgb_from_linear(small.pixels[i].z)};
    Lines lines{ImageF(kLook.width, kLook.height), ImageF(kLook.width, kLook.height)};
    const auto change = [](Vec3f a, Vec3f b) { return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z); };
    for (int y = 2; y < kLook.height - 2; ++y)
        for (int x = 0; x < kLook.width; ++x) {
            const auto at = [&](int dx, int dy) { return seen.at(wrap_column(x + dx, kLook.width), y + dy); };
            // A long line agrees with itself beside: three places, one change.
            const auto mean3 = [&](int dx, int dy, bool along_x) {
                return (along_x ? at(dx - 2, dy) + at(dx, dy) + at(dx + 2, dy) : at(dx, dy - 2) + at(dx, dy) + at(dx, dy + 2)) * (1.f / 3.f);
            };
            lines.level.at(x, y) = change(mean3(0, -1, true), mean3(0, 1, true));
            lines.upright.at(x, y) = change(mean3(-1, 0, false), mean3(1, 0, false));
        }
    normalize(lines.level);
    normalize(lines.upright);
    return lines;
}

// Strength at (lon, lat): the best of the row and its neighbours, for a box is never exact.
float strength_at(const ImageF& lines, float lon, float lat, bool level) {
    const int x = static_cast<int>(std::floor((lon / (2 * kPi) + 0.5f) * static_cast<float>(kLook.width)));
    const int y = std::clamp(static_cast<int>((0.5f - lat / kPi) * static_cast<float>(kLook.height)), 1, kLook.height - 2);
    float best = 0;
    for (int d = -1; d <= 1; ++d)
        best = std::max(best, level ? lines.at(wrap_column(x, kLook.width), y + d) : lines.at(wrap_column(x + d, kLook.width), y));
    return best;
}

constexpr int kDistances = 40;
constexpr float kNearest = 0.5f, kFarthest = 14.f;  // of a wall: rooms between a closet and a hall
float distance_of(int i) { return kNearest * std::pow(kFarthest / kNearest, static_cast<float>(i) / (kDistances - 1)); }
constexpr int kSlices = 80;  // of the half circle in front of a wall
float azimuth_of(int slice) { return (static_cast<float>(slice) / kSlices - 0.5f) * kPi; }
int slice_of(float azimuth) { return std::clamp(static_cast<int>((azimuth / kPi + 0.5f) * kSlices), 0, kSlices); }

// For one wall's direction and one height of floor or ceiling: sums of the line's strength over azimuth, per distance,
// so that the strength between any two corners is one subtraction.
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

using Walls = std::array<int, 4>;  // index of each wall's distance

class BoxScore {
  public:
    BoxScore(const Lines& lines, float yaw, float floor_m, float ceiling_m) : lines_(lines), yaw_(yaw), floor_m_(floor_m), ceiling_m_(ceiling_m) {
        for (std::size_t i = 0; i < 4; ++i) {
            const float facing = yaw + static_cast<float>(i) * kPi / 2;
            floor_[i] = level_sums(lines.level, facing, floor_m, -1);
            ceiling_[i] = level_sums(lines.level, facing, ceiling_m, 1);
        }
    }
    // Strength per slice of the whole turn.
    float operator()(const Walls& walls) const {
        float level = 0, upright = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto d = [&](std::size_t w) { return distance_of(walls[w % 4]); };
            const float left = -std::atan(d(i + 3) / d(i)), right = std::atan(d(i + 1) / d(i));
            // Furniture stands on the floor and hides its edge; the ceiling's is mostly free.
            level += 0.6f * floor_[i].between(walls[i], left, right) + 1.4f * ceiling_[i].between(walls[i], left, right);
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
            sum += strength_at(lines_.upright, lon, bottom + (top - bottom) * (static_cast<float>(i) + 0.5f) / kSteps, false);
        return sum / kSteps;
    }
    const Lines& lines_;
    float yaw_, floor_m_, ceiling_m_;
    std::array<EdgeSums, 4> floor_, ceiling_;
};

struct Fit {
    float score = -1, yaw = 0, ceiling_m = 0;
    Walls walls{};
};

Fit best_walls(const Lines& lines, float yaw, float floor_m, float ceiling_m) {
    const BoxScore score(lines, yaw, floor_m, ceiling_m);
    Fit best;
    // From a small, a middling and a large room: the walls are moved one at a time, and may stick.
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
    const Lines lines = find_lines(panorama);
    constexpr int kYaws = 30;                                             // every 3 degrees
    constexpr float kCeilings[] = {0.35f, 0.5f, 0.62f, 0.75f, 0.9f, 1.1f, 1.4f, 1.9f};  // above the camera, in camera heights
    constexpr int kHeights = static_cast<int>(std::size(kCeilings));
    std::vector<Fit> fits(kYaws * kHeights);
    parallel_for(static_cast<std::int64_t>(fits.size()), 4, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const float yaw = static_cast<float>(i / kHeights) * (kPi / 2) / kYaws;
            fits[static_cast<std::size_t>(i)] = best_walls(lines, yaw, camera_height_m, kCeilings[i % kHeights] * camera_height_m);
        }
    });
    const Fit best = *std::max_element(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.score < b.score; });
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
