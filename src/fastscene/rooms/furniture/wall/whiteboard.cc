// Whiteboard.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {

// ---- boards

void build_whiteboard(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 0.95f, 0.05f});
    const int frame = k.material(steel());
    const int board = k.main(plain("enamel board", {0.78f, 0.79f, 0.79f}, 0.18f));
    k.board(board, {0, 0.01f, 0.009f}, {s.x - 0.01f, s.y - 0.02f, 0.012f}, 0.001f);
    wall_frame(k, frame, s, 0.022f, 0.02f);
    const auto ink = [&](Vec3f color) { return k.material(plain("marker", color, 0.5f)); };
    const int blue = ink({0.03f, 0.07f, 0.35f}), red = ink({0.5f, 0.03f, 0.03f}), black = ink({0.03f, 0.03f, 0.035f}),
              green = ink({0.02f, 0.22f, 0.06f});
    const float z = 0.0156f, w = 0.5f * s.x, h = s.y, u = std::min(s.x / 1.5f, s.y / 0.95f);
    {
        Chalk pen(k, black, z, 0.006f * u);
        pen.words(-0.9f * w, -0.25f * w, 0.85f * h, 0.06f * u);
        pen.line({{-0.9f * w, 0.82f * h}, {-0.3f * w, 0.815f * h}});
        for (int i = 0; i < 4; ++i) {
            const float y = h * (0.68f - 0.1f * static_cast<float>(i));
            pen.words(-0.82f * w, k.rng.uniform(-0.35f, -0.12f) * w, y, 0.034f * u);
            pen.box({-0.9f * w, y}, {-0.9f * w + 0.03f * u, y + 0.03f * u});
        }
    }
    {
        // A chart of boxes.
        Chalk pen(k, blue, z, 0.006f * u);
        const Vec2f size{0.2f * w, 0.09f * h}, a{0.12f * w, 0.8f * h}, b{0.62f * w, 0.8f * h}, c{0.62f * w, 0.58f * h};
        for (const Vec2f p : {a, b, c}) {
            pen.box(p - size * 0.5f, p + size * 0.5f);
            pen.words(p.x - 0.4f * size.x, p.x + 0.4f * size.x, p.y - 0.012f * u, 0.028f * u);
        }
        pen.arrow({a.x + 0.55f * size.x, a.y}, {b.x - 0.58f * size.x, b.y}, 0.035f * u);
        pen.arrow({b.x, b.y - 0.55f * size.y}, {c.x, c.y + 0.6f * size.y}, 0.035f * u);
    }
    {
        Chalk pen(k, red, z, 0.006f * u);
        pen.circle({0.62f * w, 0.58f * h}, {0.17f * w, 0.085f * h});
        pen.line({{-0.89f * w, 0.695f * h}, {-0.875f * w, 0.685f * h}, {-0.84f * w, 0.73f * h}});
        pen.words(0.28f * w, 0.8f * w, 0.12f * h, 0.045f * u);
    }
    {
        // A curve over its axes.
        Chalk pen(k, green, z, 0.006f * u);
        const Vec2f o{0.0f * w, 0.2f * h};
        pen.arrow(o, {o.x + 0.5f * w, o.y}, 0.03f * u);
        pen.arrow(o, {o.x, o.y + 0.32f * h}, 0.03f * u);
        Stroke curve;
        for (int i = 0; i <= 12; ++i) {
            const float t = static_cast<float>(i) / 12.f;
            curve.push_back({o.x + 0.44f * w * t, o.y + h * (0.03f + 0.24f * t * t + 0.02f * std::sin(9 * t))});
        }
        pen.line(curve);
    }
    // The tray with pens and the sponge.
    k.board(frame, {0, 0.f, 0.035f}, {0.5f * s.x, 0.008f, 0.06f}, 0.002f);
    for (const auto& [x, cap] : {std::pair{-0.12f, blue}, {-0.02f, red}, {0.06f, black}}) {
        k.rod(board, {x * s.x, 0.016f, 0.045f}, {x * s.x + 0.1f, 0.016f, 0.047f}, 0.008f, -1, 12);
        k.rod(cap, {x * s.x + 0.1f, 0.016f, 0.047f}, {x * s.x + 0.135f, 0.016f, 0.047f}, 0.0085f, -1, 12);
    }
    k.board(blue, {0.19f * s.x, 0.008f, 0.042f}, {0.11f, 0.026f, 0.045f}, 0.004f);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.98f;
}

}  // namespace fastscene::furniture
