// Of passages between rooms: doors with numbers, the sign of the way out, the fronts and stairs of malls.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/lettering.h"
#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// A closed door in its frame, with a number, as along the corridors of hotels and offices.
void build_room_door(Kit& k) {
    const Vec3f s = k.wanted({1.04f, 2.12f, 0.06f});
    const int leaf = k.main(k.style.wood), frame = k.material(k.style.trim), metal = k.material(k.style.metal),
              dark = color(k, "lock", {0.02f, 0.02f, 0.022f}, 0.4f);
    constexpr float kFrame = 0.09f, kSkirting = 0.02f;  // which goes on behind it
    const float wide = s.x - 2 * kFrame, high = s.y - kFrame;
    for (const float side : {-1.f, 1.f})
        k.board(frame, {side * 0.5f * (s.x - kFrame), 0, 0.5f * (s.z + kSkirting)}, {kFrame, s.y, s.z - kSkirting},
                0.008f);
    k.board(frame, {0, high, 0.5f * s.z}, {wide, kFrame, s.z}, 0.008f);
    Mesh panel = shapes::box({wide, high - 0.006f, 0.024f}, 0.003f);
    shapes::lay_grain(panel, {k.rng.uniform(0, 3), k.rng.uniform(0, 3), 0});
    k.add(std::move(panel), leaf, {0, 0.5f * high + 0.003f, kSkirting + 0.013f});
    // Two fields, framed by flat mouldings.
    for (const auto& [y0, y1] : {std::pair{0.16f, 0.86f}, {1.02f, high - 0.14f}})
        for (const float side : {-1.f, 1.f}) {
            k.board(leaf, {side * (0.5f * wide - 0.13f), y0, kSkirting + 0.028f}, {0.022f, y1 - y0, 0.01f}, 0.004f);
            k.board(leaf, {0, side < 0 ? y0 : y1 - 0.022f, kSkirting + 0.028f}, {wide - 0.28f, 0.022f, 0.01f}, 0.004f);
        }
    // The handle with a reader for cards, the spy-hole, the plate.
    const float x = 0.5f * wide - 0.075f;
    k.board(dark, {x, 0.98f, kSkirting + 0.03f}, {0.05f, 0.2f, 0.012f}, 0.008f);
    k.rod(metal, {x, 1.03f, kSkirting + 0.03f}, {x, 1.03f, kSkirting + 0.078f}, 0.009f, -1, 10);
    k.rod(metal, {x + 0.005f, 1.03f, kSkirting + 0.075f}, {x - 0.12f, 1.03f, kSkirting + 0.075f}, 0.009f, -1, 10);
    k.add(shapes::ball({0, 1.5f, kSkirting + 0.026f}, {0.012f, 0.012f, 0.006f}, 10), metal);
    sign(k, std::to_string(101 + k.rng.index(48)), {0.035f, 0.037f, 0.042f}, {0.7f, 0.66f, 0.55f},
         {-0.085f, 1.6f, kSkirting + 0.034f}, {0.17f, 0.1f});
    k.piece.mount = Mount::wall;
}

// The way out: green, lit, with someone who runs to an open door.
void build_exit_sign(Kit& k) {
    const Vec3f s = k.wanted({0.42f, 0.3f, 0.04f});
    Material shine = glow("exit green", {0.005f, 0.3f, 0.075f}), pale = glow("exit white", {1.f, 1.1f, 1.f});
    shine.pattern = pale.pattern = Pattern::screen;
    const int rim = k.main(plain("sign case", {0.66f, 0.66f, 0.66f}, 0.4f)), green = k.material(std::move(shine)),
              white = k.material(std::move(pale)), metal = k.material(steel());
    constexpr float kPlate = 0.2f;
    const float low = -s.y;
    for (const float x : {-0.14f, 0.14f}) k.rod(metal, {x, low + kPlate, 0}, {x, 0, 0}, 0.006f, -1, 6);
    k.board(rim, {0, low, 0}, {s.x, kPlate, s.z}, 0.006f);
    for (const float side : {-1.f, 1.f}) {
        const float z = side * (0.5f * s.z + 0.002f);
        block(k, green, {0, low + 0.01f, z}, {s.x - 0.02f, kPlate - 0.02f, 0.003f});
        const float f = side * (0.5f * s.z + 0.0045f);
        block(k, white, {0.12f, low + 0.035f, f}, {0.075f, 0.13f, 0.002f});
        // Trunk, head, arms and legs.
        const Vec3f hip{-0.005f, low + 0.085f, f}, neck{0.015f, low + 0.13f, f};
        slat(k, white, hip, neck, 0.024f, 0.002f);
        block(k, white, {0.028f, low + 0.138f, f}, {0.024f, 0.024f, 0.002f});
        slat(k, white, neck, neck + Vec3f{0.04f, -0.02f, 0}, 0.011f, 0.002f);
        slat(k, white, neck, neck + Vec3f{-0.045f, -0.022f, 0}, 0.011f, 0.002f);
        slat(k, white, hip, hip + Vec3f{0.045f, -0.03f, 0}, 0.014f, 0.002f);
        slat(k, white, hip, hip + Vec3f{-0.03f, -0.045f, 0}, 0.014f, 0.002f);
        slat(k, white, {-0.16f, low + 0.1f, f}, {-0.09f, low + 0.1f, f}, 0.016f, 0.002f);
        for (const float up : {-1.f, 1.f})
            slat(k, white, {-0.165f, low + 0.1f, f}, {-0.135f, low + 0.1f + up * 0.03f, f}, 0.016f, 0.002f);
    }
    k.piece.mount = Mount::ceiling;
}

// The large mirror at the back of a lift.
void build_lift_mirror(Kit& k) {
    const Vec3f s = k.wanted({1.6f, 1.1f, 0.02f});
    Material silver = plain("mirror", {0.86f, 0.87f, 0.87f}, 0.f);
    silver.mirror = 1;
    const int frame = k.main(steel()), pane = k.material(silver);
    k.board(frame, {0, 0, 0.4f * s.z}, {s.x, s.y, 0.8f * s.z}, 0.004f);
    block(k, pane, {0, 0.02f, 0.8f * s.z}, {s.x - 0.04f, s.y - 0.04f, 0.004f});
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.02f;
}

namespace {

const char* shop_name(Kit& k) {
    constexpr std::array kNames{"NORD", "LUMEN", "ATLAS", "VELO", "MODA", "PIXEL", "AURA", "TOTEM", "OPTIK", "SPORT"};
    return kNames[static_cast<std::size_t>(k.rng.index(static_cast<int>(kNames.size())))];
}

// Letters of tubes that shine, about the middle of their lower edge.
void shining_name(Kit& k, int ink, std::string_view text, Vec3f at, float high, float widest) {
    const float height = std::min(high, high * widest / std::max(0.01f, letters_width(text, high))),
                left = -0.5f * letters_width(text, height);
    for (const std::vector<Vec2f>& line : letter_strokes(text, height))
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const Vec3f a{line[i].x + left, line[i].y, 0}, b{line[i + 1].x + left, line[i + 1].y, 0};
            if (length(b - a) > 1e-4f) slat(k, ink, at + a, at + b, 0.14f * height, 0.02f);
        }
}

}  // namespace

// A shop seen from the walk before it: a glazed front, goods and figures behind it, its sign above.
void build_shop_front(Kit& k) {
    const Vec3f s = k.wanted({3.8f, 3.1f, 1.3f});
    const Vec3f tone = k.request.color ? *k.request.color : k.accent();
    const int
        frame = k.main(plain("shop frame", tone * 0.5f, 0.35f)),
        pane = k.material(glass()), wall = color(k, "shop wall", {0.66f, 0.64f, 0.6f}, 0.8f),
        floor = k.material(k.style.wood), ink = k.material([&] {
            Material m = glow("sign", tone / std::max(0.1f, max_component(tone)) * 2.4f + Vec3f{0.3f, 0.3f, 0.3f});
            m.pattern = Pattern::screen;
            return m;
        }()),
        strip = k.material([] {
            Material m = glow("shop light", {6.5f, 6.f, 5.2f});
            m.pattern = Pattern::screen;
            return m;
        }()),
        dark = color(k, "fascia", {0.03f, 0.03f, 0.033f}, 0.4f);
    const float back = -0.5f * s.z, front = 0.5f * s.z, sign = 0.6f, head = s.y - sign;
    block(k, wall, {0, 0, back + 0.02f}, {s.x, head, 0.04f});
    for (const float sx : {-1.f, 1.f}) {
        block(k, wall, {sx * (0.5f * s.x - 0.03f), 0, 0}, {0.06f, head, s.z - 0.04f});
        k.board(frame, {sx * (0.5f * s.x - 0.05f), 0, front - 0.06f}, {0.1f, head, 0.12f}, 0.006f);
    }
    k.board(floor, {0, 0, 0}, {s.x, 0.12f, s.z - 0.02f}, 0.004f);
    k.board(dark, {0, head, 0}, {s.x, sign, s.z}, 0.006f);
    k.board(strip, {0, head - 0.03f, back + 0.5f}, {s.x - 0.5f, 0.03f, 0.12f});
    k.board(frame, {0, head - 0.1f, front - 0.06f}, {s.x, 0.1f, 0.12f}, 0.006f);
    shining_name(k, ink, shop_name(k), {0, head + 0.16f, front + 0.012f}, 0.28f, 0.8f * s.x);
    // Panes left and right of a door.
    const float door = 1.1f, side = 0.5f * (s.x - 0.2f - door);
    for (const float sx : {-1.f, 1.f}) {
        const float wx = sx * (0.5f * door + 0.5f * side);
        block(k, pane, {wx, 0.14f, front - 0.06f}, {side, head - 0.24f, 0.012f});
        k.board(frame, {sx * 0.5f * door, 0, front - 0.06f}, {0.06f, head, 0.1f}, 0.005f);
        // What is shown: shelves with goods, or figures.
        if (k.rng.chance(0.5f)) {
            const Goods goods = std::array{Goods::shoes, Goods::toys, Goods::books,
                                           Goods::boxes}[static_cast<std::size_t>(k.rng.index(4))];
            for (int level = 0; level < 4; ++level) {
                const float y = 0.35f + 0.48f * static_cast<float>(level);
                k.board(floor, {wx, y - 0.03f, back + 0.22f}, {side - 0.1f, 0.03f, 0.36f}, 0.003f);
                stock(k, goods, wx - 0.5f * side + 0.1f, wx + 0.5f * side - 0.1f, y, 0.44f, back + 0.4f, 0.32f);
            }
        } else {
            k.merge(k.small("mannequin"), {wx, 0.12f, 0.05f * sx});
        }
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 1.2f;
}

namespace {

// The height of a storey of a mall, from floor to floor.
constexpr float kStorey = 3.5f, kSlab = 0.3f, kParapet = 1.05f;

// A balustrade of glass along x at the edge of a slab.
void glass_parapet(Kit& k, int pane, int rail, float x0, float x1, float y, float z) {
    k.board(pane, {0.5f * (x0 + x1), y + 0.04f, z}, {x1 - x0 - 0.04f, kParapet - 0.1f, 0.014f}, 0.002f);
    k.rod(rail, {x0, y + kParapet, z}, {x1, y + kParapet, z}, 0.026f, -1, 10);
    block(k, rail, {0.5f * (x0 + x1), y, z}, {x1 - x0, 0.05f, 0.05f});
}

// A lit shop behind panes, of few triangles: it is seen from afar.
void upper_shop(Kit& k, float x0, float x1, float y, float high, float back, float front) {
    const Vec3f tone = k.accent();
    const int wall = color(k, "upper shop", {0.7f, 0.68f, 0.64f}, 0.7f),
              frame = color(k, "upper frame", tone * 0.5f, 0.4f), pane = k.material(glass()),
              strip = lit(k, "shop light", {6.f, 5.6f, 5.f}),
              goods = color(k, "goods", lerp(tone, {0.4f, 0.35f, 0.3f}, 0.5f), 0.7f);
    const float middle = 0.5f * (x0 + x1), wide = x1 - x0, sign_high = 0.5f, head = high - sign_high;
    block(k, wall, {middle, y, back + 0.02f}, {wide, high, 0.04f});
    block(k, frame, {middle, y + head, 0.5f * (back + front)}, {wide, sign_high, front - back});
    for (const float x : {x0 + 0.05f, middle - 0.5f, middle + 0.5f, x1 - 0.05f})
        block(k, frame, {x, y, front - 0.04f}, {0.08f, head, 0.08f});
    for (const float side : {-1.f, 1.f})
        block(k, pane, {middle + side * (0.25f * wide + 0.24f), y + 0.05f, front - 0.04f},
              {0.5f * wide - 0.6f, head - 0.06f, 0.01f});
    block(k, strip, {middle, y + head - 0.04f, back + 0.35f}, {wide - 0.4f, 0.03f, 0.12f});
    for (int level = 0; level < 3; ++level)
        for (float x = x0 + 0.25f; x < x1 - 0.2f; x += 0.42f)
            if (k.rng.chance(0.75f))
                block(k, goods, {x, y + 0.25f + 0.62f * static_cast<float>(level), back + 0.16f},
                      {0.3f, k.rng.uniform(0.18f, 0.4f), 0.2f});
    sign(k, shop_name(k), tone * 0.35f, {0.85f, 0.84f, 0.8f}, {middle - 0.3f * wide, y + head + 0.06f, front + 0.004f},
         {0.6f * wide, sign_high - 0.12f});
}

}  // namespace

namespace {

// A shop of this width at the floor, its back at z.
void lower_shop(Kit& k, float width, float back) {
    PieceRequest shop;
    shop.kind = "shop_front", shop.style = &k.style, shop.size_m.x = width;
    shop.seed = k.rng.next_u64();
    const Piece piece = make_piece(shop);
    k.merge(piece, {0, 0, back + 0.5f * piece.size_m.z});
}

}  // namespace

// Two storeys of a mall's side: a shop at the floor, before the one above it a gallery with a balustrade of glass.
void build_shop_gallery(Kit& k) {
    const Vec3f s = k.wanted({3.9f, 2 * kStorey - 0.3f, 2.7f});
    const int slab = k.main(plain("gallery", {0.72f, 0.71f, 0.69f}, 0.4f)), pane = k.material(glass()),
              rail = k.material(steel()), lamp = lit(k, "gallery lamp", {7.f, 6.6f, 6.f});
    const float back = -0.5f * s.z, front = 0.5f * s.z;
    lower_shop(k, s.x - 0.1f, back);
    block(k, slab, {0, kStorey - kSlab, 0}, {s.x, kSlab, s.z - 0.06f});
    glass_parapet(k, pane, rail, -0.5f * s.x, 0.5f * s.x, kStorey, front - 0.06f);
    for (const float x : {-0.3f * s.x, 0.f, 0.3f * s.x})  // in the gallery's underside
        k.add(shapes::prism(shapes::circle(0.07f, 16), kStorey - kSlab - 0.008f, kStorey - kSlab, 0.001f), lamp,
              {x, 0, 0.25f * s.z});
    k.add(shapes::prism(shapes::circle(0.17f, 24), 0, kStorey - kSlab, 0.002f), slab,
          {-0.5f * s.x + 0.2f, 0, front - 0.35f});
    upper_shop(k, -0.5f * s.x, 0.5f * s.x, kStorey, s.y - kStorey, back, back + 0.8f);
    k.piece.against_wall = true;
}

// Moving stairs side by side, up and down, a storey high.
void build_escalator_pair(Kit& k) {
    const Vec3f s = k.wanted({3.2f, kStorey + 1, 6.4f});
    for (const float side : {-1.f, 1.f}) {
        PieceRequest one = k.request;
        one.kind = "escalator", one.size_factor = 1, one.size_m = {0.5f * s.x - 0.06f, s.y, s.z};
        one.seed = k.rng.next_u64();
        k.merge(make_piece(one), {side * 0.25f * s.x, 0, 0});
    }
    k.piece.clearance_front_m = 1.2f;
}

// The bridge between two galleries, at the head of the moving stairs; open where they arrive.
void build_gallery_bridge(Kit& k) {
    const Vec3f s = k.wanted({6.6f, 2 * kStorey - 0.3f, 2.2f});
    const int slab = k.main(plain("gallery", {0.72f, 0.71f, 0.69f}, 0.4f)), pane = k.material(glass()),
              rail = k.material(steel());
    const float back = -0.5f * s.z, front = 0.5f * s.z, half = 0.5f * s.x, stairs = 1.75f;
    block(k, slab, {0, kStorey - kSlab, 0}, {s.x, kSlab, s.z - 0.06f});
    for (const float side : {-1.f, 1.f})
        glass_parapet(k, pane, rail, side < 0 ? -half : stairs, side < 0 ? -stairs : half, kStorey, front - 0.06f);
    lower_shop(k, 3.8f, back);
    for (const float side : {-1.f, 1.f})
        upper_shop(k, side < 0 ? -half : 0.05f, side < 0 ? -0.05f : half, kStorey, s.y - kStorey, back, back + 0.8f);
    k.piece.against_wall = true;
}

// The glazed roof of a mall: panes of a bright sky between beams, along the middle.
void build_mall_roof(Kit& k) {
    const Vec3f s = k.wanted({6, 0.5f, 14});
    const int beam = k.main(plain("roof beam", {0.6f, 0.6f, 0.6f}, 0.4f)), sky = k.material([] {
        Material m = glow("roof pane", {2.6f, 3.f, 3.5f});
        m.pattern = Pattern::screen;
        return m;
    }());
    constexpr float kCell = 1.5f;
    const float half_x = 0.5f * std::min(s.x, 5.6f), half_z = 0.5f * s.z - 0.3f;
    block(k, sky, {0, -0.03f, 0}, {2 * half_x, 0.02f, 2 * half_z});
    const int rows = std::max(1, static_cast<int>(2 * half_z / kCell));
    for (int i = 0; i <= rows; ++i) {
        const float z = half_z * (2 * static_cast<float>(i) / static_cast<float>(rows) - 1);
        block(k, beam, {0, -s.y, z}, {2 * half_x, s.y - 0.005f, 0.09f});
    }
    for (int i = -2; i <= 2; ++i) {
        const bool edge = i == -2 || i == 2;
        block(k, beam, {0.5f * half_x * static_cast<float>(i), edge ? -s.y - 0.04f : -0.22f, 0},
              {edge ? 0.16f : 0.06f, edge ? s.y + 0.035f : 0.215f, 2 * half_z + 0.1f});
    }
    k.piece.mount = Mount::ceiling;
}

}  // namespace fastscene::furniture
