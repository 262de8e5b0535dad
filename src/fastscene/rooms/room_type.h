// Room types: what a room of a kind is like, whatever its style. A type is a file, room_types/NAME.toml.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/rooms/recipe.h"
#include "fastscene/rooms/style_choices.h"

namespace fastscene {

struct RoomType {
    std::string name, title;  // "living", "living room"
    int rank = 0;             // place among room_types(); the first stands in for unknown ones
    bool wet = false;         // tiled; no paper, no boards on its ceiling
    bool for_children = false;
    bool deep_paints = false;               // may be painted dark
    std::array<std::string, 2> next_rooms;  // behind a doorway, one as often as the other

    std::string furnished_as;        // a type whose recipe it shares; empty: it has its own
    std::vector<RecipeStep> recipe;  // what stands in it

    float width_low_m = 0, width_high_m = 0, depth_low_m = 0, depth_high_m = 0;  // usual inside sizes
    // How often rooms of the type have a feature.
    float breast_probability = 0, corner_probability = 0, bay_probability = 0, alcove_probability = 0,
          doorway_probability = 0;

    std::vector<std::string> pieces;  // what else it takes where its walls are bare, in order
    float pieces_per_m2 = 0;          // on the floor, all together, without clutter
    std::vector<std::string> sills;   // what stands at windows, in this order
    Shelves shelves = Shelves::books;
    float wall_shelf_probability = 0, mirror_probability = 0, clock_probability = 0;
};

// Throws Error naming file, line and key for what is missing, unknown or out of range.
RoomType read_room_type(std::string_view text, const std::string& file);
// By rank.
const std::vector<RoomType>& all_room_types();
// The first for a name that none has.
const RoomType& room_type(std::string_view name);
// What stands in a room of this type: its own recipe, or that of the type that it is furnished as.
const std::vector<RecipeStep>& recipe_of(std::string_view type);

}  // namespace fastscene
