// Chalkboard.
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {

// Slate in a frame of wood: a list, a drawing, wiped places.
void build_chalkboard(Kit& k) {
    const bool kitchen = k.style.shelves == Shelves::kitchen;
    const Vec3f s = k.wanted(kitchen ? Vec3f{0.7f, 0.95f, 0.05f} : Vec3f{1.35f, 0.9f, 0.05f});
    Material slate = plain("slate board",
                           k.style.mouldings == Mouldings::rich || k.rng.chance(0.4f) ? Vec3f{0.035f, 0.06f, 0.045f}
                                                                                      : Vec3f{0.04f, 0.041f, 0.043f},
                           0.85f);
    slate.pattern = Pattern::plaster;
    slate.scale_m = 0.5f;
    slate.color_b = slate.color_a * 1.7f + Vec3f{0.012f, 0.012f, 0.012f};
    slate.color_c = slate.color_b;
    const int board = k.main(slate), wood = k.material(k.style.wood);
    k.board(board, {0, 0.01f, 0.008f}, {s.x - 0.02f, s.y - 0.02f, 0.012f}, 0.001f);
    wall_frame(k, wood, s, 0.04f, 0.024f);
    const auto stick = [&](Vec3f color) { return k.material(plain("chalk", color, 0.95f)); };
    const int white = stick({0.6f, 0.6f, 0.57f}), yellow = stick({0.6f, 0.46f, 0.15f}),
              pink = stick({0.55f, 0.24f, 0.28f});
    const float z = 0.0146f, w = 0.5f * s.x, h = s.y, u = kitchen ? s.x / 0.7f : s.y / 0.9f;
    {
        Chalk pen(k, white, z, 0.0065f * u);
        pen.words(kitchen ? -0.5f * w : -0.45f * w, 0.6f * w, 0.83f * h, 0.075f * u);
        pen.line({{-0.5f * w, 0.79f * h}, {0.5f * w, 0.785f * h}});
        for (int i = 0; i < 5; ++i) {
            const float y = h * (0.67f - 0.095f * static_cast<float>(i));
            pen.words(-0.8f * w, (kitchen ? 0.3f : -0.1f) * w, y, 0.038f * u);
            if (kitchen) pen.words(0.55f * w, 0.85f * w, y, 0.038f * u);
        }
        // A steaming cup, or a figure with its angles.
        if (kitchen) {
            const Vec2f o{0.35f * w, 0.1f * h};
            pen.line(bow(o + Vec2f{0, 0.07f * u}, {0.06f * u, 0.07f * u}, 180, 360));
            pen.line({o + Vec2f{-0.06f * u, 0.07f * u}, o + Vec2f{0.06f * u, 0.07f * u}});
            pen.line(bow(o + Vec2f{0.062f * u, 0.045f * u}, {0.022f * u, 0.02f * u}, -80, 80));
            for (const float x : {-0.025f, 0.02f})
                pen.line({o + Vec2f{x, 0.09f} * u, o + Vec2f{x + 0.012f, 0.11f} * u, o + Vec2f{x - 0.006f, 0.13f} * u,
                          o + Vec2f{x + 0.008f, 0.15f} * u});
        } else {
            pen.line({{0.15f * w, 0.24f * h}, {0.75f * w, 0.24f * h}, {0.6f * w, 0.64f * h}, {0.15f * w, 0.24f * h}});
            pen.circle({0.46f * w, 0.375f * h}, {0.135f * h, 0.135f * h});
        }
    }
    {
        Chalk pen(k, yellow, z, 0.0065f * u);
        pen.words(-0.8f * w, -0.1f * w, 0.12f * h, 0.045f * u);
        if (!kitchen) pen.line(bow({0.15f * w, 0.24f * h}, {0.09f * h, 0.09f * h}, 0, 45));
    }
    {
        Chalk pen(k, pink, z, 0.0065f * u);
        for (const float x : {-0.72f, 0.72f}) {  // flowers in the upper corners
            const Vec2f o{x * w, 0.87f * h};
            for (int i = 0; i < 5; ++i) {
                const float a = kTau * static_cast<float>(i) / 5.f;
                pen.circle(o + Vec2f{std::cos(a), std::sin(a)} * (0.024f * u), {0.016f * u, 0.016f * u});
            }
        }
    }
    k.board(wood, {0, -0.004f, 0.035f}, {0.8f * s.x, 0.012f, 0.05f}, 0.003f);
    for (const auto& [x, material] : {std::pair{-0.2f, white}, {0.05f, yellow}, {0.14f, pink}})
        k.rod(material, {x * s.x, 0.014f, 0.045f}, {x * s.x + 0.055f, 0.014f, 0.043f}, 0.0055f, -1, 10);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = kitchen ? 1.1f : 1.f;
}

}  // namespace fastscene::furniture
