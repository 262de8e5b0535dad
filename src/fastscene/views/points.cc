#include "fastscene/views/points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/geometry/outlook.h"
#include "fastscene/geometry/range_edges.h"
#include "fastscene/image/color.h"
#include "fastscene/views/edge.h"

namespace fastscene {
namespace {

// Minimum distance of sky points. The sky has no parallax, but splats have: at 30 m a step of half a metre moved them
// by five pixels of 2048, and averaging the viewpoints blurred the view through a window. Viewers clip at a thousand
// metres.
constexpr float kSky_m = 400.f;
constexpr float kFlattest = 0.15f;  // minimum cosine: limits the weight of grazing pixels
constexpr float kMostArea = 4.f;    // maximum pixel area in medians: limits the weight of distant pixels

struct Surface {
    Vec3f point, normal;
    Vec3f across, down;  // tangents, per column and per row
};

// In the panorama's frame. Nothing is behind the sky, which has the same distance from the world's origin in every
// panorama, so it shows no parallax. An inpainted range between a wall's and the sky's may be kilometres.
Vec3f point_at(const Panorama& panorama, float sky_m, int x, int y) {
    const float range = panorama.range.at(x, y);
    const Vec3f direction = direction_of_pixel(x, y, panorama.size());
    return range < sky_m ? direction * range : direction * sky_m + inverse(panorama.world_from_pano) * Vec3f{};
}

// From differences to neighbours on the same surface; an isolated pixel faces the viewpoint.
Surface surface_at(const Panorama& panorama, const ImageMask& cuts, float sky_m, int x, int y) {
    const int w = cuts.width, h = cuts.height, left = wrap_column(x - 1, w), right = wrap_column(x + 1, w);
    const Vec3f p = point_at(panorama, sky_m, x, y);
    const bool cut_left = cuts.at(left, y) & kCutRight, cut_right = cuts.at(x, y) & kCutRight,
               cut_up = y == 0 || (cuts.at(x, y - 1) & kCutDown), cut_down = y + 1 == h || (cuts.at(x, y) & kCutDown);
    const Vec3f a = cut_left ? p : point_at(panorama, sky_m, left, y);
    const Vec3f b = cut_right ? p : point_at(panorama, sky_m, right, y);
    const Vec3f c = cut_up ? p : point_at(panorama, sky_m, x, y - 1);
    const Vec3f d = cut_down ? p : point_at(panorama, sky_m, x, y + 1);
    Vec3f normal = normalize(cross(b - a, d - c));
    if (!(dot(normal, normal) > 0.5f)) normal = -normalize(p);
    return {p, dot(normal, p) > 0 ? -normal : normal, (b - a) * (cut_left || cut_right ? 1.f : 0.5f),
            (d - c) * (cut_up || cut_down ? 1.f : 0.5f)};
}

// The plane that continues on both sides of a pixel: the wall or door around a joint a few pixels wide, which becomes a
// line on it. By their own ranges, the pixels of a joint would lie at different depths and face all ways, and begin as
// a ragged line.
std::optional<Surface> surface_across_joint(const Panorama& panorama, const ImageMask& cuts, float sky_m, int x,
                                            int y) {
    constexpr int kSide = 3;              // pixels to each side: joints of up to three pixels, and what is beside them
    constexpr float kDeepest_m = 0.1f;    // deeper gaps show another thing behind
    constexpr float kSameNormal = 0.97f;  // cosine
    constexpr float kSamePlane = 0.04f;   // offset of the sides from one plane, relative to their distance
    const EquirectSize size = panorama.size();
    const Vec3f direction = direction_of_pixel(x, y, size), here = point_at(panorama, sky_m, x, y);
    for (const bool along_row : {true, false}) {
        const int dx = along_row ? kSide : 0, dy = along_row ? 0 : kSide;
        if (y < dy || y + dy >= size.height) continue;
        const int x0 = wrap_column(x - dx, size.width), x1 = wrap_column(x + dx, size.width);
        if ((cuts.at(x0, y - dy) | cuts.at(x1, y + dy)) & kFarSide) continue;
        const Surface a = surface_at(panorama, cuts, sky_m, x0, y - dy),
                      b = surface_at(panorama, cuts, sky_m, x1, y + dy);
        const Vec3f between = b.point - a.point, normal = normalize(a.normal + b.normal);
        if (!(dot(a.normal, b.normal) > kSameNormal) ||
            !(std::fabs(dot(between, normal)) < kSamePlane * length(between)))
            continue;
        const float level = dot(a.point + b.point, normal) * 0.5f, behind = level - dot(here, normal);
        if (!(behind > -kSamePlane * length(between)) || behind > kDeepest_m) continue;
        const auto on_plane = [&](Vec3f d) { return d * (level / dot(d, normal)); };
        const Vec3f point = on_plane(direction);
        return Surface{point, normal, on_plane(direction_of_pixel(wrap_column(x + 1, size.width), y, size)) - point,
                       on_plane(direction_of_pixel(x, y > 0 ? y - 1 : y + 1, size)) * (y > 0 ? -1.f : 1.f) +
                           point * (y > 0 ? 1.f : -1.f)};
    }
    return std::nullopt;
}

// Pixels that may become points, with their weights.
struct Candidate {
    std::uint32_t panorama, pixel;
    // Steradians; square metres (of the known outside: weighted steradians); edge strength times solid angle.
    float angle, area, edge;
    bool outside;  // no range: distance and area are assumed
    // > 0: a surface pixel, but the point belongs to the outside behind it; the density of such points
    float hidden = 0;
};

// Given panoramas (photographed or rendered); walked ones mostly repeat what these show.
bool is_given(const Panorama& panorama) {
    return panorama.known.empty() || std::all_of(panorama.known.pixels.begin(), panorama.known.pixels.end(),
                                                 [](Known k) { return k == Known::original; });
}

// Behind all surfaces, and so far that steps between panoramas hardly change its direction.
float sky_distance(const std::vector<Panorama>& panoramas) {
    constexpr float kBeyond = 1.5f, kMost_m = 900.f;  // viewers clip at 1000 m, and the backdrop is behind it
    constexpr float kSteps = 250.f;
    float far = 0, step = 0;
    for (std::size_t i = 0; i < panoramas.size(); ++i) {
        if (i > 0 && !is_given(panoramas[i])) continue;
        step = std::max(step, length(panoramas[i].world_from_pano.translation));
        for (const float r : panoramas[i].range.pixels)
            if (r < kMost_m) far = std::max(far, r);
    }
    return std::clamp(std::max(kBeyond * far, kSteps * step), kSky_m, kMost_m);
}

// Decides which of several panoramas contributes the points of a surface: the one with the finest resolution there. So
// each surface is sampled once, in its best colors.
class Owners {
  public:
    Owners(const std::vector<Panorama>& panoramas, float sky_m) : sky_m_(sky_m) {
        for (std::uint32_t i = 0; i < panoramas.size(); ++i)
            if (i == 0 || is_given(panoramas[i]))
                given_.push_back({&panoramas[i], inverse(panoramas[i].world_from_pano), i});
    }
    std::size_t count() const { return given_.size(); }
    // Candidates come from every n-th row and column, as overlapping panoramas have more pixels than needed.
    int stride() const {
        constexpr double kCandidates = 4e6;
        double pixels = 0;
        for (const Given& g : given_) pixels += static_cast<double>(g.panorama->range.size());
        return std::max(1, static_cast<int>(std::sqrt(pixels / kCandidates)));
    }
    // For a surface seen by panorama `index`, in its frame.
    bool owns(std::uint32_t index, const Panorama& panorama, const Surface& surface, bool outside) const {
        if (given_.size() < 2) return true;
        const Vec3f point = panorama.world_from_pano * surface.point,
                    normal = panorama.world_from_pano.rotation * surface.normal;
        const float own = pixels_an_area(surface.point, surface.normal);
        for (const Given& g : given_) {
            if (g.index == index || (outside && g.index > index)) continue;
            const Vec3f there = g.pano_from_world * point;
            if (!outside) {
                const float its = pixels_an_area(there, g.pano_from_world.rotation * normal);
                if (its < own || (its == own && g.index > index)) continue;
            }
            if (sees(*g.panorama, there, outside)) return false;
        }
        return true;
    }

  private:
    struct Given {
        const Panorama* panorama;
        Rigid pano_from_world;
        std::uint32_t index;
    };
    static float pixels_an_area(Vec3f point, Vec3f normal) {
        const float far2 = dot(point, point);
        return std::max(0.f, -dot(normal, point)) / (far2 * std::sqrt(far2));
    }
    bool sees(const Panorama& panorama, Vec3f there, bool outside) const {
        // tolerance for the depth range of a slanted surface within a pixel
        constexpr float kSame = 0.02f, kSame_m = 0.01f;
        const Vec2f at = pixel_of_direction(there, panorama.size());
        const float range = panorama.range.at(wrap_column(static_cast<int>(at.x), panorama.color.width),
                                              std::min(static_cast<int>(at.y), panorama.color.height - 1));
        if (outside) return !(range < sky_m_);
        const float far = length(there);
        return std::fabs(range - far) < kSame * far + kSame_m;
    }

    float sky_m_;
    std::vector<Given> given_;
};

// Whether the outside is known in the pixel's direction; not if it is seen in a mirror.
bool sees(const Outside& outside, const Panorama& panorama, int x, int y) {
    const ImageMask& seen = outside.seen;
    const int w = panorama.color.width, h = panorama.color.height;  // both are in panorama 0's orientation
    return seen.at(x * seen.width / w, y * seen.height / h) != 0;
}

void collect(const std::vector<Panorama>& panoramas, std::uint32_t index, const Owners& owners, float sky_m,
             const Outside* known, std::vector<Candidate>& out) {
    const Panorama& panorama = panoramas[index];
    const bool given = index == 0 || is_given(panorama);
    const EquirectSize size = panorama.size();
    const ImageMask cuts = range_edges(panorama.range);
    const int stride = given ? owners.stride() : 1;
    // The outside is contributed by a single panorama, so all its pixels count.
    const auto on_grid = [stride](int i) { return i % stride == stride / 2; };
    std::vector<std::vector<Candidate>> rows(static_cast<std::size_t>(size.height));
    parallel_for(static_cast<std::int64_t>(rows.size()), 8, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t row = begin; row < end; ++row) {
            const auto y = static_cast<int>(row);
            for (int x = 0; x < size.width; ++x) {
                const bool outside = !(panorama.range.at(x, y) < sky_m);
                if (outside ? known && sees(*known, panorama, x, y) : !(on_grid(x) && on_grid(y))) continue;
                const float angle = static_cast<float>(pixel_solid_angle(y, size)) *
                                    static_cast<float>(outside ? 1 : stride * stride);
                const Known known = panorama.known.empty() ? Known::original : panorama.known.at(x, y);
                // The first panorama counts whole: what its picture did not have is filled there, and only there.
                if (index > 0 &&
                    (given ? known != Known::original : known != Known::invented && known != Known::looked))
                    continue;
                const bool is_far_side = cuts.at(x, y) & kFarSide;
                const auto whole = is_far_side && !outside ? surface_across_joint(panorama, cuts, sky_m, x, y)
                                                           : std::nullopt;
                // mixed colors of two surfaces; inpainted pixels have only one
                if (given && is_far_side && !whole) continue;
                const Surface s = whole ? *whole : surface_at(panorama, cuts, sky_m, x, y);
                if (given && !owners.owns(index, panorama, s, outside)) continue;
                const float distance = length(s.point),
                            cosine = std::max(kFlattest, -dot(s.normal, s.point) / distance);
                rows[static_cast<std::size_t>(row)].push_back(
                    {index, static_cast<std::uint32_t>(y * size.width + x), angle, angle * distance * distance / cosine,
                     angle * (0.01f + edge_strength(panorama.color, x, y)), outside});
            }
        }
    });
    for (const auto& row : rows) out.insert(out.end(), row.begin(), row.end());
}

// Angular distance in radians from each pixel to the nearest nonzero one, by 8-connected steps (too long by at most a
// twelfth); columns wrap.
ImageF angle_to(const ImageMask& mask) {
    const int w = mask.width, h = mask.height;
    ImageF out(w, h, std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < out.size(); ++i)
        if (mask.pixels[i]) out.pixels[i] = 0;
    const float down = kPi / static_cast<float>(h);
    const auto across = [&](int y) {
        return 2 * kPi / static_cast<float>(w) * std::sin(down * (static_cast<float>(y) + 0.5f));
    };
    // A row is updated from the one before, then from left to right and back, twice around.
    const auto pass = [&](int y, int before) {
        const float side = across(y), slant = std::hypot(side, down);
        for (int x = 0; x < w && before >= 0 && before < h; ++x)
            out.at(x,
                   y) = std::min({out.at(x, y), out.at(x, before) + down, out.at(wrap_column(x - 1, w), before) + slant,
                                  out.at(wrap_column(x + 1, w), before) + slant});
        for (const int step : {1, -1})
            for (int n = 0; n < 2 * w; ++n) {
                const int x = wrap_column(step * n, w);
                out.at(x, y) = std::min(out.at(x, y), out.at(wrap_column(x - step, w), y) + side);
            }
    };
    for (int y = 0; y < h; ++y) pass(y, y - 1);
    for (int y = h; y-- > 0;) pass(y, y + 1);
    return out;
}

// The outside continues behind frames and walls, where a step sideways may reveal it although no viewpoint sees it:
// behind the neighbouring surfaces of panorama 0, as far as such a step shifts them.
void collect_hidden(const Panorama& panorama, std::vector<Candidate>& out) {
    constexpr float kStep_m = 1.f;
    constexpr float kBeside = 3.f * kPi / 180.f;  // full density up to this distance from seen outside; then decreasing
    const EquirectSize size = panorama.size();
    ImageMask outside(size.width, size.height);
    for (std::size_t i = 0; i < outside.size(); ++i) outside.pixels[i] = !std::isfinite(panorama.range.pixels[i]);
    const ImageF beside = angle_to(outside);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const float away = beside.at(x, y);
            if (outside.at(x, y) || away > std::max(kBeside, std::atan2(kStep_m, panorama.range.at(x, y)))) continue;
            const float angle = static_cast<float>(pixel_solid_angle(y, size));
            out.push_back(
                {0, static_cast<std::uint32_t>(y * size.width + x), angle, 0, 0, true, std::min(1.f, kBeside / away)});
        }
}

constexpr std::uint32_t kOutside = 0xffffffff;  // marks points of Outside, in place of a panorama's index

// Includes a margin: at the border of the visible directions, discs overlap on one side only. What few places of the
// room show gets fewer points: beside the window one sees half of the sphere, from the bed a part of the sky.
void collect_outside(const Outside& outside, std::vector<Candidate>& out) {
    constexpr float kMargin = 3.f * kPi / 180.f;
    const EquirectSize size{outside.color.width, outside.color.height};
    const ImageF away = angle_to(outside.seen);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (away.at(x, y) > kMargin) continue;
            constexpr float kOften = 0.3f, kLeast = 0.25f;  // share of places with full density; smallest weight
            const float share = static_cast<float>(outside.seen.at(x, y)) / 255,
                        weight = std::clamp(std::sqrt(share / kOften), kLeast, 1.f),
                        angle = static_cast<float>(pixel_solid_angle(y, size));
            out.push_back({kOutside, static_cast<std::uint32_t>(y * size.width + x), angle, weight * angle,
                           weight * angle * (0.01f + edge_strength(outside.color, x, y)), true});
        }
}

// The area that a surface's pixel counts with.
std::vector<float> areas_of_surfaces(const std::vector<Candidate>& candidates) {
    std::vector<float> per_angle;
    for (const Candidate& c : candidates) per_angle.push_back(c.area / c.angle);
    const auto middle = per_angle.begin() + static_cast<std::ptrdiff_t>(per_angle.size() / 2);
    if (!per_angle.empty()) std::nth_element(per_angle.begin(), middle, per_angle.end());
    const float usual = per_angle.empty() ? 1.f : *middle;
    std::vector<float> areas;
    areas.reserve(candidates.size());
    for (const Candidate& c : candidates) areas.push_back(std::min(c.area, kMostArea * usual * c.angle));
    return areas;
}

// The outside has no size, only directions: pixels count by their solid angle.
std::vector<float> areas_of_outside(const std::vector<Candidate>& candidates) {
    constexpr float kHidden = 0.25f;  // rarely seen, and without detail
    std::vector<float> areas;
    areas.reserve(candidates.size());
    for (const Candidate& c : candidates)
        areas.push_back(c.hidden > 0 ? kHidden * c.hidden * c.angle : c.panorama == kOutside ? c.area : c.angle);
    return areas;
}

// Expected number of points per pixel: half by area, half by edges; at most one, since a second would be at the same
// position.
std::vector<double> shares_of(const std::vector<Candidate>& candidates, const std::vector<float>& areas, int count) {
    double area = 0, edge = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        area += static_cast<double>(areas[i]);
        edge += static_cast<double>(candidates[i].edge);
    }
    const double by_edges = edge > 0 ? 0.5 : 0;
    std::vector<double> shares(candidates.size());
    for (std::size_t i = 0; i < candidates.size(); ++i)
        shares[i] = (1 - by_edges) * static_cast<double>(areas[i]) / area +
                    (edge > 0 ? by_edges * static_cast<double>(candidates[i].edge) / edge : 0);
    // What saturated pixels cannot take is redistributed.
    double scale = count;
    constexpr int kRounds = 12;
    for (int round = 0; round < kRounds; ++round) {
        double full = 0, open = 0;
        for (const double s : shares) (scale * s >= 1 ? full : open) += scale * s >= 1 ? 1 : s;
        if (open <= 0 || full >= count) break;
        scale = (count - full) / open;
    }
    for (double& s : shares) s = std::min(1.0, scale * s);
    return shares;
}

// The number of points of the outside: by density, over its weighted solid angle.
int outside_count(const std::vector<float>& areas, const ViewsParams& params) {
    constexpr double kSquareDegrees = 180 * 180 / (static_cast<double>(kPi) * static_cast<double>(kPi));
    double angle = 0;
    for (const float a : areas) angle += static_cast<double>(a);
    return static_cast<int>(std::min<double>(params.outside_points, params.outside_density * kSquareDegrees * angle));
}

// Stratified sampling along the cumulative sum of the shares, with one jittered sample per stratum: calls
// point(candidate, share).
template <class Point>
void sample(const std::vector<Candidate>& candidates, const std::vector<double>& shares, int count, Random& random,
            const Point& point) {
    double sum = 0, next = static_cast<double>(random.uniform());
    for (std::size_t i = 0, made = 0; i < candidates.size(); ++i) {
        sum += shares[i];
        while (next < sum && made < static_cast<std::size_t>(count)) {
            point(candidates[i], shares[i]), ++made;
            next = std::floor(next) + 1.0 + static_cast<double>(random.uniform());
        }
    }
}

}  // namespace

std::vector<SurfacePoint> sample_points(const std::vector<Panorama>& panoramas, const ViewsParams& params,
                                        const Run& run, const Outside* outside) {
    std::vector<Candidate> surfaces, far;
    const Outside* known = outside && !outside->color.empty() ? outside : nullptr;
    const float sky_m = sky_distance(panoramas);
    const Owners owners(panoramas, sky_m);
    {
        std::vector<Candidate> all;
        for (std::uint32_t i = 0; i < panoramas.size(); ++i) collect(panoramas, i, owners, sky_m, known, all);
        for (const Candidate& c : all) (c.outside ? far : surfaces).push_back(c);
    }
    if (surfaces.empty() && far.empty()) return {};
    ImageColor outlook;
    if (known) collect_outside(*known, far);
    else outlook = outside_picture(panoramas[0].color, panoramas[0].range);
    if (!outlook.empty()) collect_hidden(panoramas[0], far);

    std::vector<SurfacePoint> points;
    std::vector<ImageMask> cuts(panoramas.size());
    const auto surface_of = [&](const Candidate& c, int x, int y) {
        if (cuts[c.panorama].empty()) cuts[c.panorama] = range_edges(panoramas[c.panorama].range);
        const Panorama& panorama = panoramas[c.panorama];
        const auto whole = c.outside ? std::nullopt : surface_across_joint(panorama, cuts[c.panorama], sky_m, x, y);
        return whole ? *whole : surface_at(panorama, cuts[c.panorama], sky_m, x, y);
    };
    const auto add = [&](const Candidate& c, double share) {
        const bool known_outside = c.panorama == kOutside, at_sky = known_outside || c.hidden > 0;
        const Panorama& panorama = panoramas[known_outside ? 0 : c.panorama];
        const ImageColor& color = known_outside ? known->color : c.hidden > 0 ? outlook : panorama.color;
        const int x = static_cast<int>(c.pixel) % color.width, y = static_cast<int>(c.pixel) / color.width;
        const Vec3f d = direction_of_pixel(x, y, {color.width, color.height});
        const auto shift = [&](int i, int j) {
            return (direction_of_pixel(i, j, {color.width, color.height}) - d) * sky_m;
        };
        const Surface s = at_sky ? Surface{d * sky_m, -d, shift(x + 1, y), shift(x, y + 1)} : surface_of(c, x, y);
        SurfacePoint point;
        point.position_m = panorama.world_from_pano * s.point;
        point.normal = panorama.world_from_pano.rotation * s.normal;
        point.color = srgb8_from_linear(color.at(x, y));
        point.edge = panorama.world_from_pano.rotation * edge_at(color, x, y, s.normal, s.across, s.down);
        const float area = at_sky ? c.angle * sky_m * sky_m : c.area;
        // Rarely trained, so it stays as initialized: discs must overlap enough to be opaque from the start.
        constexpr float kWide = 1.7f;
        point.radius_m = (at_sky ? kWide : 1.f) * static_cast<float>(std::sqrt(static_cast<double>(area) / share));
        points.push_back(point);
    };
    const auto draw = [&](const std::vector<Candidate>& candidates, const std::vector<float>& areas, int count,
                          const char* stream) {
        if (candidates.empty() || count < 1) return;
        Random random(run.seed, stream);
        sample(candidates, shares_of(candidates, areas, count), count, random, add);
    };
    draw(surfaces, areas_of_surfaces(surfaces), params.points, "views/points");
    const std::vector<float> areas = areas_of_outside(far);
    draw(far, areas, outside_count(areas, params), "views/points.outside");
    return points;
}

std::vector<SurfacePoint> backdrop_points(const std::vector<Panorama>& panoramas, int count, const Outside* outside) {
    constexpr float kBehind = 1.1f;  // times the sky's distance
    constexpr float kWide = 1.3f;    // times their spacing: they overlap well
    const Panorama& first = panoramas[0];
    // Angular distance from its center at which a disc is still visible: three radii.
    const float reach = 3 * kWide * std::sqrt(4 * kPi / static_cast<float>(count));
    const bool known = outside && !outside->color.empty();
    const ImageF away = known ? angle_to(outside->seen) : ImageF{};
    const auto at = [](const auto& picture, Vec3f d) {
        const Vec2f p = pixel_of_direction(d, {picture.width, picture.height});
        return picture.at(wrap_column(static_cast<int>(p.x), picture.width),
                          std::min(static_cast<int>(p.y), picture.height - 1));
    };
    // Gaps between the splats of the outside show more of it, not the floor that panorama 0 sees in that direction.
    const auto color_of = [&](Vec3f d) {
        return known && at(away, d) <= reach ? at(outside->color, d) : at(first.color, d);
    };
    const float golden = kPi * (3.f - std::sqrt(5.f)), far = kBehind * sky_distance(panoramas),
                n = static_cast<float>(count);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < count; ++i) {  // a Fibonacci spiral
        const float y = 1.f - 2.f * (static_cast<float>(i) + 0.5f) / n, r = std::sqrt(1.f - y * y),
                    a = golden * static_cast<float>(i);
        const Vec3f d{r * std::cos(a), y, r * std::sin(a)};
        points.push_back({d * far, -d, srgb8_from_linear(color_of(d)), kWide * far * std::sqrt(4 * kPi / n)});
    }
    return points;
}

}  // namespace fastscene
