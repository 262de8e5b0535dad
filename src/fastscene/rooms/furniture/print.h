// What is printed or bound in many kinds: spines of books, covers, labels of goods. Each trade has a sheet of them,
// drawn once, with its own colors and words; a thing shows one cell of it.
#pragma once

#include <string_view>

#include "fastscene/image/image.h"
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

enum class Print {
    cloth_spines,  // bindings in cloth and leather, with gilt
    paper_spines,
    book_covers,
    film_covers,
    sleeves,  // of records
    groceries,
    tins,
    preserves,  // labels of jars
    drinks,     // cartons of milk and juice
    wines,      // labels of bottles
    coffees,    // bags
    medicines,
    cosmetics,
    toys,  // boxes
    hardware,
    parcels,  // cartons with a label
    film_posters,
    travel_posters,
    offers,  // of shops
    food_posters,
    sport_posters,
    concert_posters,
    charts,   // of schools and laboratories
    notices,  // rules and announcements
    fashion_posters,
    bakery_posters,
    count,
};

// "films", "travel" …: what the pattern of a poster or a billboard may name.
bool is_poster_topic(std::string_view name);

// Of the sheet's picture: the corners of a cell, v up.
struct Cell {
    Vec2f low, high;
};

struct PrintSheet {
    int material;  // of the kit, which has it once
    int cells;
    Print print;
    Cell operator[](int i) const;
};

PrintSheet print_sheet(Kit& k, Print print);

// A box of which the front (+z) shows the cell; the other faces have its ground. By the middle of its lower face.
Mesh printed_box(const Cell& cell, Vec3f size);
// An upright round box whose front and back show the cell, from y0 to y1.
Mesh printed_can(const Cell& cell, float radius, float y0, float y1, int sides = 12);
// One face looking to +z, lower left corner at the origin.
Mesh printed_face(const Cell& cell, Vec2f size);

// A material that shows a picture, (0, 0) to (1, 1) of the coordinates; colors are linear.
Material picture_material(const char* name, const ImageColor& image, float width_m, float roughness);

// A board with words on it, of its own picture: signs above shelves, of shops. The lower left corner at `at`, looking
// to +z.
void sign(Kit& k, std::string_view words, Vec3f ground, Vec3f ink, Vec3f at, Vec2f size);

// Old bindings where the style has mouldings, else now and then.
bool is_old_book(const Style& style, Random& rng);
// The color of a cover of such a book.
Vec3f cover_color(Random& rng, bool old);

// A row of books along +x: the lower left corner of its front (+z) at `at`. Some stand in sets, lean or lie.
void book_row(Kit& k, Print spines, Vec3f at, float length, float max_height, float depth);

}  // namespace fastscene::furniture
