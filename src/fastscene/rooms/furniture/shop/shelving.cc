// Shelving of shops, stores and bars, with what is sold.
#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "fastscene/rooms/furniture/print.h"
#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

struct Shelving {
    Vec3f size;
    int rows;
    bool wood;            // else powder-coated steel
    bool lettered;        // a colored board above says what is sold
    float first = 0.12f;  // height of the lowest shelf
};

// What the board above a shelf says, by what stands there.
std::string_view word_above(Kit& k, Goods goods) {
    static constexpr std::array<std::pair<Goods, std::array<std::string_view, 4>>, 8> kWords{
        {{Goods::packets, {"CEREALS", "PASTA + RICE", "BAKING", "TEA"}},
         {Goods::cans, {"TINNED FOOD", "SOUPS", "VEGETABLES", "FISH"}},
         {Goods::preserves, {"PRESERVES", "JAM + HONEY", "SAUCES", "PICKLES"}},
         {Goods::cartons, {"MILK", "JUICE", "DAIRY", "DRINKS"}},
         {Goods::bottles, {"WINES", "OILS", "DRINKS", "SPIRITS"}},
         {Goods::films, {"COMEDY", "DRAMA", "NEW RELEASES", "CLASSICS"}},
         {Goods::toys, {"TOYS", "GAMES", "PUZZLES", "PLAY"}},
         {Goods::hardware, {"SCREWS", "TOOLS", "PAINT", "FITTINGS"}}}};
    for (const auto& [of, words] : kWords)
        if (of == goods) return words[static_cast<std::size_t>(k.rng.index(4))];
    return {};
}
// Signs are dull: the style's accent, darkened.
Vec3f sign_ground(Kit& k) { return k.accent() * 0.5f + Vec3f{0.01f, 0.01f, 0.01f}; }

// At a wall: a back, sides and shelves that step back upwards a little.
void wall_shelving(Kit& k, const Shelving& like, Goods goods) {
    const Vec3f s = k.wanted(like.size);
    const int body = k.main(like.wood ? k.style.wood : plain("shelf steel", {0.62f, 0.62f, 0.6f}, 0.45f));
    const int edge = like.wood ? body : color(k, "price rail", {0.75f, 0.74f, 0.7f}, 0.35f);
    k.board(body, {0, 0, -0.5f * s.z + 0.01f}, {s.x, s.y, 0.02f}, 0.003f);
    for (const float sx : {-1.f, 1.f}) k.board(body, {sx * (0.5f * s.x - 0.014f), 0, 0}, {0.028f, s.y, s.z}, 0.003f);
    k.board(body, {0, 0, 0}, {s.x - 0.06f, like.first, s.z - 0.04f}, 0.003f);
    const float top = like.lettered ? s.y - 0.2f : s.y, step = (top - like.first) / static_cast<float>(like.rows);
    for (int i = 0; i < like.rows; ++i) {
        const float y = like.first + step * static_cast<float>(i), front = 0.5f * s.z - 0.012f;
        k.board(body, {0, y, 0}, {s.x - 0.05f, 0.022f, s.z - 0.024f}, 0.002f);
        if (!like.wood) k.board(edge, {0, y - 0.012f, front}, {s.x - 0.05f, 0.036f, 0.006f}, 0.001f);
        stock(k, goods, -0.5f * s.x + 0.035f, 0.5f * s.x - 0.035f, y + 0.022f, step - 0.04f, front, s.z - 0.05f);
    }
    k.board(body, {0, top, 0}, {s.x, 0.022f, s.z}, 0.003f);
    if (like.lettered) {
        const Vec3f ground = sign_ground(k),
                    ink = luminance(ground) > 0.25f ? Vec3f{0.03f, 0.03f, 0.03f} : Vec3f{0.7f, 0.68f, 0.62f};
        k.board(color(k, "sign", ground, 0.5f), {0, top + 0.022f, 0}, {s.x, 0.178f, 0.05f}, 0.004f);
        if (const std::string_view word = word_above(k, goods); !word.empty())
            sign(k, word, ground, ink, {-0.48f * s.x, top + 0.032f, 0.0256f}, {0.96f * s.x, 0.158f});
    }
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.8f;
}

// In the middle of the floor: goods on both sides.
void island(Kit& k, Vec3f usual, int rows, bool wood, Goods goods, std::optional<Goods> on_top = {}) {
    const Vec3f s = k.wanted(usual);
    const int body = k.main(wood ? k.style.wood : plain("shelf steel", {0.62f, 0.62f, 0.6f}, 0.45f));
    const float first = 0.12f, step = (s.y - first) / static_cast<float>(rows), deep = 0.5f * s.z - 0.02f;
    k.board(body, {0, 0, 0}, {s.x, first, s.z}, 0.004f);
    k.board(body, {0, first, 0}, {s.x, s.y - first, 0.03f}, 0.003f);
    for (const float sx : {-1.f, 1.f})
        k.board(body, {sx * (0.5f * s.x - 0.012f), first, 0}, {0.024f, s.y - first, s.z - 0.04f}, 0.003f);
    const std::size_t before = k.piece.meshes.size();
    for (int i = 0; i < rows; ++i) {
        const float y = first + step * static_cast<float>(i);
        if (i > 0) k.board(body, {0, y - 0.02f, 0}, {s.x - 0.05f, 0.02f, s.z - 0.04f}, 0.002f);
        stock(k, i == rows - 1 ? on_top.value_or(goods) : goods, -0.5f * s.x + 0.03f, 0.5f * s.x - 0.03f, y,
              step - 0.05f, 0.5f * s.z - 0.02f, deep);
    }
    // The other side is the same, turned about.
    const std::size_t after = k.piece.meshes.size();
    for (std::size_t i = before; i < after; ++i) {
        Mesh m = k.piece.meshes[i];
        if (m.material == body) continue;
        shapes::turn(m, {0, 1, 0}, 180);
        k.piece.meshes.push_back(std::move(m));
    }
    k.top(s.y, 0, 0, 0.45f * s.x, 0.02f);
    k.piece.clearance_front_m = 0.7f;
}

}  // namespace

void build_grocery_shelf(Kit& k) {
    const Goods goods = std::array{Goods::packets, Goods::cans, Goods::preserves, Goods::cartons,
                                   Goods::bottles}[static_cast<std::size_t>(k.rng.index(5))];
    wall_shelving(k, {{1.25f, 2.1f, 0.45f}, 5, false, true}, goods);
}
void build_grocery_island(Kit& k) {
    island(k, {1.8f, 1.45f, 0.8f}, 4, false, k.rng.chance(0.6f) ? Goods::packets : Goods::preserves);
}
// New books: covers to the front above, spines below.
void build_book_island(Kit& k) { island(k, {1.5f, 1.2f, 0.6f}, 3, true, Goods::paperbacks, Goods::covers); }
void build_cosmetics_island(Kit& k) { island(k, {1.5f, 1.35f, 0.7f}, 4, false, Goods::cosmetics, Goods::medicines); }
void build_library_shelf(Kit& k) { island(k, {2.0f, 1.95f, 0.56f}, 5, true, Goods::books); }
void build_shoe_wall(Kit& k) { wall_shelving(k, {{1.3f, 2.0f, 0.36f}, 6, true, false}, Goods::shoes); }
void build_toy_shelf(Kit& k) { wall_shelving(k, {{1.3f, 1.9f, 0.4f}, 5, true, true}, Goods::toys); }
void build_bread_shelf(Kit& k) { wall_shelving(k, {{1.3f, 2.0f, 0.4f}, 5, true, false, 0.7f}, Goods::bread); }
void build_jar_shelf(Kit& k) { wall_shelving(k, {{1.1f, 2.1f, 0.32f}, 6, true, false}, Goods::jars); }
void build_video_shelf(Kit& k) { wall_shelving(k, {{1.2f, 2.0f, 0.3f}, 7, false, true, 0.2f}, Goods::films); }
void build_video_island(Kit& k) { island(k, {1.6f, 1.3f, 0.6f}, 5, false, Goods::films); }
void build_record_crates(Kit& k) {
    const Vec3f s = k.wanted({1.3f, 0.86f, 0.62f});
    const int wood = k.main(k.style.wood);
    legs(k, wood, 0.5f * s.x - 0.06f, 0.5f * s.z - 0.06f, 0.5f, 0.05f);
    k.board(wood, {0, 0.5f, 0}, {s.x, 0.02f, s.z});
    for (const float sz : {-1.f, 1.f}) k.board(wood, {0, 0.52f, sz * (0.5f * s.z - 0.01f)}, {s.x, 0.2f, 0.02f});
    for (const float sx : {-1.f, 0.f, 1.f}) k.board(wood, {sx * (0.5f * s.x - 0.01f), 0.52f, 0}, {0.02f, 0.2f, s.z});
    stock(k, Goods::records, -0.5f * s.x + 0.12f, 0.5f * s.x, 0.53f, 0.33f, 0.5f * s.z - 0.04f, s.z);
    k.piece.clearance_front_m = 0.6f;
}

// Uprights of steel, beams and boards, cartons on pallets.
void build_pallet_rack(Kit& k) {
    const Vec3f s = k.wanted({2.6f, 3.0f, 0.95f});
    const int upright = k.main(plain("rack steel", {0.04f, 0.1f, 0.3f}, 0.4f)),
              beam = color(k, "beam steel", {0.62f, 0.2f, 0.02f}, 0.4f),
              carton = color(k, "cardboard", {0.36f, 0.23f, 0.12f}, 0.85f),
              pale = color(k, "pale cardboard", {0.46f, 0.32f, 0.18f}, 0.85f),
              tape = color(k, "tape", {0.5f, 0.4f, 0.26f}, 0.4f), wood = k.material(materials::timber("natural", 0.8f));
    for (const float sx : {-1.f, 1.f}) {
        for (const float sz : {-1.f, 1.f})
            k.board(upright, {sx * (0.5f * s.x - 0.04f), 0, sz * (0.5f * s.z - 0.04f)}, {0.08f, s.y, 0.08f}, 0.004f);
        for (int i = 0; i < 5; ++i) {
            const float y = s.y * (static_cast<float>(i) + 0.1f) / 5,
                        z = (i % 2 == 0 ? 1.f : -1.f) * (0.5f * s.z - 0.05f);
            k.rod(upright, {sx * (0.5f * s.x - 0.04f), y, -z}, {sx * (0.5f * s.x - 0.04f), y + s.y / 5.2f, z}, 0.014f,
                  -1, 6);
        }
    }
    const int levels = std::max(2, static_cast<int>(s.y / 1.25f));
    const float step = s.y / static_cast<float>(levels);
    for (int j = 0; j < levels; ++j) {
        const float y = j == 0 ? 0.f : step * static_cast<float>(j);
        if (j > 0)
            for (const float sz : {-1.f, 1.f})
                k.board(beam, {0, y - 0.1f, sz * (0.5f * s.z - 0.04f)}, {s.x - 0.16f, 0.1f, 0.05f}, 0.004f);
        for (const float sx : {-1.f, 1.f}) {
            const float x = sx * 0.24f * s.x, w = 0.42f * s.x;
            for (int b = 0; b < 5; ++b)
                block(k, wood, {x, y + 0.1f, -0.4f * s.z + 0.2f * s.z * static_cast<float>(b)}, {w, 0.022f, 0.09f});
            for (int b = -1; b <= 1; ++b)
                block(k, wood, {x + 0.44f * w * static_cast<float>(b), y, 0}, {0.09f, 0.1f, 0.85f * s.z});
            if (k.rng.chance(0.15f)) continue;
            const int high = 1 + k.rng.index(2), across = 2 + k.rng.index(2);
            for (int h = 0; h < high; ++h)
                for (int c = 0; c < across; ++c) {
                    const float cw = w / static_cast<float>(across), ch = 0.36f * std::min(1.f, (step - 0.25f) / 0.8f);
                    const Vec3f at{x - 0.5f * w + cw * (static_cast<float>(c) + 0.5f),
                                   y + 0.123f + ch * static_cast<float>(h), 0};
                    block(k, k.rng.chance(0.6f) ? carton : pale, at, {cw - 0.02f, ch - 0.01f, 0.8f * s.z});
                    block(k, tape, at + Vec3f{0, 0.4f * ch, 0.401f * s.z}, {cw - 0.02f, 0.05f, 0.003f});
                }
        }
    }
    k.piece.clearance_front_m = 0.9f;
}

// The wall behind a bar: cupboards below, glass shelves with bottles before a mirror.
void build_bottle_shelf(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 2.15f, 0.42f});
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal);
    Material mirror = plain("mirror", {0.8f, 0.8f, 0.8f}, 0.05f);
    mirror.mirror = 1;
    k.board(wood, {0, 0, 0}, {s.x, 0.9f, s.z});
    fronts(k, wood, metal, -0.5f * s.x + 0.02f, 0.5f * s.x - 0.02f, 0.08f, 0.86f, 0.5f * s.z, 3, 1);
    k.board(wood, {0, 0.9f, 0.005f}, {s.x, 0.035f, s.z + 0.02f}, 0.006f);
    k.board(wood, {0, 0.93f, -0.5f * s.z + 0.015f}, {s.x, s.y - 0.93f, 0.03f});
    k.board(k.material(mirror), {0, 0.96f, -0.5f * s.z + 0.032f}, {s.x - 0.16f, s.y - 1.1f, 0.004f}, 0.001f);
    for (const float sx : {-1.f, 1.f})
        k.board(wood, {sx * (0.5f * s.x - 0.03f), 0.93f, -0.5f * s.z + 0.12f}, {0.06f, s.y - 0.95f, 0.22f}, 0.008f);
    k.board(wood, {0, s.y - 0.09f, -0.5f * s.z + 0.14f}, {s.x + 0.02f, 0.09f, 0.28f}, 0.012f);
    static constexpr std::array<Vec3f, 5> kGlass{Vec3f{0.05f, 0.12f, 0.05f},
                                                 {0.2f, 0.09f, 0.02f},
                                                 {0.4f, 0.42f, 0.4f},
                                                 {0.28f, 0.03f, 0.03f},
                                                 {0.04f, 0.08f, 0.16f}};
    std::array<int, 5> glasses{};
    for (std::size_t i = 0; i < glasses.size(); ++i) glasses[i] = color(k, "bottle glass", kGlass[i], 0.08f);
    const int cap = color(k, "cap", {0.5f, 0.4f, 0.16f}, 0.3f), label = color(k, "label", {0.66f, 0.6f, 0.46f}, 0.7f);
    for (int row = 0; row < 3; ++row) {
        const float y = 0.94f + 0.36f * static_cast<float>(row), z = -0.5f * s.z + (row == 0 ? 0.2f : 0.14f);
        if (row > 0) k.board(wood, {0, y - 0.02f, -0.5f * s.z + 0.13f}, {s.x - 0.12f, 0.02f, 0.2f}, 0.004f);
        for (float x = -0.5f * s.x + 0.14f; x < 0.5f * s.x - 0.12f; x += 0.105f) {
            if (k.rng.chance(0.08f)) continue;
            const float h = k.rng.uniform(0.25f, 0.32f);
            bottle(k, glasses[static_cast<std::size_t>(k.rng.index(5))], cap, {x, y, z}, h, 0.037f);
            block(k, label, {x, y + 0.18f * h, z + 0.036f}, {0.045f, 0.25f * h, 0.004f});
        }
    }
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.8f;
}

// A cooled cabinet with a glass door, lit from within.
void build_drinks_fridge(Kit& k) {
    const Vec3f s = k.wanted({0.75f, 2.0f, 0.68f});
    const int body = k.main(plain("fridge lacquer", {0.05f, 0.05f, 0.055f}, 0.3f)),
              inner = color(k, "white liner", {0.75f, 0.76f, 0.76f}, 0.5f), metal = k.material(steel());
    k.board(body, {0, 0, -0.5f * s.z + 0.02f}, {s.x, s.y, 0.04f});
    for (const float sx : {-1.f, 1.f}) k.board(body, {sx * (0.5f * s.x - 0.025f), 0, 0}, {0.05f, s.y, s.z});
    k.board(body, {0, 0, 0}, {s.x - 0.1f, 0.22f, s.z - 0.02f});
    const Vec3f ground = sign_ground(k);
    k.board(color(k, "sign", ground, 0.4f), {0, s.y - 0.26f, 0.01f}, {s.x - 0.1f, 0.24f, s.z - 0.02f}, 0.006f);
    sign(k, "COLD DRINKS", ground, {0.72f, 0.71f, 0.68f}, {-0.5f * s.x + 0.06f, s.y - 0.25f, 0.5f * s.z + 0.0006f},
         {s.x - 0.12f, 0.22f});
    k.board(body, {0, s.y - 0.02f, 0}, {s.x, 0.02f, s.z});
    k.board(inner, {0, 0.22f, -0.5f * s.z + 0.045f}, {s.x - 0.1f, s.y - 0.48f, 0.01f});
    for (int i = 0; i < 4; ++i) {
        const float y = 0.23f + 0.375f * static_cast<float>(i);
        k.board(inner, {0, y, -0.03f}, {s.x - 0.1f, 0.012f, s.z - 0.12f}, 0.002f);
        stock(k, i % 2 == 0 ? Goods::bottles : Goods::cans, -0.5f * s.x + 0.06f, 0.5f * s.x - 0.06f, y + 0.012f, 0.34f,
              0.5f * s.z - 0.1f, s.z - 0.2f);
    }
    k.rod(metal, {0.5f * s.x - 0.07f, 0.8f, 0.5f * s.z + 0.02f}, {0.5f * s.x - 0.07f, 1.3f, 0.5f * s.z + 0.02f},
          0.011f);
    for (const float y : {0.82f, 1.28f})
        k.rod(metal, {0.5f * s.x - 0.07f, y, 0.5f * s.z - 0.02f}, {0.5f * s.x - 0.07f, y, 0.5f * s.z + 0.02f}, 0.008f);
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.8f;
}

// Bottles lie in the squares of a rack, necks to the front.
void build_wine_rack(Kit& k) {
    const Vec3f s = k.wanted({1.3f, 1.95f, 0.32f});
    const int wood = k.main(k.style.wood), dark = color(k, "wine bottle", {0.02f, 0.035f, 0.02f}, 0.12f);
    const std::array<int, 3> caps{color(k, "red foil", {0.26f, 0.02f, 0.03f}, 0.3f),
                                  color(k, "gold foil", {0.5f, 0.36f, 0.1f}, 0.25f),
                                  color(k, "black foil", {0.03f, 0.03f, 0.03f}, 0.3f)};
    const float cell = 0.115f;
    const int columns = static_cast<int>((s.x - 0.04f) / cell), rows = static_cast<int>((s.y - 0.08f) / cell);
    const float w = cell * static_cast<float>(columns), h = cell * static_cast<float>(rows);
    for (int i = 0; i <= columns; ++i)
        for (const float sz : {-1.f, 1.f})
            k.board(wood, {-0.5f * w + cell * static_cast<float>(i), 0, sz * (0.5f * s.z - 0.03f)},
                    {0.02f, h + 0.06f, 0.03f}, 0.003f);
    for (int j = 0; j <= rows; ++j)
        k.board(wood, {0, 0.03f + cell * static_cast<float>(j), 0}, {w + 0.02f, 0.014f, s.z - 0.01f}, 0.003f);
    const std::array<Vec2f, 6> body{Vec2f{0.034f, 0}, {0.037f, 0.01f}, {0.037f, 0.19f},
                                    {0.015f, 0.235f}, {0.014f, 0.25f}, {0.014f, 0.251f}};
    const std::array<Vec2f, 2> foil{Vec2f{0.0165f, 0.25f}, {0.0165f, 0.305f}};
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            if (k.rng.chance(0.2f)) continue;
            const Vec3f at{-0.5f * w + cell * (static_cast<float>(i) + 0.5f),
                           0.044f + 0.038f + cell * static_cast<float>(j), -0.5f * s.z + 0.02f};
            Mesh lying = shapes::lathe(body, 9, true), neck = shapes::lathe(foil, 9);
            for (Mesh* m : {&lying, &neck}) shapes::turn(*m, {1, 0, 0}, 90);
            k.add(std::move(lying), dark, at);
            k.add(std::move(neck), caps[static_cast<std::size_t>(k.rng.index(3))], at);
        }
    k.top(0.044f + h, 0, 0, 0.45f * w, 0.12f);
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.7f;
}

}  // namespace fastscene::furniture
