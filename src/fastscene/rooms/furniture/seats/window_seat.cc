// Window seat.
#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/storage/carcass.h"

namespace fastscene::furniture {

// A chest below a window with a cushion on it.
void build_window_seat(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 0.5f, 0.5f});
    const int cloth = k.main(k.style.fabric), wood = k.material(k.style.of(k.style.made_of.window_seat)),
              metal = k.material(k.style.metal);
    const float top = s.y - 0.09f;
    k.board(wood, {0, 0, -0.02f}, {s.x - 0.04f, 0.07f, s.z - 0.06f}, 0.004f);
    k.board(wood, {0, 0.07f, 0}, {s.x, top - 0.095f, s.z - 0.03f}, 0.004f);
    k.board(wood, {0, top - 0.025f, 0}, {s.x + 0.02f, 0.025f, s.z}, 0.006f);
    fronts(k, wood, metal, -0.5f * s.x + 0.02f, 0.5f * s.x - 0.02f, 0.09f, top - 0.04f, 0.5f * s.z - 0.015f,
           s.x > 1.2f ? 3 : 2, 1);
    k.soft(cloth, {0, top - 0.003f, 0.005f}, {s.x - 0.02f, 0.1f, s.z - 0.03f}, {0.04f, 0.014f, 0.003f, 22});
    for (const float sx : {-1.f, 1.f})
        put_pillow(k, sx < 0 ? accent_cloth(k) : k.material(tinted(k.style.fabric2, k.accent())),
                   {sx * (0.5f * s.x - 0.25f), s.y, -0.5f * s.z + 0.17f}, {0.42f, 0.38f, 0.14f}, 18.f, -sx * 14.f);
    k.top(s.y + 0.005f, 0, 0.06f, 0.2f * s.x, 0.3f * s.z);
    k.piece.clearance_front_m = 0.4f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
