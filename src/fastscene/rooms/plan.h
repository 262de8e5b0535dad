// Plan: the empty room. Room frame: x right, y UP, z towards the far wall, metres; the floor is y = 0 and the plan's
// center is the origin. Walls are numbered 0 far (+z), 1 right (+x), 2 near (-z), 3 left (-x).
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/random.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/rooms/style.h"

namespace fastscene {

inline constexpr float kWallThickness = 0.22f;

// A hole in a wall (window), or a door leaf set before it. `u` runs along the wall from its left end as seen from inside.
struct Opening {
    enum class Kind : unsigned char { window, door } kind = Kind::window;
    int wall = 0;
    float u0 = 0, u1 = 0, y0 = 0, y1 = 0;
    bool requested = false;
    std::string color;
};

// The inner face of a wall.
struct WallFace {
    Vec3f origin;   // its left end at the floor, as seen from inside
    Vec3f along;    // unit, to the right as seen from inside
    Vec3f inward;   // unit, into the room
    float length;
    Vec3f point(float u, float y) const { return origin + along * u + Vec3f{0, y, 0}; }
};

struct Plan {
    float width = 4, depth = 5, height = 2.7f;   // inside
    std::vector<Opening> openings;
    Style style;                                 // with the prompt's wishes for walls, floor and so on worked in
    bool accent = false;                         // wall 0 has the accent material
    bool beams = false;

    WallFace wall(int i) const;
};

// Size, openings and surfaces from what the prompt asks and the room's type; the rest is drawn from `dice`.
// Adds to spec.assumed what it chose.
Plan make_plan(PromptSpec& spec, Random& dice);

// Walls, floor, ceiling, mouldings, window frames, door: meshes in the room frame. Materials and objects are appended to
// `room` (objects still with room-frame poses), portals too.
void build_shell(const Plan& plan, Room& room);

}  // namespace fastscene
