#include "fastscene/trace/outside_rows.h"

#include <array>

#include "fastscene/trace/noise.h"

namespace fastscene::outside {
namespace {

// Intersection of the ray with a plane that faces the viewer at an azimuth: metres to the right, and above the ground.
Vec2f on_plane(float da, float height, float distance_m, float eye_height_m) {
    return {std::tan(da) * distance_m, std::tan(height) * distance_m / std::max(0.05f, std::cos(da)) + eye_height_m};
}

constexpr std::array<Vec3f, 8> kWalls{Vec3f{0.62f, 0.55f, 0.43f}, {0.66f, 0.63f, 0.58f}, {0.38f, 0.17f, 0.11f},
                                      {0.5f, 0.46f, 0.42f},       {0.58f, 0.44f, 0.3f},  {0.42f, 0.4f, 0.38f},
                                      {0.6f, 0.5f, 0.46f},        {0.45f, 0.25f, 0.17f}};
constexpr std::array<Vec3f, 3> kRoofs{Vec3f{0.3f, 0.13f, 0.08f}, {0.13f, 0.13f, 0.145f}, {0.2f, 0.15f, 0.12f}};

// A window pane with its frame; q: position within the facade's bay, in [0, 1]^2. `lit`: the window's own random number
// in [0, 1).
Vec3f pane(const Light& light, Vec2f q, float lit, Vec3f frame) {
    const bool bar = std::abs(q.x - 0.5f) < 0.03f || q.x < 0.07f || q.x > 0.93f || q.y < 0.05f || q.y > 0.95f ||
                     std::abs(q.y - 0.68f) < 0.02f;
    if (bar) return frame;
    if (light.dark && lit > 0.6f) {
        const float curtain = lit > 0.85f && std::abs(q.x - 0.5f) > 0.28f ? 0.55f : 1.f;
        return Vec3f{0.38f, 0.25f, 0.12f} * (0.25f + 0.9f * (lit - 0.6f)) * curtain * (0.7f + 0.4f * q.y);
    }
    // Glass reflects the sky, more towards the top; some windows have a curtain.
    const Vec3f mirrored = light.haze * (0.1f + 0.22f * q.y * lit);
    const bool curtain = lit < 0.35f && (q.x < 0.3f || q.x > 0.7f);
    return curtain ? lerp(mirrored, light.shade * 0.3f, 0.5f) : mirrored;
}

// Distance of a clump from the viewer, relative to its row's distance.
float depth_of(const BedRow& row, int cell) { return 0.93f + 0.14f * lattice_unit(cell, 0, 7, row.seed); }

// One cell's clump, if the ray hits it.
void clump(const Light& light, const BedRow& row, int cell, float middle, float azimuth, float height, Vec3f& color) {
    static constexpr std::array<Vec3f, 4> kLeaves{
        Vec3f{0.055f, 0.09f, 0.03f}, {0.1f, 0.14f, 0.045f}, {0.1f, 0.12f, 0.085f}, {0.075f, 0.1f, 0.035f}};
    static constexpr std::array<Vec3f, 7> kFlowers{
        Vec3f{0.7f, 0.68f, 0.62f}, {0.62f, 0.2f, 0.34f}, {0.3f, 0.2f, 0.52f},  {0.68f, 0.5f, 0.08f},
        {0.55f, 0.06f, 0.05f},     {0.66f, 0.4f, 0.42f}, {0.68f, 0.26f, 0.06f}};
    const auto rng = [&](int what) { return lattice_unit(cell, what, 7, row.seed); };
    const float distance = row.distance_m * depth_of(row, cell), r = row.radius_m * (0.7f + 0.6f * rng(1)),
                high = row.high_m * (0.5f + rng(2));
    const Vec2f p = on_plane(azimuth - middle, height, distance, row.eye_height_m);
    if (p.y < -0.05f * row.high_m || p.y > 1.3f * high || std::abs(p.x) > 1.4f * r) return;
    const Vec2f q{p.x / r, std::max(0.f, p.y) / high};
    const float leaves = fbm2({p.x * 5.f / row.radius_m + 17.f * rng(3), p.y * 5.f / row.radius_m}, 4, 0.f,
                              row.seed + static_cast<std::uint32_t>(cell));
    const float inside = 1 - q.x * q.x - q.y * q.y + 1.5f * (leaves - 0.5f);
    if (inside < 0) return;
    const Vec3f normal = normalize(Vec3f{q.x, 0.25f + q.y, std::sqrt(std::max(0.1f, 1 - q.x * q.x - q.y * q.y))});
    Vec3f tone = kLeaves[static_cast<std::size_t>(rng(4) * 3.99f)] *
                 (0.35f + 0.9f * leaves + 0.5f * noise2(p * (2.2f / row.bloom_m), row.seed + 6));
    // Flowers on a jittered grid, denser towards the top; one clump in three has leaves only.
    const Vec2f g{p.x / row.bloom_m + 31.f * rng(5), p.y / row.bloom_m};
    const int gx = floor_int(g.x), gy = floor_int(g.y);
    const float off_x = g.x - static_cast<float>(gx) - 0.15f - 0.7f * lattice_unit(gx, gy, 1, row.seed + 7),
                off_y = g.y - static_cast<float>(gy) - 0.15f - 0.7f * lattice_unit(gx, gy, 2, row.seed + 7);
    const bool flower = !light.snow && rng(6) > 0.3f &&
                        off_x * off_x + off_y * off_y < 0.05f + 0.12f * lattice_unit(gx, gy, 5, row.seed + 7) &&
                        lattice_unit(gx, gy, 3, row.seed + 7) < (0.25f + 0.75f * q.y) * (0.45f + 0.55f * rng(7));
    if (flower)
        tone = kFlowers[static_cast<std::size_t>(rng(8) * 6.99f)] *
               (0.7f + 0.5f * lattice_unit(gx, gy, 4, row.seed + 7));
    if (light.snow) tone = lerp(tone, {0.72f, 0.75f, 0.8f}, unit_clamp(normal.y + 1.2f * (leaves - 0.4f)));
    const float sky_part = 0.4f + 0.6f * unit_clamp(0.3f + 0.7f * q.y);
    const Vec3f arriving = light.shade * sky_part + light.sun * (0.9f * light.sunlit(normal, middle)) +
                           light.street * 0.06f;
    color = light.far_off(tone * arriving, row.haze);
}

}  // namespace

void buildings(const Light& light, const Row& row, float azimuth, float height, Vec3f& color) {
    const float wide = 2 * kPi / static_cast<float>(row.cells);
    const int cell = floor_int((azimuth + kPi) / wide);
    const std::uint32_t hash = lattice_hash(cell, row.cells, 3, row.seed);
    if (lattice_unit(cell, 5, 1, row.seed) < row.gap) return;
    const float middle = (static_cast<float>(cell) + 0.5f) * wide - kPi;
    Vec2f p = on_plane(azimuth - middle, height, row.distance_m, row.eye_height_m);
    const float half = std::tan(wide / 2) * row.distance_m * (row.pitched && row.gap > 0.3f ? 0.72f : 1.f);
    const float storey = 3.1f,
                eaves = storey *
                            std::floor((row.low_m + (row.high_m - row.low_m) * lattice_unit(cell, 1, 9, row.seed)) /
                                       storey) +
                        0.6f;
    const float rise = row.pitched ? (row.gap > 0.3f ? 0.75f * (half - std::abs(p.x)) : 2.6f) : 0.f;
    if (std::abs(p.x) > half || p.y > eaves + std::max(0.f, rise) || p.y < 0) return;
    const Vec3f wall = kWalls[hash % kWalls.size()], frame{0.55f, 0.54f, 0.52f};
    const float sun = light.sunlit({0, 0.08f, 1}, middle);
    const Vec3f arriving = light.shade + light.sun * sun + light.street * (0.5f * std::exp(-p.y / 6.f));
    if (p.y > eaves) {
        Vec3f roof = light.snow ? Vec3f{0.75f, 0.77f, 0.8f} : kRoofs[(hash >> 8) % kRoofs.size()];
        roof = roof * (0.85f + 0.3f * noise2({p.x * 1.5f, p.y * 5.f}, row.seed));
        const bool gable = row.gap > 0.3f && (hash >> 12 & 1);
        color = light.far_off((gable ? wall : roof) * (light.shade + light.sun * light.sunlit({0, 0.7f, 0.7f}, middle)),
                              row.haze);
        return;
    }
    const float bay = 1.7f + 1.1f * lattice_unit(cell, 2, 4, row.seed), across = (p.x + half) / bay, up = p.y / storey;
    const int column = floor_int(across), floor = floor_int(up);
    const float fx = across - static_cast<float>(column), fy = up - static_cast<float>(floor);
    const bool whole = (static_cast<float>(column) + 1) * bay < 2 * half &&
                       (static_cast<float>(floor) + 1) * storey < eaves + 0.3f;
    const float lit = lattice_unit(column + 131 * cell, floor, 8, row.seed);
    const float x0 = 0.24f, x1 = 0.76f, y0 = floor == 0 ? 0.12f : 0.28f, y1 = 0.82f;
    Vec3f out;
    if (whole && fx > x0 && fx < x1 && fy > y0 && fy < y1) {
        out = pane(light, {(fx - x0) / (x1 - x0), (fy - y0) / (y1 - y0)}, lit, frame * arriving);
    } else {
        const float dirt = 0.86f + 0.22f * fbm2(p * 0.35f, 3, 0.f, row.seed + hash % 97);
        // A ledge at every floor and above every window, with its shadow.
        float tone = fy > 0.955f ? 1.15f : fy > 0.92f ? 0.75f : 1.f;
        if (whole && fx > x0 - 0.06f && fx < x1 + 0.06f && fy > y0 - 0.05f && fy < y1 + 0.05f) tone = 1.18f;
        if (p.y > eaves - 0.35f) tone = 1.2f;
        out = wall * arriving * (dirt * tone);
    }
    color = light.far_off(out, row.haze);
}

void trees(const Light& light, const TreeRow& row, float azimuth, float height, Vec3f& color) {
    const float wide = 2 * kPi / static_cast<float>(row.cells);
    const int here = floor_int((azimuth + kPi) / wide);
    for (int k = -1; k <= 1; ++k) {
        const int cell = (here + k + row.cells) % row.cells;
        const auto rng = [&](int what) { return lattice_unit(cell, what, 6, row.seed); };
        if (rng(0) < row.gap) continue;
        const float middle = (static_cast<float>(here + k) + 0.2f + 0.6f * rng(1)) * wide - kPi;
        const float distance = row.distance_m * (0.85f + 0.3f * rng(2)), r = row.radius_m * (0.75f + 0.5f * rng(3));
        const Vec2f p = on_plane(azimuth - middle, height, distance, row.eye_height_m);
        const float trunk = row.conifers ? 0.4f : r * (0.5f + 0.5f * rng(4)),
                    high = row.conifers ? r * (3.2f + 1.4f * rng(5)) : trunk + 1.9f * r;
        if (p.y < 0 || p.y > high * 1.15f || std::abs(p.x) > 1.4f * r) continue;
        const float leaves = fbm2({p.x * 2.1f / r + 13.f * rng(6), p.y * 2.1f / r}, 5, 0.f,
                                  row.seed + static_cast<std::uint32_t>(cell));
        Vec3f normal{};
        float depth = -1;
        if (row.conifers) {
            // Conifer: tiers of branches.
            const float t = (p.y - trunk) / (high - trunk), bough = t * 7.f - std::floor(t * 7.f);
            const float half = 0.62f * r * (1 - t) * (0.82f + 0.36f * (1 - bough)) + 0.2f * r * (leaves - 0.5f);
            if (t > 0 && half > 0 && std::abs(p.x) < half) {
                depth = 1 - std::abs(p.x) / half;
                normal = normalize(Vec3f{p.x / half, 0.35f + 0.5f * (1 - bough), 0.4f + 0.6f * depth});
            }
        } else {
            for (int b = 0; b < 7; ++b) {
                const float turn = 2.4f * static_cast<float>(b) + 6.f * rng(7), out = b == 0 ? 0.f : r * 0.55f;
                const Vec2f c{std::cos(turn) * out, trunk + 0.95f * r + std::sin(turn) * out * 0.75f};
                const float rb = r * (b == 0 ? 0.72f : 0.36f + 0.2f * lattice_unit(cell, b, 11, row.seed));
                const Vec2f d{(p.x - c.x) / rb, (p.y - c.y) / rb};
                const float d2 = d.x * d.x + d.y * d.y + 1.5f * (leaves - 0.5f);
                if (d2 < 1 && 1 - d2 > depth)
                    depth = 1 - d2, normal = {d.x, d.y, std::sqrt(std::max(0.05f, 1 - d.x * d.x - d.y * d.y))};
            }
        }
        if (depth < 0) {
            if (p.y < trunk + 0.6f * r && std::abs(p.x) < 0.055f * r * (1.4f - p.y / high))
                color = light.far_off(Vec3f{0.1f, 0.075f, 0.055f} * (light.shade + light.sun * 0.3f), row.haze);
            continue;
        }
        const float fine = noise2({p.x * 17.f / r, p.y * 17.f / r}, row.seed + 5), clump = 0.45f + 0.95f * leaves;
        Vec3f green = row.conifers ? Vec3f{0.045f, 0.075f, 0.04f}
                                   : lerp(Vec3f{0.07f, 0.1f, 0.035f}, Vec3f{0.14f, 0.15f, 0.05f}, rng(8));
        // One in eight is a copper beech or in blossom.
        if (!row.conifers && rng(9) < 0.12f)
            green = rng(10) < 0.5f ? Vec3f{0.13f, 0.055f, 0.045f} : Vec3f{0.36f, 0.25f, 0.26f};
        if (row.snow)
            green = lerp(green, Vec3f{0.7f, 0.73f, 0.78f}, unit_clamp(0.2f + normal.y + 1.6f * (fine - 0.5f)));
        const float sky_part = 0.45f + 0.55f * unit_clamp(0.5f + 0.5f * normal.y);
        const Vec3f arriving = light.shade * (sky_part * clump) +
                               light.sun * (light.sunlit(normalize(normal), middle) * clump * 0.9f) +
                               light.street * 0.06f;
        color = light.far_off(green * arriving * (0.55f + 0.9f * fine), row.haze);
    }
}

void hedge(const Light& light, float distance_m, float high_m, float eye_height_m, bool snow, std::uint32_t seed,
           float azimuth, float height, Vec3f& color) {
    const float y = std::tan(height) * distance_m + eye_height_m, x = azimuth * distance_m;
    if (y < 0 || y > high_m + 0.25f) return;
    const float leaves = fbm2({x * 2.2f, y * 2.2f}, 4, 0.f, seed), fine = noise2({x * 9.f, y * 9.f}, seed + 1);
    const float top = high_m + 0.22f * (leaves - 0.5f);
    if (y > top) return;
    Vec3f green{0.06f, 0.09f, 0.03f};
    const float edge = smooth_step(top - 0.22f, top, y);
    if (snow) green = lerp(green, {0.72f, 0.75f, 0.8f}, std::max(edge, 0.35f * fine));
    const Vec3f arriving = light.shade * (0.5f + 0.5f * edge) +
                           light.sun * (light.sunlit({0, 0.3f + 0.7f * edge, 0.9f - 0.5f * edge}, azimuth) * 0.85f);
    color = light.far_off(
        green * arriving * (0.45f + 0.6f * leaves + 0.5f * fine) * (0.6f + 0.4f * smooth_step(0, 0.6f, y)), 0.05f);
}

void beds(const Light& light, const BedRow& row, float azimuth, float height, const std::function<bool(float)>& planted,
          Vec3f& color) {
    const float low = std::tan(height) * row.distance_m + row.eye_height_m;
    if (low > 2.2f * row.high_m || low < -0.3f * row.eye_height_m) return;
    const float wide = 2 * kPi / static_cast<float>(row.cells);
    const int here = floor_int((azimuth + kPi) / wide);
    const auto cell_at = [&](int k) { return (here + k + row.cells) % row.cells; };
    std::array<int, 5> order{-2, -1, 0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return depth_of(row, cell_at(a)) > depth_of(row, cell_at(b));
    });  // far to near, so that near ones occlude
    for (const int k : order)
        if (const float middle = (static_cast<float>(here + k) + 0.5f) * wide - kPi; planted(middle))
            clump(light, row, cell_at(k), middle, azimuth, height, color);
}

}  // namespace fastscene::outside
