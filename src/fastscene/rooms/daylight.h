// The light of a room: its hour, its sky, what its windows show, and how bright its lamps are.
#pragma once

#include <cstdint>

#include "fastscene/base/random.h"
#include "fastscene/rooms/plan.h"
#include "fastscene/scene/room.h"

namespace fastscene {

// What is assumed when the prompt does not say it: the hour; once the plan is made, what the windows show. The hour
// comes first of all, as the lamps and their number depend on it.
void assume_time(PromptSpec& spec, std::uint64_t seed);
void assume_outlook(PromptSpec& spec, const Style& style, std::uint64_t seed);

// The random stream of a room's light.
Random light_draws(const PromptSpec& spec, std::uint64_t seed);

// The sun stands where it shines through the first window, a little from the side, so that its patch falls on the
// floor.
Sky make_sky(PromptSpec& spec, const Plan& plan, const Mat3f& world_from_room, Random& rng);

// How much of their light the lamps give, by the hour. Where no day comes in they are lit.
float lamp_level(const PromptSpec& spec, const Plan& plan);

}  // namespace fastscene
