#include "fastscene/views/sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/views/spacing.h"

namespace fastscene {
namespace {

constexpr int kLookWidth =
    256;  // pixels: views are compared at this size, which suppresses noise and small pose errors
constexpr int kDistances = 64;
constexpr int kWitnesses = 8;  // other views compared per ray
constexpr int kTries = 100;    // attempts to find them
constexpr float kSure =
    0.3f;  // share of the median disagreement along a ray: the best distance must be below this to be distinct
constexpr float kAgrees = 45;  // maximum sum of three channel differences, of 255 each
constexpr float kLeastSure = 0.02f;

// A downsampled view.
struct Look {
    const View* view = nullptr;
    Rigid camera_from_world;
    int shrunk = 1;
    Image<Vec3f> color;

    explicit Look(const View& of)
        : view(&of),
          camera_from_world(inverse(of.world_from_camera)),
          shrunk(std::max(1, of.color.width / kLookWidth)) {
        color = Image<Vec3f>(of.color.width / shrunk, of.color.height / shrunk);
        const float share = 1.f / static_cast<float>(shrunk * shrunk);
        for (int y = 0; y < color.height * shrunk; ++y)
            for (int x = 0; x < color.width * shrunk; ++x) {
                const Rgb8 c = of.color.at(x, y);
                color.at(x / shrunk, y / shrunk) += Vec3f{static_cast<float>(c.r), static_cast<float>(c.g),
                                                          static_cast<float>(c.b)} *
                                                    share;
            }
    }
    EquirectSize size() const { return {view->camera.width, view->camera.height}; }
    bool is_sphere() const { return view->model == CameraModel::equirectangular; }
    // In world coordinates, unit length.
    Vec3f direction(Vec2f pixel) const {
        return view->world_from_camera.rotation *
               normalize(is_sphere() ? direction_at(pixel, size()) : view->camera.direction_at(pixel));
    }
    // The color at a world point, if it is in the picture.
    std::optional<Vec3f> seen(Vec3f place) const {
        const Vec3f there = camera_from_world * place;
        const std::optional<Vec2f> pixel = is_sphere() ? std::optional(pixel_of_direction(there, size()))
                                                       : view->camera.project(there);
        if (!pixel) return {};
        const float fx = pixel->x / static_cast<float>(shrunk) - 0.5f,
                    fy = pixel->y / static_cast<float>(shrunk) - 0.5f;
        if (!(fy > -0.5f && fy < static_cast<float>(color.height) - 0.5f)) return {};
        if (!is_sphere() && !(fx > -0.5f && fx < static_cast<float>(color.width) - 0.5f)) return {};
        const int x = static_cast<int>(std::floor(fx)), y = static_cast<int>(std::floor(fy));
        const auto at = [&](int i, int j) {
            return color.at(is_sphere() ? wrap_column(i, color.width) : std::clamp(i, 0, color.width - 1),
                            std::clamp(j, 0, color.height - 1));
        };
        const float u = fx - static_cast<float>(x), v = fy - static_cast<float>(y);
        return lerp(lerp(at(x, y), at(x + 1, y), u), lerp(at(x, y + 1), at(x + 1, y + 1), u), v);
    }
};

struct Ray {
    std::size_t view = 0;
    int x = 0, y = 0;
    float distance = 0;  // 0: unknown
};

// Mean difference between the patch in this view and in another one, if that shows all of it.
std::optional<float> disagreement(const Look& other, const std::array<Vec3f, 5>& places,
                                  const std::array<Vec3f, 5>& colors) {
    float sum = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::optional<Vec3f> c = other.seen(places[i]);
        if (!c) return {};
        const Vec3f off = *c - colors[i];
        sum += std::abs(off.x) + std::abs(off.y) + std::abs(off.z);
    }
    return sum / static_cast<float>(places.size());
}

// The distance at which the other views agree with the ray's own; 0 if none is distinct.
float swept_distance(const std::vector<Look>& looks, const Ray& ray, const std::vector<float>& distances,
                     Random& random) {
    const Look& own = looks[ray.view];
    const Vec3f from = own.view->world_from_camera.translation;
    const float step = 1.5f * static_cast<float>(own.shrunk), px = static_cast<float>(ray.x) + 0.5f,
                py = static_cast<float>(ray.y) + 0.5f;
    const std::array<Vec2f, 5> patch{Vec2f{px, py}, {px - step, py}, {px + step, py}, {px, py - step}, {px, py + step}};
    std::array<Vec3f, 5> ways, colors, places;
    for (std::size_t i = 0; i < patch.size(); ++i) {
        ways[i] = own.direction(patch[i]);
        const std::optional<Vec3f> c = own.seen(from + ways[i]);
        if (!c) return 0;  // at the picture's border
        colors[i] = *c;
    }
    // From another position, and with part of the ray in the picture.
    const auto may_know = [&](const Look& other) {
        if (!(length(other.view->world_from_camera.translation - from) > 0.02f * distances.front())) return false;
        for (std::size_t i = kDistances / 8; i < kDistances; i += kDistances / 8)
            if (other.seen(from + ways[0] * distances[i])) return true;
        return false;
    };
    std::vector<const Look*> witnesses;
    for (int tries = 0; tries < kTries && static_cast<int>(witnesses.size()) < kWitnesses; ++tries) {
        const Look& other = looks[static_cast<std::size_t>(random.index(static_cast<int>(looks.size())))];
        if (may_know(other) && std::find(witnesses.begin(), witnesses.end(), &other) == witnesses.end())
            witnesses.push_back(&other);
    }
    std::vector<float> costs, asked;
    float best = kAgrees, distance = 0;
    for (const float d : distances) {
        for (std::size_t i = 0; i < places.size(); ++i) places[i] = from + ways[i] * d;
        asked.clear();
        for (const Look* other : witnesses)
            if (const auto cost = disagreement(*other, places, colors)) asked.push_back(*cost);
        if (asked.empty()) continue;
        // Robust to occlusion: some of them may see something in front.
        std::sort(asked.begin(), asked.end());
        asked.resize((3 * asked.size() + 3) / 4);
        float mean = 0;
        for (const float a : asked) mean += a / static_cast<float>(asked.size());
        costs.push_back(mean);
        if (mean < best) best = mean, distance = d;
    }
    if (costs.size() < kDistances / 4) return 0;
    const auto middle = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2);
    std::nth_element(costs.begin(), middle, costs.end());
    return best < kSure * *middle ? distance : 0;
}

float difference(Rgb8 a, Rgb8 b) {
    return static_cast<float>(std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b));
}

// Rays without a distance copy that of the nearest similar-colored ray in their view. If there is none, as for the
// black behind an object on a table, they stay empty.
void take_from_neighbours(std::vector<Ray>& rays, std::size_t begin, std::size_t end, const Look& look) {
    const View& view = *look.view;
    std::vector<Ray> sure;
    for (std::size_t i = begin; i < end; ++i)
        if (rays[i].distance > 0) sure.push_back(rays[i]);
    parallel_for(static_cast<std::int64_t>(end - begin), 64, [&](std::int64_t first, std::int64_t last) {
        for (std::int64_t i = first; i < last; ++i) {
            Ray& ray = rays[begin + static_cast<std::size_t>(i)];
            if (ray.distance > 0) continue;
            std::int64_t least = INT64_MAX;
            for (const Ray& s : sure) {
                std::int64_t dx = std::abs(s.x - ray.x);
                if (look.is_sphere()) dx = std::min(dx, static_cast<std::int64_t>(view.camera.width) - dx);
                const std::int64_t dy = s.y - ray.y, far = dx * dx + dy * dy;
                if (far < least && difference(view.color.at(s.x, s.y), view.color.at(ray.x, ray.y)) < kAgrees)
                    least = far, ray.distance = s.distance;
            }
        }
    });
}

}  // namespace

std::vector<SurfacePoint> swept_points(const ViewSet& set, int count, float nearest_m, float farthest_m,
                                       const Run& run) {
    std::vector<Look> looks;
    for (const View& view : set.views) looks.emplace_back(view);
    std::vector<float> distances;
    for (int i = 0; i < kDistances; ++i)
        distances.push_back(nearest_m * std::pow(farthest_m / nearest_m, static_cast<float>(i) / (kDistances - 1)));
    std::vector<Ray> rays(static_cast<std::size_t>(count));
    Progress progress(run, "points", count);
    parallel_for(count, 256, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        for (std::int64_t i = begin; i < end; ++i) {
            Random random(run.seed, "views/sweep", static_cast<std::uint64_t>(i));
            Ray& ray = rays[static_cast<std::size_t>(i)];
            // Grouped by view.
            ray.view = static_cast<std::size_t>(i) * looks.size() / static_cast<std::size_t>(count);
            const View& view = *looks[ray.view].view;
            for (int tries = 0; tries < 16; ++tries) {
                ray.x = random.index(view.color.width), ray.y = random.index(view.color.height);
                if (view.weight.empty() || view.weight.at(ray.x, ray.y) > 0) break;
            }
            ray.distance = swept_distance(looks, ray, distances, random);
        }
        progress.advance(end - begin);
    });
    const auto sure = std::count_if(rays.begin(), rays.end(), [](const Ray& ray) { return ray.distance > 0; });
    if (static_cast<float>(sure) < kLeastSure * static_cast<float>(count)) return {};
    for (std::size_t begin = 0; begin < rays.size();) {
        std::size_t end = begin;
        while (end < rays.size() && rays[end].view == rays[begin].view) ++end;
        take_from_neighbours(rays, begin, end, looks[rays[begin].view]);
        begin = end;
    }
    std::vector<SurfacePoint> points;
    std::vector<Vec3f> places;
    for (const Ray& ray : rays) {
        if (!(ray.distance > 0)) continue;
        const Look& look = looks[ray.view];
        const Vec3f way = look.direction({static_cast<float>(ray.x) + 0.5f, static_cast<float>(ray.y) + 0.5f});
        places.push_back(look.view->world_from_camera.translation + way * ray.distance);
        points.push_back({places.back(), {}, look.view->color.at(ray.x, ray.y), 0});
    }
    const std::vector<float> sizes = spacings(places);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].radius_m = std::max(sizes[i], 1e-4f);
    return points;
}

}  // namespace fastscene
