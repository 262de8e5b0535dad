#include "fastscene/trace/standable.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fastscene/base/parallel.h"
#include "fastscene/scene/raised_floor.h"

namespace fastscene {
namespace {

constexpr float kCell_m = 0.1f;
constexpr float kStart_m = 1.5f;     // metres: the walk must be able to start this close to panorama 0
constexpr float kLargest_m = 200.f;  // metres: limit of the grid's side

// Bounding rectangle on the floor of everything in the room, adjoining rooms included.
struct Extent {
    Vec2f low{1e9f, 1e9f}, high{-1e9f, -1e9f};
};
Extent extent_of(const Room& room) {
    Extent e;
    for (const Mesh& mesh : room.meshes)
        for (const Vec3f p : mesh.positions) {
            e.low = {std::min(e.low.x, p.x), std::min(e.low.y, p.z)};
            e.high = {std::max(e.high.x, p.x), std::max(e.high.y, p.z)};
        }
    const auto held = [](float v) { return std::clamp(v, -kLargest_m / 2, kLargest_m / 2); };
    return {{held(e.low.x), held(e.low.y)}, {held(e.high.x), held(e.high.y)}};
}

// Heights above the floor of a column of balls of this radius that covers the body from `step_over_m` to its head.
std::vector<float> ball_heights(const Body& body, float radius_m) {
    const float lowest = body.step_over_m + radius_m, highest = body.height_m - radius_m;
    const int steps = std::max(1, static_cast<int>(std::ceil((highest - lowest) / (0.8f * radius_m))));
    std::vector<float> heights;
    for (int k = 0; k <= steps; ++k)
        heights.push_back(lowest + (highest - lowest) * static_cast<float>(k) / static_cast<float>(steps));
    return heights;
}

// Where one climbs, legs are not stopped by the next step: the body is free above this height.
constexpr float kClimb_m = 0.25f;

// The free radius around a body at a point of the floor, up to its `clear_m`; 0 where it does not fit.
float free_radius(const TracedRoom& room, const Body& body, const std::vector<float>& heights, Vec2f at,
                  float floor_y) {
    // There must be a floor below, which also excludes points outside the walls.
    constexpr float kOnFloor_m = Body{}.step_over_m + 0.01f;
    const float low = heights.front();
    const float down = room.distance({at.x, floor_y - low, at.y}, {0, 1, 0});
    if (!(std::fabs(down - low) < kOnFloor_m)) return 0;
    float least = body.clear_m;
    for (const float h : heights) {
        // A wider ball would touch the floor.
        const float limit = std::min(body.clear_m, h - body.step_over_m);
        const float free = room.clearance({at.x, floor_y - h, at.y}, limit);
        if (free < body.pass_m) return 0;
        if (free < limit) least = std::min(least, free);
    }
    return least;
}

// Keeps the cells that can be reached, from neighbour to neighbour, from the standable cell nearest to the origin.
void keep_reachable(StandableFloor& floor) {
    const std::vector<FloorCell> cells = standable_cells(floor);
    FloorCell start{-1, -1};
    float nearest = kStart_m;
    for (const FloorCell c : cells)
        if (const float far = length(floor.center(c.column, c.row)); far < nearest) nearest = far, start = c;
    const std::vector<std::uint8_t> free = std::move(floor.standable);
    floor.standable.assign(free.size(), 0);
    if (start.column < 0) return;
    const auto index = [&](FloorCell c) {
        return static_cast<std::size_t>(c.row) * static_cast<std::size_t>(floor.columns) +
               static_cast<std::size_t>(c.column);
    };
    std::vector<FloorCell> todo{start};
    floor.standable[index(start)] = 1;
    while (!todo.empty()) {
        const FloorCell c = todo.back();
        todo.pop_back();
        for (const FloorCell n : {FloorCell{c.column - 1, c.row}, FloorCell{c.column + 1, c.row},
                                  FloorCell{c.column, c.row - 1}, FloorCell{c.column, c.row + 1}}) {
            if (n.column < 0 || n.row < 0 || n.column >= floor.columns || n.row >= floor.rows || !free[index(n)] ||
                floor.at(n.column, n.row) ||
                std::fabs(floor.level_at(n.column, n.row) - floor.level_at(c.column, c.row)) > kClimb_m)
                continue;
            floor.standable[index(n)] = 1;
            todo.push_back(n);
        }
    }
}

}  // namespace

StandableFloor standable_floor(const TracedRoom& room, const Body& given) {
    const Extent extent = extent_of(room.room());
    StandableFloor floor;
    floor.cell_m = kCell_m;
    floor.floor_y = room.room().max_corner.y;
    // The grid is aligned to the origin, the same in every room.
    const auto first = [](float low) { return std::floor(low / kCell_m); };
    floor.corner_m = {first(extent.low.x) * kCell_m, first(extent.low.y) * kCell_m};
    floor.columns = std::max(0, static_cast<int>(std::ceil((extent.high.x - floor.corner_m.x) / kCell_m)));
    floor.rows = std::max(0, static_cast<int>(std::ceil((extent.high.y - floor.corner_m.y) / kCell_m)));
    floor.standable.assign(static_cast<std::size_t>(floor.columns) * static_cast<std::size_t>(floor.rows), 0);
    const bool raised = has_raised_floor(room.room());
    Body body = given;
    if (raised) {
        floor.level_y.assign(floor.standable.size(), floor.floor_y);
        body.step_over_m = std::max(body.step_over_m, kClimb_m);
    }
    const std::vector<float> heights = ball_heights(body, body.pass_m);
    std::vector<float> radii(floor.standable.size());
    parallel_for(floor.rows, 1, [&](std::int64_t begin, std::int64_t end) {
        for (auto row = static_cast<int>(begin); row < end; ++row)
            for (int column = 0; column < floor.columns; ++column) {
                const auto cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(floor.columns) +
                                  static_cast<std::size_t>(column);
                const Vec2f at = floor.center(column, row);
                const float level = raised ? floor_at(room.room(), at) : floor.floor_y;
                if (raised) floor.level_y[cell] = level;
                radii[cell] = free_radius(room, body, heights, at, level);
                floor.standable[cell] = radii[cell] > 0;
            }
    });
    keep_reachable(floor);
    for (std::size_t cell = 0; cell < radii.size(); ++cell)
        floor.standable[cell] = floor.standable[cell] && radii[cell] >= body.clear_m;
    return floor;
}

}  // namespace fastscene
