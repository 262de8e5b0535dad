// Standable floor: a grid of where a person can stand in a room. World frame (x right, y down, z forward, metres).
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/math/vec.h"

namespace fastscene {

struct StandableFloor {
    Vec2f corner_m;  // (x, z) of the outer corner of cell (0, 0)
    float cell_m = 0.1f;
    int columns = 0;                      // along x
    int rows = 0;                         // along z
    float floor_y = 0;                    // of the lowest floor; y points down
    std::vector<std::uint8_t> standable;  // rows x columns; nonzero: one can stand at the cell's center
    std::vector<float> level_y;           // of the floor in each cell; empty: floor_y everywhere

    bool at(int column, int row) const {
        return column >= 0 && row >= 0 && column < columns && row < rows &&
               standable[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                         static_cast<std::size_t>(column)] != 0;
    }
    float level_at(int column, int row) const {
        return level_y.empty() ? floor_y
                               : level_y[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                                         static_cast<std::size_t>(column)];
    }
    Vec2f center(int column, int row) const {
        return {corner_m.x + (static_cast<float>(column) + 0.5f) * cell_m,
                corner_m.y + (static_cast<float>(row) + 0.5f) * cell_m};
    }
};

// (column, row) of every standable cell, row by row.
struct FloorCell {
    int column = 0, row = 0;
    friend bool operator==(FloorCell, FloorCell) = default;
};
std::vector<FloorCell> standable_cells(const StandableFloor& floor);
// The heights (world y) of the standable cells, each once, from the lowest floor up; floor_y alone if it is level.
std::vector<float> levels_of(const StandableFloor& floor);
// The cells of one of those heights alone.
StandableFloor at_level(const StandableFloor& floor, float y);
// Square metres.
double standable_area_m2(const StandableFloor& floor);

// Outlines of the standable cells: closed polygons (x, z) along cell edges, without repeated or collinear vertices,
// largest first. Outer rings and holes (furniture that one walks around) have opposite orientations; the even-odd rule
// gives the standable area. Cells that touch only at a corner belong to different rings.
std::vector<std::vector<Vec2f>> outlines(const StandableFloor& floor);

}  // namespace fastscene
