#include "fastscene/scene/standable_floor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "fastscene/scene/walkable.h"

namespace fastscene {
namespace {

// A corner of the grid.
struct Corner {
    int x = 0, z = 0;
    friend auto operator<=>(const Corner&, const Corner&) = default;
    friend bool operator==(const Corner&, const Corner&) = default;
};
// Unit steps along the grid, each rotated left from the previous one, with x to the right and z up.
constexpr std::array<Corner, 4> kSteps{Corner{1, 0}, Corner{0, 1}, Corner{-1, 0}, Corner{0, -1}};

// Bit mask per corner of the directions in which boundary edges leave it. Edges have the standable cell on their left.
std::map<Corner, unsigned> boundary_edges(const StandableFloor& floor) {
    std::map<Corner, unsigned> edges;
    for (const auto& [i, j] : standable_cells(floor)) {
        if (!floor.at(i, j - 1)) edges[{i, j}] |= 1u << 0;
        if (!floor.at(i + 1, j)) edges[{i + 1, j}] |= 1u << 1;
        if (!floor.at(i, j + 1)) edges[{i + 1, j + 1}] |= 1u << 2;
        if (!floor.at(i - 1, j)) edges[{i, j + 1}] |= 1u << 3;
    }
    return edges;
}

}  // namespace

std::vector<FloorCell> standable_cells(const StandableFloor& floor) {
    std::vector<FloorCell> cells;
    for (int row = 0; row < floor.rows; ++row)
        for (int column = 0; column < floor.columns; ++column)
            if (floor.at(column, row)) cells.push_back({column, row});
    return cells;
}

std::vector<float> levels_of(const StandableFloor& floor) {
    if (floor.level_y.empty()) return {floor.floor_y};
    std::vector<float> levels;
    for (const FloorCell cell : standable_cells(floor)) levels.push_back(floor.level_at(cell.column, cell.row));
    std::sort(levels.begin(), levels.end(), std::greater<>());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    return levels;
}

StandableFloor at_level(const StandableFloor& floor, float y) {
    StandableFloor out = floor;
    out.floor_y = y;
    out.level_y.clear();
    for (const FloorCell cell : standable_cells(floor))
        if (floor.level_at(cell.column, cell.row) != y)
            out.standable[static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(floor.columns) +
                          static_cast<std::size_t>(cell.column)] = 0;
    return out;
}

double standable_area_m2(const StandableFloor& floor) {
    return static_cast<double>(standable_cells(floor).size()) * static_cast<double>(floor.cell_m) *
           static_cast<double>(floor.cell_m);
}

std::vector<std::vector<Vec2f>> outlines(const StandableFloor& floor) {
    std::map<Corner, unsigned> edges = boundary_edges(floor);
    std::vector<std::vector<Vec2f>> rings;
    while (!edges.empty()) {
        const Corner start = edges.begin()->first;
        Corner at = start;
        unsigned direction = 0;
        while (!(edges.begin()->second >> direction & 1u)) ++direction;
        std::vector<Vec2f> ring;
        unsigned before = 4;  // none
        do {
            const auto leaving = edges.find(at);
            // Where two cells touch only at a corner, turning left stays with the same cell.
            if (before < 4)
                for (const unsigned turn : {1u, 0u, 3u})
                    if (leaving->second >> ((before + turn) % 4) & 1u) {
                        direction = (before + turn) % 4;
                        break;
                    }
            if (direction != before)
                ring.push_back({floor.corner_m.x + static_cast<float>(at.x) * floor.cell_m,
                                floor.corner_m.y + static_cast<float>(at.z) * floor.cell_m});
            leaving->second &= ~(1u << direction);
            if (leaving->second == 0) edges.erase(leaving);
            at = {at.x + kSteps[direction].x, at.z + kSteps[direction].z};
            before = direction;
        } while (at != start);
        rings.push_back(std::move(ring));
    }
    std::stable_sort(rings.begin(), rings.end(), [](const auto& a, const auto& b) {
        return std::fabs(signed_area(a)) > std::fabs(signed_area(b));
    });
    return rings;
}

}  // namespace fastscene
