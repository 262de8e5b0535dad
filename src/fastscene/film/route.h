// Routes over the walkable floor for a film's camera: shortest ways that keep away from furniture, and the smooth curve
// along them.
#pragma once

#include <vector>

#include "fastscene/scene/walkable.h"

namespace fastscene {

// Metres from a floor point to the nearest edge of the area; negative outside.
float clearance(const WalkableArea& area, Vec2f point);

// The floor in cells, those that can be walked to from a starting point.
class FloorGrid {
  public:
    // Throws Error if the area has no floor.
    FloorGrid(const WalkableArea& area, Vec2f start);

    const std::vector<Vec2f>& places() const { return places_; }           // centers of all cells
    float clearance_at(std::size_t place) const { return clear_[place]; }  // metres to the edge
    std::size_t nearest(Vec2f point) const;                                // the place nearest to a point
    // Costs of the ways from a place to all others, in metres that count more beside an edge; `before` gives each
    // place's predecessor.
    struct Ways {
        std::vector<float> cost;
        std::vector<std::size_t> before;
    };
    Ways ways_from(std::size_t place) const;
    // The places along the way that ways_from(…) found, from its start to `to`.
    std::vector<Vec2f> way(const Ways& ways, std::size_t to) const;

  private:
    std::vector<std::size_t> neighbours(std::size_t place) const;

    Vec2f corner_{};
    int columns_ = 0, rows_ = 0;
    std::vector<int> place_of_cell_;  // -1: cannot be walked to
    std::vector<std::size_t> cell_of_place_;
    std::vector<Vec2f> places_;
    std::vector<float> clear_;
};

// A smooth curve near a way, in steps of about kCurveStep_m: first and last point stay, and it comes no nearer to an
// edge than the way itself or kCurveMargin_m.
inline constexpr float kCurveStep_m = 0.04f, kCurveMargin_m = 0.12f;
std::vector<Vec2f> smooth_curve(const WalkableArea& area, const std::vector<Vec2f>& way);

}  // namespace fastscene
