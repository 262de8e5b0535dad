// Lantern.
#include <utility>
#include <vector>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// A cage of metal with panes about a candle; a ring to carry it by.
void build_lantern(Kit& k) {
    const float size = k.request.size_factor, half = 0.085f * size,
                high = (k.request.size_m.y > 0 ? k.request.size_m.y : 0.36f * size), body = 0.66f * high;
    k.sized = true;
    const int metal = k.main(k.style.of(k.style.made_of.lantern)), pane = k.material(glass());
    k.board(metal, {0, 0, 0}, {2.25f * half, 0.016f, 2.25f * half}, 0.003f);
    k.board(metal, {0, 0.016f, 0}, {2 * half, 0.012f, 2 * half}, 0.003f);
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.board(metal, {sx * 0.93f * half, 0.02f, sz * 0.93f * half}, {0.012f, body - 0.02f, 0.012f}, 0.002f);
    for (const float s : {-1.f, 1.f}) {
        k.board(pane, {0, 0.028f, s * 0.93f * half}, {1.8f * half, body - 0.034f, 0.002f}, 0.0005f);
        k.board(pane, {s * 0.93f * half, 0.028f, 0}, {0.002f, body - 0.034f, 1.8f * half}, 0.0005f);
        k.board(metal, {0, 0.5f * body, s * 0.95f * half}, {1.8f * half, 0.006f, 0.006f}, 0.001f);
        k.board(metal, {s * 0.95f * half, 0.5f * body, 0}, {0.006f, 0.006f, 1.8f * half}, 0.001f);
    }
    k.board(metal, {0, body - 0.008f, 0}, {2.2f * half, 0.014f, 2.2f * half}, 0.003f);
    // A roof of four sides, a small chimney, the ring.
    std::vector<Vec2f> roof{{1.45f * half, body},
                            {0.55f * half, body + 0.17f * high},
                            {0.42f * half, body + 0.17f * high},
                            {0.42f * half, body + 0.21f * high},
                            {0.5f * half, body + 0.22f * high},
                            {0.02f * half, body + 0.25f * high}};
    Mesh cap = shapes::lathe(roof, 4);
    shapes::turn(cap, {0, 1, 0}, 45);
    k.add(std::move(cap), metal);
    Mesh loop = shapes::ring(0.045f * high / 0.36f, 0.006f, 24);
    shapes::turn(loop, {1, 0, 0}, 90);
    k.add(std::move(loop), metal, {0, high - 0.05f * high / 0.36f, 0});
    PieceRequest flame_of;
    flame_of.kind = "candle", flame_of.style = &k.style, flame_of.seed = k.rng.next_u64(),
    flame_of.size_m = {0.06f, 0, 0};
    k.merge(make_piece(flame_of), {0, 0.028f, 0});
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
