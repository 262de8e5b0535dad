// What stands on the shelves of shops, bars and stores, of few triangles each: there is much of it.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

enum class Goods { packets, cans, books, shoes, toys, bread, jars, bottles, cartons, boxes, records, films };

// A box of twelve triangles, by the middle of its lower face.
void block(Kit& k, int material, Vec3f base_center, Vec3f size);
// Upright, of glass, with a neck and a cap.
void bottle(Kit& k, int glass, int cap, Vec3f at, float height, float radius);
// Goods side by side along +x on one shelf, their fronts at z_front, as high as there is room.
void stock(Kit& k, Goods goods, float x0, float x1, float y, float room_y, float z_front, float depth);
// One that shines at any hour.
int lit(Kit& k, const char* name, Vec3f radiance);
// A material of one color.
int color(Kit& k, const char* name, Vec3f albedo, float roughness = 0.5f);

}  // namespace fastscene::furniture
