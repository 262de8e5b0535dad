// Plants, vases, pictures, textiles, instruments and the small things that make a room lived in.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture_kit.h"
#include "fastscene/rooms/furniture_motifs.h"

namespace fastscene::furniture {

Material foliage(Kit& k, Vec3f tone, float scale) {
    Material m = plain("leaf", tone * k.dice.uniform(0.85f, 1.15f), 0.45f);
    m.pattern = Pattern::leaf;
    m.color_b = tone * 1.5f + Vec3f{0.02f, 0.03f, 0.f};
    m.scale_m = scale;
    m.transmission = 0.25f;
    m.seed = k.seed();
    return m;
}

Mesh blade(Vec3f base, Vec3f out, float length, float width, float lift, float droop, float point) {
    const Vec3f side = cross(Vec3f{0, 1, 0}, out);
    Mesh m = shapes::sheet(4, 10, [&](float u, float v) {
        const float a = 2 * u - 1, w = width * std::pow(std::sin(3.1f * std::pow(v * 0.97f + 0.02f, point)), 0.9f);
        return base + out * (length * v) + Vec3f{0, length * (lift * v - droop * v * v) + 0.12f * width * a * a, 0} +
               side * (0.5f * w * a);
    });
    for (std::size_t i = 0; i < m.coords.size(); ++i) {
        const float u = static_cast<float>(i % 5) / 4.f, v = static_cast<float>(i / 5) / 10.f;
        m.coords[i] = {(u - 0.5f) * width, v * length, 0};
    }
    return m;
}

Vec3f around(float a) { return {std::cos(a), 0, std::sin(a)}; }

namespace {

float pot(Kit& k, int mat, float r, float h) {
    const std::array<Vec2f, 4> p{Vec2f{0.7f * r, 0}, {0.74f * r, 0.01f}, {r, h - 0.03f}, {r, h}};
    k.add(shapes::vessel(p, 0.012f, 32), mat);
    k.add(shapes::prism(shapes::circle(0.9f * r, 24), 0.6f * h, 0.88f * h),
          k.material(plain("soil", {0.06f, 0.042f, 0.03f}, 0.95f)));
    return 0.88f * h;
}
enum Growth { rosette, leafy_tree, swords, palm };
// Fronds that arch from the top of a slim trunk, leaflets along both sides of each.
void palm_crown(Kit& k, float y, float size, int green, int bark) {
    const Vec3f crown{0.05f * size, y + 0.5f * size, 0.02f * size};
    k.rod(bark, {0, y - 0.03f, 0}, crown, 0.032f * size, 0.024f * size, 10);
    Mesh ribs;
    for (int f = 0; f < 11; ++f) {
        const float a = 2.39996f * static_cast<float>(f), t = static_cast<float>(f) / 10.f,
                    length = size * k.dice.uniform(0.52f, 0.66f) * (1.f - 0.22f * t), lift = 0.55f + 1.1f * t,
                    droop = 1.05f + 0.1f * t;
        const Vec3f out = around(a), side = cross(Vec3f{0, 1, 0}, out);
        const auto rib = [&](float v) {
            return crown + out * (length * v) + Vec3f{0, length * (lift * v - droop * v * v), 0};
        };
        std::vector<Vec3f> path;
        for (int i = 0; i <= 8; ++i) path.push_back(rib(static_cast<float>(i) / 8.f));
        shapes::append(ribs, shapes::tube(path, 0.005f * size, 5));
        for (int i = 0; i < 12; ++i) {
            const float v = 0.2f + 0.067f * static_cast<float>(i), leaf = length * (0.36f - 0.2f * std::abs(v - 0.45f));
            for (const float way : {-1.f, 1.f})
                k.add(blade(rib(v), normalize(side * way + out * 0.75f), leaf, 0.034f * size, 0.18f, 0.55f, 0.7f),
                      green);
        }
    }
    k.add(std::move(ribs), green);
}
void plant_of(Kit& k, int kind, float size) {
    Material clay = plain("plant pot", k.dice.chance(0.4f) ? Vec3f{0.7f, 0.68f, 0.63f} : k.accent(), 0.6f);
    if (k.style.plants > 0.8f && size > 0.6f) clay = *material_named("wicker");
    const int green = k.main(foliage(k,
                                     kind == 1   ? Vec3f{0.09f, 0.19f, 0.06f}
                                     : kind == 0 ? Vec3f{0.06f, 0.16f, 0.06f}
                                                 : Vec3f{0.11f, 0.2f, 0.09f},
                                     0.2f * size)),
              clay_m = k.material(clay);
    const float y = pot(k, clay_m, 0.17f * size, 0.3f * size);
    Material bark_m = plain("bark", {0.18f, 0.12f, 0.08f}, 0.9f);
    bark_m.pattern = Pattern::bark;
    bark_m.scale_m = 0.03f;
    bark_m.color_b = {0.08f, 0.055f, 0.04f};
    const int bark = k.material(bark_m);
    if (kind == palm) return palm_crown(k, y, size, green, bark);
    if (kind == 0) {  // a rosette of arching fronds
        for (int i = 0; i < 22; ++i) {
            const float a = 2.39996f * static_cast<float>(i), t = static_cast<float>(i) / 22.f;
            k.add(blade({0, y - 0.01f, 0}, around(a), size * (0.62f - 0.25f * t), size * 0.085f, 0.7f + 1.7f * t,
                        1.1f - 0.2f * t, 0.7f),
                  green);
        }
    } else if (kind == 1) {  // a small tree with many leaves
        const Vec3f crown{0.04f * size, y + 0.75f * size, 0.02f * size};
        k.rod(bark, {0, y - 0.03f, 0}, crown, 0.022f * size, 0.014f * size, 10);
        for (int b = 0; b < 9; ++b) {
            const float a = 2.39996f * static_cast<float>(b), rise = 0.1f + 0.06f * static_cast<float>(b % 5);
            const Vec3f from = lerp(Vec3f{0, y, 0}, crown, 0.55f + 0.05f * static_cast<float>(b)),
                        to = from + around(a) * (0.3f * size) + Vec3f{0, rise * 1.3f * size, 0};
            k.rod(bark, from, to, 0.009f * size, 0.004f * size, 6);
            for (int i = 0; i < 12; ++i) {
                const float t = 0.3f + 0.06f * static_cast<float>(i), la = a + k.dice.uniform(-1.6f, 1.6f);
                k.add(blade(lerp(from, to, t), around(la), size * k.dice.uniform(0.13f, 0.2f), size * 0.085f,
                            k.dice.uniform(0.1f, 0.9f), 0.8f, 0.8f),
                      green);
            }
        }
    } else {  // upright swords
        for (int i = 0; i < 16; ++i) {
            const float a = 2.39996f * static_cast<float>(i), r = 0.02f + 0.0065f * static_cast<float>(i);
            k.add(blade(around(a) * (r * size) + Vec3f{0, y - 0.02f, 0}, around(a), size * 0.16f, size * 0.065f,
                        k.dice.uniform(3.2f, 5.6f), 0.2f, 1.4f),
                  green);
        }
    }
}
void plant(Kit& k) { plant_of(k, k.request.pattern == "palm" ? palm : k.dice.index(3), 1.05f); }
void plant_tree(Kit& k) { plant_of(k, k.request.pattern == "palm" ? palm : leafy_tree, 1.4f); }
void plant_small(Kit& k) {
    plant_of(k, k.dice.index(2) * 2, 0.3f);
    k.piece.mount = Mount::surface;
}

// Fresh flowers in something whose mouth is at y: a loose ball of blooms over leaves.
void flowers(Kit& k, int bloom, float mouth_y, std::string_view kind, float size) {
    const int stem = k.material(plain("stem", {0.07f, 0.16f, 0.05f}, 0.7f)),
              leaf = k.material(foliage(k, {0.08f, 0.19f, 0.06f}, 0.1f)),
              middle = k.material(plain(
                  "flower middle", kind == "sunflower" ? Vec3f{0.07f, 0.04f, 0.02f} : Vec3f{0.6f, 0.42f, 0.06f}, 0.9f));
    constexpr int kBlooms = 13;
    for (int i = 0; i < kBlooms; ++i) {
        const float t = (static_cast<float>(i) + 0.5f) / kBlooms, a = 2.39996f * static_cast<float>(i),
                    far = 0.088f * size * std::sqrt(t) * k.dice.uniform(0.85f, 1.15f);
        const Vec3f head = around(a) * far +
                           Vec3f{0, mouth_y + size * (0.22f - 0.1f * t + 0.03f * k.dice.uniform()), 0};
        k.rod(stem, {0.2f * head.x, 0.5f * mouth_y, 0.2f * head.z}, head, 0.0028f, -1, 5);
        k.add(blade({0.4f * head.x, mouth_y, 0.4f * head.z}, around(a + 0.9f), 0.1f * size, 0.026f * size, 1.1f, 0.7f,
                    0.8f),
              leaf);
        const Vec3f up = normalize(head - Vec3f{0, mouth_y - 0.12f * size, 0});
        const float r = size * k.dice.uniform(0.026f, 0.034f);
        if (kind == "tulip") {  // a closed cup
            const std::array<Vec2f, 5> cup{Vec2f{0.25f * r, 0},
                                           {0.85f * r, 0.5f * r},
                                           {0.95f * r, 1.2f * r},
                                           {0.7f * r, 2.f * r},
                                           {0.3f * r, 2.3f * r}};
            Mesh m = shapes::lathe(shapes::curve(cup, 2), 10, true);
            shapes::turn(m, {up.z, 0, -up.x}, 40.f * std::hypot(up.x, up.z));
            k.add(std::move(m), bloom, head);
        } else if (kind == "daisy" || kind == "sunflower") {  // petals around a middle
            const float reach = kind == "sunflower" ? 1.9f * r : 1.3f * r;
            const Vec3f side = normalize(cross(up, Vec3f{0.3f, 0.1f, 1.f})), other = cross(up, side);
            for (int p = 0; p < 12; ++p) {
                const float b = kTau * static_cast<float>(p) / 12.f;
                const Vec3f way = side * std::cos(b) + other * std::sin(b);
                k.add(shapes::rod(head + way * (0.3f * reach), head + way * reach + up * 0.002f, 0.006f * size,
                                  0.003f * size, 5),
                      bloom);
            }
            k.add(shapes::ball(head + up * 0.002f, {0.5f * reach, 0.3f * reach, 0.5f * reach}, 10), middle);
        } else {  // a full bloom: petals in two rings about a bud
            k.add(shapes::ball(head, {0.62f * r, 0.7f * r, 0.62f * r}, 10), bloom);
            for (int p = 0; p < 9; ++p) {
                const float b = kTau * static_cast<float>(p) / (p < 5 ? 5.f : 4.f), out = p < 5 ? 0.72f * r : 0.45f * r;
                k.add(shapes::ball(head + around(b) * out + Vec3f{0, p < 5 ? -0.2f * r : 0.3f * r, 0},
                                   {0.6f * r, 0.5f * r, 0.6f * r}, 8),
                      bloom);
            }
        }
    }
}
// What a flower is usually colored.
Vec3f color_of_flower(Kit& k, std::string_view kind) {
    static constexpr std::array<const char*, 5> kGarden{"crimson", "dusty pink", "lemon", "white", "lavender"};
    if (kind == "rose") return *color_named("crimson");
    if (kind == "sunflower") return {0.75f, 0.4f, 0.02f};
    if (kind == "daisy" || kind == "lily") return *color_named("white");
    if (kind == "peony") return *color_named("pink");
    if (kind == "hydrangea") return *color_named("light blue");
    return *color_named(kGarden[static_cast<std::size_t>(k.dice.index(5))]);
}
void bouquet(Kit& k) {
    const std::string_view kind = k.request.pattern;
    const int bloom = k.main(plain("petals", color_of_flower(k, kind), 0.6f));
    Material pot = k.dice.chance(0.5f) ? plain("glazed vase", {0.7f, 0.68f, 0.63f}, 0.2f)
                                       : plain("glazed vase", k.accent(), 0.25f);
    if (const auto asked = material_named(k.request.holder_material)) pot = *asked;
    if (const auto asked = color_named(k.request.holder_color)) pot = tinted(pot, *asked);
    const std::array<Vec2f, 6> p{Vec2f{0.045f, 0}, {0.06f, 0.03f},  {0.066f, 0.09f},
                                 {0.055f, 0.15f},  {0.045f, 0.19f}, {0.055f, 0.215f}};
    k.add(shapes::vessel(shapes::curve(p, 3), 0.004f, 28), k.material(pot));
    flowers(k, bloom, 0.21f, kind, 1.05f);
    k.piece.mount = Mount::surface;
}

void vase_of(Kit& k, float size, bool stems) {
    const int body = k.main(plain("glazed vase", k.accent(), 0.25f));
    const int kind = k.dice.index(3);
    const std::array<std::array<Vec2f, 7>, 3> profiles{{{Vec2f{0.05f, 0},
                                                         {0.08f, 0.04f},
                                                         {0.1f, 0.12f},
                                                         {0.08f, 0.2f},
                                                         {0.04f, 0.25f},
                                                         {0.035f, 0.28f},
                                                         {0.045f, 0.3f}},
                                                        {Vec2f{0.045f, 0},
                                                         {0.055f, 0.02f},
                                                         {0.06f, 0.1f},
                                                         {0.065f, 0.18f},
                                                         {0.07f, 0.24f},
                                                         {0.065f, 0.27f},
                                                         {0.06f, 0.28f}},
                                                        {Vec2f{0.06f, 0},
                                                         {0.1f, 0.03f},
                                                         {0.12f, 0.09f},
                                                         {0.1f, 0.15f},
                                                         {0.05f, 0.18f},
                                                         {0.03f, 0.22f},
                                                         {0.04f, 0.24f}}}};
    std::array<Vec2f, 7> p = profiles[static_cast<std::size_t>(kind)];
    for (Vec2f& q : p) q = q * size;
    k.add(shapes::vessel(shapes::curve(p, stems ? 3 : 2), 0.004f, stems ? 28 : 18), body);
    k.piece.mount = Mount::surface;
    if (!stems) return;
    // Dried stems, or fresh flowers where people like them.
    const bool fresh = !is_one_of(k.style.name, {"japandi", "industrial", "modern"}) && k.dice.chance(0.45f);
    if (fresh)
        return flowers(k, k.material(plain("petals", color_of_flower(k, ""), 0.6f)), p.back().y,
                       k.dice.chance(0.4f) ? "tulip" : "", 0.95f * size);
    const int stalk = k.material(plain("dried stem", {0.3f, 0.22f, 0.12f}, 0.9f)),
              plume = k.material(plain("pampas", lerp(k.accent(), {0.6f, 0.5f, 0.36f}, 0.65f), 0.95f));
    for (int i = 0; i < 7; ++i) {
        const float a = 2.39996f * static_cast<float>(i), lean = k.dice.uniform(0.05f, 0.16f) * size,
                    h = k.dice.uniform(0.55f, 0.75f) * size;
        const Vec3f tip = around(a) * lean + Vec3f{0, h, 0};
        k.rod(stalk, {0, 0.1f * size, 0}, tip, 0.002f, -1, 5);
        Mesh m = shapes::ball({0, 0, 0}, {0.016f * size, 0.075f * size, 0.016f * size}, 10);
        shapes::turn(m, {std::sin(a), 0, -std::cos(a)}, 18);
        k.add(std::move(m), plume, tip);
    }
}
void vase(Kit& k) { vase_of(k, 1.f, true); }
void vase_small(Kit& k) { vase_of(k, 0.7f, false); }

void picture(Kit& k) {
    const bool wide = k.dice.chance(0.4f);
    const Vec3f s = k.wanted(wide ? Vec3f{0.9f, 0.62f, 0.025f} : Vec3f{0.55f, 0.75f, 0.025f});
    const int pick = k.dice.index(3);
    const int frame = k.material(pick == 0   ? k.style.metal
                                 : pick == 1 ? k.style.wood
                                             : k.style.wood2),
              mat_board = k.material(plain("passe-partout", {0.76f, 0.75f, 0.71f}, 0.9f));
    const float f = k.style.mouldings == Mouldings::rich ? 0.04f : 0.02f, pass = 0.09f * std::min(s.x, s.y);
    const float w = s.x - 2 * f - 2 * pass, h = s.y - 2 * f - 2 * pass;
    Material m = plain("art", k.style.palette[0], 0.6f);
    m.pattern = Pattern::art;
    const auto i = static_cast<std::size_t>(k.dice.index(6));
    m.color_a = k.style.palette[i % 6];
    m.color_b = k.style.palette[(i + 1) % 6];
    m.color_c = k.style.palette[(i + 2) % 6];
    m.scale_m = w;
    m.seed = k.seed();
    const bool motif = is_motif(k.request.pattern);
    if (motif) draw_motif(k, k.request.pattern, {0, 0.5f * s.y, 0.0145f}, w, h);
    const int art = motif ? -1 : k.main(m);
    for (const float sg : {-1.f, 1.f}) {
        k.board(frame, {sg * 0.5f * (s.x - f), 0, 0.0125f}, {f, s.y, 0.025f}, 0.003f);
        k.board(frame, {0, sg > 0 ? s.y - f : 0.f, 0.0125f}, {s.x - 2 * f, f, 0.025f}, 0.003f);
    }
    k.board(mat_board, {0, f, 0.007f}, {s.x - 2 * f, s.y - 2 * f, 0.012f}, 0.001f);
    Mesh canvas = shapes::box({w, h, 0.003f}, 0.0006f);
    canvas.coords = canvas.positions;
    for (Vec3f& c : canvas.coords) c = {c.x + 0.5f * w, 0.5f * h - c.y, c.z};  // from the picture's upper left corner
    if (!motif) k.add(std::move(canvas), art, {0, 0.5f * s.y, 0.0135f});
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.35f;
}
// A hide: the outline of what wore it, with its own color; a cow's has blots.
void hide_rug(Kit& k) {
    const bool cow = k.request.pattern == "cowhide";
    const Vec3f s = k.wanted(cow ? Vec3f{2.f, 0.01f, 1.75f} : Vec3f{1.5f, 0.02f, 1.05f});
    Material m = *material_named("carpet");
    m.name = cow ? "cowhide" : "fur";
    m.color_a = cow ? Vec3f{0.7f, 0.66f, 0.58f} : Vec3f{0.66f, 0.6f, 0.5f};
    m.color_b = m.color_a * 0.7f;
    m.bump_m = cow ? 0.002f : 0.01f;
    const auto color = k.request.color_name.empty() ? std::nullopt : color_named(k.request.color_name);
    if (color && !cow) m.color_a = *color, m.color_b = *color * 0.6f;
    if (cow) {
        m.pattern = Pattern::camouflage, m.scale_m = 0.75f, m.seed = k.seed();
        m.color_b = color.value_or(k.dice.chance(0.5f) ? Vec3f{0.19f, 0.085f, 0.04f} : Vec3f{0.035f, 0.03f, 0.027f}),
        m.color_c = m.color_a;
    }
    const int fur = k.piece.main_material = k.material(m);
    // Half of it, from the neck (z < 0) to the tail: the rest is its mirror image.
    static constexpr std::array<Vec2f, 13> kHalf{{{0.f, -0.5f},
                                                  {0.13f, -0.49f},
                                                  {0.2f, -0.4f},
                                                  {0.36f, -0.43f},
                                                  {0.5f, -0.38f},
                                                  {0.47f, -0.29f},
                                                  {0.36f, -0.2f},
                                                  {0.335f, 0.f},
                                                  {0.37f, 0.18f},
                                                  {0.5f, 0.29f},
                                                  {0.47f, 0.4f},
                                                  {0.27f, 0.4f},
                                                  {0.f, 0.5f}}};
    std::vector<Vec2f> ring;
    for (const Vec2f& p : kHalf) ring.push_back({p.x, p.y});
    for (std::size_t i = kHalf.size() - 1; i-- > 1;) ring.push_back({-kHalf[i].x, kHalf[i].y});
    std::vector<Vec2f> closed{ring.back()};
    closed.insert(closed.end(), ring.begin(), ring.end());
    closed.push_back(ring[0]), closed.push_back(ring[1]);
    const std::uint32_t seed = k.seed();
    std::vector<Vec2f> outline;
    const std::vector<Vec2f> smooth = shapes::curve(closed, 6);
    for (std::size_t i = 6; i + 12 < smooth.size() + 5; ++i) outline.push_back(smooth[i]);
    // The long side of the rug's box is its spine.
    const auto place = [&](Vec2f p, float x, float z) {
        const float n = 1.f + 0.025f * shapes::wobble({7 * p.x, 7 * p.y, 0}, seed);
        return Vec2f{x * p.y * n, z * p.x * n};
    };
    std::vector<Vec2f> rim;
    for (const Vec2f& p : outline) rim.push_back(place(p, s.x, s.z));
    Mesh hide = shapes::prism(rim, 0.f, s.y, 0.002f);
    for (std::size_t i = 0; i < hide.coords.size(); ++i) hide.coords[i] = {hide.positions[i].x, hide.positions[i].z, 0};
    k.add(std::move(hide), fur);
}
void rug(Kit& k) {
    if (k.request.pattern == "cowhide" || k.request.pattern == "hide") return hide_rug(k);
    const Vec3f s = k.wanted({2.3f, 0.012f, 1.6f});
    Material m = k.style.rug;
    // The seed picks what is woven: lozenges, medallions, bands of zigzag (see Pattern::rug). Formal rooms have
    // medallions, northern ones zigzag; the fourth, large blots, looks like a hide and is left out.
    static constexpr std::array<std::uint32_t, 12> kWoven{8, 9, 19, 20, 4, 6, 7, 11, 2, 3, 5, 10};
    const int first = k.style.mouldings == Mouldings::rich ? 4
                      : k.style.name == "scandinavian"     ? 8
                                                           : 0,
              range = first == 0 ? 12 : 4;
    m.seed = kWoven[static_cast<std::size_t>(first + static_cast<int>(k.seed() % static_cast<std::uint32_t>(range)))];
    // Round as asked, or where nothing else is, in some rooms that like it.
    const bool round = k.request.pattern == "round" ||
                       (!k.request.size_m.x &&
                        (k.style.name == "boho" || k.style.name == "scandinavian" || k.style.name == "art deco") &&
                        k.dice.chance(0.4f));
    const float d = std::min(s.x, s.z) * (k.request.size_m.x ? 1.f : 1.15f);
    m.scale_m = m.pattern == Pattern::rug ? 0.5f * (round ? d : s.x) : m.scale_m;
    // Who asks for wool or a fluffy rug means deep pile of one color.
    if (k.request.material == "wool" && (k.request.pattern.empty() || round)) {
        m = *material_named("carpet");
        m.name = "deep pile";
        m.color_a = *color_named("ivory");
        m.color_b = *color_named("linen");
        m.bump_m = 0.008f;
        if (k.request.color) m = tinted(m, *k.request.color);
        else if (const auto color = color_named(k.request.color_name); color && !k.request.color_name.empty())
            m = tinted(m, *color);
    }
    const bool plain_pile = m.name == "deep pile";
    const int pile = plain_pile ? k.piece.main_material = k.material(m) : k.main(m);
    Mesh r = round ? shapes::prism(shapes::circle(0.5f * d, 48), 0.f, 0.012f, 0.004f)
                   : shapes::prism(shapes::rounded_rectangle(s.x, s.z, 0.03f, 3), 0.f, 0.012f, 0.004f);
    // Metres from the rug's middle; y carries half its depth (negative: it is round), which the border follows.
    for (std::size_t i = 0; i < r.coords.size(); ++i)
        r.coords[i] = {r.positions[i].x, round ? -0.5f * d : 0.5f * s.z, r.positions[i].z};
    k.add(std::move(r), pile);
    if (!round && !plain_pile && (k.style.lamp == LampFamily::paper || k.style.mouldings == Mouldings::rich)) {
        Mesh fringe;
        const int count = static_cast<int>(s.z / 0.035f);
        for (int i = 0; i < count; ++i)
            for (const float sx : {-1.f, 1.f}) {
                const float z = (static_cast<float>(i) + 0.5f) / static_cast<float>(count) * s.z - 0.5f * s.z;
                Mesh f = shapes::box({0.06f, 0.004f, 0.008f}, 0.001f);
                shapes::append(fringe, shapes::move(f, {sx * (0.5f * s.x + 0.025f), 0.002f, z}));
            }
        k.add(std::move(fringe), k.material(plain("fringe", {0.66f, 0.6f, 0.48f}, 0.95f)));
    }
}
void curtain(Kit& k) {
    // size.x: the rod's width; size.y: from the floor to the rod.
    const Vec3f s = k.wanted({2.0f, 2.4f, 0.12f});
    const int cloth = k.main(k.style.curtain), metal = k.material(k.style.metal);
    // Deeply dyed cloth lets less through than a white veil: in the sun red would glow pink.
    constexpr float kVeil = 0.5f, kLeast = 0.15f;  // luminance of a veil's albedo; share that the darkest dye leaves
    Material& dyed = k.piece.materials[static_cast<std::size_t>(cloth)];
    dyed.transmission *= std::clamp(luminance(dyed.color_a) / kVeil, kLeast, 1.f);
    const float w = std::min(0.3f * s.x, 0.62f), h = s.y - 0.03f;
    for (const float sx : {-1.f, 1.f}) {
        const std::uint32_t seed = k.seed();
        const float folds = std::round(w / 0.085f);
        k.add(shapes::sheet(96, 18,
                            [=](float u, float v) {
                                const float drape = 1.f - v,
                                            wave = std::sin(kTau * folds * u +
                                                            0.9f * shapes::wobble({u * 4.f, v * 1.5f, 1.f}, seed));
                                const float spread = 0.92f + 0.08f * drape;
                                return Vec3f{sx * (0.5f * s.x - 0.02f) - sx * w * (sx > 0 ? 1.f - u : u) * spread,
                                             h * v + 0.006f,
                                             0.06f + (0.026f + 0.016f * drape) * wave +
                                                 0.006f * shapes::wobble({u * 9.f, v * 3.f, 4.f}, seed)};
                            }),
              cloth);
    }
    k.rod(metal, {-0.5f * s.x, s.y - 0.015f, 0.06f}, {0.5f * s.x, s.y - 0.015f, 0.06f}, 0.012f, -1, 16);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(metal, {sx * (0.5f * s.x - 0.06f), s.y - 0.015f, 0.f}, {sx * (0.5f * s.x - 0.06f), s.y - 0.015f, 0.06f},
              0.008f);
        k.add(shapes::ball({sx * (0.5f * s.x - 0.004f), s.y - 0.022f, 0.06f}, {0.022f, 0.022f, 0.022f}, 14), metal);
    }
    k.piece.mount = Mount::wall;
}
void basket(Kit& k) {
    const int straw = k.main(*material_named("wicker"));
    const std::array<Vec2f, 5> p{Vec2f{0.15f, 0}, {0.17f, 0.02f}, {0.2f, 0.15f}, {0.19f, 0.28f}, {0.185f, 0.3f}};
    k.add(shapes::vessel(p, 0.012f, 32), straw);
    k.add(shapes::ring(0.185f, 0.02f, 32), straw, {0, 0.3f, 0});
    k.soft(k.material(tinted(k.style.fabric2, k.accent())), {0, 0.1f, 0}, {0.24f, 0.24f, 0.24f},
           {0.09f, 0.03f, 0.02f, 12});
}
void book_stack(Kit& k) {
    const int count = 2 + k.dice.index(3);
    float y = 0.f;
    const int paper = k.material(plain("paper", {0.72f, 0.68f, 0.58f}, 0.9f));
    for (int i = 0; i < count; ++i) {
        const float t = k.dice.uniform(0.018f, 0.038f), w = 0.24f - 0.018f * static_cast<float>(i),
                    d = 0.17f - 0.012f * static_cast<float>(i), yaw = k.dice.uniform(-14, 14);
        Material c = plain("book cover", k.accent(), 0.5f);
        const int cover = i == 0 ? k.main(c) : k.material(c);
        const auto put = [&](Vec3f size, Vec3f at, int mat) {
            Mesh m = shapes::box(size, 0.001f);
            shapes::turn(shapes::move(m, at), {0, 1, 0}, yaw);
            k.add(std::move(m), mat, {0, y, 0});
        };
        put({w, 0.003f, d}, {0, 0.0015f, 0}, cover);
        put({w, 0.003f, d}, {0, t - 0.0015f, 0}, cover);
        put({w, t, 0.004f}, {0, 0.5f * t, -0.5f * d}, cover);
        put({w - 0.012f, t - 0.005f, d - 0.01f}, {0, 0.5f * t, -0.002f}, paper);
        y += t + 0.0005f;
    }
    k.piece.mount = Mount::surface;
}
void bowl(Kit& k) {
    const int body = k.main(plain("bowl", k.accent(), 0.3f));
    const std::array<Vec2f, 6> p{Vec2f{0.05f, 0}, {0.055f, 0.008f}, {0.09f, 0.025f},
                                 {0.12f, 0.055f}, {0.13f, 0.08f},   {0.131f, 0.085f}};
    k.add(shapes::vessel(p, 0.005f, 32), body);
    const Vec3f fruit[] = {{0.5f, 0.08f, 0.04f}, {0.65f, 0.3f, 0.05f}, {0.35f, 0.42f, 0.08f}};
    for (int i = 0; i < 5; ++i) {
        const float a = 1.2566f * static_cast<float>(i);
        k.add(shapes::ball(i == 4 ? Vec3f{0, 0.085f, 0} : around(a) * 0.05f + Vec3f{0, 0.055f, 0},
                           {0.034f, 0.032f, 0.034f}, 14),
              k.material(plain("fruit", fruit[i % 3], 0.35f)));
    }
    k.piece.mount = Mount::surface;
}
// A wick and the flame on it, `height` tall: dark orange at the root, yellow in its belly, orange at the point.
class Wick {
  public:
    explicit Wick(Kit& k)
        : k_(k),
          root_(k.material(flame("flame root", {5.f, 1.3f, 0.22f}))),
          belly_(k.material(flame("flame", {17.f, 7.6f, 1.1f}))),
          point_(k.material(flame("flame point", {11.f, 2.9f, 0.16f}))),
          thread_(k.material(plain("wick", {0.03f, 0.027f, 0.025f}, 0.9f))) {}
    void burn(Vec3f at, float height) {
        const float r = 0.2f * height;
        k_.rod(thread_, at, at + Vec3f{0, 0.22f * height, 0}, 0.0012f, -1, 5);
        const auto part = [&](std::initializer_list<Vec2f> profile, int material) {
            const std::vector<Vec2f> p(profile);
            k_.add(shapes::lathe(shapes::curve(p, 2), 12, true), material, at + Vec3f{0, 0.12f * height, 0});
        };
        part({{0.f, 0.f}, {0.55f * r, 0.06f * height}, {0.88f * r, 0.16f * height}}, root_);
        part({{0.88f * r, 0.16f * height}, {r, 0.3f * height}, {0.86f * r, 0.5f * height}, {0.62f * r, 0.64f * height}},
             belly_);
        part({{0.62f * r, 0.64f * height}, {0.3f * r, 0.84f * height}, {0.f, height}}, point_);
    }

  private:
    Kit& k_;
    int root_, belly_, point_, thread_;
};

// One for narrow places: a bathtub's rim.
void single_candle(Kit& k) {
    k.sized = true;
    const int wax = k.main(plain("wax", {0.75f, 0.7f, 0.6f}, 0.6f));
    k.add(shapes::prism(shapes::circle(0.028f, 24), 0.f, 0.006f), k.material(k.style.metal));
    const float high = k.dice.uniform(0.07f, 0.12f);
    k.rod(wax, {0, 0.005f, 0}, {0, high, 0}, 0.022f, -1, 20);
    Wick(k).burn({0, high - 0.001f, 0}, 0.034f);
    k.piece.mount = Mount::surface;
}
void candle(Kit& k) {
    if (k.request.size_m.x > 0 && k.request.size_m.x < 0.12f) return single_candle(k);
    const int wax = k.main(plain("wax", {0.75f, 0.7f, 0.6f}, 0.6f)), metal = k.material(k.style.metal);
    Wick wick(k);
    const float xs[] = {-0.07f, 0.f, 0.06f}, hs[] = {0.11f, 0.17f, 0.08f}, zs[] = {0.02f, -0.02f, 0.04f};
    k.add(shapes::prism(shapes::rounded_rectangle(0.26f, 0.14f, 0.05f), 0.f, 0.012f), metal);
    for (std::size_t i = 0; i < 3; ++i) {
        k.rod(wax, {xs[i], 0.011f, zs[i]}, {xs[i], hs[i], zs[i]}, 0.026f, -1, 20);
        wick.burn({xs[i], hs[i] - 0.001f, zs[i]}, 0.036f);
    }
    k.piece.mount = Mount::surface;
}
// Five arms on a turned foot, a candle on each.
void candelabrum(Kit& k) {
    const int metal = k.main(k.style.metal.metal > 0.5f ? k.style.metal : *material_named("brass")),
              wax = k.material(plain("wax", {0.75f, 0.71f, 0.62f}, 0.6f));
    const std::array<Vec2f, 12> p{Vec2f{0.075f, 0}, {0.078f, 0.01f}, {0.05f, 0.022f}, {0.016f, 0.04f},
                                  {0.024f, 0.06f},  {0.012f, 0.08f}, {0.011f, 0.15f}, {0.02f, 0.168f},
                                  {0.011f, 0.186f}, {0.014f, 0.25f}, {0.008f, 0.27f}, {0.008f, 0.3f}};
    k.add(shapes::lathe(p, 24, true), metal);
    Wick wick(k);
    const auto light = [&](Vec3f at) {
        const std::array<Vec2f, 6> cup{Vec2f{0.006f, -0.012f}, {0.014f, -0.004f}, {0.03f, 0.004f},
                                       {0.031f, 0.008f},       {0.015f, 0.01f},   {0.013f, 0.024f}};
        k.add(shapes::lathe(cup, 20), metal, at);
        const float high = k.dice.uniform(0.09f, 0.115f);
        k.rod(wax, at + Vec3f{0, 0.012f, 0}, at + Vec3f{0, high, 0}, 0.0105f, 0.0095f, 14);
        wick.burn(at + Vec3f{0, high - 0.001f, 0}, 0.03f);
    };
    light({0, 0.3f, 0});
    for (int i = 0; i < 4; ++i) {
        const Vec3f out = i % 2 == 0 ? Vec3f{i == 0 ? 1.f : -1.f, 0, 0.18f} : Vec3f{i == 1 ? 1.f : -1.f, 0, -0.18f};
        const float far = i % 2 == 0 ? 0.15f : 0.085f, rise = i % 2 == 0 ? 0.255f : 0.285f;
        std::vector<Vec3f> arm;
        for (int j = 0; j <= 14; ++j) {
            const float t = static_cast<float>(j) / 14.f;
            arm.push_back(
                out * (far * (0.06f + 0.94f * std::sin(0.5f * kPi * t))) +
                Vec3f{0, 0.18f - 0.05f * std::sin(kPi * std::min(1.f, 1.5f * t)) + (rise - 0.18f) * t * t, 0});
        }
        k.add(shapes::tube(arm, 0.006f, 8), metal);
        light(arm.back());
    }
    k.piece.mount = Mount::surface;
}
void clock_piece(Kit& k) {
    const int rim = k.main(k.style.metal), face = k.material(plain("dial", {0.76f, 0.74f, 0.69f}, 0.6f)),
              dark = k.material(plain("clock hands", {0.035f, 0.035f, 0.035f}, 0.5f));
    const auto flat = [&](Mesh m, int mat, Vec3f at) { k.add(std::move(shapes::turn(m, {1, 0, 0}, 90)), mat, at); };
    flat(shapes::prism(shapes::circle(0.18f, 48), 0.f, 0.02f), face, {0, 0.2f, 0});
    flat(shapes::ring(0.185f, 0.03f, 48), rim, {0, 0.2f, 0.015f});
    for (int i = 0; i < 12; ++i) {
        const float a = kTau * static_cast<float>(i) / 12.f;
        Mesh m = shapes::box({0.006f, i % 3 == 0 ? 0.03f : 0.016f, 0.002f}, 0.0005f);
        shapes::move(m, {0, 0.15f, 0.021f});
        k.add(shapes::turn(m, {0, 0, 1}, a * 57.29578f), dark, {0, 0.2f, 0});
    }
    for (int i = 0; i < 2; ++i) {
        Mesh m = shapes::box({0.008f, i == 0 ? 0.1f : 0.14f, 0.002f}, 0.0005f);
        shapes::move(m, {0, i == 0 ? 0.04f : 0.06f, 0.023f + 0.002f * static_cast<float>(i)});
        k.add(shapes::turn(m, {0, 0, 1}, k.dice.uniform(0, 360)), dark, {0, 0.2f, 0});
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.7f;
}
void piano(Kit& k) {
    const int body = k.main(plain("piano lacquer", {0.032f, 0.032f, 0.033f}, 0.1f)),
              ivory = k.material(plain("ivory keys", {0.75f, 0.73f, 0.66f}, 0.3f)),
              black = k.material(plain("black keys", {0.032f, 0.032f, 0.033f}, 0.3f)),
              gold = k.material(*material_named("brass"));
    k.board(body, {0, 0.0f, -0.12f}, {1.48f, 1.22f, 0.32f}, 0.008f);
    k.board(body, {0, 1.22f, -0.1f}, {1.52f, 0.03f, 0.38f}, 0.008f);
    k.board(body, {0, 0.6f, 0.16f}, {1.48f, 0.07f, 0.3f}, 0.008f);
    for (const float sx : {-1.f, 1.f}) {
        k.board(body, {sx * 0.72f, 0.0f, 0.27f}, {0.06f, 0.62f, 0.06f}, 0.01f);
        k.board(body, {sx * 0.71f, 0.66f, 0.16f}, {0.07f, 0.1f, 0.3f}, 0.012f);
    }
    for (int i = 0; i < 52; ++i) {
        const float x = -0.6248f + 0.0245f * static_cast<float>(i);
        k.board(ivory, {x, 0.67f, 0.21f}, {0.0232f, 0.018f, 0.16f}, 0.002f);
        const int note = i % 7;
        if (i < 51 && note != 2 && note != 6)
            k.board(black, {x + 0.0122f, 0.685f, 0.18f}, {0.012f, 0.014f, 0.1f}, 0.002f);
    }
    Mesh desk_board = shapes::box({0.9f, 0.26f, 0.015f}, 0.004f);
    shapes::turn(desk_board, {1, 0, 0}, -12);
    k.add(std::move(desk_board), body, {0, 0.98f, 0.085f});
    Mesh sheet_music = shapes::box({0.4f, 0.28f, 0.002f}, 0.0005f);
    shapes::turn(sheet_music, {1, 0, 0}, -12);
    k.add(std::move(sheet_music), ivory, {0, 0.985f, 0.098f});
    for (int i = -1; i <= 1; ++i)
        k.board(gold, {0.08f * static_cast<float>(i), 0.05f, 0.07f}, {0.03f, 0.015f, 0.1f}, 0.005f);
    k.top(1.25f, 0, -0.1f, 0.7f, 0.15f);
    k.piece.clearance_front_m = 0.9f;
    k.piece.against_wall = true;
}
void guitar(Kit& k) {
    Material spruce = *material_named("pine");
    spruce.roughness = 0.25f;
    const int body = k.main(spruce), dark = k.material(*material_named("mahogany")),
              black = k.material(plain("ebony", {0.033f, 0.031f, 0.03f}, 0.4f)), chrome = k.material(steel());
    Piece inner;  // the instrument stands upright in a small stand, leaning back
    std::vector<Vec2f> o;
    for (int i = 0; i < 64; ++i) {
        const float a = kTau * static_cast<float>(i) / 64.f, y = std::sin(a);
        const float r = 0.165f - 0.022f * y - 0.05f * std::exp(-18.f * (y - 0.25f) * (y - 0.25f));
        o.push_back({r * std::cos(a) * (1.f + 0.18f * (1.f - y * y)), -0.24f * y});
    }
    const auto upright = [&](Mesh m, int mat, Vec3f at) {
        shapes::turn(m, {1, 0, 0}, 90);
        shapes::move(m, at);
        shapes::turn(m, {1, 0, 0}, -14);
        k.add(std::move(m), mat, {0, 0.14f, 0.08f});
    };
    upright(shapes::prism(o, 0.f, 0.09f, 0.006f), dark, {0, 0.24f, -0.045f});
    for (Vec2f& p : o) p = p * 0.985f;
    upright(shapes::prism(o, 0.f, 0.004f, 0.001f), body, {0, 0.24f, 0.044f});
    upright(shapes::prism(shapes::circle(0.05f, 32), 0.f, 0.001f, 0.0002f), black, {0, 0.3f, 0.0482f});
    const auto piece_at = [&](Vec3f size, Vec3f at, int mat) {
        Mesh m = shapes::box(size, 0.003f);
        shapes::move(m, at);
        shapes::turn(m, {1, 0, 0}, -14);
        k.add(std::move(m), mat, {0, 0.14f, 0.08f});
    };
    piece_at({0.054f, 0.52f, 0.02f}, {0, 0.64f, 0.045f}, dark);
    piece_at({0.05f, 0.58f, 0.006f}, {0, 0.61f, 0.057f}, black);
    piece_at({0.075f, 0.16f, 0.016f}, {0, 0.97f, 0.04f}, dark);
    piece_at({0.15f, 0.025f, 0.012f}, {0, 0.13f, 0.052f}, black);
    for (int i = 0; i < 6; ++i) {
        const float x = -0.02f + 0.008f * static_cast<float>(i);
        Mesh s = shapes::rod({x, 0.13f, 0.062f}, {x, 0.92f, 0.062f}, 0.0007f, 0.0007f, 4);
        shapes::turn(s, {1, 0, 0}, -14);
        k.add(std::move(s), chrome, {0, 0.14f, 0.08f});
        piece_at({0.02f, 0.012f, 0.012f},
                 {(i % 2 ? 1.f : -1.f) * 0.046f, 0.92f + 0.04f * static_cast<float>(i / 2), 0.04f}, chrome);
    }
    for (const float sx : {-1.f, 1.f}) {
        k.rod(black, {sx * 0.16f, 0.f, 0.2f}, {sx * 0.07f, 0.14f, 0.0f}, 0.008f);
        k.rod(black, {sx * 0.08f, 0.14f, 0.f}, {sx * 0.08f, 0.14f, 0.16f}, 0.009f);
    }
    k.rod(black, {0, 0, -0.2f}, {0, 0.4f, -0.06f}, 0.008f);
    k.rod(black, {-0.08f, 0.14f, 0}, {0.08f, 0.14f, 0}, 0.008f);
    k.rod(black, {0, 0.14f, 0}, {0, 0.4f, -0.06f}, 0.008f);
}
void aquarium(Kit& k) {
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal),
              sand = k.material(plain("sand", {0.5f, 0.42f, 0.28f}, 0.95f));
    Material water = glass();
    water.color_a = water.color_b = {0.55f, 0.75f, 0.78f};
    const int tank = k.material(water), light = k.material(glow("aquarium light", {4.f, 5.5f, 6.5f})),
              green = k.material(foliage(k, {0.08f, 0.22f, 0.08f}, 0.1f));
    k.board(wood, {0, 0, 0}, {1.0f, 0.72f, 0.42f}, 0.005f);
    fronts(k, wood, metal, -0.49f, 0.49f, 0.02f, 0.7f, 0.21f, 2, 1);
    k.board(tank, {0, 0.73f, 0}, {0.96f, 0.5f, 0.38f}, 0.003f);
    k.board(sand, {0, 0.735f, 0}, {0.94f, 0.05f, 0.36f}, 0.01f);
    k.board(wood, {0, 1.23f, 0}, {1.0f, 0.06f, 0.42f}, 0.006f);
    k.board(light, {0, 1.21f, 0}, {0.8f, 0.012f, 0.1f}, 0.002f);
    for (int i = 0; i < 14; ++i)
        k.add(blade({k.dice.uniform(-0.4f, 0.4f), 0.78f, k.dice.uniform(-0.12f, 0.12f)},
                    around(k.dice.uniform(0, kTau)), 0.08f, 0.02f, k.dice.uniform(2.f, 4.f), 0.3f, 1.1f),
              green);
    for (int i = 0; i < 6; ++i)
        k.add(shapes::ball({k.dice.uniform(-0.36f, 0.36f), k.dice.uniform(0.86f, 1.12f), k.dice.uniform(-0.1f, 0.12f)},
                           {0.035f, 0.016f, 0.008f}, 12),
              k.material(plain("fish", i % 2 ? Vec3f{0.7f, 0.25f, 0.04f} : k.accent(), 0.3f)));
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.6f;
}
void rocking_horse(Kit& k) {
    const int wood = k.main(k.style.wood2), hair = k.material(plain("mane", {0.25f, 0.15f, 0.08f}, 0.9f)),
              saddle = k.material(tinted(k.style.leather, k.accent()));
    for (const float sz : {-1.f, 1.f}) {
        std::vector<Vec3f> rocker;
        for (int i = 0; i <= 16; ++i) {
            const float t = static_cast<float>(i) / 8.f - 1.f;
            rocker.push_back({0.48f * t, 0.018f + 0.13f * t * t, sz * 0.14f});
        }
        k.add(shapes::tube(rocker, 0.018f, 10), wood);
        for (const float sx : {-1.f, 1.f})
            k.rod(wood, {sx * 0.26f, 0.05f, sz * 0.14f}, {sx * 0.18f, 0.42f, sz * 0.07f}, 0.02f, 0.03f);
    }
    k.add(shapes::ball({0, 0.46f, 0}, {0.3f, 0.13f, 0.12f}, 24), wood);
    k.rod(wood, {0.2f, 0.48f, 0}, {0.36f, 0.76f, 0}, 0.085f, 0.055f, 18);
    k.rod(wood, {0.33f, 0.76f, 0}, {0.5f, 0.66f, 0}, 0.065f, 0.04f, 18);
    for (const float sz : {-1.f, 1.f})
        k.rod(wood, {0.33f, 0.8f, sz * 0.035f}, {0.32f, 0.86f, sz * 0.04f}, 0.018f, 0.006f, 8);
    for (int i = 0; i < 6; ++i)
        k.add(shapes::ball({0.17f + 0.028f * static_cast<float>(i), 0.57f + 0.045f * static_cast<float>(i), 0},
                           {0.04f, 0.05f, 0.03f}, 10),
              hair);
    k.rod(hair, {-0.28f, 0.5f, 0}, {-0.4f, 0.28f, 0}, 0.035f, 0.015f);
    k.add(shapes::ball({-0.02f, 0.56f, 0}, {0.13f, 0.06f, 0.11f}, 18), saddle);
    k.rod(wood, {0.33f, 0.72f, -0.13f}, {0.33f, 0.72f, 0.13f}, 0.012f);
    k.piece.clearance_front_m = 0.2f;
}
void coat_rack(Kit& k) {
    const int wood = k.main(k.style.wood);
    const std::array<Vec2f, 4> foot{Vec2f{0.17f, 0}, {0.17f, 0.02f}, {0.04f, 0.045f}, {0.025f, 0.07f}};
    k.add(shapes::lathe(foot, 32), wood);
    k.rod(wood, {0, 0.04f, 0}, {0, 1.75f, 0}, 0.02f, 0.016f);
    for (int i = 0; i < 6; ++i)
        k.rod(wood, {0, 1.5f + 0.03f * static_cast<float>(i), 0},
              around(1.0472f * static_cast<float>(i)) * 0.19f + Vec3f{0, 1.62f + 0.03f * static_cast<float>(i), 0},
              0.01f, 0.012f);
    const int coat = k.material(tinted(k.style.fabric2, k.accent()));
    const std::uint32_t seed = k.seed();
    k.add(shapes::slab(32, 16, 0.02f,
                       [=](float u, float v) {
                           const float a = (u - 0.5f) * 4.4f, h = 1.6f - 0.95f * (1.f - v),
                                       r = (0.05f + 0.13f * std::sqrt(1.f - v)) *
                                           (1.f + 0.12f * std::sin(a * 7.f) * (1.f - v) +
                                            0.08f * shapes::wobble({a * 2, v * 4, 0}, seed));
                           return Vec3f{0.1f - r * std::sin(a) * 0.9f, h, 0.06f + r * std::cos(a)};
                       }),
          coat);
}
void cat(Kit& k) {
    if (k.request.pattern == kAsleep) return cat_asleep(k);
    const Vec3f coats[] = {{0.35f, 0.18f, 0.07f}, {0.06f, 0.055f, 0.05f}, {0.5f, 0.48f, 0.44f}};
    Material m = plain("fur", coats[k.dice.index(3)], 0.95f);
    m.pattern = Pattern::carpet;
    m.color_b = m.color_a * 0.6f;
    const int fur = k.main(m), eye = k.material(plain("eye", {0.3f, 0.4f, 0.08f}, 0.1f));
    // It sits upright and looks to the front.
    k.add(shapes::ball({0, 0.13f, -0.03f}, {0.085f, 0.13f, 0.11f}, 24), fur);
    k.add(shapes::ball({0, 0.2f, 0.03f}, {0.06f, 0.11f, 0.065f}, 20), fur);
    k.add(shapes::ball({0, 0.32f, 0.05f}, {0.058f, 0.052f, 0.055f}, 20), fur);
    k.add(shapes::ball({0, 0.305f, 0.095f}, {0.026f, 0.02f, 0.02f}, 14), fur);
    for (const float s : {-1.f, 1.f}) {
        k.rod(fur, {s * 0.034f, 0.345f, 0.045f}, {s * 0.043f, 0.4f, 0.045f}, 0.022f, 0.003f, 10);
        k.add(shapes::ball({s * 0.022f, 0.33f, 0.1f}, {0.009f, 0.009f, 0.006f}, 8), eye);
        k.rod(fur, {s * 0.035f, 0.f, 0.085f}, {s * 0.035f, 0.18f, 0.06f}, 0.02f, 0.024f);
        k.add(shapes::ball({s * 0.035f, 0.015f, 0.1f}, {0.022f, 0.015f, 0.032f}, 12), fur);
        k.add(shapes::ball({s * 0.07f, 0.06f, -0.03f}, {0.04f, 0.06f, 0.08f}, 16), fur);
    }
    std::vector<Vec3f> tail;
    for (int i = 0; i <= 14; ++i) {
        const float a = -1.6f + 0.18f * static_cast<float>(i);
        tail.push_back({0.16f * std::cos(a), 0.018f, 0.16f * std::sin(a) - 0.0f});
    }
    k.add(shapes::tube(tail, 0.017f, 10), fur);
}

constexpr Entry kDecor[] = {{"plant", plant},
                            {"plant_tree", plant_tree},
                            {"plant_small", plant_small},
                            {"vase", vase},
                            {"vase_small", vase_small},
                            {"bouquet", bouquet},
                            {"picture", picture},
                            {"rug", rug},
                            {"curtain", curtain},
                            {"basket", basket},
                            {"book_stack", book_stack},
                            {"bowl", bowl},
                            {"candle", candle},
                            {"candelabrum", candelabrum},
                            {"clock", clock_piece},
                            {"piano", piano},
                            {"guitar", guitar},
                            {"aquarium", aquarium},
                            {"rocking_horse", rocking_horse},
                            {"coat_rack", coat_rack},
                            {"cat", cat}};

}  // namespace

std::span<const Entry> decor() { return kDecor; }

}  // namespace fastscene::furniture
