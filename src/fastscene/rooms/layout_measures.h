// What SceneEval (Tam et al. 2025) measures of a layout without a language model, and whether a form stands twice in a
// room. A check from without: it looks at the triangles of the pieces and at the plan's outline, and shares no rule
// with the layout (layout_place.h) nor with its validator (validate.h).
#pragma once

#include <string>
#include <vector>

#include "fastscene/rooms/layout.h"

namespace fastscene {

// What counts against a room: "collision", "outside", "opening", "unreachable", "repeat".
struct LayoutFinding {
    std::string measure, text;
};

// Of one room, or of many together.
struct LayoutMeasures {
    int rooms = 0, pieces = 0;
    int colliding = 0, outside = 0;         // pieces
    int rooms_colliding = 0;                // rooms with any such pair
    double navigability = 0;                // sum over the rooms: the largest connected part of the free floor
    int openings = 0, clear = 0;            // doors and windows, and those that are clear
    int untouched = 0;                      // … and those that nothing at all stands before
    double opening_m2 = 0, covered_m2 = 0;  // their area, and what of it is covered
    int repeats = 0;                        // things that look like an earlier one of the room, and are no set with it
    std::vector<LayoutFinding> findings;    // of one room

    void add(const LayoutMeasures& other);  // all but the findings
};

// Pieces collide when their triangles cut each other, or one lies within the other, and still do after one of them was
// moved by 5 mm, whichever way. What stands on a carpet may stand in its pile.
// A piece is outside when more than 1 % of its surface is not over the floor plan (with the reveals of its windows).
// Free floor: what someone 0.2 m wide can stand on, with nothing between 5 cm and 2 m above it; carpets are walked on.
// A step of up to kMostStep connects two levels.
// Before an opening is a box: as deep as a door is wide, 0.8 m where no leaf swings (doorways, sliding doors), 0.5 m at
// a window. A door is clear when nothing is in it, a window when what is in it covers at most 5 % of it: a sofa's back
// may reach above its sill. Curtains, blinds, what stands on the sill and the building's own railing belong to a
// window; one walks over a mat before a door.
LayoutMeasures measure_layout(const Plan& plan, const std::vector<Placed>& placed);

}  // namespace fastscene
