// Relations: whether a piece stands where the prompt says ("under the window", "between the beds", "in the corner").
#pragma once

#include <optional>
#include <vector>

#include "fastscene/rooms/layout.h"

namespace fastscene {

// Of `piece`, which stands or might stand in the room with the others. Nothing: it asks for no place, or for one at
// something that is not there (yet).
std::optional<bool> stands_as_asked(const Plan& plan, const std::vector<Placed>& placed, const Placed& piece, const PromptObject& wish);

}  // namespace fastscene
