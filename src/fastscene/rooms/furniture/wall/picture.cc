// Picture.
#include <algorithm>
#include <string>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/wall/motifs.h"
#include "fastscene/rooms/furniture/wall/panels.h"

namespace fastscene::furniture {

void build_picture(Kit& k) {
    const bool wide = k.rng.chance(0.4f);
    const Vec3f s = k.wanted(wide ? Vec3f{0.9f, 0.62f, 0.025f} : Vec3f{0.55f, 0.75f, 0.025f});
    const int pick = k.rng.index(3);
    const int frame = k.material(pick == 0   ? k.style.metal
                                 : pick == 1 ? k.style.wood
                                             : k.style.wood2),
              mat_board = k.material(plain("passe-partout", {0.76f, 0.75f, 0.71f}, 0.9f));
    const float f = k.style.mouldings == Mouldings::rich ? 0.04f : 0.02f, pass = 0.09f * std::min(s.x, s.y);
    const float w = s.x - 2 * f - 2 * pass, h = s.y - 2 * f - 2 * pass;
    Material m = plain("art", k.style.palette[0], 0.6f);
    m.pattern = Pattern::art;
    const auto i = static_cast<std::size_t>(k.rng.index(6));
    m.color_a = k.style.palette[i % 6];
    m.color_b = k.style.palette[(i + 1) % 6];
    m.color_c = k.style.palette[(i + 2) % 6];
    // A panel shows its part of a picture as wide as all of them.
    const Panel panel = panel_of(k.request.pattern).value_or(Panel{});
    const float step = s.x + kPanelGap_m;
    m.scale_m = w + step * static_cast<float>(panel.of - 1);
    m.seed = k.seed();
    m.variant = static_cast<std::uint8_t>(k.rng.index(kArtDesigns));
    const bool motif = is_motif(k.request.pattern);
    if (motif) draw_motif(k, k.request.pattern, {0, 0.5f * s.y, 0.0145f}, w, h);
    const int art = motif ? -1 : k.main(m);
    if (!motif) k.piece.form = "design " + std::to_string(m.variant);
    for (const float sg : {-1.f, 1.f}) {
        k.board(frame, {sg * 0.5f * (s.x - f), 0, 0.0125f}, {f, s.y, 0.025f}, 0.003f);
        k.board(frame, {0, sg > 0 ? s.y - f : 0.f, 0.0125f}, {s.x - 2 * f, f, 0.025f}, 0.003f);
    }
    k.board(mat_board, {0, f, 0.007f}, {s.x - 2 * f, s.y - 2 * f, 0.012f}, 0.001f);
    Mesh canvas = shapes::box({w, h, 0.003f}, 0.0006f);
    canvas.coords = canvas.positions;
    for (Vec3f& c : canvas.coords)
        c = {c.x + 0.5f * w + step * static_cast<float>(panel.number), 0.5f * h - c.y,
             c.z};  // from the picture's upper left corner
    if (!motif) k.add(std::move(canvas), art, {0, 0.5f * s.y, 0.0135f});
    k.piece.mount = Mount::wall;
    // Its middle at the height of eyes, as galleries hang them.
    constexpr float kMiddle_m = 1.52f;
    k.piece.hang_height_m = kMiddle_m - 0.5f * s.y;
}

}  // namespace fastscene::furniture
