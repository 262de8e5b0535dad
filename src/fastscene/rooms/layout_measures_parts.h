// What the sources of layout_measures.h share.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "fastscene/rooms/layout_measures.h"

namespace fastscene::measuring {

using Corners = std::array<Vec3f, 3>;

struct Extents {
    Vec3f low{1e9f, 1e9f, 1e9f}, high{-1e9f, -1e9f, -1e9f};
    void add(Vec3f p) {
        for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
    }
    bool meets(const Extents& o) const {
        return low.x <= o.high.x && high.x >= o.low.x && low.y <= o.high.y && high.y >= o.low.y && low.z <= o.high.z &&
               high.z >= o.low.z;
    }
    bool within(const Extents& o) const {
        return low.x >= o.low.x && low.y >= o.low.y && low.z >= o.low.z && high.x <= o.high.x && high.y <= o.high.y &&
               high.z <= o.high.z;
    }
};

// A piece as triangles in the room frame.
struct Solid {
    int piece = 0;  // index into `placed`
    Extents box;
    std::vector<Corners> triangles;
};
std::vector<Solid> solids_of(const std::vector<Placed>& placed);
std::string name_of_piece(const std::vector<Placed>& placed, int piece);

// The part of a polygon on the side of a plane where the coordinate is at least (`above`) or at most `at`.
std::vector<Vec3f> clipped(const std::vector<Vec3f>& polygon, std::size_t axis, float at, bool above);
// Whether the point (x, z) is floor: within the plan's outline, out of its blocks; `slack` metres beyond still are.
bool is_floor(const Plan& plan, Vec2f point, float slack = 0);

bool collide(const Solid& a, const Solid& b);

// A map of cells: sets those whose middle the polygon (x, y) covers, and those along its edges.
struct CellMap {
    Vec2f origin;
    float cell = 0.02f;
    int columns = 0, rows = 0;
    std::vector<char> set{};
    CellMap(Vec2f low, Vec2f high, float cell_m);
    void mark(Vec2f p);
    void fill(const std::vector<Vec2f>& polygon);
};

// The largest connected share of the free floor.
double navigability_of(const Plan& plan, const std::vector<Placed>& placed, const std::vector<Solid>& solids,
                       std::vector<LayoutFinding>& findings);

}  // namespace fastscene::measuring
