// Tables, desks, shelves and cabinets.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/furniture_forms.h"

namespace fastscene::furniture {
namespace {

int leg_material(Kit& k, int wood) {
    return k.style.legs == LegType::metal_frame || k.style.legs == LegType::hairpin ? k.material(k.style.metal) : wood;
}

// A rectangular table: top, apron, legs. size.y is the height of the top.
void plain_table(Kit& k, Vec3f s, float thick) {
    const int wood = k.main(k.style.wood, k.request.holder_material != kTableCloth), leg = leg_material(k, wood);
    k.board(wood, {0, s.y - thick, 0}, {s.x, thick, s.z}, 0.006f);
    const float t = std::min(0.07f, 0.14f * s.y + 0.01f), in = 0.06f;
    legs(k, leg, 0.5f * s.x - in - 0.5f * t, 0.5f * s.z - in - 0.5f * t, s.y - thick + 0.002f, t);
    const float apron = std::min(0.08f, 0.18f * s.y);
    for (const float sg : {-1.f, 1.f}) {
        k.board(leg, {0, s.y - thick - apron, sg * (0.5f * s.z - in - 0.03f)}, {s.x - 2 * in - t, apron, 0.022f});
        k.board(leg, {sg * (0.5f * s.x - in - 0.03f), s.y - thick - apron, 0}, {0.022f, apron, s.z - 2 * in - t});
    }
    k.top(s.y, 0, 0, 0.46f * s.x, 0.46f * s.z);
}
void round_table(Kit& k, float d, float y, float thick) {
    const int wood = k.main(k.style.wood, k.request.holder_material != kTableCloth), leg = leg_material(k, wood);
    k.add(shapes::prism(shapes::circle(0.5f * d, 48), y - thick, y, 0.006f), wood);
    if (y > 0.6f && k.style.legs != LegType::splayed) {
        const std::array<Vec2f, 8> p{Vec2f{0.26f * d, 0},
                                     {0.26f * d, 0.025f},
                                     {0.06f * d, 0.06f},
                                     {0.04f * d, 0.2f * y},
                                     {0.05f * d, 0.5f * y},
                                     {0.04f * d, 0.8f * y},
                                     {0.12f * d, y - thick - 0.01f},
                                     {0.12f * d, y - thick + 0.002f}};
        k.add(shapes::lathe(p, 32), leg);
    } else {
        for (int i = 0; i < 3; ++i) {
            const float a = 2.0944f * static_cast<float>(i) + 0.5f;
            k.rod(leg, {0.42f * d * std::cos(a), 0, 0.42f * d * std::sin(a)},
                  {0.3f * d * std::cos(a), y - thick + 0.002f, 0.3f * d * std::sin(a)}, 0.012f, 0.02f);
        }
    }
    k.top(y, 0, 0, 0.33f * d, 0.33f * d);
}
void put_small(Kit& k, std::string klass, Vec3f at, float turn = 0.f) { k.merge(k.small(std::move(klass)), at, turn); }

// A thick top on two crossed trestles and a stretcher.
void trestle_table(Kit& k, Vec3f s) {
    const int wood = k.main(k.style.wood, k.request.holder_material != kTableCloth),
              frame = k.style.legs == LegType::metal_frame ? k.material(k.style.metal) : wood;
    k.board(wood, {0, s.y - 0.05f, 0}, {s.x, 0.05f, s.z}, 0.008f);
    const float x = 0.5f * s.x - 0.26f, z = 0.5f * s.z - 0.1f, y = s.y - 0.045f;
    for (const float sx : {-1.f, 1.f}) {
        for (const float sz : {-1.f, 1.f}) {
            Mesh leg = shapes::box({0.06f, std::hypot(y, 2 * z), 0.05f}, 0.006f);
            shapes::lay_grain(leg, {k.dice.uniform(0, 3), 0, 0});
            shapes::turn(leg, {1, 0, 0}, sz * std::atan2(2 * z, y) * 57.29578f);
            k.add(std::move(leg), frame, {sx * (x + 0.026f * sz), 0.5f * y, 0});
        }
        k.board(frame, {sx * x, s.y - 0.1f, 0}, {0.09f, 0.052f, 2 * z + 0.05f}, 0.006f);
    }
    k.board(frame, {0, 0.5f * y - 0.03f, 0}, {2 * x, 0.06f, 0.04f}, 0.006f);
    // Nothing reaches below the floor, however the legs lean.
    for (Mesh& m : k.piece.meshes)
        for (Vec3f& p : m.positions) p.y = std::max(p.y, 0.f);
    k.top(s.y, 0, 0, 0.46f * s.x, 0.46f * s.z);
}
// A drum with flutes; a slab on two cheeks; two tops of different height.
void drum_table(Kit& k, float d, float y) {
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal);
    k.add(shapes::prism(shapes::circle(0.42f * d, 40), 0.02f, y - 0.03f, 0.004f), wood);
    for (int i = 0; i < 32; ++i) {
        const float a = 0.19635f * static_cast<float>(i);
        k.rod(wood, {0.42f * d * std::cos(a), 0.02f, 0.42f * d * std::sin(a)},
              {0.42f * d * std::cos(a), y - 0.03f, 0.42f * d * std::sin(a)}, 0.022f, -1, 8);
    }
    k.add(shapes::prism(shapes::circle(0.5f * d, 48), y - 0.03f, y, 0.006f), wood);
    k.add(shapes::prism(shapes::circle(0.46f * d, 40), 0.f, 0.022f, 0.004f), metal);
    k.top(y, 0, 0, 0.33f * d, 0.33f * d);
}
void slab_table(Kit& k, Vec3f s) {
    const int wood = k.main(k.style.wood);
    k.board(wood, {0, s.y - 0.06f, 0}, {s.x, 0.06f, s.z}, 0.01f);
    for (const float sx : {-1.f, 1.f})
        k.board(wood, {sx * (0.5f * s.x - 0.16f), 0, 0}, {0.06f, s.y - 0.06f, s.z - 0.08f}, 0.008f);
    k.board(wood, {0, 0.1f, 0}, {s.x - 0.38f, 0.025f, s.z - 0.12f}, 0.004f);
    k.top(s.y, 0, 0, 0.46f * s.x, 0.46f * s.z);
}
void twin_table(Kit& k, Vec3f s) {
    const int wood = k.main(k.style.wood), second = k.material(k.style.wood2);
    const auto low = [&](int mat, float x, float z, float d, float y) {
        k.add(shapes::prism(shapes::circle(0.5f * d, 44), y - 0.025f, y, 0.006f), mat, {x, 0, z});
        for (int i = 0; i < 3; ++i) {
            const float a = 2.0944f * static_cast<float>(i) + x;
            k.rod(mat, {x + 0.4f * d * std::cos(a), 0, z + 0.4f * d * std::sin(a)},
                  {x + 0.28f * d * std::cos(a), y - 0.02f, z + 0.28f * d * std::sin(a)}, 0.011f, 0.018f);
        }
    };
    low(wood, -0.2f * s.x, 0.02f, 0.66f * s.z * 1.1f, s.y);
    low(second, 0.26f * s.x, -0.02f, 0.5f * s.z * 1.1f, s.y + 0.08f);
    k.top(s.y, -0.2f * s.x - 0.03f, 0.02f, 0.2f * s.z, 0.2f * s.z);
}
void coffee_table(Kit& k) {
    enum { four_legs, round, drum, slab, twin };
    const Vec3f s = k.wanted({1.1f, 0.4f, 0.6f});
    switch (form_for(k,
                     {{"modern", slab, twin},
                      {"scandinavian", twin, round},
                      {"japandi", slab, round},
                      {"industrial", four_legs, slab},
                      {"classic", four_legs, drum},
                      {"boho", drum, round},
                      {"rustic", four_legs, slab},
                      {"mid-century", round, twin},
                      {"mediterranean", drum, four_legs},
                      {"art deco", drum, round}},
                     four_legs)) {
        case round: return round_table(k, 0.8f * s.x, s.y, 0.03f);
        case drum: return drum_table(k, 0.75f * s.x, s.y);
        case slab: return slab_table(k, s);
        case twin: return twin_table(k, s);
        default: break;
    }
    plain_table(k, s, 0.035f);
    if (k.style.legs == LegType::square || k.style.legs == LegType::metal_frame)
        k.board(k.piece.main_material, {0, 0.1f, 0}, {s.x - 0.16f, 0.02f, s.z - 0.14f});
}
void side_table(Kit& k) { round_table(k, 0.45f, 0.53f, 0.022f); }
// A cloth over a top of this outline (counter-clockwise from above): it lies on it, and hangs over its rim in folds.
void lay_cloth_on(Kit& k, std::span<const Vec2f> rim, float y, float down) {
    Material cloth = k.style.fabric;
    const bool said = !k.request.holder_color.empty();
    const Vec3f color = said ? *color_named(k.request.holder_color) : Vec3f{0.74f, 0.72f, 0.68f};
    cloth.color_a = cloth.color_c = color, cloth.color_b = color * 0.85f;
    cloth.name = "tablecloth";
    k.print(cloth, said ? std::optional(color) : std::nullopt);
    const int linen = k.material(cloth);
    std::vector<float> along{0.f};  // metres along the rim
    for (std::size_t i = 0; i < rim.size(); ++i)
        along.push_back(along.back() + length(rim[(i + 1) % rim.size()] - rim[i]));
    constexpr float kOver = 0.004f, kLift = 0.003f, kFold = 0.16f;
    const float folds = std::round(along.back() / kFold);
    Mesh m;
    const int columns = static_cast<int>(along.back() / 0.02f), hem = 12;
    const auto at = [&](int c, int row) {
        const float s = along.back() * static_cast<float>(c % columns) / static_cast<float>(columns);
        std::size_t i = 0;
        while (i + 2 < along.size() && along[i + 1] <= s) ++i;
        const Vec2f a = rim[i], b = rim[(i + 1) % rim.size()],
                    p = a + (b - a) * ((s - along[i]) / std::max(1e-6f, along[i + 1] - along[i]));
        const Vec2f run = (b - a) * (1.f / std::max(1e-6f, length(b - a))), across{run.y, -run.x},
                    out = across.x * p.x + across.y * p.y < 0 ? across * -1.f : across;
        if (row == 0) return std::pair{Vec3f{0, y + kLift, 0}, Vec3f{0, 0, 0}};
        const float drop = down * static_cast<float>(row - 1) / static_cast<float>(hem),
                    wave = 0.5f + 0.5f * std::sin(kTau * folds * s / along.back()),
                    spread = kOver + (row > 1 ? 0.02f + 0.03f * wave * drop / down : 0.f);
        const Vec2f q = p + out * spread;
        return std::pair{Vec3f{q.x, y + kLift - drop * (row > 1 ? 1.f : 0.f), q.y},
                         Vec3f{p.x + out.x * drop, 0, p.y + out.y * drop}};
    };
    for (int row = 0; row <= hem + 1; ++row)
        for (int c = 0; c <= columns; ++c) {
            const auto [p, q] = at(c, row);
            m.positions.push_back(p);
            m.coords.push_back({q.x, q.z, 0});
        }
    const auto id = [&](int c, int row) { return static_cast<std::uint32_t>(row * (columns + 1) + c); };
    for (int row = 0; row <= hem; ++row)
        for (int c = 0; c < columns; ++c) {
            // Seen from above the rim runs counter-clockwise about +y: outward is up and out.
            if (row > 0) m.triangles.insert(m.triangles.end(), {id(c, row), id(c + 1, row), id(c, row + 1)});
            m.triangles.insert(m.triangles.end(), {id(c + 1, row), id(c + 1, row + 1), id(c, row + 1)});
        }
    m.normals.assign(m.positions.size(), Vec3f{0, 1, 0});
    shapes::smooth_normals(m);
    // The top is flat, whatever the rim does.
    for (int row = 0; row <= 1; ++row)
        for (int c = 0; c <= columns; ++c) m.normals[id(c, row)] = {0, 1, 0};
    k.add(std::move(m), linen);
    for (Surface& s : k.piece.surfaces) s.center.y = std::max(s.center.y, y + kLift);
}
bool has_cloth(const Kit& k) { return k.request.holder_material == kTableCloth; }

void dining_table(Kit& k) {
    enum { four_legs, trestle, pedestal };
    const int form = form_for(k,
                              {{"modern", four_legs, pedestal},
                               {"scandinavian", four_legs, pedestal},
                               {"japandi", four_legs, trestle},
                               {"industrial", trestle, four_legs},
                               {"classic", four_legs, pedestal},
                               {"boho", trestle, pedestal},
                               {"rustic", trestle, four_legs},
                               {"mid-century", pedestal, four_legs},
                               {"mediterranean", trestle, four_legs},
                               {"art deco", pedestal, four_legs}},
                              four_legs);
    const bool sized = k.request.size_m.x > 0.f || k.request.size_m.z > 0.f;
    const Vec3f s = k.wanted({1.7f, 0.75f, 0.9f});
    const bool round = form == pedestal && !sized;
    if (form == trestle) trestle_table(k, s);
    else if (round) round_table(k, 0.75f * s.x, s.y, 0.035f);
    else plain_table(k, s, 0.04f);
    constexpr float kDown = 0.24f;
    if (has_cloth(k))
        lay_cloth_on(k, round ? shapes::circle(0.375f * s.x, 72) : shapes::rounded_rectangle(s.x, s.z, 0.03f, 4), s.y,
                     kDown);
}
void dining_table_round(Kit& k) {
    const float d = k.wanted({1.2f, 0.75f, 1.2f}).x;
    round_table(k, d, 0.75f, 0.035f);
    if (has_cloth(k)) lay_cloth_on(k, shapes::circle(0.5f * d, 72), 0.75f, 0.3f);
}
void console_table(Kit& k) {
    plain_table(k, k.wanted({1.1f, 0.8f, 0.35f}), 0.03f);
    k.piece.against_wall = true;
}

void desk(Kit& k) {
    const int screens = k.request.screens;
    const Vec3f s = k.wanted(
        {std::max(1.35f, 0.25f + kMonitorStep * static_cast<float>(screens)), 0.75f, screens > 0 ? 0.72f : 0.65f});
    plain_table(k, s, 0.03f);
    k.piece.surfaces.clear();
    k.board(k.piece.main_material, {0.5f * s.x - 0.3f, s.y - 0.17f, 0.02f}, {0.38f, 0.14f, s.z - 0.2f});
    const int metal = k.material(k.style.metal), dark = k.material(plain("dark plastic", {0.04f, 0.04f, 0.043f}, 0.4f)),
              alu = k.material(plain("aluminium", {0.5f, 0.51f, 0.52f}, 0.35f));
    Material scr = plain("laptop screen", {0.1f, 0.16f, 0.24f}, 0.2f);
    scr.pattern = Pattern::screen;
    scr.emission = {0.5f, 0.7f, 0.95f};
    const int screen = k.material(scr);
    fronts(k, k.piece.main_material, metal, 0.5f * s.x - 0.49f, 0.5f * s.x - 0.11f, s.y - 0.17f, s.y - 0.03f,
           0.5f * s.z - 0.08f, 1, 1);
    k.piece.clearance_front_m = 0.8f;
    k.piece.against_wall = true;
    if (screens > 0) {
        // A keyboard and a mouse before the monitors that come; all of the top's back is theirs.
        k.board(dark, {0, s.y, 0.17f}, {0.42f, 0.016f, 0.13f}, 0.005f);
        k.board(alu, {0, s.y + 0.015f, 0.17f}, {0.4f, 0.004f, 0.112f}, 0.001f);
        k.board(dark, {0.3f, s.y, 0.18f}, {0.06f, 0.03f, 0.1f}, 0.013f);
        k.top(s.y, 0, -0.13f, 0.5f * s.x - 0.02f, 0.5f * s.z - 0.15f);
        return;
    }
    // The laptop faces who sits at the front (+z).
    k.board(alu, {0, s.y, 0.06f}, {0.34f, 0.014f, 0.24f}, 0.004f);
    k.board(dark, {0, s.y + 0.0135f, 0.03f}, {0.29f, 0.002f, 0.11f}, 0.0005f);
    Mesh lid = shapes::box({0.34f, 0.23f, 0.008f}, 0.003f), face = shapes::box({0.315f, 0.205f, 0.002f}, 0.0005f);
    shapes::move(face, {0, 0, 0.0045f});
    for (Mesh* m : {&lid, &face}) shapes::move(shapes::turn(*m, {1, 0, 0}, -16), {0, s.y + 0.122f, -0.09f});
    k.add(lid, alu);
    k.add(face, screen);
    put_small(k, "book_stack", {0.5f * s.x - 0.25f, s.y, -0.08f}, 12);
    const std::array<Vec2f, 2> cup{Vec2f{0.036f, 0}, {0.04f, 0.09f}};
    k.add(shapes::vessel(cup, 0.004f, 18), k.material(plain("mug", k.accent(), 0.3f)), {0.3f, s.y, 0.14f});
    // Room for a lamp and more at the left.
    k.top(s.y, -0.25f * s.x - 0.09f, -0.01f, 0.25f * s.x - 0.1f, 0.5f * s.z - 0.04f);
}

// A case of boards: sides, top, bottom, back; the front is open.
void carcass(Kit& k, int wood, Vec3f s, float y0, float t = 0.022f) {
    for (const float sx : {-1.f, 1.f}) k.board(wood, {sx * 0.5f * (s.x - t), y0, 0}, {t, s.y - y0, s.z}, 0.003f);
    k.board(wood, {0, s.y - t, 0}, {s.x - 2 * t, t, s.z - 0.002f}, 0.003f);
    k.board(wood, {0, y0, 0}, {s.x - 2 * t, t, s.z - 0.002f}, 0.003f);
    k.board(wood, {0, y0 + t, -0.5f * s.z + 0.006f}, {s.x - 2 * t, s.y - y0 - 2 * t, 0.01f}, 0.002f);
}
// A closed cabinet on legs or a plinth with a grid of fronts.
void chest(Kit& k, Vec3f s, float leg, int columns, int rows, float clearance) {
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal);
    const bool rich = k.style.mouldings == Mouldings::rich;
    if (leg > 0.03f)
        legs(k, k.style.legs == LegType::metal_frame ? metal : wood, 0.5f * s.x - 0.05f, 0.5f * s.z - 0.05f,
             leg + 0.002f, 0.045f);
    else k.board(wood, {0, 0, -0.01f}, {s.x - 0.04f, leg + 0.001f, s.z - 0.06f});
    k.board(wood, {0, leg, -0.012f}, {s.x, s.y - leg - 0.024f, s.z - 0.03f}, 0.004f);
    const float lip = rich ? 0.025f : 0.004f;
    k.board(wood, {0, s.y - 0.024f, lip * 0.3f}, {s.x + 2 * lip, 0.024f, s.z + lip}, rich ? 0.01f : 0.003f);
    fronts(k, wood, metal, -0.5f * s.x + 0.012f, 0.5f * s.x - 0.012f, leg + 0.012f, s.y - 0.034f, 0.5f * s.z - 0.028f,
           columns, rows);
    k.top(s.y, 0, 0, 0.46f * s.x, 0.42f * s.z);
    k.piece.clearance_front_m = clearance;
    k.piece.against_wall = true;
}
void nightstand(Kit& k) { chest(k, k.wanted({0.45f, 0.52f, 0.4f}), 0.14f, 1, 2, 0.3f); }
void dresser(Kit& k) { chest(k, k.wanted({1.2f, 0.82f, 0.48f}), 0.12f, 2, 3, 0.6f); }
void wardrobe(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 2.1f, 0.6f});
    chest(k, s, 0.06f, std::max(2, static_cast<int>(s.x / 0.5f)), 1, 0.6f);
}
void cabinet(Kit& k) { chest(k, k.wanted({0.9f, 1.2f, 0.42f}), 0.12f, 2, 1, 0.5f); }
// Sliding doors of upright slats.
void slatted_chest(Kit& k, Vec3f s, float leg, float clearance) {
    const int wood = k.main(k.style.wood);
    legs(k, wood, 0.5f * s.x - 0.09f, 0.5f * s.z - 0.07f, leg + 0.002f, 0.045f);
    k.board(wood, {0, leg, -0.012f}, {s.x, s.y - leg, s.z - 0.03f}, 0.006f);
    const int count = static_cast<int>((s.x - 0.06f) / 0.032f);
    Mesh slats;
    for (int i = 0; i < count; ++i) {
        if (i == count / 2) continue;
        Mesh m = shapes::box({0.02f, s.y - leg - 0.07f, 0.016f}, 0.003f);
        shapes::lay_grain(m, {0.1f * static_cast<float>(i), 0, 0});
        shapes::append(slats,
                       shapes::move(m, {(static_cast<float>(i) + 0.5f) / static_cast<float>(count) * (s.x - 0.06f) -
                                            0.5f * s.x + 0.03f,
                                        0.5f * (s.y + leg), 0.5f * s.z - 0.02f}));
    }
    k.add(std::move(slats), wood);
    k.top(s.y, 0, 0, 0.46f * s.x, 0.42f * s.z);
    k.piece.clearance_front_m = clearance;
    k.piece.against_wall = true;
}
bool slatted(Kit& k) {
    return form_for(
               k, {{"scandinavian", 0, 1}, {"japandi", 1, 0}, {"mid-century", 1, 0}, {"boho", 0, 1}, {"modern", 0, 1}},
               0) == 1;
}
void sideboard(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 0.75f, 0.45f});
    if (slatted(k)) return slatted_chest(k, s, 0.18f, 0.5f);
    if (k.style.name == "industrial" || k.style.name == "rustic")
        return chest(k, s, 0.16f, 3, k.dice.chance(0.5f) ? 1 : 2, 0.5f);
    chest(k, s, 0.16f, 4, 1, 0.5f);
}
void shoe_rack(Kit& k) {
    const Vec3f s = k.wanted({0.8f, 0.5f, 0.32f});
    const int wood = k.main(k.style.wood);
    carcass(k, wood, s, 0.06f);
    k.board(wood, {0, 0.28f, 0}, {s.x - 0.044f, 0.02f, s.z - 0.02f});
    for (const float sx : {-1.f, 1.f}) k.board(wood, {sx * (0.5f * s.x - 0.06f), 0, 0}, {0.04f, 0.062f, s.z - 0.04f});
    for (int i = 0; i < 6; ++i) {
        const int shoe = i % 2 == 0 ? k.material(tinted(k.style.leather, k.accent()))
                                    : static_cast<int>(k.piece.materials.size()) - 1;
        const float y = i < 4 ? 0.082f : 0.3f, x = (i < 4 ? -0.27f : -0.15f) + 0.12f * static_cast<float>(i % 4) +
                                                   0.06f * static_cast<float>(i / 2);
        Mesh m = shapes::soft_box({0.085f, 0.07f, 0.24f}, {0.035f, 0.01f, 0.001f, 3, k.seed()});
        k.add(std::move(m), shoe, {x, y + 0.036f, 0.02f});
        k.soft(shoe, {x, y + 0.04f, -0.055f}, {0.075f, 0.07f, 0.1f}, {0.03f, 0.005f, 0.001f, 2});
    }
    k.top(s.y, 0, 0, 0.45f * s.x, 0.4f * s.z);
    k.piece.against_wall = true;
}

void tv(Kit& k) {
    const int dark = k.main(plain("black plastic", {0.032f, 0.032f, 0.034f}, 0.25f));
    Material m = plain("tv screen", {0.03f, 0.03f, 0.034f}, 0.08f);
    m.pattern = Pattern::screen;
    const int screen = k.material(m);
    const float w = 1.22f, h = 0.7f;
    const bool hung = k.request.pattern == kHungScreen;
    const float foot = hung ? 0.f : 0.05f;
    k.board(dark, {0, foot, 0}, {w, h, 0.035f}, 0.005f);
    k.board(screen, {0, foot + 0.012f, 0.0175f}, {w - 0.016f, h - 0.024f, 0.003f}, 0.001f);
    for (const float sx : {-1.f, 1.f}) {
        if (hung) break;
        k.board(dark, {sx * 0.36f, 0, 0}, {0.03f, 0.052f, 0.025f}, 0.003f);
        k.board(dark, {sx * 0.36f, 0, 0}, {0.03f, 0.012f, 0.22f}, 0.004f);
    }
    k.piece.mount = Mount::surface;
}
// On a foot, lit as a computer's is.
void monitor(Kit& k) {
    const int dark = k.main(plain("black plastic", {0.032f, 0.032f, 0.034f}, 0.3f));
    Material m = plain("monitor screen", {0.1f, 0.16f, 0.24f}, 0.2f);
    m.pattern = Pattern::screen;
    m.emission = {0.5f, 0.7f, 0.95f};
    const int screen = k.material(m);
    const float w = 0.55f, h = 0.33f, foot = 0.1f;
    k.board(dark, {0, foot, 0}, {w, h, 0.03f}, 0.005f);
    k.board(screen, {0, foot + 0.012f, 0.015f}, {w - 0.02f, h - 0.024f, 0.003f}, 0.001f);
    k.board(dark, {0, 0.01f, -0.022f}, {0.05f, foot + 0.1f, 0.016f}, 0.004f);
    k.board(dark, {0, 0, 0}, {0.22f, 0.012f, 0.16f}, 0.004f);
    k.piece.mount = Mount::surface;
}
void tv_stand(Kit& k) {
    const Vec3f s = k.wanted({1.6f, 0.48f, 0.42f});
    if (slatted(k)) return slatted_chest(k, s, 0.12f, 0.6f);
    chest(k, s, 0.12f, 3, 1, 0.6f);
}

// What stands on one shelf: books, a vase, a basket, a bowl; `room_y` = free height.
void fill_shelf(Kit& k, float x0, float x1, float y, float room_y, float z_back, float depth) {
    static constexpr std::array<std::array<const char*, 6>, 3> kOthers{
        {{"towel_stack", "toiletries", "bottles", "towel_stack", "storage_box", "plant_small"},
         {"bottles", "pot", "bowl", "storage_box", "cup", "plant_small"},
         {"teddy_bear", "toy_blocks", "storage_box", "book_stack", "globe", "teddy_bear"}}};
    const Shelves kind = k.style.shelves;
    float x = x0 + 0.015f;
    while (x < x1 - 0.12f) {
        const float left = x1 - x - 0.01f;
        const int what = k.dice.index(10);
        if (kind != Shelves::books && !(kind == Shelves::toys && what < 4)) {
            const auto& others = kOthers[static_cast<std::size_t>(kind) - 1];
            const Piece p = k.small(others[static_cast<std::size_t>(k.dice.index(6))]);
            const bool fits = p.size_m.x < left && p.size_m.y < room_y - 0.02f && p.size_m.z < depth + 0.02f;
            if (fits) k.merge(p, {x + 0.5f * p.size_m.x, y, z_back + 0.5f * depth});
            x += fits ? p.size_m.x + k.dice.uniform(0.03f, 0.12f) : 0.06f;
            continue;
        }
        if (what < 6) {
            const float w = std::min(left, k.dice.uniform(0.18f, 0.4f));
            books(k, {x, y, z_back + 0.01f}, w, room_y - 0.03f, std::min(0.2f, depth - 0.03f));
            x += w + 0.02f;
        } else {
            Piece p = k.small(what == 6 ? "vase_small" : what == 7 ? "book_stack" : what == 8 ? "bowl" : "plant_small");
            if (p.size_m.x < left && p.size_m.y < room_y - 0.02f && p.size_m.z < depth + 0.02f)
                k.merge(p, {x + 0.5f * p.size_m.x, y, z_back + 0.5f * depth});
            x += std::min(left, p.size_m.x + k.dice.uniform(0.02f, 0.1f));
        }
    }
}
void bookshelf(Kit& k) {
    const Vec3f s = k.wanted({0.95f, 1.95f, 0.3f});
    const int wood = k.main(k.style.wood);
    carcass(k, wood, s, 0.05f);
    k.board(wood, {0, 0, 0.01f}, {s.x - 0.044f, 0.052f, s.z - 0.05f});
    const int rows = std::max(2, static_cast<int>(s.y / 0.36f)), columns = s.x > 1.3f ? 2 : 1;
    const float step = (s.y - 0.072f) / static_cast<float>(rows), w = (s.x - 0.044f) / static_cast<float>(columns);
    for (int j = 0; j < rows; ++j) {
        const float y = 0.05f + step * static_cast<float>(j);
        if (j > 0) k.board(wood, {0, y, 0}, {s.x - 0.044f, 0.022f, s.z - 0.012f});
        for (int i = 0; i < columns; ++i) {
            const float x0 = -0.5f * s.x + 0.022f + w * static_cast<float>(i);
            if (i > 0) k.board(wood, {x0, y + 0.022f, 0}, {0.022f, step - 0.022f, s.z - 0.014f});
            fill_shelf(k, x0 + (i > 0 ? 0.012f : 0.f), x0 + w - 0.012f, y + 0.022f, step - 0.022f, -0.5f * s.z + 0.012f,
                       s.z - 0.03f);
        }
    }
    k.top(s.y, 0, 0, 0.45f * s.x, 0.4f * s.z);
    k.piece.clearance_front_m = 0.5f;
    k.piece.against_wall = true;
}
void shelf(Kit& k) {
    const Vec3f s = k.wanted({0.9f, 0.f, 0.22f});
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal);
    k.board(wood, {0, 0.14f, 0.5f * s.z}, {s.x, 0.028f, s.z}, 0.005f);
    for (const float sx : {-1.f, 1.f}) {
        const float x = sx * (0.5f * s.x - 0.12f);
        k.board(metal, {x, 0.0f, 0.006f}, {0.022f, 0.142f, 0.012f});
        k.rod(metal, {x, 0.02f, 0.008f}, {x, 0.142f, s.z - 0.04f}, 0.006f, -1, 8);
    }
    fill_shelf(k, -0.5f * s.x, 0.5f * s.x, 0.168f, 0.36f, 0.01f, s.z - 0.02f);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.25f;
}
void ladder_shelf(Kit& k) {
    const int wood = k.main(k.style.wood);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(wood, {sx * 0.29f, 0, 0.24f}, {sx * 0.29f, 1.85f, -0.22f}, 0.018f, -1, 10);
        k.rod(wood, {sx * 0.29f, 0, -0.22f}, {sx * 0.29f, 1.85f, -0.225f}, 0.015f, -1, 10);
    }
    for (int i = 0; i < 4; ++i) {
        const float y = 0.3f + 0.42f * static_cast<float>(i), front = 0.24f - 0.46f * y / 1.85f, d = front + 0.23f;
        k.board(wood, {0, y, 0.5f * (front - 0.22f)}, {0.58f, 0.022f, d}, 0.004f);
        fill_shelf(k, -0.27f, 0.27f, y + 0.022f, 0.36f, -0.215f, std::max(0.12f, d - 0.02f));
    }
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.4f;
}
void toy_box(Kit& k) {
    const int wood = k.main(k.style.wood2);
    const Vec3f s{0.8f, 0.42f, 0.45f};
    carcass(k, wood, s, 0.0f);
    k.board(wood, {0, 0, 0.5f * s.z - 0.011f}, {s.x - 0.044f, s.y - 0.02f, 0.02f});
    for (int i = 0; i < 3; ++i)
        k.add(shapes::ball({-0.2f + 0.2f * static_cast<float>(i), 0.42f + 0.06f, 0.02f * static_cast<float>(i)},
                           {0.07f, 0.07f, 0.07f}, 16),
              k.material(plain("toy ball", k.accent(), 0.4f)));
    for (int i = 0; i < 4; ++i)
        k.board(k.material(plain("toy block", k.accent(), 0.5f)),
                {-0.26f + 0.17f * static_cast<float>(i), 0.14f, 0.5f * s.z}, {0.09f, 0.09f, 0.012f}, 0.004f);
    k.piece.against_wall = true;
}

constexpr Entry kTables[] = {{"coffee_table", coffee_table},
                             {"side_table", side_table},
                             {"dining_table", dining_table},
                             {"dining_table_round", dining_table_round},
                             {"console_table", console_table},
                             {"desk", desk},
                             {"nightstand", nightstand},
                             {"dresser", dresser},
                             {"wardrobe", wardrobe},
                             {"cabinet", cabinet},
                             {"sideboard", sideboard},
                             {"shoe_rack", shoe_rack},
                             {"tv", tv},
                             {"monitor", monitor},
                             {"tv_stand", tv_stand},
                             {"bookshelf", bookshelf},
                             {"shelf", shelf},
                             {"ladder_shelf", ladder_shelf},
                             {"toy_box", toy_box}};

}  // namespace

std::span<const Entry> tables() { return kTables; }

}  // namespace fastscene::furniture
