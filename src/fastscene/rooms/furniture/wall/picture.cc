// Picture.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/wall/framed_art.h"
#include "fastscene/rooms/furniture/wall/motifs.h"
#include "fastscene/rooms/furniture/wall/panels.h"

namespace fastscene::furniture {
namespace {

// The rest are graphic designs in the style's own colors.
constexpr float kFramedShare = 0.6f;

// Paintings where there are rich mouldings, rather photographs and prints elsewhere.
Genre genre_for(Kit& k) {
    const float painted = k.style.mouldings == Mouldings::rich ? 0.75f : 0.3f, at = k.rng.uniform();
    return at < painted ? Genre::painting : at < painted + 0.6f * (1 - painted) ? Genre::print : Genre::photo;
}

// Coordinates of a picture that covers a rectangle of this size, of which the canvas begins at `from_left`; what
// does not fit is cut off at the sides, `shift` in [0, 1] of it at the left.
void cover(Mesh& canvas, const ImageRgb8& image, Vec2f size, float from_left, float shift) {
    const float aspect = static_cast<float>(image.width) / static_cast<float>(image.height),
                share_x = std::min(1.f, size.x / size.y / aspect), share_y = std::min(1.f, aspect * size.y / size.x);
    for (Vec3f& c : canvas.coords)
        c = {shift * (1 - share_x) + share_x * (c.x + from_left) / size.x, 0.5f + share_y * c.y / size.y, 0};
}

}  // namespace

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
    const float art_width = w + step * static_cast<float>(panel.of - 1);
    m.scale_m = art_width;
    m.seed = k.seed();
    m.variant = static_cast<std::uint8_t>(k.rng.index(kArtDesigns));
    const bool motif = is_motif(k.request.pattern), is_colored = k.request.color || !k.request.color_name.empty();
    std::optional<FramedArt> framed;
    if (!motif && !is_colored && k.rng.chance(kFramedShare)) {
        framed = framed_art(genre_for(k), m.seed);
        m = plain(kFramedArt, {1, 1, 1}, 0.5f);
        m.pattern = Pattern::image;
        m.image = framed->image;
        m.scale_m = art_width;
    }
    if (motif) draw_motif(k, k.request.pattern, {0, 0.5f * s.y, 0.0145f}, w, h);
    const int art = motif ? -1 : k.main(m);
    k.piece.form = motif    ? k.request.pattern
                   : framed ? std::string(framed->name)
                            : "design " + std::to_string(m.variant);
    for (const float sg : {-1.f, 1.f}) {
        k.board(frame, {sg * 0.5f * (s.x - f), 0, 0.0125f}, {f, s.y, 0.025f}, 0.003f);
        k.board(frame, {0, sg > 0 ? s.y - f : 0.f, 0.0125f}, {s.x - 2 * f, f, 0.025f}, 0.003f);
    }
    k.board(mat_board, {0, f, 0.007f}, {s.x - 2 * f, s.y - 2 * f, 0.012f}, 0.001f);
    Mesh canvas = shapes::box({w, h, 0.003f}, 0.0006f);
    canvas.coords = canvas.positions;
    const float from_left = step * static_cast<float>(panel.number);
    if (framed) cover(canvas, framed->image->levels[0], {m.scale_m, h}, from_left + 0.5f * w, k.rng.uniform());
    else  // from the picture's upper left corner
        for (Vec3f& c : canvas.coords) c = {c.x + 0.5f * w + from_left, 0.5f * h - c.y, c.z};
    if (!motif) k.add(std::move(canvas), art, {0, 0.5f * s.y, 0.0135f});
    k.piece.mount = Mount::wall;
    // Its middle at the height of eyes, as galleries hang them.
    constexpr float kMiddle_m = 1.52f;
    k.piece.hang_height_m = kMiddle_m - 0.5f * s.y;
}

}  // namespace fastscene::furniture
