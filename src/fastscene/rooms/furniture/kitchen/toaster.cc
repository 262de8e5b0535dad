// Toaster.
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_toaster(Kit& k) {
    const int body = k.main(k.rng.chance(0.5f) ? steel() : plain("enamel", k.accent(), 0.25f)),
              dark = k.material(plain("black plastic", {0.035f, 0.035f, 0.037f}, 0.4f));
    k.board(dark, {}, {0.27f, 0.02f, 0.16f}, 0.005f);
    k.board(body, {0, 0.018f, 0}, {0.28f, 0.17f, 0.17f}, 0.035f);
    for (const float z : {-0.035f, 0.035f}) k.board(dark, {0, 0.1885f, z}, {0.19f, 0.001f, 0.024f}, 0.0003f);
    k.board(dark, {0.142f, 0.11f, 0}, {0.014f, 0.02f, 0.04f}, 0.004f);
    on_surface(k);
}

}  // namespace fastscene::furniture
