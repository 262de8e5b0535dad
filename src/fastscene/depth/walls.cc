#include "fastscene/depth/walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fastscene/geometry/sphere.h"

namespace fastscene {
namespace {

constexpr float kLeastShare = 0.03f;  // share of the sphere: less may be a cupboard or a part of something round
constexpr std::size_t kMostWalls = 8;
constexpr float kThickness = 0.05f;    // of the distance: the typical error of a network's walls
constexpr float kUpright = 0.35f;      // maximum vertical component of a wall's normal; sofas are more slanted
constexpr float kNormalCosine = 0.9f;  // between a pixel's normal and its plane's: 25 degrees
constexpr float kFlatCosine = 0.978f;  // between the mean normals of a wall's halves: 12 degrees

constexpr int kYaws = 72, kDistances = 96;  // Hough bins: 5 degrees, 4 %
constexpr float kNearest_m = 0.3f, kStep = 0.04f;
float yaw_of_bin(int i) { return (static_cast<float>(i) + 0.5f) * 2 * kPi / kYaws; }
int bin_of_distance(float m) {
    return std::clamp(static_cast<int>(std::log(m / kNearest_m) / kStep), 0, kDistances - 1);
}

// A pixel that may be on a wall, projected to the floor plan.
struct Spot {
    Vec2f at, normal;  // (x, z) in metres; horizontal part of the surface normal, facing away from the camera
    float weight;      // solid angle; 0: already assigned to a plane
};

Vec2f ahead(float yaw) { return {std::sin(yaw), std::cos(yaw)}; }

// Pixels that are neither floor nor ceiling and have a horizontal normal.
std::vector<Spot> upright_spots(const ImageF& range, float floor_m, float ceiling_m) {
    const EquirectSize size{range.width, range.height};
    const int step = std::max(1, range.width / 256);
    const auto point = [&](int x, int y) {
        return direction_of_pixel(wrap_column(x, size.width), y, size) * range.at(wrap_column(x, size.width), y);
    };
    std::vector<Spot> spots;
    for (int y = step; y + step < size.height; y += step)
        for (int x = 0; x < size.width; x += step) {
            const Vec3f p = point(x, y);
            if (!std::isfinite(range.at(x, y)) || p.y > 0.92f * floor_m || (ceiling_m > 0 && p.y < -0.92f * ceiling_m))
                continue;
            Vec3f n = normalize(
                cross(point(x + step, y) - point(x - step, y), point(x, y + step) - point(x, y - step)));
            if (dot(n, p) < 0) n = -n;
            if (!(std::abs(n.y) < kUpright)) continue;  // true for NaN: beside the sky
            spots.push_back({{p.x, p.z}, {n.x, n.z}, static_cast<float>(pixel_solid_angle(y, size) * step * step)});
        }
    return spots;
}

// The plane with the most Hough votes; share: of the smoothed votes.
Wall most_voted(const std::vector<Spot>& spots) {
    constexpr int kReach = 3;  // yaw bins to each side, for the tolerance of coarse normals
    std::vector<float> votes(static_cast<std::size_t>(kYaws) * kDistances);
    const auto vote = [&](int yaw, int distance) -> float& {
        return votes[static_cast<std::size_t>((yaw + kYaws) % kYaws * kDistances + distance)];
    };
    for (const Spot& s : spots) {
        const int middle = static_cast<int>(std::floor(std::atan2(s.normal.x, s.normal.y) / (2 * kPi) * kYaws));
        for (int d = -kReach; d <= kReach; ++d) {
            const float distance = dot(s.at, ahead(yaw_of_bin(middle + d)));
            if (distance > kNearest_m)
                vote(middle + d + kYaws, bin_of_distance(distance)) += s.weight / static_cast<float>(1 + std::abs(d));
        }
    }
    Wall best;
    for (int yaw = 0; yaw < kYaws; ++yaw)
        for (int i = 1; i + 1 < kDistances; ++i) {
            const float sum = vote(yaw, i - 1) + vote(yaw, i) + vote(yaw, i + 1);
            if (sum > best.share)
                best = {yaw_of_bin(yaw), kNearest_m * std::exp((static_cast<float>(i) + 0.5f) * kStep), sum, 0};
        }
    return best;
}

bool is_on(const Spot& s, const Wall& wall, float thickness) {
    return std::abs(dot(s.at, ahead(wall.yaw)) - wall.distance_m) < thickness * wall.distance_m;
}

// Line fit in the floor plan through the spots near the wall and facing it; distant ones weigh less.
Wall refined(const std::vector<Spot>& spots, Wall wall) {
    for (int i = 0; i < 12; ++i) {
        const Vec2f n = ahead(wall.yaw);
        double sum = 0, mx = 0, mz = 0, xx = 0, xz = 0, zz = 0;
        for (const Spot& s : spots) {
            if (dot(s.normal, n) < kNormalCosine) continue;
            const double off = (dot(s.at, n) - wall.distance_m) / (kThickness * wall.distance_m),
                         q = 1 / (1 + off * off), w = s.weight * q * q;
            sum += w, mx += w * s.at.x, mz += w * s.at.y, xx += w * s.at.x * s.at.x, xz += w * s.at.x * s.at.y,
                zz += w * s.at.y * s.at.y;
        }
        if (!(sum > 0)) return {};
        mx /= sum, mz /= sum;
        const double a = xx / sum - mx * mx, b = xz / sum - mx * mz, c = zz / sum - mz * mz;
        // The direction of minimum variance.
        const double along = 0.5 * std::atan2(2 * b, a - c);  // from x towards z
        double nx = -std::sin(along), nz = std::cos(along);
        if (nx * mx + nz * mz < 0) nx = -nx, nz = -nz;
        wall.yaw = static_cast<float>(std::atan2(nx, nz));
        wall.distance_m = static_cast<float>(nx * mx + nz * mz);
        if (!(wall.distance_m > kNearest_m)) return {};
    }
    return wall;
}

// Whether the normals at the left and right end of the plane agree; a part of a round object fits a plane, too.
bool is_flat(const std::vector<Spot>& spots, const Wall& wall) {
    const Vec2f n = ahead(wall.yaw), right{n.y, -n.x};
    float weight = 0, middle = 0;
    for (const Spot& s : spots)
        if (is_on(s, wall, kThickness)) weight += s.weight, middle += s.weight * dot(s.at, right);
    if (!(weight > 0)) return false;
    middle /= weight;
    std::array<Vec2f, 2> ends;
    for (const Spot& s : spots)
        if (is_on(s, wall, kThickness) && dot(s.normal, n) > 0.5f) {
            Vec2f& end = ends[dot(s.at, right) < middle ? 0 : 1];
            end = end + s.normal * s.weight;
        }
    return dot(ends[0], ends[1]) > kFlatCosine * length(ends[0]) * length(ends[1]);
}

// Strength of the picture's lines where a wall at `distance` would meet floor and ceiling, over the longitudes at which
// it is visible.
float line_strength(const RoomLines& lines, float yaw, const std::vector<float>& azimuths, float distance,
                    float floor_m, float ceiling_m) {
    float sum = 0;
    for (const float azimuth : azimuths) {
        const float reach = std::cos(azimuth) / distance;
        sum += strength_at(lines.level, yaw + azimuth, -std::atan(floor_m * reach), true);
        if (ceiling_m > 0) sum += strength_at(lines.level, yaw + azimuth, std::atan(ceiling_m * reach), true);
    }
    return sum / static_cast<float>(azimuths.size() * (ceiling_m > 0 ? 2 : 1));
}

// Azimuths relative to the wall's yaw, every 1.5 degrees, at which it is visible.
std::vector<float> azimuths_of(const ImageF& range, const Wall& wall) {
    const EquirectSize size{range.width, range.height};
    std::vector<float> out;
    constexpr float kEvery = 1.5f * kPi / 180;
    for (float azimuth = -1.3f; azimuth < 1.3f; azimuth += kEvery) {
        const int x = wrap_column(
            static_cast<int>(std::floor(((wall.yaw + azimuth) / (2 * kPi) + 0.5f) * static_cast<float>(size.width))),
            size.width);
        int on = 0;
        for (int y = size.height / 4; y < size.height * 3 / 4; ++y) {
            const Vec3f p = direction_of_pixel(x, y, size) * range.at(x, y);
            on += is_on({{p.x, p.z}, {}, 0}, wall, kThickness);
        }
        if (on * 8 >= size.height) out.push_back(azimuth);  // in a quarter of the rows examined
    }
    return out;
}

}  // namespace

std::vector<Wall> upright_planes(const ImageF& range, float floor_m, float ceiling_m) {
    std::vector<Spot> spots = upright_spots(range, floor_m, ceiling_m);
    std::vector<Wall> walls;
    constexpr float kSphere = 4 * kPi;
    while (walls.size() < kMostWalls) {
        Wall wall = most_voted(spots);
        if (!(wall.share > kLeastShare * kSphere / 2)) break;  // only spots with consistent normals vote
        wall = refined(spots, wall);
        float on = 0;
        for (const Spot& s : spots) on += is_on(s, wall, kThickness) ? s.weight : 0;
        wall.share = on / kSphere;
        if (wall.share >= kLeastShare && is_flat(spots, wall)) walls.push_back(wall);
        // Removed in any case, along with slightly deviating spots, which would otherwise become the next wall.
        const std::size_t before = spots.size();
        std::erase_if(spots, [&](const Spot& s) {
            return is_on(s, wall, 2 * kThickness) && dot(s.normal, ahead(wall.yaw)) > 0.5f;
        });
        if (spots.size() == before) break;
    }
    std::sort(walls.begin(), walls.end(), [](const Wall& a, const Wall& b) { return a.share > b.share; });
    return walls;
}

std::vector<Wall> walls_with_lines(const ImageF& range, const RoomLines& lines, float floor_m, float ceiling_m) {
    constexpr int kSteps = 15;  // to each side, in distance
    constexpr float kFactor = 0.02f;
    constexpr float kClearer = 0.12f;  // required margin over the line strength at other distances
    std::vector<Wall> out;
    for (Wall wall : upright_planes(range, floor_m, ceiling_m)) {
        const std::vector<float> azimuths = azimuths_of(range, wall);
        if (azimuths.size() < 8) continue;  // 12 degrees: too short for a line
        std::array<float, 2 * kSteps + 1> strengths{};
        for (int i = -kSteps; i <= kSteps; ++i)
            strengths[static_cast<std::size_t>(i + kSteps)] = line_strength(
                lines, wall.yaw, azimuths, wall.distance_m * std::exp(kFactor * static_cast<float>(i)), floor_m,
                ceiling_m);
        auto sorted = strengths;
        std::sort(sorted.begin(), sorted.end());
        const auto best = std::max_element(strengths.begin(), strengths.end());
        if (*best < sorted[kSteps] + kClearer) continue;
        wall.line_m = wall.distance_m * std::exp(kFactor * static_cast<float>(best - strengths.begin() - kSteps));
        out.push_back(wall);
    }
    return out;
}

Json json_of_walls(const ImageF& range, const ImageColor& color, float floor_m, float ceiling_m) {
    Json out = Json::array();
    for (const Wall& wall : walls_with_lines(range, find_lines(color), floor_m, ceiling_m))
        out.push_back({{"yaw_deg", wall.yaw * 57.29578f},
                       {"distance_m", wall.distance_m},
                       {"share", wall.share},
                       {"line_m", wall.line_m}});
    return out;
}

}  // namespace fastscene
