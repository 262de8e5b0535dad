// What designs of lit screens share. Colors are linear, 1 is the screen's white. Private to screen*.cc.
#pragma once

#include <array>

#include "fastscene/rooms/furniture/print_designs.h"
#include "fastscene/rooms/furniture/screen.h"

namespace fastscene::furniture::screens {

inline constexpr Vec3f kShownWhite{0.95f, 0.95f, 0.95f}, kShownBlack{0.006f, 0.006f, 0.008f},
    kPaperWhite{0.82f, 0.83f, 0.85f}, kTextGray{0.12f, 0.12f, 0.13f}, kBlueAccent{0.03f, 0.2f, 0.62f},
    kGreenAccent{0.04f, 0.4f, 0.14f}, kRedAccent{0.6f, 0.03f, 0.03f}, kAmberAccent{0.85f, 0.42f, 0.03f};
inline constexpr std::array<Vec3f, 4> kAccents{kBlueAccent, kGreenAccent, kAmberAccent, kRedAccent};

// Land up to a crest of waves, from the lower edge; heights are shares of the patch.
void ridge(Patch& p, float base, float swing, float waves, float phase, Vec3f color);
void halo(Patch& p, Vec2f at, float radius, Vec3f color);
// Words of a text that is too small to read.
void text_lines(Patch& p, Random& rng, Vec2f low, Vec2f high, float pitch, Vec3f ink);
void bars(Patch& p, Random& rng, Vec2f low, Vec2f high, int count, Vec3f color);
void curve(Patch& p, Random& rng, Vec2f low, Vec2f high, Vec3f color, float weight);
void ring(Patch& p, Vec2f at, float outer, float inner, Vec3f color, Vec3f ground);

// The pictures of Shown; `variant`: which.
void film(Patch& p, Random& rng, int variant);
void broadcast(Patch& p, Random& rng, int variant);
void game(Patch& p, Random& rng, int variant);
void marquee(Patch& p, Random& rng, int variant);
void reels(Patch& p, Random& rng, int variant);
void jackpot(Patch& p, Random& rng, int variant);

}  // namespace fastscene::furniture::screens
