// Radiator.
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_radiator(Kit& k) {
    const int white = k.main(plain("radiator enamel", {0.76f, 0.76f, 0.74f}, 0.3f));
    for (int i = 0; i < 14; ++i)
        k.soft(white, {-0.455f + 0.07f * static_cast<float>(i), 0.1f, 0}, {0.06f, 0.56f, 0.1f},
               {0.025f, 0.004f, 0.f, 3});
    for (const float y : {0.18f, 0.58f}) k.rod(white, {-0.47f, y, 0}, {0.47f, y, 0}, 0.02f);
    for (const float x : {-0.4f, 0.4f}) k.board(white, {x, 0, 0}, {0.03f, 0.12f, 0.06f});
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
