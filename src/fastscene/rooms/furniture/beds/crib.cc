// A crib.
#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

void build_crib(Kit& k) {
    const int wood = k.main(k.style.wood), linen = k.material(tinted(k.style.fabric, {0.72f, 0.7f, 0.65f})),
              cloth = accent_cloth(k);
    const float hx = 0.65f, hz = 0.35f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) k.board(wood, {sx * hx, 0, sz * hz}, {0.045f, 0.92f, 0.045f}, 0.008f);
    for (const float s : {-1.f, 1.f})
        for (const float y : {0.25f, 0.86f}) {
            k.board(wood, {0, y, s * hz}, {2 * hx, 0.04f, 0.03f}, 0.006f);
            k.board(wood, {s * hx, y, 0}, {0.03f, 0.04f, 2 * hz}, 0.006f);
        }
    for (const float s : {-1.f, 1.f}) {
        for (int i = -6; i <= 6; ++i)
            k.rod(wood, {0.092f * static_cast<float>(i), 0.28f, s * hz},
                  {0.092f * static_cast<float>(i), 0.87f, s * hz}, 0.009f, -1, 8);
        for (int i = -3; i <= 3; ++i)
            k.rod(wood, {s * hx, 0.28f, 0.092f * static_cast<float>(i)},
                  {s * hx, 0.87f, 0.092f * static_cast<float>(i)}, 0.009f, -1, 8);
    }
    k.soft(linen, {0, 0.3f, 0}, {1.24f, 0.12f, 0.64f}, {0.03f, 0.01f, 0.001f, 8});
    k.soft(cloth, {0.2f, 0.4f, 0}, {0.7f, 0.05f, 0.6f}, {0.02f, 0.015f, 0.006f, 14});
    k.top(0.45f, 0.2f, 0, 0.3f, 0.24f);
    k.piece.clearance_front_m = 0.6f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
