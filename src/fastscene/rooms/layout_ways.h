// Ways: where one can walk between the furniture, on a grid over the floor. A room is good when one can go from its
// door to a spot where the camera has air around it.
#pragma once

#include <vector>

#include "fastscene/rooms/plan.h"

namespace fastscene {

inline constexpr float kEyeHeight = 1.5f;  // of the camera, metres above the floor

// Floor that furniture may cut off, in no room's way: a corner beside a nightstand, in m², or in a large room this
// share of its free floor.
inline constexpr float kFewCutOff = 0.15f, kShareCutOff = 0.012f;

struct Placed;

// How much room one needs who walks through, and the camera that looks from there; metres.
struct Passage {
    float body_radius = 0.27f;  // a walkway of about 0.55 m
    float eye_radius = 0.65f;   // air that the camera wants around it
};

class Ways {
  public:
    explicit Ways(const Plan& plan, const Passage& passage = {});

    void add(const Placed& placed);
    // Whether a way from the door (without a door: any way) leads to a spot for the camera.
    bool open() const { return open_; }
    // … and still would with this piece.
    bool open_with(const Placed& extra) const;
    // Floor, in square metres, where somebody slim could stand, and that no way of a slim body's width connects with
    // the largest part of it; and whether this piece would leave more of it than a room may have.
    float cut_off() const { return cut_off(cells_).apart; }
    float free_floor() const { return cut_off(cells_).all; }
    bool cuts_off(const Placed& extra) const;
    // Whether one can walk from the door to within half a step of this point.
    bool reaches(Vec2f point) const;

  private:
    // Distances of a cell's center to the nearest thing: at the feet, and around the eyes; and at the feet of who steps
    // over nothing.
    struct Clear {
        float feet, eyes, ground;
    };
    Vec2f center(int i, int j) const;
    float floor_of(int cell) const { return floors_.empty() ? 0.f : floors_[static_cast<std::size_t>(cell)]; }
    int cell_near(Vec2f point) const;
    struct FreeFloor {
        float all, apart;  // m²
    };
    FreeFloor cut_off(const std::vector<Clear>& cells) const;
    // Says whether a cell where one could walk or look from is none any more.
    bool narrow(std::vector<Clear>& cells, const Placed& placed) const;
    std::vector<char> walked(const std::vector<Clear>& cells) const;
    bool leads_to_a_view(const std::vector<Clear>& cells, const std::vector<char>& walked) const;

    const Plan* plan_;
    Passage passage_;
    int columns_, rows_;
    std::vector<Clear> cells_;
    std::vector<float> floors_;  // height of each cell; empty: the floor is level
    std::vector<int> starts_;    // cells before the door
    std::vector<int> goals_;     // … and before a doorway, which must be reached too
    std::vector<char> walked_;
    bool open_ = false;
};

}  // namespace fastscene
