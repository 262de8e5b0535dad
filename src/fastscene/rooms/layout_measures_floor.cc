// Where one can walk, on a fine grid over the floor.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_measures_parts.h"

namespace fastscene::measuring {
namespace {

constexpr float kAgent = 0.1f;           // metres: half the width of who walks; SceneEval's robot is 0.2 m wide
constexpr float kStepOver = 0.05f;       // metres above the floor: one walks on it or over it
constexpr float kHead = 2.f;             // metres above the floor: what hangs higher is in nobody's way
constexpr float kGrid = 0.02f;           // metres
constexpr float kWorthTelling = 0.005f;  // share of the free floor: smaller parts are in no report

// Everything within `radius` of what is set, too.
void widen(CellMap& map, float radius) {
    const int reach = static_cast<int>(radius / map.cell);
    std::vector<std::pair<int, int>> disc;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x)
            if (std::hypot(static_cast<float>(x), static_cast<float>(y)) * map.cell <= radius) disc.push_back({x, y});
    const std::vector<char> before = map.set;
    const auto is_set = [&](int x, int y) {
        return x < 0 || y < 0 || x >= map.columns || y >= map.rows ||
               before[static_cast<std::size_t>(y * map.columns + x)] != 0;
    };
    for (int y = 0; y < map.rows; ++y)
        for (int x = 0; x < map.columns; ++x) {
            if (!is_set(x, y) || (is_set(x - 1, y) && is_set(x + 1, y) && is_set(x, y - 1) && is_set(x, y + 1)))
                continue;
            for (const auto& [dx, dy] : disc) {
                const int i = x + dx, j = y + dy;
                if (i >= 0 && j >= 0 && i < map.columns && j < map.rows)
                    map.set[static_cast<std::size_t>(j * map.columns + i)] = 1;
            }
        }
}

struct Part {
    int cells = 0;
    Vec2f middle;
};

// Connected parts of the cells that are not set, over edges and corners; never over a step that is too high.
std::vector<Part> parts_of(const CellMap& map, const std::vector<float>& floor) {
    std::vector<char> seen = map.set;
    std::vector<Part> parts;
    std::vector<int> open;
    for (int start = 0; start < map.columns * map.rows; ++start) {
        if (seen[static_cast<std::size_t>(start)]) continue;
        seen[static_cast<std::size_t>(start)] = 1;
        open.assign(1, start);
        Part part;
        while (!open.empty()) {
            const int at = open.back(), x = at % map.columns, y = at / map.columns;
            open.pop_back();
            ++part.cells;
            part.middle = part.middle + Vec2f{static_cast<float>(x), static_cast<float>(y)};
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const int i = x + dx, j = y + dy;
                    if (i < 0 || j < 0 || i >= map.columns || j >= map.rows) continue;
                    const auto to = static_cast<std::size_t>(j * map.columns + i);
                    constexpr float kRounding = 0.001f;
                    if (seen[to] || (!floor.empty() &&
                                     std::abs(floor[to] - floor[static_cast<std::size_t>(at)]) > kMostStep + kRounding))
                        continue;
                    seen[to] = 1;
                    open.push_back(static_cast<int>(to));
                }
        }
        part.middle = map.origin +
                      (part.middle * (1.f / static_cast<float>(part.cells)) + Vec2f{0.5f, 0.5f}) * map.cell;
        parts.push_back(part);
    }
    return parts;
}

}  // namespace

CellMap::CellMap(Vec2f low, Vec2f high, float cell_m)
    : origin(low),
      cell(cell_m),
      columns(std::max(1, static_cast<int>(std::ceil((high.x - low.x) / cell_m)))),
      rows(std::max(1, static_cast<int>(std::ceil((high.y - low.y) / cell_m)))),
      set(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0) {}

void CellMap::mark(Vec2f p) {
    const int x = static_cast<int>(std::floor((p.x - origin.x) / cell)),
              y = static_cast<int>(std::floor((p.y - origin.y) / cell));
    if (x >= 0 && y >= 0 && x < columns && y < rows) set[static_cast<std::size_t>(y * columns + x)] = 1;
}

void CellMap::fill(const std::vector<Vec2f>& polygon) {
    if (polygon.empty()) return;
    Vec2f low = polygon[0], high = polygon[0];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2f from = polygon[i], along = polygon[(i + 1) % polygon.size()] - from;
        low = {std::min(low.x, from.x), std::min(low.y, from.y)};
        high = {std::max(high.x, from.x), std::max(high.y, from.y)};
        const int steps = 1 + static_cast<int>(2 * length(along) / cell);
        for (int s = 0; s < steps; ++s) mark(from + along * (static_cast<float>(s) / static_cast<float>(steps)));
    }
    const auto index = [&](float at, float from, int most) {
        return std::clamp(static_cast<int>(std::floor((at - from) / cell)), 0, most - 1);
    };
    const int x0 = index(low.x, origin.x, columns), x1 = index(high.x, origin.x, columns),
              y0 = index(low.y, origin.y, rows), y1 = index(high.y, origin.y, rows);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const Vec2f p = origin + Vec2f{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f} * cell;
            bool left = true, right = true;  // of all edges: the polygon is convex
            for (std::size_t i = 0; i < polygon.size() && (left || right); ++i) {
                const Vec2f a = polygon[i], e = polygon[(i + 1) % polygon.size()] - a, to = p - a;
                const float side = e.x * to.y - e.y * to.x;
                left = left && side >= 0, right = right && side <= 0;
            }
            if (left || right) set[static_cast<std::size_t>(y * columns + x)] = 1;
        }
}

double navigability_of(const Plan& plan, const std::vector<Placed>& placed, const std::vector<Solid>& solids,
                       std::vector<LayoutFinding>& findings) {
    // With a border of walls.
    const Vec2f half{plan.width / 2 + 2 * kGrid, plan.depth / 2 + 2 * kGrid};
    CellMap map(half * -1.f, half, kGrid);
    std::vector<float> floor;
    const bool levels = !plan.platforms.empty();
    for (int y = 0; y < map.rows; ++y)
        for (int x = 0; x < map.columns; ++x) {
            const Vec2f p = map.origin + Vec2f{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f} * kGrid;
            if (!is_floor(plan, p)) map.mark(p);
            if (levels) floor.push_back(plan.floor_at(p));
        }
    for (const Solid& solid : solids) {
        if (placed[static_cast<std::size_t>(solid.piece)].flat) continue;
        for (const Corners& t : solid.triangles) {
            const Vec3f middle = (t[0] + t[1] + t[2]) / 3.f;
            const float ground = levels ? plan.floor_at({middle.x, middle.z}) : 0.f;
            const auto band = clipped(clipped({t.begin(), t.end()}, 1, ground + kStepOver, true), 1, ground + kHead,
                                      false);
            std::vector<Vec2f> shadow;
            for (const Vec3f p : band) shadow.push_back({p.x, p.z});
            map.fill(shadow);
        }
    }
    widen(map, kAgent);
    const std::vector<Part> parts = parts_of(map, floor);
    int all = 0, largest = 0;
    for (const Part& part : parts) all += part.cells, largest = std::max(largest, part.cells);
    if (all == 0) {
        findings.push_back({"unreachable", "nowhere can anybody stand"});
        return 0;
    }
    for (const Part& part : parts)
        if (part.cells != largest && static_cast<float>(part.cells) > kWorthTelling * static_cast<float>(all))
            findings.push_back(
                {"unreachable",
                 fmt::format("{:.2f} m² of {:.2f} m² at {:.1f}, {:.1f}", static_cast<float>(part.cells) * kGrid * kGrid,
                             static_cast<float>(all) * kGrid * kGrid, part.middle.x, part.middle.y)});
    return static_cast<double>(largest) / all;
}

}  // namespace fastscene::measuring
