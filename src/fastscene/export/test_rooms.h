// Rooms for tests of exported files.
#pragma once

#include "fastscene/rooms/rooms.h"

namespace fastscene {

inline Room room_from(const std::string& prompt, std::uint64_t seed = 7) {
    PromptSpec spec = understand_prompt(prompt, false);
    return make_room(spec, Run{seed, nullptr, {}});
}

}  // namespace fastscene
