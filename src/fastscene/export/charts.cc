#include "fastscene/export/charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "fastscene/export/identities.h"

namespace fastscene {
namespace {

constexpr float kFacing = 0.85f;         // cosine between a chart's first triangle and its others: 32 degrees
constexpr float kWeld_m = 1e-4f;         // vertices closer than this are one
constexpr int kChartGutter = 1;          // texels around a chart
constexpr float kThinner = 0.9f;         // how the density shrinks until the charts fit
constexpr float kSparsest_per_m = 0.5f;  // of texels; with fewer, a room would be a few colors

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::array<Vec3f, 3> corners_of(const Mesh& mesh, std::uint32_t first) {
    return {mesh.positions[mesh.triangles[first]], mesh.positions[mesh.triangles[first + 1]],
            mesh.positions[mesh.triangles[first + 2]]};
}
// Twice its area long.
Vec3f normal_of(const Mesh& mesh, std::uint32_t first) {
    const auto [a, b, c] = corners_of(mesh, first);
    return cross(b - a, c - a);
}

// Triangles beside each other, by their edges.
std::map<Edge, std::vector<std::uint32_t>> neighbours(const Mesh& mesh) {
    std::map<std::array<std::int32_t, 3>, std::uint32_t> places;
    std::vector<std::uint32_t> welded;
    for (const Vec3f p : mesh.positions) {
        const std::array<std::int32_t, 3> place{static_cast<std::int32_t>(std::lround(p.x / kWeld_m)),
                                                static_cast<std::int32_t>(std::lround(p.y / kWeld_m)),
                                                static_cast<std::int32_t>(std::lround(p.z / kWeld_m))};
        welded.push_back(places.try_emplace(place, static_cast<std::uint32_t>(places.size())).first->second);
    }
    std::map<Edge, std::vector<std::uint32_t>> out;
    for (std::uint32_t t = 0; t + 2 < mesh.triangles.size(); t += 3)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = welded[mesh.triangles[t + k]], b = welded[mesh.triangles[t + (k + 1) % 3]];
            out[{std::min(a, b), std::max(a, b)}].push_back(t);
        }
    return out;
}

// Its axes: the longest edge runs along `right`, so that walls stay upright and fill their rectangles.
void lay_flat(Chart& chart, const Mesh& mesh) {
    Vec3f normal{}, longest{};
    for (const std::uint32_t t : chart.triangles) {
        normal += normal_of(mesh, t);
        const auto c = corners_of(mesh, t);
        for (std::size_t k = 0; k < 3; ++k)
            if (const Vec3f edge = c[(k + 1) % 3] - c[k]; dot(edge, edge) > dot(longest, longest)) longest = edge;
    }
    normal = normalize(normal);
    chart.right = normalize(longest - normal * dot(longest, normal));
    if (chart.right == Vec3f{}) {
        Vec3f up;
        make_frame(normal == Vec3f{} ? Vec3f{0, 0, 1} : normal, chart.right, up);
    }
    chart.down = normalize(cross(normal, chart.right));
    if (chart.down == Vec3f{}) chart.down = normalize(cross(Vec3f{0.36f, 0.48f, 0.8f}, chart.right));
    for (int turn = 0; turn < 2; ++turn) {
        chart.low = {1e9f, 1e9f}, chart.high = {-1e9f, -1e9f};
        for (const std::uint32_t t : chart.triangles)
            for (const Vec3f p : corners_of(mesh, t)) {
                const Vec2f q = chart.flat(p);
                chart.low = {std::min(chart.low.x, q.x), std::min(chart.low.y, q.y)};
                chart.high = {std::max(chart.high.x, q.x), std::max(chart.high.y, q.y)};
            }
        if (chart.high.x - chart.low.x >= chart.high.y - chart.low.y) return;
        std::swap(chart.right, chart.down);  // lying: rows of the picture are filled better
    }
}

void add_charts(std::vector<Chart>& out, const Mesh& mesh, int index) {
    const auto beside = neighbours(mesh);
    std::vector<std::vector<std::uint32_t>> next(mesh.triangles.size() / 3);
    for (const auto& [edge, triangles] : beside)
        for (const std::uint32_t a : triangles)
            for (const std::uint32_t b : triangles)
                if (a != b) next[a / 3].push_back(b);
    std::vector<bool> taken(mesh.triangles.size() / 3, false);
    for (std::uint32_t seed = 0; seed + 2 < mesh.triangles.size(); seed += 3) {
        if (taken[seed / 3]) continue;
        taken[seed / 3] = true;
        Chart chart{index, {seed}, {}, {}, {}, {}};
        const Vec3f facing = normalize(normal_of(mesh, seed));
        for (std::size_t i = 0; i < chart.triangles.size(); ++i)
            for (const std::uint32_t t : next[chart.triangles[i] / 3]) {
                if (taken[t / 3] || dot(normalize(normal_of(mesh, t)), facing) < kFacing) continue;
                taken[t / 3] = true;
                chart.triangles.push_back(t);
            }
        lay_flat(chart, mesh);
        out.push_back(std::move(chart));
    }
}

// Rows of charts, high ones first. Returns the height.
int place_in_rows(std::vector<Chart>& charts, int width) {
    std::vector<std::size_t> order(charts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return charts[a].height > charts[b].height; });
    int x = 0, y = 0, row = 0;
    for (const std::size_t i : order) {
        Chart& c = charts[i];
        const int w = c.width + 2 * kChartGutter, h = c.height + 2 * kChartGutter;
        if (x > 0 && x + w > width) x = 0, y += row, row = 0;
        c.x = x + kChartGutter, c.y = y + kChartGutter;
        x += w, row = std::max(row, h);
    }
    return y + row;
}

}  // namespace

ChartAtlas chart_atlas(const Room& room, const std::vector<int>& meshes, const BakeParams& params) {
    ChartAtlas atlas;
    for (const int m : meshes) add_charts(atlas.charts, room.meshes[at(m)], m);
    const int most = params.texture_size;
    for (float density = params.texels_per_metre; density > kSparsest_per_m; density *= kThinner) {
        int widest = 1;
        double area = 0;
        for (Chart& c : atlas.charts) {
            const Vec2f size = (c.high - c.low) * density;
            c.width = std::max(1, static_cast<int>(std::ceil(size.x)));
            c.height = std::max(1, static_cast<int>(std::ceil(size.y)));
            widest = std::max(widest, c.width + 2 * kChartGutter);
            area += static_cast<double>(c.width + 2 * kChartGutter) * (c.height + 2 * kChartGutter);
        }
        if (widest > most || area > static_cast<double>(most) * most) continue;
        const int width = std::clamp(static_cast<int>(1.05 * std::sqrt(area)), widest, most);
        for (const int w : {width, most})
            if (const int height = place_in_rows(atlas.charts, w); height <= most) {
                atlas.width = w, atlas.height = std::max(1, height), atlas.texels_per_metre = density;
                return atlas;
            }
    }
    throw UsageError("--texture-size: expected room for the {} flat pieces of the room, found {} pixels",
                     atlas.charts.size(), most);
}

BakedMesh mapped(const Mesh& mesh, const ChartAtlas& atlas, const std::vector<std::size_t>& charts) {
    BakedMesh out;
    for (const std::size_t index : charts) {
        const Chart& chart = atlas.charts[index];
        std::map<std::uint32_t, std::uint32_t> own;
        for (const std::uint32_t t : chart.triangles)
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t v = mesh.triangles[t + k];
                const auto [entry, is_new] = own.try_emplace(v, static_cast<std::uint32_t>(out.vertices.size()));
                out.triangles.push_back(entry->second);
                if (!is_new) continue;
                out.vertices.push_back(v);
                out.uv.push_back(atlas.uv(chart, mesh.positions[v]));
            }
    }
    return out;
}

std::vector<ChartTexel> texels_of(const Room& room, const ChartAtlas& atlas, const Chart& chart) {
    const Mesh& mesh = room.meshes[at(chart.mesh)];
    const int width = chart.width + 2 * kChartGutter, height = chart.height + 2 * kChartGutter;
    constexpr float kFar = 1e9f;
    std::vector<float> outside(at(width) * at(height), kFar);  // how far a texel is from the triangle that it shows
    std::vector<ChartTexel> found(outside.size());
    for (const std::uint32_t t : chart.triangles) {
        const auto corner = corners_of(mesh, t);
        std::array<Vec2f, 3> flat;
        for (std::size_t k = 0; k < 3; ++k) flat[k] = (chart.flat(corner[k]) - chart.low) * atlas.texels_per_metre;
        const auto area = [](Vec2f a, Vec2f b, Vec2f c) {
            return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        };
        const float whole = area(flat[0], flat[1], flat[2]);
        Vec3f normal = normalize(normal_of(mesh, t));
        if (dot(normal, mesh.normals[mesh.triangles[t]]) < 0) normal = -normal;
        const auto [left, right] = std::minmax({flat[0].x, flat[1].x, flat[2].x});
        const auto [top, bottom] = std::minmax({flat[0].y, flat[1].y, flat[2].y});
        for (int j = std::max(-kChartGutter, static_cast<int>(std::floor(top)) - 1);
             j <= std::min(chart.height + kChartGutter - 1, static_cast<int>(std::ceil(bottom))); ++j)
            for (int i = std::max(-kChartGutter, static_cast<int>(std::floor(left)) - 1);
                 i <= std::min(chart.width + kChartGutter - 1, static_cast<int>(std::ceil(right))); ++i) {
                const Vec2f p{static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f};
                std::array<float, 3> w{1, 0, 0};
                if (std::fabs(whole) > 1e-6f)
                    w = {area(p, flat[1], flat[2]) / whole, area(flat[0], p, flat[2]) / whole,
                         area(flat[0], flat[1], p) / whole};
                float sum = 0;
                for (float& share : w) share = std::clamp(share, 0.f, 1.f), sum += share;
                const Vec3f position = (corner[0] * w[0] + corner[1] * w[1] + corner[2] * w[2]) / sum;
                const float off = length((chart.flat(position) - chart.low) * atlas.texels_per_metre - p);
                const std::size_t k = at((j + kChartGutter) * width + i + kChartGutter);
                if (off >= outside[k]) continue;
                outside[k] = off;
                found[k] = {chart.x + i, chart.y + j, position, normal};
            }
    }
    std::vector<ChartTexel> out;
    for (std::size_t k = 0; k < found.size(); ++k)
        if (outside[k] < kFar) out.push_back(found[k]);
    return out;
}

}  // namespace fastscene
