#include "fastscene/views/points.h"

#include <algorithm>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/geometry/range_edges.h"
#include "fastscene/image/color.h"

namespace fastscene {
namespace {

constexpr float kSky_m = 30.f;           // where points of the sky stand
constexpr float kFlattest = 0.15f;       // least cosine: grazing pixels must not eat all points

struct Surface {
    Vec3f point, normal;
};

Vec3f point_at(const Panorama& panorama, int x, int y) {
    const float range = panorama.range.at(x, y);
    return direction_of_pixel(x, y, panorama.size()) * (range < kFarthestRange ? range : kSky_m);
}

// Differences to the neighbours on the same surface; a pixel alone looks at the viewpoint.
Surface surface_at(const Panorama& panorama, const ImageMask& cuts, int x, int y) {
    const int w = cuts.width, h = cuts.height, left = wrap_column(x - 1, w), right = wrap_column(x + 1, w);
    const Vec3f p = point_at(panorama, x, y);
    const Vec3f a = cuts.at(left, y) & kCutRight ? p : point_at(panorama, left, y);
    const Vec3f b = cuts.at(x, y) & kCutRight ? p : point_at(panorama, right, y);
    const Vec3f c = y == 0 || (cuts.at(x, y - 1) & kCutDown) ? p : point_at(panorama, x, y - 1);
    const Vec3f d = y + 1 == h || (cuts.at(x, y) & kCutDown) ? p : point_at(panorama, x, y + 1);
    Vec3f normal = normalize(cross(b - a, d - c));
    if (!(dot(normal, normal) > 0.5f)) normal = -normalize(p);
    return {p, dot(normal, p) > 0 ? -normal : normal};
}

float gradient_at(const ImageColor& color, int x, int y) {
    const auto value = [&](int i, int j) {
        return std::sqrt(std::max(0.f, luminance(color.at(wrap_column(i, color.width), std::clamp(j, 0, color.height - 1)))));
    };
    return std::fabs(value(x + 1, y) - value(x - 1, y)) + std::fabs(value(x, y + 1) - value(x, y - 1));
}

// The pixels that may give points, with their shares.
struct Candidate {
    std::uint32_t panorama, pixel;
    float area, edge;   // square metres; edge strength times solid angle
};

// Panoramas that somebody took or traced; the others are walked, and repeat what these have seen.
bool is_given(const Panorama& panorama) {
    return panorama.known.empty() ||
           std::all_of(panorama.known.pixels.begin(), panorama.known.pixels.end(), [](Known k) { return k == Known::original; });
}

void collect(const std::vector<Panorama>& panoramas, std::uint32_t index, std::vector<Candidate>& out) {
    const Panorama& panorama = panoramas[index];
    const bool given = index == 0 || is_given(panorama);
    const EquirectSize size = panorama.size();
    const ImageMask cuts = range_edges(panorama.range);
    for (int y = 0; y < size.height; ++y) {
        const float angle = static_cast<float>(pixel_solid_angle(y, size));
        for (int x = 0; x < size.width; ++x) {
            const Known known = panorama.known.empty() ? Known::original : panorama.known.at(x, y);
            if (known != (given ? Known::original : Known::invented)) continue;
            if (given && cuts.at(x, y) & kFarSide) continue;   // two surfaces in one color; what was painted has one
            const Surface s = surface_at(panorama, cuts, x, y);
            const float distance = length(s.point), cosine = std::max(kFlattest, -dot(s.normal, s.point) / distance);
            out.push_back({index, static_cast<std::uint32_t>(y * size.width + x), angle * distance * distance / cosine,
                           angle * (0.01f + gradient_at(panorama.color, x, y))});
        }
    }
}

}  // namespace

std::vector<SurfacePoint> sample_points(const std::vector<Panorama>& panoramas, int count, const Run& run) {
    std::vector<Candidate> candidates;
    for (std::uint32_t i = 0; i < panoramas.size(); ++i) collect(panoramas, i, candidates);
    if (candidates.empty()) return {};
    double area = 0, edge = 0;
    for (const Candidate& c : candidates) {
        area += static_cast<double>(c.area);
        edge += static_cast<double>(c.edge);
    }
    // One walk along the sum of shares, with one jittered draw a step: spread more evenly than free draws.
    std::vector<SurfacePoint> points;
    points.reserve(static_cast<std::size_t>(count));
    std::vector<ImageMask> cuts(panoramas.size());
    Random random(run.seed, "views/points");
    double sum = 0, next = static_cast<double>(random.uniform());
    for (const Candidate& c : candidates) {
        const double share = static_cast<double>(count) * (0.5 * static_cast<double>(c.area) / area + 0.5 * static_cast<double>(c.edge) / edge);
        sum += share;
        while (next < sum && static_cast<int>(points.size()) < count) {
            const Panorama& panorama = panoramas[c.panorama];
            if (cuts[c.panorama].empty()) cuts[c.panorama] = range_edges(panorama.range);
            const int x = static_cast<int>(c.pixel) % panorama.color.width, y = static_cast<int>(c.pixel) / panorama.color.width;
            const Surface s = surface_at(panorama, cuts[c.panorama], x, y);
            SurfacePoint point;
            point.position_m = panorama.world_from_pano * s.point;
            point.normal = panorama.world_from_pano.rotation * s.normal;
            point.color = srgb8_from_linear(panorama.color.at(x, y));
            point.radius_m = static_cast<float>(std::sqrt(static_cast<double>(c.area) / share));
            points.push_back(point);
            next = std::floor(next) + 1.0 + static_cast<double>(random.uniform());
        }
    }
    return points;
}

}  // namespace fastscene
