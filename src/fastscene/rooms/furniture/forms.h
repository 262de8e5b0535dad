// Silhouettes and cloth that pieces of several kinds share.
#pragma once

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// One of the two forms that rooms of a style have of a piece: the first a little more often.
template <class Form>
Form form_for(Kit& k, const TwoForms<Form>& forms) {
    return k.rng.index(16) < 9 ? forms.first : forms.second;
}

void feet(Kit& k, int wood, float width, float depth, float high, float lean = 0.02f);

// Buttons drawn into a padded face, in a diamond grid on the plane z.
void buttons(Kit& k, int cloth, float x0, float x1, float y0, float y1, float z, float step);

// Cloth in one of the style's accents: plain, striped or knitted.
int accent_cloth(Kit& k);

// A cushion on its lower edge at `at`, leaning back, then turned.
void put_pillow(Kit& k, int material, Vec3f at, Vec3f size, float lean_deg, float yaw_deg = 0.f);

// Asked for in rattan, cane or the like: what is woven of it looks so in every style.
bool is_woven(const Kit& k);

// Its weave, of strands as wide as a seat has them, in the color that was asked for.
int woven_main(Kit& k);

}  // namespace fastscene::furniture
