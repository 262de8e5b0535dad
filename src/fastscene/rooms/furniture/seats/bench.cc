// A bench.
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_bench(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 0.46f, 0.38f});
    const bool padded = is_upholstery(k.request.material);
    const int seat = k.main(padded ? k.style.fabric : k.style.wood);
    const int metal = k.style.legs == LegType::metal_frame ? k.material(k.style.metal)
                      : padded                             ? k.material(k.style.wood)
                                                           : seat;
    legs(k, metal, 0.5f * s.x - 0.1f, 0.5f * s.z - 0.06f, s.y - 0.04f, 0.05f);
    if (padded) k.soft(seat, {0, s.y - 0.1f, 0}, {s.x, 0.1f, s.z}, {0.03f, 0.016f, 0.002f, 20});
    else k.board(seat, {0, s.y - 0.045f, 0}, {s.x, 0.045f, s.z}, 0.006f);
    k.top(s.y, 0, 0, 0.45f * s.x, 0.4f * s.z);
    k.piece.clearance_front_m = 0.4f;
}

}  // namespace fastscene::furniture
