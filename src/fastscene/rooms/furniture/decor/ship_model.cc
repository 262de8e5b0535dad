// Ship model.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {

// A three-masted ship on a stand.
void build_ship_model(Kit& k) {
    const int wood = k.main(k.style.wood2), dark = k.material(plain("rigging", {0.05f, 0.035f, 0.025f}, 0.7f));
    Material canvas = plain("sailcloth", {0.66f, 0.6f, 0.48f}, 0.9f);
    const int sail = k.material(canvas), flag = k.material(plain("pennant", k.accent(), 0.8f));
    const float length = 0.42f, keel = 0.07f, deck = 0.15f;
    k.board(wood, {0, 0, 0}, {0.2f, 0.012f, 0.09f}, 0.003f);
    for (const float sx : {-1.f, 1.f}) k.board(wood, {sx * 0.07f, 0.011f, 0}, {0.014f, keel, 0.05f}, 0.002f);
    // The hull: sections along x, fuller at the deck; bow to the right.
    k.add(shapes::slab(20, 10, 0.004f,
                       [&](float u, float v) {
                           const float t = 2 * u - 1, fine = t > 0 ? 1.f - t * t : 1.f - 0.35f * t * t,
                                       a = kPi * (v - 0.5f);
                           const float sheer = deck + 0.035f * t * t,
                                       depth = (sheer - keel) * std::sqrt(std::max(0.02f, fine));
                           return Vec3f{0.5f * length * t, sheer - depth * std::cos(a),
                                        0.045f * std::sqrt(std::max(0.01f, fine)) * std::sin(a)};
                       }),
          wood);
    k.add(shapes::sheet(12, 2,
                        [&](float u, float v) {
                            const float t = 2 * u - 1, fine = t > 0 ? 1.f - t * t : 1.f - 0.35f * t * t;
                            return Vec3f{0.49f * length * t, deck + 0.03f * t * t - 0.004f,
                                         (0.5f - v) * 0.086f * std::sqrt(std::max(0.01f, fine))};
                        }),
          wood);
    k.rod(dark, {0.47f * length, deck + 0.03f, 0}, {0.68f * length, deck + 0.09f, 0}, 0.004f, 0.0025f, 8);
    const std::array<float, 3> xs{-0.13f, 0.f, 0.12f}, tops{0.4f, 0.48f, 0.42f};
    for (std::size_t i = 0; i < 3; ++i) {
        k.rod(dark, {xs[i], deck, 0}, {xs[i], tops[i], 0}, 0.0045f, 0.003f, 8);
        for (int j = 0; j < 3; ++j) {
            const float y0 = deck + 0.03f + (tops[i] - deck - 0.06f) * static_cast<float>(j) / 3.f,
                        h = (tops[i] - deck - 0.06f) / 3.f - 0.008f, w = 0.1f - 0.022f * static_cast<float>(j);
            k.rod(dark, {xs[i] + 0.004f, y0 + h, -0.52f * w}, {xs[i] + 0.004f, y0 + h, 0.52f * w}, 0.0025f, -1, 6);
            // Full of wind from astern.
            k.add(
                shapes::slab(8, 6, 0.002f,
                             [&](float u, float v) {
                                 const float belly = 0.03f * std::sin(kPi * u) * std::sin(kPi * (0.15f + 0.8f * v));
                                 return Vec3f{xs[i] + 0.007f + belly, y0 + h * v, (0.5f - u) * w * (1.08f - 0.12f * v)};
                             }),
                sail);
        }
    }
    k.add(shapes::slab(6, 3, 0.0015f,
                       [&](float u, float v) {
                           return Vec3f{-0.06f * u, tops[1] - 0.026f + 0.024f * v - 0.004f * std::sin(5.f * u),
                                        0.003f * std::sin(7.f * u)};
                       }),
          flag);
    k.piece.mount = Mount::surface;
}

}  // namespace fastscene::furniture
