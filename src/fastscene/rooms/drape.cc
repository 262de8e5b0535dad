#include "fastscene/rooms/drape.h"

#include <algorithm>
#include <cmath>

#include "fastscene/rooms/shapes.h"

namespace fastscene {
namespace {

// Two points that keep their distance.
struct Link {
    int a, b;
    float rest, stiffness;
};

constexpr float kStep_s = 1.f / 60, kGravity = 9.81f;
constexpr int kSteps = 80;                              // 1.3 s: cloth has fallen and come to rest
constexpr int kIterations = 6;                          // of the links, each step: cloth stretches by a few percent
constexpr float kDamping = 0.97f, kLastDamping = 0.7f;  // of the velocity, each step; over the last third
constexpr float kFriction = 0.7f;                       // share of the way along a solid that a step loses

// The point pushed out to `clear` from the solid; where it touches, most of its way along the surface is lost.
void push_out(const DrapeSolid& s, float clear, Vec3f before, Vec3f& p) {
    const Vec3f d = p - s.center;
    Vec3f q;
    for (std::size_t a = 0; a < 3; ++a) q[a] = std::fabs(d[a]) - (s.half[a] - s.round_m);
    const Vec3f outside{std::max(q.x, 0.f), std::max(q.y, 0.f), std::max(q.z, 0.f)};
    const float far = length(outside);
    Vec3f normal{};
    float distance = 0;
    if (far > 0) {
        for (std::size_t a = 0; a < 3; ++a) normal[a] = std::copysign(outside[a] / far, d[a]);
        distance = far - s.round_m;
    } else {
        const std::size_t a = q.y >= q.x && q.y >= q.z ? 1 : q.x >= q.z ? 0 : 2;
        normal[a] = std::copysign(1.f, d[a]);
        distance = q[a] - s.round_m;
    }
    if (distance >= clear) return;
    p += normal * (clear - distance);
    const Vec3f way = p - before;
    p -= (way - normal * dot(way, normal)) * kFriction;
}

class Solver {
  public:
    Solver(const Cloth& cloth, DrapedCloth& out) : cloth_(cloth), points_(out.points) {
        const Vec2f spread = cloth.high - cloth.low,
                    cell{spread.x / static_cast<float>(out.columns), spread.y / static_cast<float>(out.rows)};
        const auto id = [&](int i, int j) { return j * (out.columns + 1) + i; };
        for (int j = 0; j <= out.rows; ++j)
            for (int i = 0; i <= out.columns; ++i) {
                // Uneven by a little, or nothing would tell the slack where to fold.
                const Vec2f at = cloth.low + Vec2f{cell.x * static_cast<float>(i), cell.y * static_cast<float>(j)};
                const float uneven = 0.5f * shapes::wobble({at.x * 5.f, 1.f, at.y * 5.f}, cloth.seed) +
                                     0.5f * shapes::wobble({at.x * 2.1f, 3.f, at.y * 2.1f}, cloth.seed + 1);
                points_.push_back({at.x, cloth.from_y + kUneven_m * (1 + uneven), at.y});
            }
        const float longer = 1 + cloth.slack;
        const auto join = [&](int i, int j, int di, int dj, float stiffness) {
            if (i + di < 0 || i + di > out.columns || j + dj > out.rows) return;
            const Vec2f flat{cell.x * static_cast<float>(di), cell.y * static_cast<float>(dj)};
            links_.push_back({id(i, j), id(i + di, j + dj), length(flat) * longer, stiffness});
        };
        for (int j = 0; j <= out.rows; ++j)
            for (int i = 0; i <= out.columns; ++i) {
                join(i, j, 1, 0, 1.f), join(i, j, 0, 1, 1.f);                          // along the threads
                join(i, j, 1, 1, kShear), join(i, j, -1, 1, kShear);                   // across them
                join(i, j, 2, 0, cloth.stiffness), join(i, j, 0, 2, cloth.stiffness);  // against bending
            }
    }

    void fall(std::span<const DrapeSolid> solids) {
        std::vector<Vec3f> before = points_;
        for (int step = 0; step < kSteps; ++step) {
            const float damping = step < 2 * kSteps / 3 ? kDamping : kLastDamping;
            for (std::size_t i = 0; i < points_.size(); ++i) {
                const Vec3f velocity = (points_[i] - before[i]) * damping;
                before[i] = points_[i];
                points_[i] += velocity - Vec3f{0, kGravity * kStep_s * kStep_s, 0};
            }
            for (int k = 0; k < kIterations; ++k) satisfy(k % 2 == 1);
            const Vec2f within = limit(step);
            for (std::size_t i = 0; i < points_.size(); ++i) {
                for (const DrapeSolid& s : solids) push_out(s, cloth_.clear_m, before[i], points_[i]);
                Vec3f& p = points_[i];
                p.x = std::clamp(p.x, -within.x, within.x);
                p.z = std::clamp(p.z, -within.y, within.y);
                p.y = std::max(p.y, cloth_.clear_m);
            }
        }
    }

  private:
    static constexpr float kUneven_m = 0.012f, kShear = 0.6f;

    // How far it may reach at a step: it is tucked in once it hangs.
    Vec2f limit(int step) const {
        constexpr float kFrom = 0.4f, kTo = 0.75f;  // of all steps
        const float tucked = std::clamp((static_cast<float>(step) / kSteps - kFrom) / (kTo - kFrom), 0.f, 1.f);
        const auto reach = [&](float low, float high, float most) {
            const float spread = std::max(std::fabs(low), std::fabs(high));
            return spread > most ? std::lerp(spread, most, tucked) : most;
        };
        return {reach(cloth_.low.x, cloth_.high.x, cloth_.most.x), reach(cloth_.low.y, cloth_.high.y, cloth_.most.y)};
    }

    // Every second time from the other end, or cloth would creep to one side.
    void satisfy(bool backwards) {
        const auto one = [&](const Link& link) {
            Vec3f &a = points_[static_cast<std::size_t>(link.a)], &b = points_[static_cast<std::size_t>(link.b)];
            const Vec3f d = b - a;
            const float now = length(d);
            if (!(now > 0)) return;
            const Vec3f half = d * (0.5f * link.stiffness * (now - link.rest) / now);
            a += half, b -= half;
        };
        if (backwards) std::for_each(links_.rbegin(), links_.rend(), one);
        else std::for_each(links_.begin(), links_.end(), one);
    }

    const Cloth& cloth_;
    std::vector<Vec3f>& points_;
    std::vector<Link> links_;
};

Vec3f cubic(Vec3f a, Vec3f b, Vec3f c, Vec3f d, float t) {
    return b + ((c - a) + ((a * 2.f - b * 5.f + c * 4.f - d) + (b * 3.f - a - c * 3.f + d) * t) * t) * (0.5f * t);
}

}  // namespace

// Catmull-Rom in both directions.
Vec3f DrapedCloth::at(float u, float v) const {
    const float x = u * static_cast<float>(columns), z = v * static_cast<float>(rows);
    const int i = std::clamp(static_cast<int>(x), 0, columns - 1), j = std::clamp(static_cast<int>(z), 0, rows - 1);
    const auto point = [&](int c, int r) {
        return points[static_cast<std::size_t>(std::clamp(r, 0, rows) * (columns + 1) + std::clamp(c, 0, columns))];
    };
    const auto along = [&](int r) {
        return cubic(point(i - 1, r), point(i, r), point(i + 1, r), point(i + 2, r), x - static_cast<float>(i));
    };
    return cubic(along(j - 1), along(j), along(j + 1), along(j + 2), z - static_cast<float>(j));
}

DrapedCloth drape(const Cloth& cloth, std::span<const DrapeSolid> solids) {
    DrapedCloth out;
    const Vec2f spread = cloth.high - cloth.low;
    out.columns = std::max(3, static_cast<int>(std::lround(spread.x / cloth.cell_m)));
    out.rows = std::max(3, static_cast<int>(std::lround(spread.y / cloth.cell_m)));
    out.size_m = spread * (1 + cloth.slack);
    Solver(cloth, out).fall(solids);
    return out;
}

Mesh cloth_mesh(const DrapedCloth& cloth, float thick_m, float cell_m) {
    const int columns = std::max(1, static_cast<int>(std::lround(cloth.size_m.x / cell_m))),
              rows = std::max(1, static_cast<int>(std::lround(cloth.size_m.y / cell_m)));
    // From the far end to the near one, so that the sheet's outer side looks up.
    Mesh mesh = shapes::slab(columns, rows, thick_m, [&](float u, float v) { return cloth.at(u, 1 - v); });
    // The lower side follows the upper one; the rims repeat points of both.
    const auto flat = [&](std::size_t k) {
        const auto w = static_cast<std::size_t>(columns) + 1;
        return Vec3f{cloth.size_m.y * (1 - static_cast<float>(k / w) / static_cast<float>(rows)),
                     cloth.size_m.x * static_cast<float>(k % w) / static_cast<float>(columns), 0};
    };
    const std::size_t grid = (static_cast<std::size_t>(columns) + 1) * (static_cast<std::size_t>(rows) + 1);
    for (std::size_t k = 0; k < 2 * grid; ++k) mesh.coords[k] = flat(k % grid);
    for (std::size_t k = 2 * grid; k < mesh.positions.size(); ++k)
        mesh.coords[k] = {mesh.positions[k].z, mesh.positions[k].x, 0};
    return mesh;
}

}  // namespace fastscene
