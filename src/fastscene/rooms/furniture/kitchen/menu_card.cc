// What stands on a café's table: a card in a holder, a sugar pourer.
#include <array>
#include <utility>

#include "fastscene/rooms/furniture/lettering.h"
#include "fastscene/rooms/furniture/shop/goods.h"
#include "fastscene/rooms/furniture/wall/boards.h"

namespace fastscene::furniture {

void build_menu_card(Kit& k) {
    const int card = k.main(plain("menu card", {0.66f, 0.62f, 0.52f}, 0.7f)), wood = k.material(k.style.wood2),
              ink = color(k, "ink", {0.08f, 0.05f, 0.04f}, 0.7f),
              sugar = color(k, "sugar", {0.72f, 0.71f, 0.68f}, 0.12f), metal = k.material(steel());
    k.board(wood, {0, 0, 0}, {0.11f, 0.025f, 0.05f}, 0.004f);
    k.board(card, {0, 0.02f, 0}, {0.1f, 0.17f, 0.004f}, 0.0008f);
    {
        Chalk pen(k, ink, 0.0026f, 0.0022f);
        const float w = letters_width("MENU", 0.018f);
        for (Stroke stroke : letter_strokes("MENU", 0.018f)) {
            for (Vec2f& p : stroke) p = p + Vec2f{-0.5f * w, 0.155f};
            pen.line(stroke);
        }
        for (int i = 0; i < 7; ++i) {
            const float y = 0.137f - 0.014f * static_cast<float>(i);
            pen.line({{-0.038f, y}, {-0.038f + k.rng.uniform(0.03f, 0.05f), y}});
            pen.line({{0.026f, y}, {0.038f, y}});
        }
    }
    const std::array<Vec2f, 4> pourer{Vec2f{0.03f, 0}, {0.033f, 0.03f}, {0.03f, 0.09f}, {0.025f, 0.1f}},
        lid{Vec2f{0.026f, 0.1f}, {0.024f, 0.115f}, {0.008f, 0.125f}};
    k.add(shapes::lathe(pourer, 16, true), sugar, {0.105f, 0, 0.01f});
    k.add(shapes::lathe(lid, 16), metal, {0.105f, 0, 0.01f});
    k.rod(metal, {0.105f, 0.12f, 0.01f}, {0.116f, 0.145f, 0.01f}, 0.005f, -1, 8);
    on_surface(k);
}

}  // namespace fastscene::furniture
