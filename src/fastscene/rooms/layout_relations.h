// Relations: whether a piece stands where the prompt says ("under the window", "between the beds", "in the corner").
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "fastscene/rooms/layout.h"

namespace fastscene {

// How high above the floor what stands before a window may reach: a little above its sill; before glass down to the
// floor sofas and tables stand.
inline float free_before(const Opening& window, float above_sill) {
    return window.y0 < 0.3f ? 0.92f : window.y0 + above_sill;
}
// Whether a wish for this class means such an opening.
bool is_opening_of(const Opening& opening, std::string_view kind);

// How far two boxes are apart on the floor, by their corners and middles: exact enough to say "beside".
float gap_between(const Footprint& a, const Footprint& b);

// Of `piece`, which stands or might stand in the room with the others. Nothing: it asks for no place, or for one at
// something that is not there (yet).
std::optional<bool> stands_as_asked(const Plan& plan, const std::vector<Placed>& placed, const Placed& piece,
                                    const PromptObject& wish);

}  // namespace fastscene
