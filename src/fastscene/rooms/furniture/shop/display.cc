// What shops and museums show things on.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/shop/goods.h"

namespace fastscene::furniture {
namespace {

// What clothes are dyed: few colors are loud.
Vec3f dye(Kit& k) {
    static constexpr std::array<Vec3f, 14> kDyes{
        Vec3f{0.03f, 0.032f, 0.036f}, {0.04f, 0.06f, 0.11f}, {0.1f, 0.15f, 0.24f},   {0.62f, 0.58f, 0.5f},
        {0.36f, 0.24f, 0.13f},        {0.12f, 0.13f, 0.07f}, {0.24f, 0.24f, 0.235f}, {0.46f, 0.3f, 0.27f},
        {0.15f, 0.03f, 0.035f},       {0.68f, 0.67f, 0.64f}, {0.2f, 0.27f, 0.26f},   {0.42f, 0.32f, 0.14f},
        {0.09f, 0.06f, 0.045f},       {0.32f, 0.13f, 0.07f}};
    return kDyes[static_cast<std::size_t>(k.rng.index(static_cast<int>(kDyes.size())))];
}
// Cloth of one: plain, or striped now and then.
int garment_cloth(Kit& k) {
    Material m = tinted(k.style.fabric, dye(k));
    if (k.rng.chance(0.12f)) {
        m.pattern = k.rng.chance(0.5f) ? Pattern::stripes : Pattern::plaid;
        m.color_b = lerp(m.color_a, luminance(m.color_a) > 0.2f ? Vec3f{0.06f, 0.07f, 0.1f} : Vec3f{0.6f, 0.57f, 0.5f},
                         0.7f);
        m.color_c = m.color_a;
        m.scale_m = 0.05f;
    }
    return k.material(std::move(m));
}

// A garment on a hanger, seen from its side: shoulders at the top, hanging cloth.
void garment(Kit& k, int cloth, int metal, Vec3f at, float length) {
    Mesh m = shapes::slab(4, 8, 0.03f, [&](float u, float v) {
        const float wide = 0.42f * (v > 0.9f ? 1.f - 4.f * (v - 0.9f) : 1.f),
                    sway = 0.012f * std::sin(9.f * u + 2.f * v);
        return Vec3f{sway, -length + length * v - 0.07f, wide * (u - 0.5f)};
    });
    k.add(std::move(m), cloth, at);
    k.rod(metal, at + Vec3f{0, 0.012f, 0}, at + Vec3f{0, -0.08f, 0}, 0.003f, -1, 5);
}

}  // namespace

void build_clothes_rack(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 1.5f, 0.5f});
    const int metal = k.main(k.style.metal);
    const float x = 0.5f * s.x - 0.05f;
    for (const float sx : {-1.f, 1.f}) {
        k.rod(metal, {sx * x, 0.04f, 0}, {sx * x, s.y, 0}, 0.016f, -1, 10);
        k.rod(metal, {sx * x, 0.03f, -0.24f}, {sx * x, 0.03f, 0.24f}, 0.016f, -1, 10);
    }
    k.rod(metal, {-x, s.y - 0.02f, 0}, {x, s.y - 0.02f, 0}, 0.014f, -1, 10);
    std::array<int, 6> cloths{};
    for (int& c : cloths) c = garment_cloth(k);
    int same = 0, cloth = cloths[0];
    float length = 0.8f;
    for (float at = -x + 0.08f; at < x - 0.05f; at += 0.06f) {
        if (--same <= 0) {
            same = 2 + k.rng.index(4), cloth = cloths[static_cast<std::size_t>(k.rng.index(6))];
            length = k.rng.uniform(0.65f, 1.1f);
        }
        garment(k, cloth, metal, {at, s.y - 0.02f, 0}, std::min(length, s.y - 0.2f));
    }
    k.piece.clearance_front_m = 0.7f;
}

// A figure in a dress or a suit on a round stand.
void build_mannequin(Kit& k) {
    const int skin = color(k, "mannequin", {0.66f, 0.63f, 0.58f}, 0.4f), metal = k.material(k.style.metal),
              cloth = k.main(tinted(k.style.fabric, dye(k)));
    k.add(shapes::prism(shapes::circle(0.2f, 24), 0, 0.02f), metal);
    k.rod(metal, {0, 0.02f, 0}, {0, 0.6f, 0}, 0.012f);
    const bool dress = k.rng.chance(0.5f);
    const std::array<Limb, 5> upper{Limb{{0, 1.0f, 0}, {0, 1.4f, 0}, 0.12f, 0.125f},
                                    {{0, 1.44f, 0}, {0, 1.52f, 0}, 0.05f, 0.045f},
                                    {{0, 1.62f, 0.01f}, {0, 1.68f, 0}, 0.08f, 0.085f},
                                    {{-0.18f, 1.41f, 0}, {-0.23f, 0.95f, 0.05f}, 0.045f, 0.03f},
                                    {{0.18f, 1.41f, 0}, {0.23f, 0.95f, 0.05f}, 0.045f, 0.03f}};
    k.add(shapes::skin(upper, 0.05f, 0.035f), skin);
    if (dress) {
        const std::array<Vec2f, 7> skirt{Vec2f{0.3f, 0.45f}, {0.27f, 0.6f}, {0.2f, 0.9f},  {0.135f, 1.05f},
                                         {0.15f, 1.3f},      {0.17f, 1.4f}, {0.09f, 1.46f}};
        Mesh m = shapes::lathe(skirt, 22, true);
        for (Vec3f& p : m.positions) p.z *= 0.9f;
        k.add(std::move(m), cloth);
        for (const float sx : {-1.f, 1.f}) k.rod(skin, {sx * 0.08f, 0.05f, 0}, {sx * 0.09f, 0.5f, 0}, 0.04f, 0.055f);
    } else {
        const std::array<Vec2f, 5> coat{
            Vec2f{0.2f, 0.82f}, {0.155f, 1.05f}, {0.17f, 1.3f}, {0.19f, 1.41f}, {0.08f, 1.47f}};
        Mesh m = shapes::lathe(coat, 22, true);
        for (Vec3f& p : m.positions) p.z *= 0.86f;
        k.add(std::move(m), cloth);
        const int trousers = color(k, "trousers", {0.04f, 0.045f, 0.06f}, 0.9f);
        for (const float sx : {-1.f, 1.f})
            k.rod(trousers, {sx * 0.09f, 0.06f, 0}, {sx * 0.085f, 0.86f, 0}, 0.07f, 0.095f, 14);
    }
    k.piece.clearance_front_m = 0.4f;
}

// A table with folded things in piles.
void build_clothes_table(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 0.8f, 0.8f});
    const int wood = k.main(k.style.wood);
    legs(k, wood, 0.5f * s.x - 0.06f, 0.5f * s.z - 0.06f, s.y - 0.03f, 0.06f);
    k.board(wood, {0, s.y - 0.035f, 0}, {s.x, 0.035f, s.z}, 0.006f);
    std::array<int, 4> cloths{};
    for (int& c : cloths) c = garment_cloth(k);
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 4; ++i) {
            const int pile = 3 + k.rng.index(4), cloth = cloths[static_cast<std::size_t>(k.rng.index(4))];
            for (int h = 0; h < pile; ++h)
                k.board(cloth,
                        {-0.5f * s.x + s.x * (static_cast<float>(i) + 0.5f) / 4, s.y + 0.032f * static_cast<float>(h),
                         (static_cast<float>(j) - 0.5f) * 0.38f},
                        {0.27f, 0.03f, 0.31f}, 0.012f);
        }
    k.piece.clearance_front_m = 0.6f;
}

// Crates of fruit and vegetables on a stepped stand.
void build_produce_stand(Kit& k) {
    const Vec3f s = k.wanted({1.6f, 1.05f, 0.9f});
    const int wood = k.main(materials::timber("natural", 0.8f));
    static constexpr std::array<Vec3f, 8> kFruit{
        Vec3f{0.45f, 0.03f, 0.03f}, {0.65f, 0.26f, 0.02f}, {0.62f, 0.5f, 0.06f}, {0.14f, 0.3f, 0.04f},
        {0.2f, 0.04f, 0.14f},       {0.5f, 0.06f, 0.04f},  {0.08f, 0.2f, 0.03f}, {0.42f, 0.28f, 0.14f}};
    const int start = k.rng.index(8);
    for (int row = 0; row < 2; ++row) {
        const float y = row == 0 ? 0.45f : 0.75f, z = row == 0 ? 0.22f : -0.22f;
        k.board(wood, {0, 0, z}, {s.x, y, 0.42f});
        for (int i = 0; i < 4; ++i) {
            const float w = s.x / 4, x = -0.5f * s.x + w * (static_cast<float>(i) + 0.5f);
            const int fruit = color(k, "fruit", kFruit[static_cast<std::size_t>(start + 3 * row + i) % 8], 0.35f);
            for (const float sx : {-1.f, 1.f})
                k.board(wood, {x + sx * (0.5f * w - 0.012f), y, z}, {0.016f, 0.13f, 0.42f}, 0.002f);
            for (const float sz : {-1.f, 1.f}) k.board(wood, {x, y, z + sz * 0.2f}, {w - 0.02f, 0.13f, 0.016f}, 0.002f);
            for (int a = 0; a < 4; ++a)
                for (int b = 0; b < 4; ++b)
                    k.add(shapes::ball({0, 0, 0}, {0.045f, 0.042f, 0.045f}, 8), fruit,
                          {x + 0.085f * (static_cast<float>(a) - 1.5f) + k.rng.uniform(-0.01f, 0.01f),
                           y + 0.11f + k.rng.uniform(0.f, 0.03f), z + 0.085f * (static_cast<float>(b) - 1.5f)});
        }
    }
    k.piece.clearance_front_m = 0.8f;
}

// Buckets of cut flowers on steps.
void build_flower_stand(Kit& k) {
    const Vec3f s = k.wanted({1.5f, 1.0f, 0.95f});
    const int wood = k.main(k.style.wood), zinc = k.material(*material_named("steel")),
              leaf = color(k, "stems", {0.06f, 0.17f, 0.04f}, 0.7f);
    static constexpr std::array<Vec3f, 7> kPetals{Vec3f{0.6f, 0.05f, 0.08f}, {0.7f, 0.45f, 0.04f}, {0.62f, 0.3f, 0.42f},
                                                  {0.72f, 0.7f, 0.64f},      {0.3f, 0.12f, 0.45f}, {0.7f, 0.22f, 0.04f},
                                                  {0.65f, 0.12f, 0.3f}};
    for (int row = 0; row < 3; ++row) {
        const float y = 0.12f + 0.22f * static_cast<float>(row), z = 0.3f - 0.3f * static_cast<float>(row);
        k.board(wood, {0, 0, z}, {s.x, y, 0.3f}, 0.006f);
        for (int i = 0; i < 4; ++i) {
            const Vec3f at{-0.5f * s.x + s.x * (static_cast<float>(i) + 0.5f) / 4, y, z};
            const std::array<Vec2f, 2> bucket{Vec2f{0.085f, 0}, {0.12f, 0.26f}};
            k.add(shapes::vessel(bucket, 0.006f, 14), zinc, at);
            const int petal = color(k, "petals", kPetals[static_cast<std::size_t>(k.rng.index(7))], 0.7f);
            for (int f = 0; f < 11; ++f) {
                const float a = k.rng.uniform(0, kTau), r = k.rng.uniform(0.f, 0.15f), h = k.rng.uniform(0.36f, 0.52f);
                const Vec3f head = at + Vec3f{r * std::cos(a), h, r * std::sin(a)};
                k.rod(leaf, at + Vec3f{0.3f * r * std::cos(a), 0.1f, 0.3f * r * std::sin(a)}, head, 0.005f, -1, 5);
                k.add(shapes::ball(head, {0.038f, 0.03f, 0.038f}, 8), petal);
                k.add(shapes::ball(head - Vec3f{0.02f, 0.1f, 0}, {0.035f, 0.018f, 0.02f}, 6), leaf);
            }
        }
    }
    k.piece.clearance_front_m = 0.7f;
}

// Glass on a base: rings and necklaces, or what a museum has dug up.
void build_display_case(Kit& k) {
    const Vec3f s = k.wanted({1.3f, 1.0f, 0.6f});
    const int wood = k.main(k.style.wood), pane = k.material(glass()), metal = k.material(*material_named("brass")),
              velvet = color(k, "velvet", {0.44f, 0.41f, 0.37f}, 0.95f),
              bust = color(k, "bust", {0.025f, 0.025f, 0.03f}, 0.9f), gold = k.material(*material_named("gold"));
    k.board(wood, {0, 0, 0}, {s.x - 0.04f, 0.72f, s.z - 0.04f}, 0.008f);
    k.board(velvet, {0, 0.72f, 0}, {s.x - 0.02f, 0.02f, s.z - 0.02f}, 0.002f);
    const float h = s.y - 0.74f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f})
            k.board(metal, {sx * (0.5f * s.x - 0.008f), 0.72f, sz * (0.5f * s.z - 0.008f)}, {0.016f, h + 0.02f, 0.016f},
                    0.002f);
    for (const float sz : {-1.f, 1.f})
        k.board(metal, {0, s.y - 0.016f, sz * (0.5f * s.z - 0.008f)}, {s.x, 0.016f, 0.016f}, 0.002f);
    for (const float sx : {-1.f, 1.f})
        k.board(metal, {sx * (0.5f * s.x - 0.008f), s.y - 0.016f, 0}, {0.016f, 0.016f, s.z}, 0.002f);
    k.board(pane, {0, s.y - 0.008f, 0}, {s.x - 0.03f, 0.005f, s.z - 0.03f}, 0.001f);
    for (const float sz : {-1.f, 1.f})
        k.board(pane, {0, 0.74f, sz * (0.5f * s.z - 0.006f)}, {s.x - 0.03f, h - 0.02f, 0.004f}, 0.001f);
    const int strip = k.material(glow("case light", {9, 8, 6.2f}));
    k.board(strip, {0, s.y - 0.022f, 0.5f * s.z - 0.024f}, {s.x - 0.08f, 0.006f, 0.012f}, 0.001f);
    for (int i = 0; i < 5; ++i) {
        const Vec3f at{-0.5f * s.x + s.x * (static_cast<float>(i) + 0.5f) / 5, 0.74f, k.rng.uniform(-0.08f, 0.08f)};
        if (i % 2 == 0) {
            k.add(shapes::ball({0, 0, 0}, {0.06f, 0.1f, 0.05f}, 12), bust, at + Vec3f{0, 0.08f, 0});
            Mesh chain = shapes::ring(0.05f, 0.008f, 18);
            shapes::turn(chain, {1, 0, 0}, 65);
            k.add(std::move(chain), gold, at + Vec3f{0, 0.11f, 0.035f});
        } else {
            for (int r = -1; r <= 1; ++r) {
                Mesh ring = shapes::ring(0.02f, 0.008f, 14);
                shapes::turn(ring, {1, 0, 0}, 80);
                k.add(std::move(ring), gold, at + Vec3f{0.06f * static_cast<float>(r), 0.025f, 0.05f});
            }
        }
    }
    k.piece.clearance_front_m = 0.8f;
}

// A white plinth with a work of art.
void build_plinth(Kit& k) {
    const int white = k.main(plain("plinth", {0.74f, 0.73f, 0.71f}, 0.6f));
    k.board(white, {0, 0, 0}, {0.45f, 1.0f, 0.45f}, 0.004f);
    Piece art = k.small("sculpture");
    const float grow = std::min(1.5f, 0.42f / std::max(0.1f, std::max(art.size_m.x, art.size_m.z)));
    for (Mesh& m : art.meshes)
        for (Vec3f& p : m.positions) p = p * grow;
    k.merge(art, {0, 1.0f, 0});
    k.piece.clearance_front_m = 0.8f;
}

}  // namespace fastscene::furniture
