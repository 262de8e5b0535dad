// Fridge.
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_fridge(Kit& k) {
    const int body = k.main(steel()), dark = k.material(plain("seal", {0.05f, 0.05f, 0.05f}, 0.6f));
    k.board(dark, {0, 0, 0}, {0.56f, 0.06f, 0.56f});
    k.board(body, {0, 0.05f, -0.03f}, {0.62f, 1.8f, 0.6f}, 0.006f);
    k.board(body, {0, 0.07f, 0.302f}, {0.61f, 0.58f, 0.06f}, 0.012f);
    k.board(body, {0, 0.66f, 0.302f}, {0.61f, 1.18f, 0.06f}, 0.012f);
    for (const Vec2f y : {Vec2f{0.36f, 0.6f}, Vec2f{0.72f, 1.2f}})
        k.rod(dark, {-0.25f, y.x, 0.36f}, {-0.25f, y.y, 0.36f}, 0.012f),
            k.rod(dark, {-0.25f, y.x + 0.03f, 0.33f}, {-0.25f, y.x + 0.03f, 0.36f}, 0.008f),
            k.rod(dark, {-0.25f, y.y - 0.03f, 0.33f}, {-0.25f, y.y - 0.03f, 0.36f}, 0.008f);
    k.top(1.85f, 0, -0.03f, 0.28f, 0.26f);
    k.piece.clearance_front_m = 0.8f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
