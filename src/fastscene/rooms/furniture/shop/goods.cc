#include "fastscene/rooms/furniture/shop/goods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/print.h"

namespace fastscene::furniture {
namespace {

Mesh low_box(Vec3f size) {
    Mesh m;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.f, 1.f}) {
            const std::size_t a = static_cast<std::size_t>(axis), b = (a + 1) % 3, c = (a + 2) % 3;
            Vec3f normal{};
            normal[a] = side;
            const auto base = static_cast<std::uint32_t>(m.positions.size());
            for (const auto& [u, v] : {std::pair{-1.f, -1.f}, {1.f, -1.f}, {1.f, 1.f}, {-1.f, 1.f}}) {
                Vec3f p{};
                p[a] = side * size[a] / 2, p[b] = u * side * size[b] / 2, p[c] = v * size[c] / 2;
                m.positions.push_back(p);
                m.normals.push_back(normal);
            }
            for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) m.triangles.push_back(base + i);
        }
    m.coords = m.positions;
    return m;
}

// Loaves, shoes and the like: an ellipsoid with few sides.
void lump(Kit& k, int material, Vec3f base_center, Vec3f size) {
    k.add(shapes::ball({0, 0, 0}, size * 0.5f, 8), material, base_center + Vec3f{0, 0.5f * size.y, 0});
}

void shoe(Kit& k, int upper, int sole, Vec3f at) {
    block(k, sole, at, {0.085f, 0.018f, 0.26f});
    lump(k, upper, at + Vec3f{0, 0.012f, 0.05f}, {0.088f, 0.075f, 0.17f});
    lump(k, upper, at + Vec3f{0, 0.012f, -0.06f}, {0.08f, 0.11f, 0.13f});
}

// Long, round or a braid; slashed on top.
void loaf(Kit& k, int crust, int cut, int form, Vec3f at) {
    if (form == 0) {
        lump(k, crust, at, {0.13f, 0.095f, 0.28f});
        for (const float z : {-0.07f, 0.f, 0.07f}) lump(k, cut, at + Vec3f{0, 0.074f, z}, {0.075f, 0.025f, 0.03f});
    } else if (form == 1) {
        lump(k, crust, at, {0.2f, 0.12f, 0.2f});
        lump(k, cut, at + Vec3f{0, 0.1f, 0}, {0.1f, 0.026f, 0.1f});
    } else {
        for (const float z : {-0.09f, -0.03f, 0.03f, 0.09f})
            for (const float x : {-0.03f, 0.03f}) lump(k, crust, at + Vec3f{x, 0, z}, {0.09f, 0.085f, 0.085f});
    }
}

// The material of that name and color, registered once.
int once(Kit& k, const char* name, Vec3f albedo, float roughness) {
    for (std::size_t i = 0; i < k.piece.materials.size(); ++i)
        if (k.piece.materials[i].name == name && k.piece.materials[i].color_a == albedo) return static_cast<int>(i);
    return color(k, name, albedo, roughness);
}

// ---- what each trade sells: one item on a shelf of its own

struct Shelf {
    Kit& k;
    PrintSheet sheet;
    int brand;  // the cell that stands side by side
    float step, room_y, depth;
};

using Put = void (*)(const Shelf&, Vec3f at);  // the middle of its foot's front edge

// Lids of tins and jars, soles, caps.
int metal_lid(Kit& k) { return once(k, "lid", {0.5f, 0.46f, 0.38f}, 0.35f); }

void put_packet(const Shelf& s, Vec3f at) {
    const float h = std::min(s.room_y - 0.03f, 0.15f + 0.03f * static_cast<float>(s.brand % 4)),
                deep = std::min(0.12f, s.depth);
    s.k.add(printed_box(s.sheet[s.brand], {s.step - 0.006f, h, deep}), s.sheet.material,
            at - Vec3f{s.k.rng.uniform(-0.002f, 0.002f), 0, 0.5f * deep + s.k.rng.uniform(0, 0.012f)});
}
void put_can(const Shelf& s, Vec3f at) {
    const int lid = metal_lid(s.k);
    const float r = 0.037f, h = 0.108f;
    for (float y = 0; y + h < std::min(s.room_y, 0.24f); y += h + 0.002f) {
        const Vec3f foot = at + Vec3f{0, y, -r - 0.006f};
        s.k.add(printed_can(s.sheet[s.brand], r, 0.005f, h - 0.005f, 12), s.sheet.material, foot);
        const std::array<Vec2f, 3> rim{Vec2f{0.97f * r, 0}, {r + 0.001f, 0.003f}, {r + 0.001f, 0.006f}};
        s.k.add(shapes::lathe(rim, 10), lid, foot + Vec3f{0, h - 0.006f, 0});
        if (s.room_y < 0.26f) break;
    }
}
void put_preserve(const Shelf& s, Vec3f at) {
    static constexpr std::array<Vec3f, 6> kFruit{Vec3f{0.2f, 0.02f, 0.025f}, {0.36f, 0.16f, 0.02f},
                                                 {0.1f, 0.015f, 0.04f},      {0.14f, 0.16f, 0.03f},
                                                 {0.4f, 0.24f, 0.05f},       {0.25f, 0.07f, 0.02f}};
    static constexpr std::array<Vec3f, 3> kLids{Vec3f{0.45f, 0.36f, 0.16f}, {0.3f, 0.05f, 0.04f}, {0.5f, 0.48f, 0.44f}};
    Kit& k = s.k;
    const auto b = static_cast<std::size_t>(s.brand);
    const float r = 0.037f, h = std::min(0.13f, s.room_y - 0.04f);
    const Vec3f foot = at - Vec3f{0, 0, r + 0.008f};
    filled_jar(k, once(k, "preserve", kFruit[b % 6], 0.12f), once(k, "jar lid", kLids[b % 3], 0.3f), foot, r, h, 8);
    k.add(printed_can(s.sheet[s.brand], r + 0.0008f, 0.22f * h, 0.62f * h, 8), s.sheet.material, foot);
}
void put_jar(const Shelf& s, Vec3f at) {
    static constexpr std::array<Vec3f, 8> kDry{Vec3f{0.06f, 0.03f, 0.016f}, {0.5f, 0.4f, 0.22f},  {0.32f, 0.15f, 0.05f},
                                               {0.6f, 0.52f, 0.38f},        {0.2f, 0.22f, 0.08f}, {0.36f, 0.07f, 0.03f},
                                               {0.42f, 0.3f, 0.14f},        {0.1f, 0.08f, 0.06f}};
    Kit& k = s.k;
    const float r = 0.5f * s.step - 0.012f,
                h = std::min(s.room_y - 0.05f, 0.2f + 0.03f * static_cast<float>(s.brand % 3));
    const Vec3f foot = at - Vec3f{0, 0, r + 0.008f};
    filled_jar(k, jar_contents(k, kDry[static_cast<std::size_t>(s.brand) % 8]), metal_lid(k), foot, r, h);
    Mesh tag = printed_face(s.sheet[s.brand], {1.1f * r, 0.8f * r});
    k.add(std::move(tag), s.sheet.material, foot + Vec3f{-0.55f * r, 0.4f * h, r + 0.001f});
}
void put_coffee(const Shelf& s, Vec3f at) {  // bags with a rolled top
    const float h = std::min(s.room_y - 0.04f, 0.2f), w = s.step - 0.012f;
    Mesh bag = printed_box(s.sheet[s.brand], {w, h, 0.07f});
    for (Vec3f& p : bag.positions)
        if (p.y > 0.5f * h) p.z *= 0.35f;
    s.k.add(std::move(bag), s.sheet.material, at - Vec3f{0, 0, 0.045f});
}
void put_cup(const Shelf& s, Vec3f at) {
    Kit& k = s.k;
    static constexpr std::array<Vec3f, 3> kGlazes{
        Vec3f{0.74f, 0.73f, 0.7f}, {0.62f, 0.56f, 0.46f}, {0.2f, 0.25f, 0.26f}};
    const int glaze = once(k, "cup glaze", kGlazes[static_cast<std::size_t>(s.brand) % 3], 0.15f);
    const std::array<Vec2f, 4> profile{Vec2f{0.024f, 0}, {0.036f, 0.018f}, {0.041f, 0.05f}, {0.042f, 0.066f}};
    for (int i = 0; i < (s.room_y > 0.2f && s.brand % 2 == 0 ? 2 : 1); ++i) {
        const Vec3f foot = at + Vec3f{0, 0.058f * static_cast<float>(i), -0.05f};
        k.add(shapes::vessel(profile, 0.004f, 10), glaze, foot);
        Mesh handle = shapes::ring(0.018f, 0.005f, 8);
        shapes::turn(handle, {1, 0, 0}, 90);
        k.add(std::move(handle), glaze, foot + Vec3f{0.048f, 0.036f, 0});
    }
}
void put_bottle(const Shelf& s, Vec3f at) {
    static constexpr std::array<Vec3f, 5> kGlass{Vec3f{0.03f, 0.06f, 0.025f},
                                                 {0.1f, 0.04f, 0.012f},
                                                 {0.3f, 0.33f, 0.3f},
                                                 {0.02f, 0.03f, 0.025f},
                                                 {0.16f, 0.18f, 0.06f}};
    static constexpr std::array<Vec3f, 4> kCaps{
        Vec3f{0.04f, 0.04f, 0.04f}, {0.2f, 0.02f, 0.025f}, {0.42f, 0.32f, 0.12f}, {0.5f, 0.48f, 0.45f}};
    Kit& k = s.k;
    const auto b = static_cast<std::size_t>(s.brand);
    const float h = std::min(s.room_y - 0.02f, 0.29f), r = 0.036f;
    const Vec3f foot = at - Vec3f{0, 0, r + 0.01f};
    bottle(k, once(k, "bottle glass", kGlass[b % 5], 0.08f), once(k, "cap", kCaps[b % 4], 0.3f), foot, h, r);
    k.add(printed_can(s.sheet[s.brand], r + 0.0008f, 0.16f * h, 0.5f * h, 10), s.sheet.material, foot);
}
void put_carton(const Shelf& s, Vec3f at) {  // with a gable
    const float h = std::min(s.room_y - 0.02f, 0.21f), w = 0.078f;
    Mesh m = printed_box(s.sheet[s.brand], {w, 0.82f * h, w});
    s.k.add(std::move(m), s.sheet.material, at - Vec3f{0, 0, 0.5f * w});
    Mesh gable = printed_box(s.sheet[s.brand], {w, 0.18f * h, w});
    for (Vec3f& p : gable.positions)
        if (p.y > 0.01f) p.z *= 0.08f;
    s.k.add(std::move(gable), s.sheet.material, at + Vec3f{0, 0.82f * h, -0.5f * w});
}
void put_box(const Shelf& s, Vec3f at) {
    const float h = std::min(s.room_y - 0.04f, s.k.rng.uniform(0.22f, 0.38f)), deep = std::min(0.34f, s.depth);
    Mesh m = printed_box(s.sheet[s.k.rng.index(s.sheet.cells)], {s.step - s.k.rng.uniform(0.03f, 0.1f), h, deep});
    shapes::turn(m, {0, 1, 0}, s.k.rng.uniform(-3, 3));
    s.k.add(std::move(m), s.sheet.material, at - Vec3f{0, 0, 0.5f * deep + 0.02f});
}
void leaned(const Shelf& s, Vec3f at, int cell, Vec3f size) {  // against what is behind it
    Mesh m = printed_box(s.sheet[cell], size);
    shapes::turn(m, {1, 0, 0}, -9);
    s.k.add(std::move(m), s.sheet.material, at - Vec3f{0, 0, size.z + 0.02f});
}
void put_film(const Shelf& s, Vec3f at) {
    leaned(s, at, s.k.rng.chance(0.6f) ? s.brand : s.k.rng.index(s.sheet.cells),
           {0.134f, std::min(s.room_y - 0.01f, 0.19f), 0.015f});
}
void put_cover(const Shelf& s, Vec3f at) {
    const float h = std::min(s.room_y - 0.02f, s.k.rng.uniform(0.2f, 0.25f));
    leaned(s, at, s.brand, {0.7f * h, h, 0.025f});
}
void put_medicine(const Shelf& s, Vec3f at) {  // low boxes, stacked
    const float w = s.step - 0.005f, h = 0.045f + 0.012f * static_cast<float>(s.brand % 4);
    const int high = std::max(1, std::min(4, static_cast<int>((s.room_y - 0.03f) / h)));
    for (int i = 0; i < high - s.brand % 2; ++i)
        s.k.add(printed_box(s.sheet[s.brand], {w, h - 0.001f, 0.06f}), s.sheet.material,
                at + Vec3f{0, h * static_cast<float>(i), -0.035f - s.k.rng.uniform(0, 0.006f)});
}
void put_cosmetic(const Shelf& s, Vec3f at) {
    Kit& k = s.k;
    const float h = std::min(s.room_y - 0.03f, 0.1f + 0.025f * static_cast<float>(s.brand % 4)),
                r = 0.022f + 0.004f * static_cast<float>(s.brand % 3);
    const Vec3f foot = at - Vec3f{0, 0, r + 0.01f};
    k.add(printed_can(s.sheet[s.brand], r, 0, 0.8f * h, 10), s.sheet.material, foot);
    const std::array<Vec2f, 3> cap{Vec2f{r, 0.8f * h}, {0.45f * r, 0.86f * h}, {0.45f * r, h}};
    k.add(shapes::lathe(cap, 8),
          once(k, "pump", s.brand % 2 == 0 ? Vec3f{0.04f, 0.04f, 0.04f} : Vec3f{0.66f, 0.65f, 0.62f}, 0.3f), foot);
}
void put_shoes(const Shelf& s, Vec3f at) {
    static constexpr std::array<Vec3f, 7> kLeathers{
        Vec3f{0.03f, 0.028f, 0.027f}, {0.14f, 0.065f, 0.03f}, {0.26f, 0.15f, 0.07f}, {0.55f, 0.52f, 0.47f},
        {0.05f, 0.07f, 0.12f},        {0.22f, 0.05f, 0.04f},  {0.2f, 0.2f, 0.19f}};
    const auto b = static_cast<std::size_t>(s.brand);
    const int upper = once(s.k, "shoe leather", kLeathers[b % 7], b % 3 == 0 ? 0.3f : 0.6f),
              sole = once(s.k, "sole", b % 2 == 0 ? Vec3f{0.62f, 0.6f, 0.56f} : Vec3f{0.06f, 0.045f, 0.035f}, 0.8f);
    for (const float side : {-1.f, 1.f}) shoe(s.k, upper, sole, at + Vec3f{side * 0.048f, 0, -0.15f});
}
void put_toy(const Shelf& s, Vec3f at) {
    static constexpr std::array<Vec3f, 4> kPlush{
        Vec3f{0.3f, 0.17f, 0.08f}, {0.55f, 0.44f, 0.3f}, {0.42f, 0.4f, 0.38f}, {0.5f, 0.3f, 0.28f}};
    static constexpr std::array<Vec3f, 4> kPaints{
        Vec3f{0.42f, 0.07f, 0.05f}, {0.09f, 0.2f, 0.36f}, {0.55f, 0.38f, 0.1f}, {0.14f, 0.28f, 0.15f}};
    Kit& k = s.k;
    const Vec3f foot = at - Vec3f{0, 0, 0.09f};
    const int fur = once(k, "plush", kPlush[static_cast<std::size_t>(k.rng.index(4))], 0.95f),
              paint = once(k, "toy paint", kPaints[static_cast<std::size_t>(k.rng.index(4))], 0.4f),
              wheel = once(k, "wheel", {0.03f, 0.03f, 0.03f}, 0.6f),
              wood = once(k, "toy wood", {0.48f, 0.32f, 0.17f}, 0.5f);
    switch (k.rng.index(5)) {
        case 0:  // a bear, sitting
            lump(k, fur, foot, {0.15f, 0.15f, 0.12f});
            lump(k, fur, foot + Vec3f{0, 0.13f, 0}, {0.12f, 0.11f, 0.1f});
            lump(k, once(k, "muzzle", {0.6f, 0.5f, 0.38f}, 0.95f), foot + Vec3f{0, 0.145f, 0.035f},
                 {0.05f, 0.045f, 0.05f});
            for (const float x : {-1.f, 1.f}) {
                lump(k, fur, foot + Vec3f{x * 0.045f, 0.21f, 0}, {0.04f, 0.04f, 0.03f});
                lump(k, fur, foot + Vec3f{x * 0.06f, 0, 0.06f}, {0.055f, 0.055f, 0.09f});
                k.add(shapes::ball(foot + Vec3f{x * 0.022f, 0.195f, 0.044f}, {0.006f, 0.006f, 0.004f}, 6), wheel);
            }
            break;
        case 1: {  // a lorry of wood
            block(k, paint, foot + Vec3f{-0.02f, 0.035f, 0}, {0.13f, 0.02f, 0.09f});
            block(k, wood, foot + Vec3f{-0.03f, 0.055f, 0}, {0.1f, 0.07f, 0.085f});
            block(k, paint, foot + Vec3f{0.06f, 0.035f, 0}, {0.055f, 0.08f, 0.085f});
            for (const float x : {-0.06f, 0.055f})
                k.rod(wheel, foot + Vec3f{x, 0.025f, -0.05f}, foot + Vec3f{x, 0.025f, 0.05f}, 0.025f, -1, 10);
            break;
        }
        default: {  // boxes with a picture, two abreast or one large
            const float h = std::min(s.room_y - 0.04f, 0.24f);
            const int cell = k.rng.index(s.sheet.cells);
            if (k.rng.chance(0.5f)) {
                k.add(printed_box(s.sheet[cell], {0.2f, h, 0.09f}), s.sheet.material, foot);
            } else {
                for (const float x : {-0.053f, 0.053f})
                    k.add(printed_box(s.sheet[cell], {0.1f, 0.7f * h, 0.07f}), s.sheet.material,
                          foot + Vec3f{x, 0, 0.01f});
            }
            break;
        }
    }
}
void put_bread(const Shelf& s, Vec3f at) {
    static constexpr std::array<Vec3f, 4> kCrusts{
        Vec3f{0.36f, 0.18f, 0.065f}, {0.22f, 0.1f, 0.04f}, {0.46f, 0.27f, 0.11f}, {0.15f, 0.075f, 0.035f}};
    const auto b = static_cast<std::size_t>(s.brand);
    const int crust = once(s.k, "crust", kCrusts[b % 4], 0.75f),
              flour = once(s.k, "floured crust", {0.55f, 0.42f, 0.26f}, 0.95f);
    loaf(s.k, crust, flour, static_cast<int>(b % 3), at - Vec3f{0, 0, 0.15f});
}
void put_records(const Shelf& s, Vec3f at) {
    const int kept = s.brand;
    for (int i = 0; i < 7; ++i) {
        Mesh sleeve = printed_box(s.sheet[(kept + 7 * i) % s.sheet.cells], {0.31f, 0.31f, 0.006f});
        shapes::turn(sleeve, {1, 0, 0}, -14.f - s.k.rng.uniform(0, 4));
        s.k.add(std::move(sleeve), s.sheet.material, at + Vec3f{0, 0.005f, -0.06f - 0.055f * static_cast<float>(i)});
    }
}

struct Ware {
    Goods goods;
    Print print;
    float step;  // metres from one to the next
    int alike;   // so many of a brand at least, side by side; 0: all differ
    Put put;
};

constexpr std::array<Ware, 18> kWares{{{Goods::packets, Print::groceries, 0.135f, 2, put_packet},
                                       {Goods::cans, Print::tins, 0.08f, 3, put_can},
                                       {Goods::covers, Print::book_covers, 0.19f, 1, put_cover},
                                       {Goods::shoes, Print::parcels, 0.21f, 0, put_shoes},
                                       {Goods::toys, Print::toys, 0.23f, 1, put_toy},
                                       {Goods::bread, Print::parcels, 0.22f, 2, put_bread},
                                       {Goods::preserves, Print::preserves, 0.09f, 2, put_preserve},
                                       {Goods::jars, Print::preserves, 0.135f, 0, put_jar},
                                       {Goods::coffee, Print::coffees, 0.115f, 2, put_coffee},
                                       {Goods::cups, Print::coffees, 0.115f, 4, put_cup},
                                       {Goods::bottles, Print::wines, 0.085f, 2, put_bottle},
                                       {Goods::cartons, Print::drinks, 0.085f, 3, put_carton},
                                       {Goods::boxes, Print::parcels, 0.42f, 0, put_box},
                                       {Goods::records, Print::sleeves, 0.33f, 0, put_records},
                                       {Goods::films, Print::film_covers, 0.142f, 1, put_film},
                                       {Goods::medicines, Print::medicines, 0.105f, 2, put_medicine},
                                       {Goods::cosmetics, Print::cosmetics, 0.066f, 3, put_cosmetic},
                                       {Goods::hardware, Print::hardware, 0.12f, 2, put_packet}}};

}  // namespace

int lit(Kit& k, const char* name, Vec3f radiance) { return k.material(lit(name, radiance)); }

int color(Kit& k, const char* name, Vec3f albedo, float roughness) {
    return k.material(plain(name, albedo, roughness));
}

void block(Kit& k, int material, Vec3f base_center, Vec3f size) {
    k.add(low_box(size), material, base_center + Vec3f{0, 0.5f * size.y, 0});
}

void bottle(Kit& k, int glass, int cap, Vec3f at, float h, float r) {
    const std::array<Vec2f, 5> body{
        Vec2f{r, 0}, {r, 0.6f * h}, {0.4f * r, 0.78f * h}, {0.36f * r, 0.95f * h}, {0.36f * r, 0.955f * h}};
    k.add(shapes::lathe(body, 9, true), glass, at);
    const std::array<Vec2f, 2> lid{Vec2f{0.42f * r, 0}, {0.42f * r, 0.06f * h}};
    k.add(shapes::lathe(lid, 8), cap, at + Vec3f{0, 0.94f * h, 0});
}

// The contents shine as the glass before them does; above them one sees the empty part of the jar.
void filled_jar(Kit& k, int contents, int lid, Vec3f at, float r, float h, int sides) {
    const int air = once(k, "empty glass", {0.4f, 0.42f, 0.4f}, 0.08f);
    const std::array<Vec2f, 3> full{Vec2f{0.94f * r, 0}, {r, 0.04f * h}, {r, 0.7f * h}},
        empty{Vec2f{r, 0.7f * h}, {r, 0.78f * h}, {0.8f * r, 0.86f * h}},
        top{Vec2f{0.86f * r, 0.86f * h}, {0.88f * r, 0.88f * h}, {0.86f * r, h}};
    k.add(shapes::lathe(full, sides, true), contents, at);
    k.add(shapes::lathe(empty, sides, true), air, at);
    k.add(shapes::lathe(top, sides), lid, at);
}

int jar_contents(Kit& k, Vec3f c) {
    for (std::size_t i = 0; i < k.piece.materials.size(); ++i)
        if (k.piece.materials[i].name == "jar contents" && k.piece.materials[i].color_a == c)
            return static_cast<int>(i);
    Material m = plain("jar contents", c, 0.15f);
    m.pattern = Pattern::terrazzo;
    m.color_b = 0.55f * c;
    m.color_c = lerp(1.3f * c, Vec3f{0.5f, 0.45f, 0.35f}, 0.1f);
    m.scale_m = 0.009f;
    return k.material(m);
}

void stock(Kit& k, Goods goods, float x0, float x1, float y, float room_y, float z_front, float depth) {
    if (goods == Goods::books || goods == Goods::paperbacks)
        return book_row(k, goods == Goods::books ? Print::cloth_spines : Print::paper_spines, {x0, y, z_front - 0.02f},
                        x1 - x0, room_y - 0.02f, std::min(0.2f, depth - 0.02f));
    const Ware& ware = *std::find_if(kWares.begin(), kWares.end(), [&](const Ware& w) { return w.goods == goods; });
    Shelf shelf{k, print_sheet(k, ware.print), 0, ware.step, room_y, depth};
    // Spread evenly over the shelf.
    const int count = static_cast<int>((x1 - x0) / ware.step);
    const float pitch = count > 0 ? (x1 - x0) / static_cast<float>(count) : 0;
    int same = 0;
    for (int i = 0; i < count; ++i) {
        if (--same <= 0) {
            same = ware.alike + k.rng.index(3);
            shelf.brand = k.rng.index(shelf.sheet.cells);
            if (k.rng.chance(0.05f)) {  // sold out
                same = 0;
                continue;
            }
        }
        ware.put(shelf, {x0 + pitch * (static_cast<float>(i) + 0.5f), y, z_front - 0.012f});
    }
}

}  // namespace fastscene::furniture
