// Shelving of single trades: the back of a café, of a pharmacy, walls of records, a store room's rack.
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {

// The wall behind a café's counter: cupboards and a worktop below; cups, coffee, jars, bottles and plants above.
void build_coffee_shelf(Kit& k) {
    const Vec3f s = k.wanted({1.1f, 2.1f, 0.42f});
    const int wood = k.main(k.style.wood), top = k.material(k.style.wood2), metal = k.material(k.style.metal);
    const float back = -0.5f * s.z, counter = 0.9f, deep = 0.24f;
    k.board(wood, {0, 0, -0.01f}, {s.x, counter - 0.03f, s.z - 0.04f}, 0.004f);
    fronts(k, wood, metal, -0.5f * s.x + 0.01f, 0.5f * s.x - 0.01f, 0.09f, counter - 0.05f, 0.5f * s.z - 0.03f, 2, 1);
    k.board(top, {0, counter - 0.03f, 0}, {s.x, 0.03f, s.z}, 0.004f);
    const float room = s.y - counter, step = room / 3;
    const auto small = [&](const char* kind, float x, float y, float z) {
        const Piece p = k.small(kind);
        if (p.size_m.y < step - 0.04f && p.size_m.z < deep + 0.05f) k.merge(p, {x, y, z});
    };
    // On the worktop: cups, and what one grinds and boils with.
    const float z = back + 0.5f * deep;
    const bool flip = k.rng.chance(0.5f);
    stock(k, Goods::cups, flip ? -0.48f * s.x : 0.02f * s.x, flip ? -0.02f * s.x : 0.48f * s.x, counter, 0.24f,
          back + 0.3f, 0.2f);
    stock(k, Goods::jars, flip ? 0.06f * s.x : -0.46f * s.x, flip ? 0.46f * s.x : -0.06f * s.x, counter, 0.36f,
          back + 0.24f, 0.2f);
    for (int i = 1; i < 3; ++i) {
        const float y = counter + step * static_cast<float>(i);
        k.board(wood, {0, y, back + 0.5f * deep}, {s.x, 0.03f, deep}, 0.004f);
        for (const float x : {-0.38f, 0.38f})
            k.rod(metal, {x * s.x, y, back}, {x * s.x, y - 0.005f, back + 0.2f}, 0.007f, -1, 8);
        const float on = y + 0.03f, front = back + deep - 0.02f, tall = step - 0.05f;
        static constexpr std::array<Goods, 4> kLeft{Goods::coffee, Goods::jars, Goods::bottles, Goods::coffee},
            kRight{Goods::cups, Goods::coffee, Goods::jars, Goods::preserves};
        const auto which = static_cast<std::size_t>((k.rng.index(2) + 2 * i) % 4);
        const float split = k.rng.uniform(-0.12f, 0.12f) * s.x;
        stock(k, kLeft[which], -0.48f * s.x, split - 0.08f, on, tall, front, deep - 0.03f);
        stock(k, kRight[which], split + 0.1f, 0.48f * s.x, on, tall, front, deep - 0.03f);
        if (k.rng.chance(0.7f)) small("plant_small", split + 0.01f, on, z);
    }
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.8f;
}

// White shelves, lit from above: boxes of medicine and creams, drawers below, a cross.
void build_medicine_shelf(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 2.2f, 0.38f});
    const int body = k.main(plain("white lacquer", {0.74f, 0.75f, 0.74f}, 0.3f)), metal = k.material(steel()),
              green = color(k, "pharmacy green", {0.03f, 0.3f, 0.14f}, 0.35f),
              strip = k.material(glow("shelf light", {4, 4, 3.8f})), pane = k.material(glass());
    const float back = -0.5f * s.z, first = 0.72f, head = 0.3f;
    k.board(body, {0, 0, back + 0.01f}, {s.x, s.y, 0.02f}, 0.003f);
    for (const float x : {-1.f, 1.f})
        k.board(body, {x * (0.5f * s.x - 0.012f), 0, 0}, {0.024f, s.y - 0.04f, s.z}, 0.003f);
    k.board(body, {0, 0.06f, -0.01f}, {s.x - 0.03f, first - 0.06f, s.z - 0.04f}, 0.003f);
    fronts(k, body, metal, -0.5f * s.x + 0.03f, 0.5f * s.x - 0.03f, 0.08f, first - 0.02f, 0.5f * s.z - 0.03f, 3, 4);
    const int rows = 5;
    const float step = (s.y - head - first) / static_cast<float>(rows);
    static constexpr std::array<Goods, 5> kRows{Goods::medicines, Goods::medicines, Goods::cosmetics, Goods::medicines,
                                                Goods::cosmetics};
    for (int i = 0; i < rows; ++i) {
        const float y = first + step * static_cast<float>(i);
        k.board(i == 0 ? body : pane, {0, y, 0.01f}, {s.x - 0.05f, 0.012f, s.z - 0.06f}, 0.001f);
        stock(k, kRows[static_cast<std::size_t>(i + k.rng.index(2)) % 5], -0.5f * s.x + 0.04f, 0.5f * s.x - 0.04f,
              y + 0.013f, step - 0.03f, 0.5f * s.z - 0.05f, s.z - 0.1f);
    }
    k.board(body, {0, s.y - head, 0}, {s.x, head, s.z}, 0.004f);
    k.board(strip, {0, s.y - head - 0.012f, 0.5f * s.z - 0.06f}, {s.x - 0.1f, 0.012f, 0.03f}, 0.002f);
    const float front = 0.5f * s.z + 0.004f, middle = s.y - 0.5f * head;
    k.board(green, {0, s.y - head + 0.02f, front - 0.002f}, {s.x - 0.02f, 0.03f, 0.012f}, 0.002f);
    for (const auto& [w, h] : {std::pair{0.06f, 0.18f}, {0.18f, 0.06f}})
        k.board(green, {0, middle + 0.01f - 0.5f * h, front}, {w, h, 0.016f}, 0.003f);
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.8f;
}

// Records that show their fronts, on narrow ledges.
void build_record_wall(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 1.75f, 0.12f});
    const int wood = k.main(k.style.wood);
    const PrintSheet sheet = print_sheet(k, Print::sleeves);
    const int disc = color(k, "vinyl", {0.012f, 0.012f, 0.013f}, 0.2f),
              paper = color(k, "record label", {0.42f, 0.1f, 0.06f}, 0.6f);
    const int rows = std::max(1, static_cast<int>(s.y / 0.42f)), columns = std::max(1, static_cast<int>(s.x / 0.36f));
    const float step = s.y / static_cast<float>(rows), pitch = s.x / static_cast<float>(columns);
    for (int j = 0; j < rows; ++j) {
        const float y = step * static_cast<float>(j);
        k.board(wood, {0, y, 0.5f * s.z}, {s.x, 0.018f, s.z}, 0.003f);
        k.board(wood, {0, y, s.z - 0.006f}, {s.x, 0.035f, 0.012f}, 0.002f);
        for (int i = 0; i < columns; ++i) {
            const float x = -0.5f * s.x + pitch * (static_cast<float>(i) + 0.5f);
            Mesh cover = printed_box(sheet[k.rng.index(sheet.cells)], {0.31f, 0.31f, 0.006f});
            shapes::turn(cover, {1, 0, 0}, -8);
            k.add(std::move(cover), sheet.material, {x, y + 0.02f, 0.07f});
            if (k.rng.chance(0.15f)) {  // the disc looks out
                k.rod(disc, {x + 0.08f, y + 0.175f, 0.032f}, {x + 0.08f, y + 0.175f, 0.036f}, 0.15f, -1, 32);
                k.rod(paper, {x + 0.08f, y + 0.175f, 0.034f}, {x + 0.08f, y + 0.175f, 0.038f}, 0.05f, -1, 20);
            }
        }
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.7f;
}

// Steel uprights and shelves: cartons, bins with lids, tins of paint, a rolled rug on top.
void build_storage_rack(Kit& k) {
    const Vec3f s = k.wanted({1.2f, 1.95f, 0.5f});
    const int frame = k.main(plain("galvanized steel", {0.36f, 0.37f, 0.38f}, 0.4f)),
              lid = color(k, "bin lid", {0.04f, 0.1f, 0.2f}, 0.45f), tin = k.material(steel()),
              clear = color(k, "plastic bin", {0.5f, 0.53f, 0.55f}, 0.25f),
              roll = color(k, "rolled rug", {0.3f, 0.14f, 0.09f}, 0.95f),
              gray = color(k, "plastic bin", {0.16f, 0.17f, 0.18f}, 0.5f);
    static constexpr std::array<Vec3f, 4> kPaints{
        Vec3f{0.62f, 0.6f, 0.55f}, {0.12f, 0.22f, 0.26f}, {0.35f, 0.12f, 0.07f}, {0.42f, 0.36f, 0.22f}};
    for (const float x : {-1.f, 1.f})
        for (const float z : {-1.f, 1.f})
            k.board(frame, {x * (0.5f * s.x - 0.02f), 0, z * (0.5f * s.z - 0.02f)}, {0.035f, s.y, 0.035f}, 0.002f);
    const int rows = std::max(3, static_cast<int>(s.y / 0.46f));
    const float step = (s.y - 0.12f) / static_cast<float>(rows - 1);
    for (int j = 0; j < rows; ++j) {
        const float y = 0.08f + step * static_cast<float>(j), room = j + 1 < rows ? step - 0.06f : 0.36f;
        k.board(frame, {0, y, 0}, {s.x - 0.01f, 0.03f, s.z - 0.02f}, 0.002f);
        for (float x = -0.5f * s.x + 0.05f; x < 0.5f * s.x - 0.26f;) {
            const float w = std::min(0.5f * s.x - 0.05f - x, k.rng.uniform(0.3f, 0.44f)), mid = x + 0.5f * w;
            const Vec3f at{mid, y + 0.03f, 0};
            switch (k.rng.index(4)) {
                case 0: {  // a bin
                    const float h = std::min(room, 0.26f);
                    k.board(k.rng.chance(0.5f) ? clear : gray, at, {w - 0.05f, h, 0.38f}, 0.02f);
                    k.board(lid, at + Vec3f{0, h - 0.01f, 0}, {w - 0.02f, 0.03f, 0.41f}, 0.01f);
                    break;
                }
                case 1: {  // tins of paint, with drips of what is in them
                    const std::array<Vec2f, 2> can{Vec2f{0.075f, 0}, {0.075f, 0.16f}},
                        top{Vec2f{0.06f, 0.16f}, {0.06f, 0.165f}};
                    const int paint = color(k, "paint", kPaints[static_cast<std::size_t>(k.rng.index(4))], 0.3f);
                    for (const float dx : {-0.085f, 0.085f}) {
                        k.add(shapes::lathe(can, 18), tin, at + Vec3f{dx, 0, 0.1f});
                        k.add(shapes::lathe(top, 18), paint, at + Vec3f{dx, 0, 0.1f});
                        block(k, paint, at + Vec3f{dx, 0.04f, 0.173f}, {0.06f, 0.08f, 0.006f});
                    }
                    break;
                }
                default:
                    stock(k, Goods::boxes, x - 0.02f, x + std::max(w, 0.425f), y + 0.03f, room, 0.5f * s.z - 0.05f,
                          0.36f);
                    break;
            }
            x += std::max(w, 0.425f) + 0.01f;
        }
    }
    k.rod(roll, {-0.42f * s.x, s.y + 0.06f, -0.1f}, {0.46f * s.x, s.y + 0.06f, -0.1f}, 0.06f, -1, 18);
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.6f;
}

// Niches behind glass, lit from above: busts with chains, rings on cones, watches on cushions; drawers below.
void build_jewelry_wall(Kit& k) {
    const Vec3f s = k.wanted({1.3f, 2.1f, 0.36f});
    const int wood = k.main(k.style.wood), metal = k.material(*material_named("brass")),
              gold = k.material(*material_named("gold")), silver = k.material(steel()),
              lining = color(k, "lining", {0.5f, 0.46f, 0.4f}, 0.95f),
              velvet = color(k, "velvet", {0.022f, 0.022f, 0.03f}, 0.95f), pane = k.material(glass()),
              strip = k.material(glow("niche light", {10, 8.6f, 6.4f}));
    static constexpr std::array<Vec3f, 4> kGems{
        Vec3f{0.02f, 0.05f, 0.3f}, {0.3f, 0.01f, 0.03f}, {0.01f, 0.2f, 0.08f}, {0.72f, 0.73f, 0.75f}};
    std::array<int, 4> gems{};
    for (std::size_t i = 0; i < gems.size(); ++i) gems[i] = color(k, "gem", kGems[i], 0.05f);
    const float back = -0.5f * s.z, low = 0.8f, rows = 3, step = (s.y - low - 0.06f) / rows;
    k.board(wood, {0, 0, -0.01f}, {s.x, low, s.z - 0.03f}, 0.004f);
    fronts(k, wood, metal, -0.5f * s.x + 0.02f, 0.5f * s.x - 0.02f, 0.08f, low - 0.02f, 0.5f * s.z - 0.025f, 2, 4);
    k.board(lining, {0, low, back + 0.01f}, {s.x, s.y - low, 0.02f}, 0.002f);
    for (const float x : {-1.f, 1.f})
        k.board(wood, {x * (0.5f * s.x - 0.03f), low, 0}, {0.06f, s.y - low, s.z}, 0.005f);
    k.board(wood, {0, s.y - 0.06f, 0}, {s.x, 0.06f, s.z}, 0.006f);
    for (int j = 0; j < 3; ++j) {
        const float y = low + step * static_cast<float>(j);
        k.board(wood, {0, y, 0}, {s.x - 0.1f, 0.025f, s.z - 0.01f}, 0.003f);
        k.board(strip, {0, y + step - 0.012f, 0.5f * s.z - 0.04f}, {s.x - 0.2f, 0.01f, 0.016f}, 0.002f);
        const int places = std::max(2, static_cast<int>((s.x - 0.16f) / 0.24f));
        for (int i = 0; i < places; ++i) {
            const Vec3f at{(s.x - 0.16f) * ((static_cast<float>(i) + 0.5f) / static_cast<float>(places) - 0.5f),
                           y + 0.025f, -0.03f};
            const int ore = k.rng.chance(0.65f) ? gold : silver, gem = gems[static_cast<std::size_t>(k.rng.index(4))];
            if ((i + j) % 2 == 0) {  // a bust: neck and shoulders, two chains and a pendant
                const std::array<Vec2f, 6> bust{Vec2f{0.06f, 0}, {0.085f, 0.05f}, {0.08f, 0.1f},
                                                {0.035f, 0.15f}, {0.03f, 0.2f},   {0.034f, 0.215f}};
                Mesh m = shapes::lathe(bust, 18, true);
                for (Vec3f& p : m.positions) p.z *= 0.6f;
                k.add(std::move(m), velvet, at);
                for (const auto& [r, up, tilt] : {std::tuple{0.046f, 0.14f, 42.f}, {0.066f, 0.115f, 50.f}}) {
                    Mesh chain = shapes::ring(r, 0.006f, 22);
                    shapes::turn(chain, {1, 0, 0}, tilt);
                    k.add(std::move(chain), ore, at + Vec3f{0, up, 0.012f});
                }
                k.add(shapes::ball(at + Vec3f{0, 0.066f, 0.058f}, {0.011f, 0.014f, 0.007f}, 8), gem);
            } else if (k.rng.chance(0.5f)) {  // rings on cones
                for (int r = -1; r <= 1; ++r) {
                    const Vec3f foot = at + Vec3f{0.055f * static_cast<float>(r), 0, 0.03f};
                    k.rod(velvet, foot, foot + Vec3f{0, 0.08f, 0}, 0.016f, 0.005f, 12);
                    k.add(shapes::ring(0.0125f, 0.005f, 14), ore, foot + Vec3f{0, 0.04f, 0});
                    k.add(shapes::ball(foot + Vec3f{0, 0.044f, 0.014f}, {0.006f, 0.006f, 0.006f}, 6), gem);
                }
            } else {  // watches round cushions
                for (const float x : {-0.045f, 0.045f}) {
                    const Vec3f middle = at + Vec3f{x, 0.045f, 0.03f};
                    k.rod(velvet, middle - Vec3f{0.03f, 0, 0}, middle + Vec3f{0.03f, 0, 0}, 0.032f, -1, 14);
                    k.rod(ore, middle - Vec3f{0.011f, 0, 0}, middle + Vec3f{0.011f, 0, 0}, 0.0345f, -1, 16);
                    k.rod(ore, middle + Vec3f{0, 0.01f, 0.026f}, middle + Vec3f{0, 0.014f, 0.041f}, 0.02f, -1, 16);
                    k.rod(lining, middle + Vec3f{0, 0.0141f, 0.0411f}, middle + Vec3f{0, 0.0144f, 0.0425f}, 0.016f, -1,
                          16);
                }
            }
        }
    }
    k.board(pane, {0, low + 0.02f, 0.5f * s.z - 0.012f}, {s.x - 0.12f, s.y - low - 0.08f, 0.005f}, 0.001f);
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.7f;
}

}  // namespace fastscene::furniture
