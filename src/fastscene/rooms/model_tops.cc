#include "fastscene/rooms/model_tops.h"

#include <algorithm>
#include <cmath>

#include "fastscene/image/image.h"

namespace fastscene {
namespace {

constexpr int kHeightCells = 48;  // of the longer side of the height map
constexpr float kFlat_m = 0.01f;  // a top may be so uneven
constexpr float kLow_m = 0.25f, kHigh_m = 1.4f;
constexpr float kLeastWidth_m = 0.2f, kLeastDepth_m = 0.15f;
constexpr float kMargin_m = 0.02f;  // things keep away from the edge
constexpr std::size_t kMostTops = 2;

// The highest point of every column of a piece.
struct HeightMap {
    ImageF height;
    float cell_m = 0;
    Vec2f corner;  // x, z of its first cell's corner
};

HeightMap height_map(const Piece& piece) {
    const Vec2f half{0.5f * piece.size_m.x, 0.5f * piece.size_m.z};
    HeightMap map;
    map.cell_m = 2 * std::max(half.x, half.y) / kHeightCells;
    map.corner = Vec2f{} - half;
    const auto cells = [&](float extent) { return std::max(1, static_cast<int>(std::ceil(2 * extent / map.cell_m))); };
    map.height = ImageF(cells(half.x), cells(half.y), 0.f);
    for (const Mesh& mesh : piece.meshes)
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
            const Vec3f p[3] = {mesh.positions[mesh.triangles[t]], mesh.positions[mesh.triangles[t + 1]],
                                mesh.positions[mesh.triangles[t + 2]]};
            const auto cell = [&](float v, float corner) { return (v - corner) / map.cell_m - 0.5f; };
            const Vec2f a{cell(p[0].x, map.corner.x), cell(p[0].z, map.corner.y)},
                b{cell(p[1].x, map.corner.x), cell(p[1].z, map.corner.y)},
                c{cell(p[2].x, map.corner.x), cell(p[2].z, map.corner.y)};
            const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
            if (std::abs(area) < 1e-9f) continue;  // upright
            const int left = std::max(0, static_cast<int>(std::ceil(std::min({a.x, b.x, c.x})))),
                      right = std::min(map.height.width - 1, static_cast<int>(std::max({a.x, b.x, c.x}))),
                      top = std::max(0, static_cast<int>(std::ceil(std::min({a.y, b.y, c.y})))),
                      bottom = std::min(map.height.height - 1, static_cast<int>(std::max({a.y, b.y, c.y})));
            for (int y = top; y <= bottom; ++y)
                for (int x = left; x <= right; ++x) {
                    const Vec2f q{static_cast<float>(x), static_cast<float>(y)};
                    const float u = ((q.x - a.x) * (c.y - a.y) - (q.y - a.y) * (c.x - a.x)) / area,
                                v = ((b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x)) / area;
                    if (u < 0 || v < 0 || u + v > 1) continue;
                    const float height = p[0].y + u * (p[1].y - p[0].y) + v * (p[2].y - p[0].y);
                    map.height.at(x, y) = std::max(map.height.at(x, y), height);
                }
        }
    return map;
}

struct Rectangle {
    int left = 0, top = 0, right = 0, bottom = 0;  // cells; right and bottom excluded
    int cells() const { return (right - left) * (bottom - top); }
};

// The largest rectangle of set cells: of each row, a stack of the columns' heights.
Rectangle largest_rectangle(const ImageMask& set) {
    Rectangle best;
    std::vector<int> tall(static_cast<std::size_t>(set.width) + 1, 0);
    for (int y = 0; y < set.height; ++y) {
        for (int x = 0; x < set.width; ++x) {
            int& t = tall[static_cast<std::size_t>(x)];
            t = set.at(x, y) ? t + 1 : 0;
        }
        std::vector<int> open;  // columns whose heights grow
        for (int x = 0; x <= set.width; ++x) {
            while (!open.empty() && tall[static_cast<std::size_t>(open.back())] >= tall[static_cast<std::size_t>(x)]) {
                const int height = tall[static_cast<std::size_t>(open.back())];
                open.pop_back();
                const Rectangle found{open.empty() ? 0 : open.back() + 1, y + 1 - height, x, y + 1};
                if (found.cells() > best.cells()) best = found;
            }
            open.push_back(x);
        }
    }
    return best;
}

}  // namespace

std::vector<Surface> tops_of(const Piece& piece) {
    const HeightMap map = height_map(piece);
    // The heights at which there is most area, in steps of what counts as flat.
    std::vector<int> histogram(static_cast<std::size_t>(kHigh_m / kFlat_m) + 2, 0);
    for (const float h : map.height.pixels)
        if (h >= kLow_m && h <= kHigh_m) ++histogram[static_cast<std::size_t>(h / kFlat_m)];
    std::vector<Surface> tops;
    while (tops.size() < kMostTops) {
        const auto most = std::max_element(histogram.begin(), histogram.end());
        if (*most == 0) break;
        const float level = (static_cast<float>(most - histogram.begin()) + 0.5f) * kFlat_m;
        for (auto near = most - (most != histogram.begin()); near != histogram.end() && near <= most + 1; ++near)
            *near = 0;
        ImageMask flat(map.height.width, map.height.height);
        for (std::size_t i = 0; i < flat.size(); ++i)
            flat.pixels[i] = std::abs(map.height.pixels[i] - level) <= kFlat_m;
        const Rectangle r = largest_rectangle(flat);
        const Vec2f half{0.5f * static_cast<float>(r.right - r.left) * map.cell_m - kMargin_m,
                         0.5f * static_cast<float>(r.bottom - r.top) * map.cell_m - kMargin_m};
        if (2 * half.x < kLeastWidth_m || 2 * half.y < kLeastDepth_m) continue;
        float height = 0;
        for (int y = r.top; y < r.bottom; ++y)
            for (int x = r.left; x < r.right; ++x) height = std::max(height, map.height.at(x, y));
        tops.push_back({{map.corner.x + 0.5f * static_cast<float>(r.left + r.right) * map.cell_m, height,
                         map.corner.y + 0.5f * static_cast<float>(r.top + r.bottom) * map.cell_m},
                        half});
    }
    std::sort(tops.begin(), tops.end(),
              [](const Surface& a, const Surface& b) { return a.half.x * a.half.y > b.half.x * b.half.y; });
    return tops;
}

}  // namespace fastscene
