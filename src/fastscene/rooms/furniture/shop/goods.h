// What stands on the shelves of shops, bars and stores, of few triangles each: there is much of it.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

enum class Goods {
    packets,
    cans,
    books,  // bound
    paperbacks,
    covers,  // books that show their fronts
    shoes,
    toys,
    bread,
    preserves,  // jars with labels
    jars,       // of glass, with what one weighs out
    coffee,
    cups,
    bottles,
    cartons,
    boxes,
    records,
    films,
    medicines,
    cosmetics,
    hardware,
};

// A box of twelve triangles, by the middle of its lower face.
void block(Kit& k, int material, Vec3f base_center, Vec3f size);
// Upright, of glass, with a neck and a cap.
void bottle(Kit& k, int glass, int cap, Vec3f at, float height, float radius);
// Goods side by side along +x on one shelf, their fronts at z_front, as high as there is room.
void stock(Kit& k, Goods goods, float x0, float x1, float y, float room_y, float z_front, float depth);
// A jar of glass, its lid of metal, filled up to near its shoulder; by the middle of its foot.
void filled_jar(Kit& k, int contents, int lid, Vec3f at, float radius, float height, int sides = 12);
// What fills jars: coffee, pasta, spices, sweets.
int jar_contents(Kit& k, Vec3f color);
// One that shines at any hour.
int lit(Kit& k, const char* name, Vec3f radiance);
// A material of one color.
int color(Kit& k, const char* name, Vec3f albedo, float roughness = 0.5f);

}  // namespace fastscene::furniture
