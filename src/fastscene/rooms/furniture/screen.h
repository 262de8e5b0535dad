// Lit screens: pictures that shine.
#pragma once

#include <span>

#include "fastscene/image/image.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/painting.h"

namespace fastscene::furniture {

// Patterns of things that show more than one kind of picture: a projector screen a film in place of slides, a departure
// board trains in place of flights.
inline constexpr const char *kFilmPattern = "film", *kTrainsPattern = "trains";

enum class Shown {
    film,
    broadcast,   // of television
    desktop,     // of computers
    slides,      // of talks
    game,        // of arcade machines
    marquee,     // the lit name of such a game
    reels,       // of slot machines
    jackpot,     // the lit sign above them
    check_in,    // a flight
    till,        // goods to tap at
    tickets,     // lines and stations
    workout,     // of treadmills
    operations,  // a map and what is watched on it
    count,
};

struct ScreenStyle {
    const char* name;
    int variants, width, height;  // pixels
    void (*draw)(Patch&, Random&, int variant);
};
namespace screens {
std::span<const ScreenStyle> screen_styles();  // screen_designs.cc: in the order of Shown
}

inline constexpr Vec3f kGameWhite{2.4f, 2.4f, 2.4f};       // of machines that draw players
inline constexpr Vec3f kMonitorWhite{1.15f, 1.2f, 1.25f};  // a little brighter than paper in the room's light

// Of a screen `width_m` wide that shows one of the pictures of this kind; `white`: radiance of white in it. Its mesh is
// a screen_box(), or of printed parts (print.h) of the whole from (0, 0) to (1, 1).
int lit_screen(Kit& k, Shown shown, Vec3f white, float width_m);
// The same with a picture of its own, of linear colors from 0 to 1.
int lit_picture(Kit& k, const ImageColor& picture, Vec3f white, float width_m);

// A thin box whose front (+z) shows the picture; by the middle of its lower face.
Mesh screen_box(Vec3f size);

}  // namespace fastscene::furniture
