#include "fastscene/walk/room_viewpoints.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"

namespace fastscene {
namespace {

// Visitors' eye heights, metres above the floor: from a child to a tall adult, and a share who crouch.
constexpr float kEyeLow_m = 1.2f, kEyeHigh_m = 1.8f, kCrouch_m = 0.7f, kCrouchShare = 0.15f;
// Camera heights for panoramas.
constexpr std::array<float, 4> kHeights_m{0.65f, 1.15f, 1.5f, 1.85f};
constexpr float kEyeAir_m = 0.15f;  // minimum clearance of a viewpoint from any surface
constexpr float kLean_m = 0.6f;     // how far a viewpoint may lean in over a counter or bed
constexpr int kMostCandidates = 420;
constexpr int kVisitors = 640, kRaysAVisitor = 20;
constexpr float kCloseUp_m = 0.6f;    // distances below this do not demand a finer resolution
constexpr float kSecondView = 0.35f;  // value of a second view of a surface, relative to the first
constexpr float kImage_m = 0.03f;     // minimum distance of a mirror image behind its mirror, and its tolerance
constexpr int kMostMore = 4;          // new viewpoints after edits
constexpr float kLeastGainOfMore = 0.01f;
constexpr float kSlant = 0.08f;  // cosine: surfaces seen at a more grazing angle give no texture

// A sample of what visitors see.
struct Sample {
    enum class Kind : unsigned char {
        surface,
        image,    // behind a flat mirror: must be seen through the mirror
        outside,  // a direction to the outside
    } kind;
    Vec3f position;    // of a surface or mirror image; for outside: a unit direction
    Vec3f normal;      // surfaces only
    float demand = 0;  // the visitor's pixel density on the surface: cosine over squared distance
};

Vec3f uniform_direction(Random& random) {
    const float y = random.uniform(-1, 1), r = std::sqrt(std::max(0.f, 1 - y * y)), a = random.uniform(-kPi, kPi);
    return {r * std::cos(a), y, r * std::sin(a)};
}

std::vector<Sample> seen_by_visitors(const TracedRoom& room, const StandableFloor& floor, const Run& run) {
    const std::vector<FloorCell> cells = standable_cells(floor);
    std::vector<std::vector<Sample>> by_visitor(kVisitors);
    parallel_for(kVisitors, 16, [&](std::int64_t begin, std::int64_t end) {
        for (auto v = static_cast<std::size_t>(begin); v < static_cast<std::size_t>(end); ++v) {
            Random random(run.seed, "walk.visitors", v);
            const FloorCell cell = cells[static_cast<std::size_t>(random.index(static_cast<int>(cells.size())))];
            const Vec2f at = floor.center(cell.column, cell.row);
            const float height = random.chance(kCrouchShare) ? random.uniform(kCrouch_m, kEyeLow_m)
                                                             : random.uniform(kEyeLow_m, kEyeHigh_m);
            const Vec3f viewpoint{at.x, floor.level_at(cell.column, cell.row) - height, at.y};
            if (!has_air(room, viewpoint, kEyeAir_m)) continue;
            for (int k = 0; k < kRaysAVisitor; ++k) {
                const Vec3f d = uniform_direction(random);
                const TracedRoom::Surface met = room.surface(viewpoint, d);
                if (!std::isfinite(met.distance)) {
                    by_visitor[v].push_back({Sample::Kind::outside, d, {}, 1.f});
                    continue;
                }
                if (const float image = room.distance_through_mirrors(viewpoint, d); image > met.distance + kImage_m) {
                    if (std::isfinite(image))
                        by_visitor[v].push_back({Sample::Kind::image, viewpoint + d * image, {}, 1 / (image * image)});
                    continue;
                }
                const float far = std::max(kCloseUp_m, met.distance), cosine = std::max(kSlant, -dot(met.normal, d));
                by_visitor[v].push_back(
                    {Sample::Kind::surface, viewpoint + d * met.distance, met.normal, cosine / (far * far)});
            }
        }
    });
    std::vector<Sample> samples;
    for (const auto& some : by_visitor) samples.insert(samples.end(), some.begin(), some.end());
    return samples;
}

// Candidate viewpoints: over the standable floor, and over objects that one can lean in over.
std::vector<Vec3f> candidates(const TracedRoom& room, const StandableFloor& floor) {
    const double area = standable_area_m2(floor) + 1;
    // Spacing by the number that is affordable; at least 0.3 m.
    const float apart = std::max(0.3f, static_cast<float>(std::sqrt(1.6 * area * kHeights_m.size() / kMostCandidates)));
    const int stride = std::max(1, static_cast<int>(apart / floor.cell_m));
    const int lean = static_cast<int>(kLean_m / floor.cell_m);
    std::vector<Vec3f> found;
    for (int row = stride / 2; row < floor.rows; row += stride)
        for (int column = stride / 2; column < floor.columns; column += stride) {
            // The nearest standable cell; leaning viewpoints must be at the height of a standing person.
            int nearest = floor.at(column, row) ? 0 : lean + 1;
            FloorCell foot{column, row};
            for (int dz = -lean; dz <= lean && nearest > 0; ++dz)
                for (int dx = -lean; dx <= lean; ++dx)
                    if (const int far = static_cast<int>(std::ceil(std::hypot(dx, dz)));
                        far < nearest && floor.at(column + dx, row + dz))
                        nearest = far, foot = {column + dx, row + dz};
            if (nearest > lean) continue;
            const Vec2f at = floor.center(column, row), from = floor.center(foot.column, foot.row);
            for (const float height : kHeights_m) {
                const Vec3f viewpoint{at.x, floor.level_at(foot.column, foot.row) - height, at.y};
                if (nearest > 0 && (height < kEyeLow_m || !room.sees({from.x, viewpoint.y, from.y}, viewpoint)))
                    continue;
                if (has_air(room, viewpoint, kEyeAir_m)) found.push_back(viewpoint);
            }
        }
    return found;
}

// How well a viewpoint sees a sample: 1 = at the visitor's resolution, 0 = not at all.
float sight(const TracedRoom& room, Vec3f viewpoint, const Sample& sample) {
    if (sample.kind == Sample::Kind::outside)
        return std::isfinite(room.surface(viewpoint, sample.position).distance) ? 0.f : 1.f;
    const Vec3f way = sample.position - viewpoint;
    const float far = length(way);
    if (sample.kind == Sample::Kind::image) {
        const float shown = room.distance_through_mirrors(viewpoint, way / far);
        return std::fabs(shown - far) < kImage_m ? std::min(1.f, 1 / (far * std::sqrt(sample.demand))) : 0.f;
    }
    const float cosine = -dot(sample.normal, way) / std::max(1e-6f, far);
    if (!(cosine > kSlant) || far < 1e-3f) return 0;
    if (!room.sees(viewpoint, sample.position)) return 0;
    return std::min(1.f, std::sqrt(cosine / (far * far) / sample.demand));
}

// How well the viewpoints chosen so far see every sample.
struct Coverage {
    std::vector<float> best, second;
    std::vector<int> views;

    explicit Coverage(std::size_t n) : best(n), second(n), views(n) {}
    // The gain of another view of sample i with quality s.
    double gain(std::size_t i, float s) const {
        if (s <= second[i]) return 0;
        if (s <= best[i]) return kSecondView * static_cast<double>(s - second[i]);
        return static_cast<double>(s - best[i]) + kSecondView * static_cast<double>(best[i] - second[i]);
    }
    void add(std::size_t i, float s) {
        if (s > 0) ++views[i];
        if (s > best[i]) second[i] = best[i], best[i] = s;
        else if (s > second[i]) second[i] = s;
    }
};

}  // namespace

RoomViewpoints choose_room_viewpoints(const TracedRoom& room, const StandableFloor& floor,
                                      const RoomViewpointParams& params, const Run& run) {
    RoomViewpoints chosen;
    if (standable_cells(floor).empty()) return chosen;
    const std::vector<Sample> samples = seen_by_visitors(room, floor, run);
    std::vector<Vec3f> viewpoints;
    std::vector<int> earlier;
    for (std::size_t i = 0; i < params.earlier_m.size(); ++i)
        if (has_air(room, params.earlier_m[i], kEyeAir_m))
            viewpoints.push_back(params.earlier_m[i]), earlier.push_back(static_cast<int>(i));
    const std::vector<Vec3f> further = candidates(room, floor);
    viewpoints.insert(viewpoints.end(), further.begin(), further.end());
    earlier.resize(viewpoints.size(), -1);
    const std::size_t n = samples.size();
    chosen.samples = n;
    if (n == 0) return chosen;
    // One row per candidate: how well it sees each sample; panorama 0 last.
    std::vector<float> sights((viewpoints.size() + 1) * n);
    parallel_for(static_cast<std::int64_t>(viewpoints.size() + 1), 4, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c)
            for (std::size_t i = 0; i < n; ++i)
                sights[c * n + i] = sight(room, c < viewpoints.size() ? viewpoints[c] : Vec3f{}, samples[i]);
    });
    Coverage coverage(n);
    const auto take = [&](std::size_t c) {
        for (std::size_t i = 0; i < n; ++i) coverage.add(i, sights[c * n + i]);
    };
    take(viewpoints.size());
    const auto choose = [&](std::size_t c) {
        take(c);
        chosen.positions_m.push_back(viewpoints[c]);
        chosen.earlier.push_back(earlier[c]);
    };
    for (std::size_t c = 0; c < viewpoints.size() && earlier[c] >= 0; ++c) choose(c);
    // What an edit uncovers may need a few more; each costs as much as several earlier ones do.
    const bool again = !chosen.positions_m.empty();
    const int most = params.most + (again ? kMostMore : 0);
    const float least_gain = again ? kLeastGainOfMore : params.least_gain;
    const double all = static_cast<double>(n) * (1 + static_cast<double>(kSecondView));
    std::vector<double> gains(viewpoints.size());
    while (static_cast<int>(chosen.positions_m.size()) < most && !viewpoints.empty()) {
        parallel_for(static_cast<std::int64_t>(viewpoints.size()), 4, [&](std::int64_t begin, std::int64_t end) {
            for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c) {
                gains[c] = 0;
                for (std::size_t i = 0; i < n; ++i) gains[c] += coverage.gain(i, sights[c * n + i]);
            }
        });
        const auto next = static_cast<std::size_t>(std::max_element(gains.begin(), gains.end()) - gains.begin());
        if (gains[next] < static_cast<double>(least_gain) * all) break;
        choose(next);
    }
    std::size_t unseen = 0, coarse = 0, one_sided = 0;
    constexpr float kHalf = 0.5f;
    for (std::size_t i = 0; i < n; ++i) {
        unseen += coverage.views[i] == 0;
        coarse += coverage.views[i] > 0 && coverage.best[i] < kHalf;
        one_sided += coverage.views[i] == 1;
    }
    const auto share = [n](std::size_t k) { return static_cast<double>(k) / static_cast<double>(n); };
    chosen.unseen_share = share(unseen), chosen.coarse_share = share(coarse), chosen.one_sided_share = share(one_sided);
    return chosen;
}

}  // namespace fastscene
