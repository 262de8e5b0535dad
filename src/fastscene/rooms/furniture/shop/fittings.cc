// What stands about in shops, markets and halls: tills, kiosks, carts, racks, booths.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/furniture/profiles.h"
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// The wires of a basket: rails at both ends of the sides, uprights between.
void wire_basket(Kit& k, int bars, Vec3f base, Vec3f low, Vec3f high, float height, int across, int deep) {
    const auto at = [&](float u, float v, float t) {
        return base +
               Vec3f{0.5f * u * (low.x + (high.x - low.x) * t), height * t, 0.5f * v * (low.z + (high.z - low.z) * t)};
    };
    for (const float t : {0.f, 0.35f, 0.7f, 1.f})
        for (const float s : {-1.f, 1.f}) {
            const float r = t == 1.f ? 0.006f : 0.0025f;
            wire(k, bars, at(-1, s, t), at(1, s, t), r), wire(k, bars, at(s, -1, t), at(s, 1, t), r);
        }
    for (int i = 0; i <= across; ++i) {
        const float u = 2.f * static_cast<float>(i) / static_cast<float>(across) - 1.f;
        for (const float s : {-1.f, 1.f}) wire(k, bars, at(u, s, 0), at(u, s, 1), 0.0025f);
        wire(k, bars, at(u, -1, 0), at(u, 1, 0), 0.0025f);
    }
    for (int i = 1; i < deep; ++i)
        for (const float s : {-1.f, 1.f}) {
            const float v = 2.f * static_cast<float>(i) / static_cast<float>(deep) - 1.f;
            wire(k, bars, at(s, v, 0), at(s, v, 1), 0.0025f);
        }
}

void till_keys(Kit& k, int key, Vec3f at, int columns, int rows, float pitch, float tilt) {
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            block(k, key,
                  at + Vec3f{pitch * (static_cast<float>(i) - 0.5f * static_cast<float>(columns - 1)),
                             tilt * static_cast<float>(j), -pitch * static_cast<float>(j)},
                  {0.8f * pitch, 0.012f, 0.8f * pitch});
}

}  // namespace

// A till: a drawer, keys, a lit display for who pays, a screen for who sells.
void build_cash_register(Kit& k) {
    const int body = k.main(plain("till", {0.06f, 0.062f, 0.066f}, 0.45f)),
              pale = color(k, "key", {0.55f, 0.54f, 0.5f}, 0.5f),
              red = color(k, "red key", {0.45f, 0.05f, 0.03f}, 0.5f), show = lit(k, "display", {0.15f, 1.4f, 0.9f}),
              metal = k.material(steel()), paper = color(k, "receipt", {0.74f, 0.73f, 0.7f}, 0.8f);
    k.board(body, {0, 0, 0}, {0.42f, 0.11f, 0.42f}, 0.008f),
        k.board(metal, {0, 0.02f, 0.211f}, {0.39f, 0.075f, 0.006f}, 0.002f),
        k.rod(metal, {0, 0.06f, 0.212f}, {0, 0.06f, 0.222f}, 0.014f, -1, 10);
    const std::array<Vec2f, 5> desk{
        Vec2f{-0.2f, 0.11f}, {0.19f, 0.11f}, {0.19f, 0.14f}, {-0.04f, 0.22f}, {-0.2f, 0.26f}};
    k.add(side_prism(desk, -0.2f, 0.2f, 0.008f), body);
    till_keys(k, pale, {-0.06f, 0.148f, 0.155f}, 5, 5, 0.036f, 0.0125f),
        till_keys(k, red, {0.12f, 0.148f, 0.155f}, 2, 5, 0.036f, 0.0125f);
    k.board(body, {-0.06f, 0.24f, -0.13f}, {0.24f, 0.12f, 0.06f}, 0.01f),
        block(k, show, {-0.06f, 0.275f, -0.098f}, {0.19f, 0.05f, 0.004f});
    k.rod(metal, {0.13f, 0.25f, -0.14f}, {0.13f, 0.4f, -0.14f}, 0.012f, -1, 10),
        k.board(body, {0.13f, 0.4f, -0.14f}, {0.16f, 0.07f, 0.05f}, 0.01f),
        block(k, show, {0.13f, 0.415f, -0.167f}, {0.13f, 0.04f, 0.004f}),
        block(k, show, {0.13f, 0.415f, -0.113f}, {0.13f, 0.04f, 0.004f});
    Mesh slip = shapes::box({0.06f, 0.11f, 0.002f}, 0.0005f);
    shapes::turn(slip, {1, 0, 0}, -14);
    k.add(std::move(slip), paper, {0.1f, 0.28f, -0.08f});
    on_surface(k);
}

// A pillar with a tall touch screen, a card reader and a slot for the receipt.
void build_self_service_kiosk(Kit& k) {
    static constexpr std::array<Vec3f, 6> kDishes{Vec3f{1.3f, 0.6f, 0.12f}, {0.9f, 0.25f, 0.12f}, {0.4f, 0.8f, 0.2f},
                                                  {1.2f, 0.95f, 0.3f},      {0.9f, 0.45f, 0.5f},  {0.5f, 0.3f, 0.16f}};
    const int body = k.main(plain("kiosk", {0.6f, 0.6f, 0.58f}, 0.35f)),
              dark = color(k, "bezel", {0.018f, 0.018f, 0.02f}, 0.2f),
              page = lit(k, "touch screen", {1.5f, 1.5f, 1.45f}), bar = lit(k, "screen bar", {1.1f, 0.12f, 0.08f}),
              buy = lit(k, "screen button", {0.15f, 0.9f, 0.25f}), text = lit(k, "screen text", {0.25f, 0.24f, 0.24f}),
              metal = k.material(steel());
    k.board(metal, {0, 0, 0}, {0.5f, 0.02f, 0.45f}, 0.006f),
        k.board(body, {0, 0.02f, -0.02f}, {0.4f, 0.86f, 0.16f}, 0.03f),
        k.board(body, {0, 0.8f, -0.02f}, {0.56f, 0.96f, 0.12f}, 0.03f),
        k.board(dark, {0, 0.85f, 0.035f}, {0.52f, 0.87f, 0.012f}, 0.004f);
    const float z = 0.042f;
    block(k, page, {0, 0.875f, z}, {0.48f, 0.82f, 0.004f}),
        block(k, bar, {0, 1.59f, z + 0.002f}, {0.48f, 0.1f, 0.004f}),
        block(k, buy, {0.13f, 0.9f, z + 0.002f}, {0.19f, 0.07f, 0.004f}),
        block(k, text, {-0.11f, 0.92f, z + 0.002f}, {0.2f, 0.022f, 0.004f});
    for (int i = 0; i < 6; ++i) {
        const Vec3f at{i % 2 ? 0.115f : -0.115f, 1.4f - 0.19f * static_cast<float>(i / 2), z + 0.002f};
        k.rod(lit(k, "dish", kDishes[static_cast<std::size_t>(i)]), at + Vec3f{0, 0.1f, -0.003f},
              at + Vec3f{0, 0.1f, 0.003f}, 0.055f, -1, 16),
            block(k, text, at + Vec3f{0, 0.012f, 0}, {0.13f, 0.014f, 0.004f});
    }
    k.board(dark, {0.1f, 0.66f, 0.08f}, {0.09f, 0.14f, 0.05f}, 0.008f),
        block(k, buy, {0.1f, 0.74f, 0.106f}, {0.06f, 0.035f, 0.002f}),
        block(k, dark, {-0.1f, 0.7f, 0.06f}, {0.12f, 0.05f, 0.006f}),
        block(k, text, {-0.1f, 0.655f, 0.06f}, {0.08f, 0.06f, 0.003f});
    k.piece.clearance_front_m = 0.8f;
}

void build_shopping_cart(Kit& k) {
    const int wire = k.main(steel()), grip = color(k, "handle", {0.45f, 0.03f, 0.03f}, 0.4f),
              tire = color(k, "castor", {0.04f, 0.04f, 0.042f}, 0.7f);
    wire_basket(k, wire, {0, 0.5f, 0.06f}, {0.4f, 0, 0.66f}, {0.54f, 0, 0.86f}, 0.46f, 9, 12);
    for (const float sx : {-1.f, 1.f}) {
        const float x = 0.25f * sx;
        const std::array<Vec3f, 5> rail{Vec3f{0.22f * sx, 0.16f, 0.42f},
                                        {x, 0.16f, -0.1f},
                                        {x, 0.2f, -0.38f},
                                        {x, 0.5f, -0.36f},
                                        {x * 1.1f, 1.02f, -0.46f}};
        k.add(shapes::tube(rail, 0.013f, 8), wire),
            k.rod(wire, {0.21f * sx, 0.16f, 0.3f}, {0.19f * sx, 0.5f, 0.3f}, 0.011f, -1, 8);
        for (const float z : {-0.36f, 0.4f})
            k.rod(tire, {x * 0.92f - 0.018f, 0.062f, z}, {x * 0.92f + 0.018f, 0.062f, z}, 0.062f, -1, 14),
                k.board(wire, {x * 0.92f, 0.06f, z}, {0.045f, 0.1f, 0.03f}, 0.004f);
    }
    k.rod(grip, {-0.28f, 1.02f, -0.46f}, {0.28f, 1.02f, -0.46f}, 0.018f, -1, 12);
    for (int i = 0; i < 7; ++i)
        k.rod(wire, {-0.21f + 0.07f * static_cast<float>(i), 0.2f, -0.3f},
              {-0.21f + 0.07f * static_cast<float>(i), 0.17f, 0.36f}, 0.004f, -1, 5);
    k.rod(wire, {-0.22f, 0.17f, 0.36f}, {0.22f, 0.17f, 0.36f}, 0.006f, -1, 6),
        k.rod(wire, {-0.24f, 0.2f, -0.3f}, {0.24f, 0.2f, -0.3f}, 0.006f, -1, 6);
}

void build_shopping_basket(Kit& k) {
    const int wire = k.main(plain("plastic", {0.45f, 0.03f, 0.03f}, 0.4f)), metal = k.material(steel());
    const Vec3f low{0.34f, 0, 0.22f}, high{0.43f, 0, 0.29f};
    wire_basket(k, wire, {0, 0.01f, 0}, low, high, 0.22f, 10, 7);
    block(k, wire, {0, 0, 0}, {0.35f, 0.012f, 0.23f});
    for (const float s : {-1.f, 1.f}) {
        block(k, wire, {0, 0.2f, s * 0.145f}, {0.44f, 0.035f, 0.008f}),
            block(k, wire, {s * 0.215f, 0.2f, 0}, {0.008f, 0.035f, 0.29f}),
            block(k, wire, {0, 0.09f, s * 0.126f}, {0.385f, 0.03f, 0.006f});
        const std::array<Vec3f, 4> bow{Vec3f{-0.2f, 0.215f, s * 0.06f},
                                       {-0.14f, 0.33f, s * 0.014f},
                                       {0.14f, 0.33f, s * 0.014f},
                                       {0.2f, 0.215f, s * 0.06f}};
        k.add(shapes::tube(bow, 0.006f, 6), metal);
    }
}

// A counter under a striped awning on four posts, goods and a lit sign.
void build_market_stall(Kit& k) {
    const Vec3f s = k.wanted({2.2f, 2.5f, 1.4f});
    const int awning = k.main(plain("awning", k.accent(), 0.85f)),
              pale = color(k, "awning stripe", {0.7f, 0.67f, 0.6f}, 0.85f), wood = k.material(k.style.wood),
              bulb = k.material(glow("bulb", {9, 7, 4}));
    k.board(wood, {0, 0.86f, 0}, {s.x, 0.05f, 0.85f}, 0.006f);
    for (int i = 0; i < 8; ++i)
        k.board(wood, {s.x * ((static_cast<float>(i) + 0.5f) / 8 - 0.5f), 0.04f, 0.38f},
                {s.x / 8 - 0.008f, 0.82f, 0.02f}, 0.003f);
    for (const float sx : {-1.f, 1.f}) {
        block(k, wood, {sx * (0.5f * s.x - 0.02f), 0.04f, 0}, {0.03f, 0.82f, 0.74f});
        for (const float sz : {-1.f, 1.f})
            k.board(wood, {sx * (0.5f * s.x - 0.03f), 0, sz * 0.4f}, {0.07f, (sz > 0 ? 0.82f : 0.9f) * s.y, 0.07f},
                    0.006f);
    }
    const int stripes = std::max(6, 2 * static_cast<int>(s.x / 0.36f)) + 1;
    const float w = s.x / static_cast<float>(stripes);
    for (int i = 0; i < stripes; ++i) {
        const float x = w * (static_cast<float>(i) - 0.5f * static_cast<float>(stripes - 1));
        const std::array<Vec2f, 4> top{Vec2f{-0.5f * s.z, 0.93f * s.y},
                                       {0.5f * s.z, 0.82f * s.y},
                                       {0.5f * s.z, 0.826f * s.y},
                                       {-0.5f * s.z, 0.937f * s.y}};
        k.add(side_prism(top, x - 0.5f * w, x + 0.5f * w, 0.001f), i % 2 ? pale : awning);
        std::vector<Vec2f> flap{{-0.5f * w, 0}, {0.5f * w, 0}};  // its lower edge is round
        for (int a = 0; a <= 6; ++a)
            flap.push_back({0.5f * w * std::cos(kPi * static_cast<float>(a) / 6.f),
                            -0.1f - 0.06f * std::sin(kPi * static_cast<float>(a) / 6.f)});
        k.add(front_prism(flap, 0.5f * s.z - 0.004f, 0.5f * s.z + 0.004f, 0.001f), i % 2 ? pale : awning,
              {x, 0.826f * s.y, 0});
    }
    for (const float x : {-0.3f, 0.3f})
        k.rod(wood, {x * s.x, 0.9f * s.y, 0}, {x * s.x, 0.78f * s.y, 0}, 0.006f, -1, 6),
            k.add(shapes::ball({x * s.x, 0.76f * s.y, 0}, {0.045f, 0.055f, 0.045f}, 10), bulb);
    const Goods goods = k.rng.chance(0.5f) ? Goods::preserves : Goods::bread;
    stock(k, goods, -0.5f * s.x + 0.1f, 0.5f * s.x - 0.1f, 0.91f, 0.3f, 0.36f, 0.3f),
        stock(k, Goods::packets, -0.5f * s.x + 0.1f, 0.5f * s.x - 0.1f, 0.91f, 0.26f, -0.05f, 0.2f);
    k.piece.clearance_front_m = 0.8f;
}

// Cards on four sides of a pole that turns.
void build_spinner_rack(Kit& k) {
    const int wire = k.main(plain("wire", {0.04f, 0.04f, 0.042f}, 0.4f)), metal = k.material(steel());
    const PrintSheet sheet = print_sheet(k, k.rng.chance(0.5f) ? Print::travel_posters : Print::fashion_posters);
    k.rod(metal, {0, 0, 0}, {0, 0.025f, 0}, 0.24f, 0.23f, 28),
        k.rod(metal, {0, 0.02f, 0}, {0, 1.72f, 0}, 0.018f, -1, 12);
    for (int side = 0; side < 4; ++side)
        for (int row = 0; row < 6; ++row)
            for (int i = 0; i < 2; ++i) {
                const float x = i ? 0.062f : -0.062f, y = 0.36f + 0.22f * static_cast<float>(row);
                const auto put = [&](Mesh m, int mat, Vec3f at) {
                    shapes::move(m, at);
                    shapes::turn(m, {0, 1, 0}, 90.f * static_cast<float>(side));
                    k.add(std::move(m), mat);
                };
                Mesh card = printed_box(sheet[k.rng.index(sheet.cells)], {0.11f, 0.16f, 0.012f});
                shapes::turn(card, {1, 0, 0}, -10);
                put(std::move(card), sheet.material, {x, y, 0.142f});
                put(shapes::rod({-0.06f, 0, 0}, {0.06f, 0, 0}, 0.003f, 0.003f, 4), wire, {x, y + 0.045f, 0.156f}),
                    put(shapes::rod({-0.06f, 0, 0}, {0.06f, 0, 0}, 0.003f, 0.003f, 4), wire, {x, y, 0.15f});
                if (i == 0) put(shapes::rod({0, 0, 0}, {0, 0, 0.15f}, 0.004f, 0.004f, 5), wire, {0, y, 0});
            }
    const int frame = k.material(steel());
    for (const float y : {0.34f, 1.64f}) k.add(shapes::ring(0.13f, 0.006f, 20), frame, {0, y, 0});
    k.add(shapes::ball({0, 1.73f, 0}, {0.028f, 0.028f, 0.028f}, 10), wire);
}

// Steps of newspapers and magazines, leaning.
void build_magazine_rack(Kit& k) {
    const Vec3f s = k.wanted({0.9f, 1.5f, 0.42f});
    const int body = k.main(k.style.wood), metal = k.material(steel());
    const PrintSheet covers = print_sheet(k, Print::fashion_posters), news = print_sheet(k, Print::notices);
    const int rows = std::max(3, static_cast<int>(s.y / 0.3f));
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * (0.5f * s.x - 0.01f);
        const std::array<Vec2f, 4> cheek{
            Vec2f{-0.5f * s.z, 0}, {0.5f * s.z, 0}, {0.5f * s.z, 0.16f}, {-0.5f * s.z + 0.1f, s.y}};
        k.add(side_prism(cheek, x - 0.01f, x + 0.01f, 0.004f), body);
    }
    block(k, body, {0, 0.04f, -0.5f * s.z + 0.01f}, {s.x - 0.03f, s.y - 0.06f, 0.014f});
    for (int row = 0; row < rows; ++row) {
        const float t = static_cast<float>(row) / static_cast<float>(rows), y = 0.08f + (s.y - 0.1f) * t,
                    z = 0.5f * s.z - 0.06f - (s.z - 0.16f) * t;
        block(k, body, {0, y, z - 0.03f}, {s.x - 0.03f, 0.014f, 0.1f}),
            block(k, body, {0, y, z + 0.015f}, {s.x - 0.03f, 0.05f, 0.01f});
        k.rod(metal, {-0.5f * s.x + 0.02f, y + 0.085f, z + 0.012f}, {0.5f * s.x - 0.02f, y + 0.085f, z + 0.012f},
              0.003f, -1, 5);
        const int count = std::max(2, static_cast<int>((s.x - 0.06f) / 0.21f));
        const float pitch = (s.x - 0.06f) / static_cast<float>(count);
        for (int i = 0; i < count; ++i) {
            const bool paper = row == 0;
            Mesh m = paper ? printed_box(news[k.rng.index(news.cells)], {pitch - 0.02f, 0.26f, 0.02f})
                           : printed_box(covers[k.rng.index(covers.cells)], {0.19f, 0.255f, 0.012f});
            shapes::turn(m, {1, 0, 0}, -14);
            k.add(std::move(m), paper ? news.material : covers.material,
                  {pitch * (static_cast<float>(i) - 0.5f * static_cast<float>(count - 1)), y + 0.014f, z - 0.008f});
        }
    }
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.6f;
}

// A board with two faces that stands before shops.
void build_menu_stand(Kit& k) {
    const int wood = k.main(k.style.wood), slate = color(k, "slate", {0.022f, 0.024f, 0.023f}, 0.85f),
              chalk = color(k, "chalk", {0.66f, 0.65f, 0.6f}, 0.9f), hinge = k.material(*material_named("brass"));
    for (const float side : {-1.f, 1.f}) {
        const auto lean = [&](Vec3f p) {
            return Vec3f{p.x, p.y, side * (0.03f + 0.22f * (1.f - p.y / 1.1f)) + side * p.z};
        };
        const auto panel = [&](int mat, float x, float y, Vec3f size, float z) {
            Mesh m = shapes::box(size, size.z > 0.011f ? 0.004f : 0.001f);
            shapes::turn(m, {1, 0, 0}, -side * 11.3f);
            k.add(std::move(m), mat, lean({x, y, z}));
        };
        panel(slate, 0, 0.58f, {0.5f, 0.84f, 0.01f}, 0);
        for (const float x : {-0.27f, 0.27f}) panel(wood, x, 0.56f, {0.05f, 1.1f, 0.025f}, 0);
        for (const float y : {0.15f, 1.03f}) panel(wood, 0, y, {0.5f, 0.05f, 0.025f}, 0);
        for (int i = 0; i < 8; ++i) {
            panel(chalk, i == 0 ? 0.f : -0.05f, 0.92f - (i ? 0.05f : 0.f) - 0.075f * static_cast<float>(i),
                  {i == 0 ? 0.3f : k.rng.uniform(0.2f, 0.3f), i == 0 ? 0.05f : 0.016f, 0.003f}, 0.0065f);
            if (i > 0) panel(chalk, 0.19f, 0.87f - 0.075f * static_cast<float>(i), {0.05f, 0.016f, 0.003f}, 0.0065f);
        }
    }
    for (const float x : {-0.2f, 0.2f}) k.rod(hinge, {x - 0.03f, 1.1f, 0}, {x + 0.03f, 1.1f, 0}, 0.014f, -1, 8);
}

// On a post, with a flag.
void build_mailbox(Kit& k) {
    const int body = k.main(plain("mailbox enamel", {0.45f, 0.05f, 0.03f}, 0.35f)), post = k.material(k.style.wood2),
              metal = k.material(steel()), flag = color(k, "flag", {0.6f, 0.42f, 0.03f}, 0.4f);
    k.board(post, {0, 0, 0}, {0.09f, 1.05f, 0.09f}, 0.006f), k.board(post, {0, 1.0f, 0}, {0.12f, 0.05f, 0.42f}, 0.006f);
    const auto shell = arch(0.11f, 0.13f), door = arch(0.1f, 0.125f);
    k.add(front_prism(shell, -0.24f, 0.23f, 0.006f), body, {0, 1.05f, 0}),
        k.add(front_prism(door, 0.23f, 0.245f, 0.004f), metal, {0, 1.055f, 0});
    k.rod(body, {0, 1.2f, 0.245f}, {0, 1.2f, 0.27f}, 0.014f, -1, 10),
        block(k, flag, {0.118f, 1.15f, 0.08f}, {0.008f, 0.2f, 0.02f}),
        block(k, flag, {0.118f, 1.28f, 0.11f}, {0.008f, 0.07f, 0.08f});
}

// Two benches face to face with a table between.
void build_booth(Kit& k) {
    const Vec3f s = k.wanted({1.9f, 1.1f, 1.25f});
    Material hide = k.style.leather;
    if (k.request.material.empty() && k.rng.chance(0.5f)) hide = tinted(hide, {0.28f, 0.03f, 0.03f});
    const int seat = k.main(hide), wood = k.material(k.style.wood), base = k.material(k.style.wood2),
              metal = k.material(steel());
    Soft how;
    how.round_m = 0.035f, how.puff_m = 0.025f, how.wrinkle_m = 0.002f, how.steps = 3;
    for (const float sx : {-1.f, 1.f}) {
        const float out = sx * 0.5f * s.x;
        k.board(base, {out - sx * 0.3f, 0, 0}, {0.5f, 0.32f, s.z - 0.04f}, 0.008f),
            k.board(base, {out - sx * 0.03f, 0, 0}, {0.06f, s.y, s.z}, 0.01f);
        k.soft(seat, {out - sx * 0.3f, 0.32f, 0}, {0.52f, 0.15f, s.z - 0.02f}, how);
        const int channels = 5;
        for (int i = 0; i < channels; ++i) {
            Soft tuft = how;
            tuft.steps = 1;
            k.soft(seat, {out - sx * 0.11f, 0.46f, (s.z - 0.03f) * ((static_cast<float>(i) + 0.5f) / channels - 0.5f)},
                   {0.14f, s.y - 0.48f, (s.z - 0.03f) / channels + 0.01f}, tuft);
        }
        k.board(base, {out - sx * 0.06f, s.y - 0.03f, 0}, {0.12f, 0.03f, s.z}, 0.008f);
    }
    const float w = s.x - 0.96f;
    k.board(wood, {0, 0.72f, 0}, {std::max(0.6f, w + 0.06f), 0.04f, s.z - 0.06f}, 0.012f),
        k.rod(metal, {0, 0.02f, 0}, {0, 0.72f, 0}, 0.04f, -1, 14),
        k.rod(metal, {0, 0, 0}, {0, 0.03f, 0}, 0.26f, 0.24f, 24);
    k.top(0.76f, 0, 0, 0.26f, 0.4f * s.z);
    k.piece.clearance_front_m = 0.6f;
}

// A glass cylinder with stripes that climb, lit from within, on a bracket.
void build_barber_pole(Kit& k) {
    static constexpr std::array<Vec3f, 3> kStripes{
        Vec3f{1.5f, 0.06f, 0.05f}, {1.6f, 1.55f, 1.45f}, {0.06f, 0.15f, 1.1f}};
    const int metal = k.main(steel()), white = lit(k, "pole light", {1.6f, 1.55f, 1.45f}),
              red = lit(k, "red stripe", kStripes[0]), blue = lit(k, "blue stripe", kStripes[2]);
    const float z = 0.16f, y0 = 0.14f, h = 0.46f, r = 0.075f;
    k.rod(white, {0, y0, z}, {0, y0 + h, z}, r - 0.002f, -1, 24);
    for (int b = 0; b < 4; ++b)
        k.add(shapes::sheet(28, 1,
                            [&](float u, float v) {
                                const float a = kTau * (1.5f * u + 0.25f * static_cast<float>(b)) - 0.8f * v;
                                return Vec3f{r * std::sin(a), y0 + h * u, z + r * std::cos(a)};
                            }),
              b % 2 ? blue : red);
    for (const float end : {0.f, 1.f}) {
        const float y = end > 0 ? y0 + h : y0, up = end > 0 ? 1.f : -1.f;
        k.rod(metal, {0, y - 0.015f * up, z}, {0, y + 0.05f * up, z}, 0.088f, 0.08f, 24);
        k.add(shapes::ball({0, y + 0.055f * up, z}, {0.07f, 0.06f, 0.07f}, 16), metal),
            k.rod(metal, {0, y + 0.1f * up, z}, {0, y + 0.13f * up, z}, 0.015f, 0.01f, 8);
        k.board(metal, {0, y + 0.012f * up, 0.5f * z}, {0.05f, 0.025f, z}, 0.004f);
    }
    k.board(metal, {0, y0 - 0.05f, 0.008f}, {0.1f, h + 0.1f, 0.016f}, 0.004f);
    k.piece.mount = Mount::wall, k.piece.hang_height_m = 1.45f;
}

// A bonnet on a stand, over a seat.
void build_hood_dryer(Kit& k) {
    const int hood = k.main(plain("hood", {0.62f, 0.61f, 0.58f}, 0.25f)), metal = k.material(steel()),
              dark = color(k, "black plastic", {0.03f, 0.03f, 0.032f}, 0.4f), seat = k.material(k.style.leather),
              inner = color(k, "inside of a hood", {0.1f, 0.1f, 0.1f}, 0.7f);
    Soft how;
    how.round_m = 0.05f, how.puff_m = 0.03f, how.steps = 3;
    k.rod(metal, {0, 0, 0.05f}, {0, 0.03f, 0.05f}, 0.29f, 0.28f, 28),
        k.rod(metal, {0, 0.02f, 0.05f}, {0, 0.36f, 0.05f}, 0.04f, -1, 14);
    k.soft(seat, {0, 0.36f, 0.06f}, {0.54f, 0.14f, 0.54f}, how),
        k.soft(seat, {0, 0.5f, -0.2f}, {0.5f, 0.5f, 0.12f}, how);
    for (const float sx : {-1.f, 1.f})
        k.rod(metal, {sx * 0.28f, 0.42f, 0.1f}, {sx * 0.28f, 0.66f, 0.1f}, 0.014f, -1, 8),
            k.board(dark, {sx * 0.28f, 0.65f, 0.04f}, {0.07f, 0.04f, 0.36f}, 0.014f);
    k.rod(metal, {0, 0.3f, -0.3f}, {0, 1.5f, -0.3f}, 0.02f, -1, 12),
        k.rod(metal, {0, 0.38f, -0.3f}, {0, 0.38f, 0}, 0.018f, -1, 8),
        k.rod(metal, {0, 1.42f, -0.3f}, {0, 1.42f, -0.16f}, 0.02f, -1, 10);
    const std::array<Vec2f, 6> p{Vec2f{0.2f, 1.2f}, {0.21f, 1.26f}, {0.205f, 1.36f},
                                 {0.17f, 1.46f},    {0.09f, 1.52f}, {0.04f, 1.53f}};
    k.add(shapes::vessel(p, 0.012f, 28), hood, {0, 0, 0.02f}),
        k.rod(dark, {0, 1.52f, 0.02f}, {0, 1.56f, 0.02f}, 0.06f, 0.05f, 16),
        k.add(hoop(0.198f, 0.012f, 24), inner, {0, 1.205f, 0.02f});
    k.board(dark, {0, 1.26f, 0.222f}, {0.1f, 0.06f, 0.02f}, 0.006f);
    k.piece.against_wall = true, k.piece.clearance_front_m = 0.6f;
}

}  // namespace fastscene::furniture
