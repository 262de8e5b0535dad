// Stools with a round seat.
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {
namespace {

void round_seat(Kit& k, float y, float r) {
    const bool padded = is_upholstery(k.request.material);
    const int seat = k.main(padded ? k.style.fabric : k.style.wood);
    const int frame = k.style.legs == LegType::metal_frame ? k.material(k.style.metal)
                      : padded                             ? k.material(k.style.wood)
                                                           : seat;
    if (padded) {
        const float d = 0.014f;
        const std::array<Vec2f, 7> p{Vec2f{0, y - 0.075f}, {r - d, y - 0.075f}, {r, y - 0.06f}, {r, y - 0.02f},
                                     {r - d, y - 0.004f},  {0.5f * r, y},       {0, y}};
        k.add(shapes::lathe(p, 36, true), seat);
    } else {
        k.add(shapes::prism(shapes::circle(r), y - 0.035f, y, 0.008f), seat);
    }
    for (int i = 0; i < 4; ++i) {
        const float a = 0.7854f + 1.5708f * static_cast<float>(i), c = std::cos(a), s = std::sin(a);
        k.rod(frame, {1.12f * r * c, 0, 1.12f * r * s}, {0.7f * r * c, y - 0.03f, 0.7f * r * s}, 0.012f, 0.016f);
    }
    Mesh foot = shapes::ring(0.98f * r, 0.014f);
    k.add(std::move(foot), frame, {0, 0.35f * y, 0});
    k.top(y, 0, 0, 0.6f * r, 0.6f * r);
}

}  // namespace

void build_stool(Kit& k) { round_seat(k, 0.46f, 0.17f); }

void build_bar_stool(Kit& k) { round_seat(k, 0.68f, 0.18f); }

}  // namespace fastscene::furniture
