// Recipes: what stands in a room of a type, step by step, as `[[recipe]]` in the type's file says it.
// docs/extend/room-type.md lists the steps and their keys.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fastscene/io/toml_table.h"

namespace fastscene {

namespace furnishing {
struct StepKind;
}

// When a step is done. Each list holds things; an empty one says nothing.
struct StepConditions {
    bool only_asked = false;                 // the step's thing was asked for
    std::vector<std::string> if_asked;       // one of these was asked for
    std::vector<std::string> if_not_asked;   // none of these was
    std::vector<std::string> if_to_place;    // one of these was asked for and does not stand yet
    std::vector<std::string> if_placed;      // one of these stands
    std::vector<std::string> if_not_placed;  // none of these does
    // Like if_not_asked and if_not_placed, but what was asked for itself comes nevertheless.
    std::vector<std::string> unless_asked, unless_placed;
};

struct RecipeStep {
    const furnishing::StepKind* kind = nullptr;  // `do`
    StepConditions when;
    bool late = false;            // once all that was asked for stands
    std::vector<std::string> at;  // the first of these that stands is the piece to stand at
    int count = 1;                // how many times

    std::string thing;
    std::vector<std::string> first_asked;  // the first of these that was asked for comes in place of the thing
    std::string other;                     // comes in place of the thing, unless with probability thing_share
    float thing_share = 1;
    float probability = 1;
    bool by_clutter = false;  // the probability is multiplied by the room's clutter, from 0 to 1
    bool needed = false;      // the room is not that room without it: placed at once, before what was asked for besides

    float center_pull = 1, window_pull = 0;  // along walls: to their middle; to windows, or away from them (< 0)
    bool corner = false;
    int side = 0;  // beside a piece: -1 left, 1 right, 0 either
    float gap_m = 0;
    bool facing = false;  // before a piece: turned to it
    float width_m = 2, depth_m = 1.4f;
    float shift_m = 0;       // of a rug: from the middle of its piece to the front
    bool from_edge = false;  // … measured from the piece's front edge
    int seats = 2;           // usual number
    // Of patterns (layout_patterns.h), metres where no unit is said.
    std::string pattern;                  // of the thing, where the prompt says none: what a poster is about
    std::string seat;                     // comes with each piece
    std::string back;                     // stands at the wall behind
    int towards = 0;                      // the wall that rows look at: 0 far, 1 right, 2 near, 3 left
    std::vector<int> walls{0, 1, 3};      // at which walls, in this order
    float pitch_m = 0;                    // from one row, lamp or seat to the next
    float rise_m = 0;                     // from one row to the next behind it: they stand on tiers (Plan::platforms)
    float aisle_m = 0;                    // down the middle
    float side_m = 0.35f;                 // free at both ends of rows, and at the ends of a counter
    float front_m = 1.5f, rear_m = 0.8f;  // free before the first row and behind the last
    float off_m = 0;                      // from the wall
    float length_m = 0;                   // at most
    int rows = 0, block = 0, most = 0;    // at most; 0: as many as fit
    bool alike = false;                   // one is like the other
    bool fill = false;                    // as large as the cell of the grid that it hangs in: vaults
    std::vector<RecipeStep> then;         // at the piece that was placed
};

// Whether a pattern of the recipe sets as many of this kind as there is room for: seats in rows, chairs at tables.
bool sets_many(const std::vector<RecipeStep>& recipe, std::string_view kind);

// The steps of a list of tables. Throws Error naming file, line and key for what is unknown, missing or out of range.
std::vector<RecipeStep> read_recipe(const TomlTable& table, std::string_view key);

}  // namespace fastscene
