// The designs of printed things: what one cell of a sheet (print.h) looks like, and in which colors and words.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "fastscene/base/random.h"
#include "fastscene/rooms/furniture/painting.h"
#include "fastscene/rooms/furniture/print.h"

namespace fastscene::furniture {

using Colors = std::span<const Vec3f>;
using Words = std::span<const std::string_view>;

struct PrintStyle {
    const char* name;
    int columns, rows, width, height;  // cells, and pixels of one
    Vec2f cell_m;                      // size of what it is printed on
    float roughness;
    void (*draw)(Patch&, Random&, const PrintStyle&);
    Colors grounds, inks;
    Words words;
};

const PrintStyle& style_of(Print print);
std::span<const PrintStyle> goods_styles();   // print_designs.cc: from the first Print up to the posters
std::span<const PrintStyle> poster_styles();  // posters.cc: the others

// food_posters.cc
void food_poster(Patch& p, Random& rng, const PrintStyle& s);
void bakery_poster(Patch& p, Random& rng, const PrintStyle& s);

// ---- what designs share

inline constexpr Vec3f kPrintBlack{0.025f, 0.024f, 0.024f}, kPrintWhite{0.74f, 0.73f, 0.7f};

template <class T>
const T& one_of(Random& rng, std::span<const T> all) {
    return all[static_cast<std::size_t>(rng.index(static_cast<int>(all.size())))];
}
// A shade of the color.
Vec3f varied(Random& rng, Vec3f color);
// An ink that stands out from the ground.
Vec3f contrasting(Random& rng, Colors inks, Vec3f ground);
// Lines of small print, each `line` pixels high.
void small_print(Patch& p, Random& rng, Vec2f low, Vec2f high, float line, Vec3f ink);
// Pixels at these shares of the patch.
Vec2f spot(const Patch& p, float x, float y);
// From the color `below` to that `above`.
void fade(Patch& p, Vec2f low, Vec2f high, Vec3f below, Vec3f above);
// A person seen from afar: the head `tall` pixels above the feet, the limbs swung by `stride` in [-1, 1].
void person(Patch& p, Vec2f feet, float tall, float stride, Vec3f ink);
// One large picture: hills and a sun, a figure, discs, a town at night, bands.
void scene(Patch& p, Random& rng, Vec2f low, Vec2f high, Vec3f sky, Vec3f ink, Vec3f light);

// ---- meshes that show a part of a sheet

inline float mix(float a, float b, float t) { return a + (b - a) * t; }
void add_quad(Mesh& mesh, const std::array<Vec3f, 4>& corners, Vec3f normal, const std::array<Vec2f, 4>& coords);

}  // namespace fastscene::furniture
