// Cutting board.
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_cutting_board(Kit& k) {
    const int wood = k.main(k.style.wood2);
    k.board(wood, {}, {0.34f, 0.022f, 0.22f}, 0.006f);
    const int loaf = k.material(plain("bread", {0.42f, 0.24f, 0.1f}, 0.8f));
    k.soft(loaf, {-0.04f, 0.018f, 0}, {0.2f, 0.09f, 0.1f}, {0.04f, 0.015f, 0.004f, 10});
    k.board(k.material(steel()), {0.1f, 0.022f, 0}, {0.02f, 0.003f, 0.14f}, 0.001f);
    on_surface(k);
}

}  // namespace fastscene::furniture
