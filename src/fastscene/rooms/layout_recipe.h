// Furnishes a room by the recipe of its type (recipe.h).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/rooms/layout_place.h"
#include "fastscene/rooms/recipe.h"

namespace fastscene::furnishing {

struct StepKind {
    std::string_view name;
    std::vector<std::string_view> keys;      // beside those that every step may have
    bool at_a_piece;                         // needs one: that of the step around it, or of `at`
    std::vector<std::string_view> asked_by;  // asking for one of these asks for a group; else the step's own thing does
    void (*place)(Placement&, const RecipeStep&, int anchor);  // anchor -1: none
};

// The kind of a step that only holds others.
inline constexpr std::string_view kStepsAlone = "steps";

// Those of single pieces and those of groups (layout_groups.h).
std::span<const StepKind> step_kinds();

// `recipe` must outlive `placement`, which returns to it for what it puts off.
// The steps at a piece.
void follow_steps(const std::vector<RecipeStep>& steps, Placement& placement, int anchor);
void follow_recipe(const std::vector<RecipeStep>& recipe, Placement& placement);

// The first of `first_asked` that was asked for; else `thing`, or `other` as often as the step says.
std::string thing_of(const RecipeStep& step, Placement& placement);

}  // namespace fastscene::furnishing
