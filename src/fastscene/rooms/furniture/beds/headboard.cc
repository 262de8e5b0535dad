// Headboards, by form.
#include "fastscene/rooms/furniture/beds/headboard.h"

#include <cmath>

#include "fastscene/rooms/furniture/forms.h"

namespace fastscene::furniture {

void headboard(Kit& k, BedForm form, float width, float length, int wood, int head) {
    const float hz = -0.5f * length - 0.06f;
    const bool rich = k.style.mouldings == Mouldings::rich;
    const float high = rich ? 1.3f : 1.05f;
    switch (form) {
        case BedForm::panels: {
            const int panels = width > 1.2f ? 4 : 2;
            const float w = (width + 0.1f) / static_cast<float>(panels);
            for (int i = 0; i < panels; ++i)
                k.soft(head, {-0.5f * (width + 0.1f) + (static_cast<float>(i) + 0.5f) * w, 0.12f, hz},
                       {w - 0.002f, high - 0.12f, 0.1f}, {0.03f, 0.02f, 0.001f, 8});
            break;
        }
        case BedForm::tufted:
            k.soft(head, {0, 0.12f, hz}, {width + 0.16f, high, 0.11f}, {0.04f, 0.02f, 0.001f, 12});
            buttons(k, head, -0.5f * width + 0.1f, 0.5f * width - 0.1f, 0.65f, high - 0.02f, hz + 0.06f, 0.22f);
            break;
        case BedForm::slats:
            for (const float sx : {-1.f, 1.f}) {
                k.board(wood, {sx * 0.5f * width, 0, hz}, {0.07f, high + 0.05f, 0.07f}, 0.01f);
                k.add(shapes::ball({sx * 0.5f * width, high + 0.085f, hz}, {0.045f, 0.045f, 0.045f}), wood);
            }
            for (int i = 0; i < 3; ++i)
                k.board(wood, {0, 0.5f + 0.19f * static_cast<float>(i), hz}, {width, 0.15f, 0.03f}, 0.006f);
            break;
        case BedForm::board: k.board(wood, {0, 0.15f, hz}, {width + 0.1f, high - 0.17f, 0.04f}, 0.012f); break;
        case BedForm::low:
            // A platform that is wider than the mattress, with a low leaning board.
            k.board(wood, {0, 0.12f, 0.04f}, {width + 0.36f, 0.06f, length + 0.2f}, 0.008f);
            k.board(wood, {0, 0.15f, hz}, {width + 0.36f, 0.66f, 0.045f}, 0.01f);
            break;
        case BedForm::iron: {
            const int metal = k.material(k.style.metal);
            for (const float end : {-1.f, 1.f}) {
                const float z = end * (0.5f * length + 0.06f), y = end < 0 ? 1.12f : 0.72f;
                for (const float sx : {-1.f, 1.f}) {
                    k.rod(metal, {sx * 0.5f * width, 0, z}, {sx * 0.5f * width, y, z}, 0.018f, -1, 12);
                    k.add(shapes::ball({sx * 0.5f * width, y + 0.025f, z}, {0.03f, 0.03f, 0.03f}, 12), metal);
                }
                for (const float t : {0.5f, 1.f})
                    k.rod(metal, {-0.5f * width, 0.35f + (y - 0.4f) * t, z}, {0.5f * width, 0.35f + (y - 0.4f) * t, z},
                          0.012f);
                const int bars = width > 1.2f ? 9 : 5;
                for (int i = 1; i < bars; ++i) {
                    const float x = width * (static_cast<float>(i) / static_cast<float>(bars) - 0.5f);
                    k.rod(metal, {x, 0.35f + 0.5f * (y - 0.4f), z}, {x, y - 0.05f, z}, 0.008f, -1, 8);
                }
            }
            break;
        }
        case BedForm::posts: {
            const float top = 2.02f, fz = 0.5f * length + 0.02f;
            for (const float sx : {-1.f, 1.f})
                for (const float z : {hz, fz})
                    k.board(wood, {sx * (0.5f * width + 0.02f), 0, z}, {0.06f, top, 0.06f}, 0.008f);
            for (const float sx : {-1.f, 1.f})
                k.board(wood, {sx * (0.5f * width + 0.02f), top - 0.05f, 0.5f * (hz + fz)}, {0.045f, 0.045f, fz - hz},
                        0.006f);
            for (const float z : {hz, fz}) k.board(wood, {0, top - 0.05f, z}, {width, 0.045f, 0.045f}, 0.006f);
            k.board(wood, {0, 0.15f, hz}, {width, 0.85f, 0.03f}, 0.01f);
            // Cloth gathered at the two posts of the head.
            Material cloth = k.style.curtain;
            const int veil = k.material(cloth);
            for (const float sx : {-1.f, 1.f})
                k.add(shapes::sheet(24, 10,
                                    [=](float u, float v) {
                                        const float a = 2 * kPi * u * 3.f, y = 0.1f + (top - 0.16f) * v;
                                        return Vec3f{sx * (0.5f * width + 0.015f) + 0.02f * std::sin(a), y,
                                                     hz + 0.05f + 0.2f * u + 0.012f * std::cos(a)};
                                    }),
                      veil);
            break;
        }
    }
}

}  // namespace fastscene::furniture
