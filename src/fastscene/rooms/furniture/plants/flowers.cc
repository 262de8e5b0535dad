// Cut flowers, and the vases they stand in.
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/kitchen/tableware.h"
#include "fastscene/rooms/furniture/plants/foliage.h"

namespace fastscene::furniture {
namespace {

// Fresh flowers in something whose mouth is at y: a loose ball of blooms over leaves.
void flowers(Kit& k, int bloom, float mouth_y, std::string_view kind, float size) {
    const int stem = k.material(plain("stem", {0.07f, 0.16f, 0.05f}, 0.7f)),
              leaf = k.material(foliage(k, {0.08f, 0.19f, 0.06f}, 0.1f)),
              middle = k.material(plain(
                  "flower middle", kind == "sunflower" ? Vec3f{0.07f, 0.04f, 0.02f} : Vec3f{0.6f, 0.42f, 0.06f}, 0.9f));
    constexpr int kBlooms = 13;
    for (int i = 0; i < kBlooms; ++i) {
        const float t = (static_cast<float>(i) + 0.5f) / kBlooms, a = 2.39996f * static_cast<float>(i),
                    far = 0.088f * size * std::sqrt(t) * k.rng.uniform(0.85f, 1.15f);
        const Vec3f head = around(a) * far + Vec3f{0, mouth_y + size * (0.22f - 0.1f * t + 0.03f * k.rng.uniform()), 0};
        k.rod(stem, {0.2f * head.x, 0.5f * mouth_y, 0.2f * head.z}, head, 0.0028f, -1, 5);
        k.add(blade({0.4f * head.x, mouth_y, 0.4f * head.z}, around(a + 0.9f), 0.1f * size, 0.026f * size, 1.1f, 0.7f,
                    0.8f),
              leaf);
        const Vec3f up = normalize(head - Vec3f{0, mouth_y - 0.12f * size, 0});
        const float r = size * k.rng.uniform(0.026f, 0.034f);
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
    return *color_named(kGarden[static_cast<std::size_t>(k.rng.index(5))]);
}

// Stems that lean out of a vase: each an arc from its mouth, `high` above it.
struct Stem {
    Vec3f foot, tip;
    float angle;
    Vec3f point(float v) const {
        const Vec3f out{tip.x - foot.x, 0, tip.z - foot.z};
        return foot + out * (v * v) + Vec3f{0, (tip.y - foot.y) * (1.25f * v - 0.25f * v * v), 0};
    }
};
std::vector<Stem> stems_of(Kit& k, int count, float mouth_y, float low, float high, float lean) {
    std::vector<Stem> out;
    for (int i = 0; i < count; ++i) {
        const float a = 2.39996f * static_cast<float>(i) + k.rng.uniform(-0.3f, 0.3f);
        out.push_back({Vec3f{0, 0.35f * mouth_y, 0},
                       around(a) * (lean * k.rng.uniform(0.45f, 1.f)) + Vec3f{0, k.rng.uniform(low, high), 0}, a});
    }
    return out;
}
void add_stem(Kit& k, int material, const Stem& stem, float radius) {
    std::vector<Vec3f> path;
    for (int i = 0; i <= 6; ++i) path.push_back(stem.point(static_cast<float>(i) / 6.f));
    k.add(shapes::tube(path, radius, 5), material);
}

void pampas(Kit& k, float mouth_y, float size) {
    const int stalk = k.material(plain("dried stem", {0.3f, 0.22f, 0.12f}, 0.9f)),
              plume = k.material(plain("pampas", lerp(k.accent(), {0.6f, 0.5f, 0.36f}, 0.65f), 0.95f));
    for (const Stem& stem : stems_of(k, 7, mouth_y, 0.55f * size, 0.75f * size, 0.16f * size)) {
        add_stem(k, stalk, stem, 0.002f);
        // A plume of fine tufts that hang a little.
        for (int i = 0; i < 34; ++i) {
            const float v = 0.8f + 0.2f * static_cast<float>(i) / 33.f, a = 2.39996f * static_cast<float>(i);
            k.add(blade(stem.point(v), around(a), 0.055f * size * (1.35f - v), 0.012f * size, 1.6f, 0.7f, 0.8f), plume);
        }
    }
}
// Round leaves in pairs.
void eucalyptus(Kit& k, float mouth_y, float size) {
    const int stalk = k.material(plain("stem", {0.2f, 0.16f, 0.12f}, 0.8f)),
              leaf = k.material(foliage(k, {0.15f, 0.22f, 0.18f}, 0.05f));
    for (const Stem& stem : stems_of(k, 6, mouth_y, 0.45f * size, 0.66f * size, 0.24f * size)) {
        add_stem(k, stalk, stem, 0.002f);
        for (int i = 0; i < 11; ++i) {
            const float v = 0.42f + 0.056f * static_cast<float>(i), l = 0.05f * size * (1.5f - v);
            for (const float way : {0.f, kPi})
                k.add(blade(stem.point(v), around(stem.angle + 1.4f + way + 0.8f * static_cast<float>(i % 2)), l,
                            0.95f * l, 0.5f, 0.6f, 0.66f),
                      leaf);
        }
    }
}
// Twigs of an orchard in spring, or bare.
void twigs(Kit& k, float mouth_y, float size, bool blossom) {
    const int bark = k.material(plain("twig", {0.11f, 0.075f, 0.055f}, 0.9f)),
              petal = blossom ? k.material(plain("blossom", {0.68f, 0.5f, 0.52f}, 0.7f)) : -1;
    for (const Stem& stem : stems_of(k, 5, mouth_y, 0.6f * size, 0.9f * size, 0.3f * size)) {
        add_stem(k, bark, stem, 0.0028f * size);
        for (int i = 0; i < 7; ++i) {
            const Vec3f from = stem.point(0.45f + 0.075f * static_cast<float>(i));
            const Vec3f to = from + around(stem.angle + k.rng.uniform(-1.4f, 1.4f)) * (0.07f * size) +
                             Vec3f{0, k.rng.uniform(0.05f, 0.12f) * size, 0};
            k.rod(bark, from, to, 0.0016f * size, 0.0008f * size, 4);
            for (int b = 0; blossom && b < 3; ++b)
                k.add(shapes::ball(lerp(from, to, 0.35f + 0.3f * static_cast<float>(b)),
                                   Vec3f{0.009f, 0.007f, 0.009f} * size, 6),
                      petal);
        }
    }
}

void fill_vase(Kit& k, float mouth_y, float size) {
    // Fresh flowers where people like them.
    if (k.style.fresh_flowers && k.rng.chance(0.4f)) {
        k.piece.form = "flowers";
        return flowers(k, k.material(plain("petals", color_of_flower(k, ""), 0.6f)), mouth_y,
                       k.rng.chance(0.4f) ? "tulip" : "", 0.95f * size);
    }
    static constexpr std::array<const char*, 5> kForms{"pampas", "eucalyptus", "twigs", "blossom", "empty"};
    const int form = k.rng.index(5);
    k.piece.form = kForms[static_cast<std::size_t>(form)];
    if (form == 0) pampas(k, mouth_y, size);
    if (form == 1) eucalyptus(k, mouth_y, size);
    if (form == 2 || form == 3) twigs(k, mouth_y, size, form == 3);
}

void vase_of(Kit& k, float size, bool stems) {
    const int body = k.main(plain("glazed vase", k.accent(), 0.25f));
    const int kind = k.rng.index(3);
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
    fill_vase(k, p.back().y, size);
}

}  // namespace

void build_bouquet(Kit& k) {
    const std::string_view kind = k.request.pattern;
    const int bloom = k.main(plain("petals", color_of_flower(k, kind), 0.6f));
    Material pot = k.rng.chance(0.5f) ? plain("glazed vase", {0.7f, 0.68f, 0.63f}, 0.2f)
                                      : plain("glazed vase", k.accent(), 0.25f);
    if (const auto asked = material_named(k.request.holder_material)) pot = *asked;
    if (const auto asked = color_named(k.request.holder_color)) pot = tinted(pot, *asked);
    const std::array<Vec2f, 6> p{Vec2f{0.045f, 0}, {0.06f, 0.03f},  {0.066f, 0.09f},
                                 {0.055f, 0.15f},  {0.045f, 0.19f}, {0.055f, 0.215f}};
    k.add(shapes::vessel(shapes::curve(p, 3), 0.004f, 28), k.material(pot));
    flowers(k, bloom, 0.21f, kind, 1.05f);
    k.piece.mount = Mount::surface;
}

void build_vase(Kit& k) { vase_of(k, 1.f, true); }

void build_vase_small(Kit& k) { vase_of(k, 0.7f, false); }

}  // namespace fastscene::furniture
