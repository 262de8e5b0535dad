// What people love and hang up: a dog, a cat asleep, a typewriter, a record player, a crystal ball; bunting, garlands,
// stockings, a rail of hooks with coats, a rack with pans over an island.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture_kit.h"

namespace fastscene::furniture {
namespace {

using shapes::Limb;

// Short fur, darker in its depth.
Material coat_of(Vec3f color) {
    Material m = plain("fur", color, 0.95f);
    m.pattern = Pattern::carpet;
    m.color_b = color * 0.62f;
    return m;
}

// It lies with its head on its paws, eyes closed, the tail around it. The skin is the same for all dogs: made once.
void dog(Kit& k) {
    static const Mesh body = [] {
        const std::array<Limb, 18> limbs{
            {{{0, 0.1f, -0.22f}, {0, 0.108f, -0.06f}, 0.082f, 0.082f},  // loins, then the deeper chest
             {{0, 0.108f, -0.06f}, {0, 0.125f, 0.1f}, 0.084f, 0.108f},
             {{0, 0.15f, 0.1f}, {0.01f, 0.165f, 0.25f}, 0.095f, 0.068f},         // shoulders and neck
             {{0.075f, 0.09f, -0.22f}, {0.13f, 0.062f, -0.1f}, 0.078f, 0.048f},  // haunches
             {{-0.075f, 0.09f, -0.22f}, {-0.13f, 0.062f, -0.1f}, 0.078f, 0.048f},
             {{0.15f, 0.034f, -0.14f}, {0.155f, 0.026f, 0.03f}, 0.03f, 0.024f},  // hind paws
             {{-0.15f, 0.034f, -0.14f}, {-0.155f, 0.026f, 0.03f}, 0.03f, 0.024f},
             {{0.085f, 0.1f, 0.1f}, {0.1f, 0.045f, 0.2f}, 0.062f, 0.036f},  // forelegs
             {{-0.085f, 0.1f, 0.1f}, {-0.1f, 0.045f, 0.2f}, 0.062f, 0.036f},
             {{0.1f, 0.038f, 0.2f}, {0.07f, 0.03f, 0.42f}, 0.034f, 0.028f},
             {{-0.1f, 0.038f, 0.2f}, {-0.07f, 0.03f, 0.42f}, 0.034f, 0.028f},
             {{0.02f, 0.16f, 0.28f}, {0.02f, 0.145f, 0.34f}, 0.072f, 0.062f},  // head
             {{0.02f, 0.118f, 0.38f}, {0.02f, 0.1f, 0.455f}, 0.042f, 0.03f},   // snout, on the paws
             {{0.02f, 0.085f, 0.38f}, {0.02f, 0.078f, 0.43f}, 0.028f, 0.022f},
             {{0.02f, 0.2f, 0.27f}, {0.02f, 0.19f, 0.31f}, 0.03f, 0.03f},
             {{0.0f, 0.08f, -0.3f}, {0.1f, 0.035f, -0.36f}, 0.03f, 0.026f},  // tail
             {{0.1f, 0.035f, -0.36f}, {0.2f, 0.028f, -0.28f}, 0.026f, 0.022f},
             {{0.2f, 0.028f, -0.28f}, {0.235f, 0.022f, -0.16f}, 0.022f, 0.012f}}};
        return shapes::skin(limbs, 0.03f, 0.0175f);
    }();
    static const Mesh ears = [] {
        Mesh both;
        for (const float s : {-1.f, 1.f}) {
            const float x = 0.02f + s * 0.058f;
            const std::array<Limb, 2> flap{
                {{{x, 0.205f, 0.285f}, {x + s * 0.028f, 0.15f, 0.3f}, 0.017f, 0.026f},
                 {{x + s * 0.028f, 0.15f, 0.3f}, {x + s * 0.024f, 0.105f, 0.315f}, 0.026f, 0.014f}}};
            shapes::append(both, shapes::skin(flap, 0.02f, 0.013f));
        }
        return both;
    }();
    static constexpr std::array<Vec3f, 4> kCoats{
        {{0.5f, 0.3f, 0.12f}, {0.2f, 0.1f, 0.045f}, {0.62f, 0.52f, 0.38f}, {0.075f, 0.065f, 0.06f}}};
    const Vec3f tone = kCoats[static_cast<std::size_t>(k.dice.index(4))];
    const int fur = k.main(coat_of(tone));
    const Vec3f shown = k.piece.materials[static_cast<std::size_t>(fur)].color_a;
    const int ear = k.material(coat_of(shown * 0.6f)), nose = k.material(plain("nose", {0.02f, 0.018f, 0.017f}, 0.25f)),
              lid = k.material(plain("eyelid", shown * 0.2f, 0.8f));
    k.add(body, fur);
    k.add(ears, ear);
    k.add(shapes::ball({0.02f, 0.112f, 0.484f}, {0.017f, 0.013f, 0.011f}, 14), nose);
    for (const float s : {-1.f, 1.f}) {
        const std::array<Vec3f, 5> line{{{0.02f + s * 0.024f, 0.166f, 0.397f},
                                         {0.02f + s * 0.031f, 0.161f, 0.397f},
                                         {0.02f + s * 0.038f, 0.16f, 0.393f},
                                         {0.02f + s * 0.044f, 0.162f, 0.387f},
                                         {0.02f + s * 0.049f, 0.167f, 0.379f}}};
        k.add(shapes::tube(line, 0.0035f, 6), lid);
    }
    // A collar with a tag.
    const int strap = k.material(plain("collar", {0.42f, 0.04f, 0.035f}, 0.5f)),
              metal = k.material(*material_named("brass"));
    Mesh ring = shapes::ring(0.085f, 0.013f, 28);
    shapes::turn(ring, {1, 0, 0}, 78);
    k.add(std::move(ring), strap, {0.008f, 0.163f, 0.215f});
    k.add(shapes::ball({0.02f, 0.076f, 0.235f}, {0.012f, 0.012f, 0.004f}, 12), metal);
}

}  // namespace

// A cat rolled up, its chin on its tail.
void cat_asleep(Kit& k) {
    static const Mesh body = [] {
        std::vector<Limb> limbs;
        // The back in an arc, thickest at the haunches; then the tail around the front.
        const auto arc = [](float turn, float r) { return Vec3f{r * std::sin(turn), 0.f, -r * std::cos(turn)}; };
        for (int i = 0; i < 7; ++i) {
            const float a = -1.9f + 0.55f * static_cast<float>(i), b = a + 0.55f,
                        ra = 0.062f + 0.018f * std::sin(0.5f * static_cast<float>(i)),
                        rb = 0.062f + 0.018f * std::sin(0.5f * static_cast<float>(i + 1));
            limbs.push_back({arc(a, 0.105f) + Vec3f{0, ra, 0}, arc(b, 0.105f) + Vec3f{0, rb, 0}, ra, rb});
        }
        for (int i = 0; i < 6; ++i) {
            const float a = 2.1f + 0.42f * static_cast<float>(i);
            limbs.push_back({arc(a, 0.165f) + Vec3f{0, 0.024f, 0},
                             arc(a + 0.42f, 0.168f - 0.004f * static_cast<float>(i)) + Vec3f{0, 0.023f, 0}, 0.021f,
                             0.02f});
        }
        limbs.push_back(
            {{0.02f, 0.04f, 0.03f}, {0, 0.052f, -0.03f}, 0.062f, 0.068f});  // what it lies around: its belly
        const Vec3f head{-0.085f, 0.1f, 0.085f};
        limbs.push_back({arc(-1.9f, 0.105f) + Vec3f{0, 0.075f, 0}, head, 0.055f, 0.05f});
        limbs.push_back({head, head + Vec3f{0.012f, 0, 0.012f}, 0.053f, 0.05f});
        limbs.push_back({head + Vec3f{0.028f, -0.018f, 0.03f}, head + Vec3f{0.038f, -0.02f, 0.038f}, 0.024f, 0.02f});
        limbs.push_back({{0.03f, 0.03f, 0.1f}, {-0.05f, 0.026f, 0.125f}, 0.028f, 0.022f});  // a paw
        return shapes::skin(limbs, 0.024f, 0.0105f);
    }();
    static constexpr std::array<Vec3f, 4> kCoats{
        {{0.42f, 0.21f, 0.08f}, {0.07f, 0.065f, 0.06f}, {0.5f, 0.48f, 0.44f}, {0.26f, 0.22f, 0.18f}}};
    const int fur = k.main(coat_of(kCoats[static_cast<std::size_t>(k.dice.index(4))]));
    const int lid = k.material(plain("eyelid", k.piece.materials[static_cast<std::size_t>(fur)].color_a * 0.15f, 0.8f)),
              nose = k.material(plain("nose", {0.3f, 0.12f, 0.1f}, 0.4f));
    k.add(body, fur);
    const Vec3f head{-0.085f, 0.1f, 0.085f};
    for (const float s : {-1.f, 1.f}) {  // ears
        const Vec3f base = head + normalize(Vec3f{s, 0, -s}) * 0.032f + Vec3f{-0.008f, 0.03f, -0.008f};
        k.rod(fur, base, base + normalize(Vec3f{s, 0, -s}) * 0.012f + Vec3f{0, 0.052f, 0}, 0.022f, 0.003f, 10);
    }
    for (const float s : {-1.f, 1.f}) {
        const Vec3f side = normalize(Vec3f{s, 0, -s}) * 0.022f, out = normalize(Vec3f{1, 0, 1});
        const std::array<Vec3f, 3> line{head + side * 0.6f + out * 0.057f + Vec3f{0, 0.006f, 0},
                                        head + side + out * 0.056f + Vec3f{0, 0.001f, 0},
                                        head + side * 1.5f + out * 0.05f + Vec3f{0, 0.006f, 0}};
        k.add(shapes::tube(line, 0.0022f, 5), lid);
    }
    k.add(shapes::ball(head + Vec3f{0.0525f, -0.016f, 0.0525f}, {0.007f, 0.005f, 0.007f}, 10), nose);
}

namespace {

// An old office machine: enamelled body, four rows of round keys, the basket of types, a carriage with a sheet in it.
void typewriter(Kit& k) {
    static constexpr std::array<Vec3f, 4> kEnamels{
        {{0.018f, 0.018f, 0.019f}, {0.05f, 0.11f, 0.09f}, {0.28f, 0.36f, 0.32f}, {0.3f, 0.045f, 0.04f}}};
    const int body = k.main(plain("enamel", kEnamels[static_cast<std::size_t>(k.dice.index(4))], 0.25f)),
              dark = k.material(plain("cast iron", {0.025f, 0.024f, 0.023f}, 0.45f)),
              bright = k.material(plain("key ring", {0.5f, 0.5f, 0.49f}, 0.25f)),
              ivory = k.material(plain("key", {0.62f, 0.58f, 0.48f}, 0.4f)),
              rubber = k.material(plain("platen", {0.02f, 0.02f, 0.02f}, 0.6f)),
              paper = k.material(plain("paper", {0.76f, 0.74f, 0.68f}, 0.9f));
    k.piece.materials[static_cast<std::size_t>(bright)].metal = 1.f;
    // The profile from the side, extruded: a low front for the keys, a hood over the types.
    const std::vector<Vec2f> hood{{-0.15f, 0.f},    {-0.15f, 0.125f}, {-0.06f, 0.14f},
                                  {-0.005f, 0.12f}, {0.02f, 0.075f},  {0.02f, 0.f}};
    std::vector<Vec2f> outline;
    for (const Vec2f& p : hood) outline.push_back({-p.x, p.y});
    for (const float sx : {-1.f, 1.f}) {
        Mesh cheek = shapes::prism(outline, -0.02f, 0.02f, 0.006f);  // (x, z) -> (z, y)
        shapes::turn(cheek, {1, 0, 0}, -90);
        shapes::turn(cheek, {0, 1, 0}, 90);
        k.add(std::move(cheek), body, {sx * 0.135f, 0, 0});
    }
    k.board(body, {0, 0.012f, 0.f}, {0.31f, 0.03f, 0.32f}, 0.012f);
    k.board(body, {0, 0.03f, -0.115f}, {0.27f, 0.095f, 0.06f}, 0.008f);
    k.board(dark, {0, 0.03f, -0.035f}, {0.24f, 0.05f, 0.1f}, 0.004f);
    // The basket: types in a fan.
    for (int i = 0; i < 21; ++i) {
        const float a = -1.1f + 0.11f * static_cast<float>(i);
        k.rod(bright, {0.012f * std::sin(a), 0.082f, -0.062f},
              {0.1f * std::sin(a), 0.096f - 0.012f * std::abs(a), -0.062f + 0.085f * std::cos(a)}, 0.0016f, -1, 5);
    }
    k.board(body, {0, 0.035f, 0.026f}, {0.25f, 0.042f, 0.012f}, 0.005f);
    // Keys on levers, each row lower than the one behind it.
    for (int row = 0; row < 4; ++row) {
        const float y = 0.088f - 0.0145f * static_cast<float>(row), z = 0.05f + 0.027f * static_cast<float>(row);
        const int keys = row == 0 ? 11 : row == 3 ? 9 : 10;
        for (int i = 0; i < keys; ++i) {
            const float x = (static_cast<float>(i) - 0.5f * static_cast<float>(keys - 1)) * 0.0245f +
                            (row % 2 ? 0.004f : -0.003f);
            const std::array<Vec2f, 3> rim{Vec2f{0.0082f, 0}, {0.0095f, 0.0015f}, {0.0095f, 0.0045f}};
            k.add(shapes::lathe(rim, 14), bright, {x, y, z});
            k.add(shapes::prism(shapes::circle(0.0078f, 14), 0.0042f, 0.0056f, 0.0004f),
                  (i + row) % 9 == 8 ? dark : ivory, {x, y, z});
            k.rod(dark, {x, 0.042f, z - 0.004f}, {x, y + 0.001f, z}, 0.0016f, -1, 5);
        }
    }
    k.rod(dark, {-0.075f, 0.04f, 0.155f}, {0.075f, 0.04f, 0.155f}, 0.006f, -1, 10);
    for (const float sx : {-0.07f, 0.07f}) k.rod(dark, {sx, 0.025f, 0.14f}, {sx, 0.04f, 0.155f}, 0.003f, -1, 6);
    // The carriage.
    k.board(dark, {0, 0.125f, -0.115f}, {0.36f, 0.016f, 0.05f}, 0.003f);
    k.rod(rubber, {-0.165f, 0.158f, -0.11f}, {0.165f, 0.158f, -0.11f}, 0.021f, -1, 20);
    for (const float sx : {-1.f, 1.f}) {
        k.rod(dark, {sx * 0.165f, 0.158f, -0.11f}, {sx * 0.205f, 0.158f, -0.11f}, 0.006f, -1, 10);
        k.rod(dark, {sx * 0.192f, 0.158f, -0.11f}, {sx * 0.212f, 0.158f, -0.11f}, 0.018f, -1, 18);
        k.board(bright, {sx * 0.17f, 0.138f, -0.115f}, {0.006f, 0.035f, 0.05f}, 0.002f);
    }
    const std::array<Vec3f, 4> lever{
        {{-0.17f, 0.165f, -0.09f}, {-0.195f, 0.172f, -0.06f}, {-0.2f, 0.175f, -0.02f}, {-0.197f, 0.172f, -0.005f}}};
    k.add(shapes::tube(lever, 0.004f, 8), bright);
    // The sheet comes up behind the platen and bends back a little.
    k.add(shapes::slab(4, 14, 0.0012f,
                       [](float u, float v) {
                           const float up = 0.19f * v;
                           return Vec3f{(u - 0.5f) * 0.21f, 0.165f + up, -0.135f - 0.5f * up * up - 0.12f * up};
                       }),
          paper);
    const int ink = k.material(plain("ink", {0.05f, 0.05f, 0.055f}, 0.9f));
    for (int i = 0; i < 5; ++i) {
        const float up = 0.16f - 0.02f * static_cast<float>(i),
                    wide = i == 4 ? 0.06f : 0.15f + 0.01f * static_cast<float>(i % 3);
        k.board(ink, {-0.08f + 0.5f * wide, 0.163f + up, -0.1335f - 0.5f * up * up - 0.12f * up + 0.0016f},
                {wide, 0.003f, 0.0006f}, 0.0001f);
    }
    k.piece.mount = Mount::surface;
}

// A wooden case, a platter with a record on it, an arm.
void record_player(Kit& k) {
    const int wood = k.main(k.style.wood), black = k.material(plain("vinyl record", {0.012f, 0.012f, 0.013f}, 0.22f)),
              metal = k.material(steel()), dark = k.material(plain("mat", {0.03f, 0.03f, 0.03f}, 0.9f)),
              label = k.material(plain("label", k.accent(), 0.7f)),
              top = k.material(plain("deck", {0.05f, 0.05f, 0.052f}, 0.45f));
    k.board(wood, {0, 0.012f, 0}, {0.44f, 0.09f, 0.35f}, 0.008f);
    for (const float sx : {-0.17f, 0.17f})
        for (const float sz : {-0.13f, 0.13f}) k.rod(dark, {sx, 0, sz}, {sx, 0.014f, sz}, 0.018f, -1, 14);
    k.board(top, {0, 0.101f, 0}, {0.41f, 0.004f, 0.32f}, 0.002f);
    const Vec3f hub{-0.045f, 0, 0};
    k.add(shapes::prism(shapes::circle(0.152f, 56), 0.105f, 0.12f, 0.003f), metal, hub);
    k.add(shapes::prism(shapes::circle(0.148f, 56), 0.12f, 0.1235f, 0.001f), black, hub);
    for (const float r : {0.07f, 0.09f, 0.11f, 0.13f}) {
        Mesh groove = shapes::ring(r, 0.0009f, 48);
        k.add(std::move(groove), dark, {hub.x, 0.1236f, hub.z});
    }
    k.add(shapes::prism(shapes::circle(0.05f, 32), 0.1235f, 0.1242f, 0.0003f), label, hub);
    k.rod(metal, {hub.x, 0.12f, hub.z}, {hub.x, 0.132f, hub.z}, 0.0035f, -1, 8);
    // The arm on its post, its needle on the record.
    const Vec3f post{0.16f, 0.105f, -0.1f};
    k.rod(metal, post, post + Vec3f{0, 0.035f, 0}, 0.018f, 0.014f, 18);
    const std::array<Vec3f, 4> arm{{post + Vec3f{0, 0.036f, -0.035f},
                                    post + Vec3f{0, 0.036f, 0.04f},
                                    {0.145f, 0.138f, 0.05f},
                                    {0.06f, 0.132f, 0.09f}}};
    k.add(shapes::tube(arm, 0.0045f, 8), metal);
    k.board(dark, {0.055f, 0.125f, 0.094f}, {0.022f, 0.009f, 0.03f}, 0.002f);
    k.rod(metal, post + Vec3f{0, 0.036f, -0.055f}, post + Vec3f{0, 0.036f, -0.03f}, 0.014f, -1, 14);
    k.rod(metal, {0.17f, 0.104f, 0.12f}, {0.17f, 0.115f, 0.12f}, 0.014f, -1, 16);
    k.piece.mount = Mount::surface;
}

// A ball of clear glass on a turned foot.
void crystal_ball(Kit& k) {
    Material clear = plain("crystal", {0.4f, 0.46f, 0.68f}, 0.03f);
    clear.metal = 0.5f;
    const int ball = k.main(clear), foot = k.material(*material_named("brass"));
    const std::array<Vec2f, 9> p{Vec2f{0.07f, 0}, {0.072f, 0.012f}, {0.05f, 0.022f},  {0.024f, 0.035f}, {0.03f, 0.048f},
                                 {0.05f, 0.058f}, {0.058f, 0.07f},  {0.054f, 0.072f}, {0.02f, 0.064f}};
    k.add(shapes::lathe(p, 32, false), foot);
    k.add(shapes::ball({0, 0.155f, 0}, {0.095f, 0.095f, 0.095f}, 36), ball);
    for (int i = 0; i < 3; ++i) {
        const Vec3f out = around(2.0944f * static_cast<float>(i) + 0.5f);
        k.rod(foot, out * 0.045f + Vec3f{0, 0.06f, 0}, out * 0.088f + Vec3f{0, 0.11f, 0}, 0.007f, 0.004f, 8);
    }
    k.piece.mount = Mount::surface;
}

// Where a cord that hangs in bows is at t in [0, 1].
Vec3f on_bows(float t, int bows, float width, float top, float sag) {
    const float in = t * static_cast<float>(bows) - std::floor(std::min(t, 0.9999f) * static_cast<float>(bows));
    return {(t - 0.5f) * width, top - sag * 4 * in * (1 - in), 0};
}

// Pennants on a cord, in two bows along a wall. In one color that was said they alternate with white.
void bunting(Kit& k) {
    const Vec3f s = k.wanted({2.4f, 0.42f, 0.02f});
    const bool said = k.request.color || !k.request.color_name.empty();
    static constexpr std::array<Vec3f, 5> kMerry{{{0.5f, 0.05f, 0.045f},
                                                  {0.62f, 0.42f, 0.06f},
                                                  {0.06f, 0.26f, 0.34f},
                                                  {0.2f, 0.36f, 0.12f},
                                                  {0.58f, 0.24f, 0.2f}}};
    Material first = k.style.fabric;
    first.color_a = kMerry[0], first.color_b = kMerry[0] * 0.8f, first.color_c = kMerry[0];
    std::vector<int> cloth{k.main(first)};
    const auto dye = [&](Vec3f color) {
        Material m = k.style.fabric;
        m.color_a = color, m.color_b = color * 0.8f, m.color_c = color;
        cloth.push_back(k.material(m));
    };
    if (!k.request.color2_name.empty()) dye(*color_named(k.request.color2_name));
    else if (said) dye({0.74f, 0.72f, 0.67f});
    else
        for (std::size_t i = 1; i < kMerry.size(); ++i) dye(kMerry[i]);
    const int cord = k.material(plain("cord", {0.66f, 0.62f, 0.52f}, 0.9f));
    constexpr int kBows = 2;
    const int flags = 2 * std::max(3, static_cast<int>(s.x / 0.36f));
    const float sag = 0.5f * s.y, high = 0.48f * s.y, wide = 0.82f * s.x / static_cast<float>(flags);
    std::vector<Vec3f> path;
    for (int i = 0; i <= 40; ++i)
        path.push_back(on_bows(static_cast<float>(i) / 40.f, kBows, s.x, s.y, sag) + Vec3f{0, 0, 0.008f});
    k.add(shapes::tube(path, 0.004f, 6), cord);
    for (int i = 0; i < flags; ++i) {
        const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(flags), half = 0.5f * wide / s.x,
                    flutter = k.dice.uniform(-0.008f, 0.008f);
        const Vec3f a = on_bows(t - half, kBows, s.x, s.y, sag), b = on_bows(t + half, kBows, s.x, s.y, sag),
                    tip = (a + b) * 0.5f - Vec3f{0, high, 0};
        k.add(shapes::slab(6, 6, 0.002f,
                           [=](float u, float v) {
                               return lerp(lerp(a, b, u), tip, 0.985f * v) +
                                      Vec3f{0, 0, 0.012f + flutter * v * std::sin(3.f * u + 1.f)};
                           }),
              cloth[static_cast<std::size_t>(i) % cloth.size()]);
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.85f;
}

// Twigs along a cord in two bows, the ends hanging down; red berries among them.
void garland(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 0.5f, 0.12f});
    const int leaf = k.main(foliage(k, {0.07f, 0.16f, 0.06f}, 0.03f)),
              pale = k.material(foliage(k, {0.13f, 0.2f, 0.11f}, 0.03f)),
              cord = k.material(plain("twig", {0.16f, 0.1f, 0.055f}, 0.9f)),
              berry = k.material(plain("berry", {0.42f, 0.025f, 0.02f}, 0.25f));
    std::vector<Vec3f> path;
    const float top = s.y - 0.06f, half = 0.5f * s.x - 0.05f;
    for (int i = 0; i <= 5; ++i) path.push_back({-half, 0.06f + (top - 0.06f) * static_cast<float>(i) / 6.f, 0.05f});
    for (int i = 0; i <= 32; ++i)
        path.push_back(on_bows(static_cast<float>(i) / 32.f, 2, 2 * half, top, 0.34f * s.y) + Vec3f{0, 0, 0.05f});
    for (int i = 5; i >= 0; --i) path.push_back({half, 0.06f + (top - 0.06f) * static_cast<float>(i) / 6.f, 0.05f});
    k.add(shapes::tube(path, 0.006f, 6), cord);
    std::array<Mesh, 2> leaves;
    Mesh berries;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const Vec3f along = normalize(path[i + 1] - path[i]);
        const int many = std::max(3, static_cast<int>(length(path[i + 1] - path[i]) / 0.0082f));
        for (int j = 0; j < many; ++j) {
            const Vec3f at = lerp(path[i], path[i + 1], k.dice.uniform());
            // A leaf is made lying along +x and put where it grows: out and along the cord.
            const float spin = k.dice.uniform(-1.75f, 1.75f), size = k.dice.uniform(0.05f, 0.085f);
            const Vec3f side = std::abs(along.y) < 0.9f ? normalize(cross(along, Vec3f{0, 0, 1})) : Vec3f{1, 0, 0};
            const Vec3f out = normalize(side * std::sin(spin) + Vec3f{0, 0, 1} * std::cos(spin) +
                                        along * k.dice.uniform(0.4f, 1.1f));
            const Vec3f wide = normalize(cross(out, std::abs(out.z) < 0.9f ? Vec3f{0, 0, 1} : Vec3f{0, 1, 0})),
                        up = cross(wide, out);
            Mesh m = blade({0, 0, 0}, {1, 0, 0}, size, 0.3f * size, 0.1f, 0.25f, 0.8f);
            for (Vec3f& p : m.positions) {
                const Vec3f q = p;
                p = at + out * q.x + up * q.y + wide * q.z;
                p.z = std::max(p.z, 0.002f);
            }
            shapes::smooth_normals(m);
            shapes::append(leaves[static_cast<std::size_t>(j % 3 == 0)], m);
        }
        if (i % 2 == 0)
            for (int j = 0; j < 2; ++j)
                shapes::append(
                    berries, shapes::ball(path[i] + Vec3f{k.dice.uniform(-0.02f, 0.02f), k.dice.uniform(-0.025f, 0.02f),
                                                          0.025f + k.dice.uniform(0.f, 0.015f)},
                                          {0.009f, 0.009f, 0.009f}, 6));
    }
    k.add(std::move(leaves[0]), leaf);
    k.add(std::move(leaves[1]), pale);
    k.add(std::move(berries), berry);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.6f;
}

// Three on a rail: what hangs at the fireplace in December.
void christmas_stocking(Kit& k) {
    Material wool = *material_named("wool");
    const auto dyed = [&](Vec3f c) {
        Material m = wool;
        m.color_a = c, m.color_b = c * 0.75f, m.color_c = c;
        return m;
    };
    const int red = k.main(dyed({0.45f, 0.035f, 0.035f})), green = k.material(dyed({0.06f, 0.17f, 0.075f})),
              white = k.material(dyed({0.74f, 0.72f, 0.68f})), wood = k.material(k.style.wood),
              metal = k.material(k.style.metal);
    const bool said = k.request.color || !k.request.color_name.empty();
    k.board(wood, {0, 0.5f, 0.012f}, {0.9f, 0.05f, 0.024f}, 0.005f);
    for (int i = 0; i < 3; ++i) {
        const float x = 0.28f * (static_cast<float>(i) - 1.f), lean = k.dice.uniform(-5.f, 5.f);
        k.rod(metal, {x, 0.52f, 0.02f}, {x, 0.515f, 0.05f}, 0.005f, -1, 8);
        // Leg, heel and foot in one skin, pressed flat.
        const std::array<Limb, 4> limbs{{{{0, 0.33f, 0}, {0, 0.15f, 0}, 0.066f, 0.06f},
                                         {{0, 0.15f, 0}, {0.005f, 0.085f, 0}, 0.06f, 0.06f},
                                         {{0.005f, 0.08f, 0}, {0.11f, 0.066f, 0}, 0.058f, 0.05f},
                                         {{0.1f, 0.066f, 0}, {0.125f, 0.064f, 0}, 0.05f, 0.047f}}};
        Mesh sock = shapes::skin(limbs, 0.03f, 0.02f);
        const std::array<Limb, 1> band{{{{-0.012f, 0.375f, 0}, {0.012f, 0.375f, 0}, 0.07f, 0.07f}}};
        Mesh cuff = shapes::skin(band, 0.01f, 0.019f);
        for (Vec3f& p : cuff.positions) p.y = 0.375f + 0.55f * (p.y - 0.375f);
        const std::array<Limb, 1> tip{{{{0.142f, 0.064f, 0}, {0.15f, 0.064f, 0}, 0.04f, 0.035f}}};
        Mesh toe = shapes::skin(tip, 0.01f, 0.016f);
        const int body = said || i != 1 ? red : green;
        for (const auto& [mesh, material] : {std::pair{&sock, body}, {&cuff, white}, {&toe, white}}) {
            for (Vec3f& p : mesh->positions) p.z = 0.55f * p.z;
            shapes::smooth_normals(*mesh);
            shapes::turn(*mesh, {0, 0, 1}, lean);
            k.add(std::move(*mesh), material, {x, 0.045f, 0.052f});
        }
        const std::array<Vec3f, 3> loop{{{x - 0.01f, 0.455f, 0.05f}, {x, 0.516f, 0.05f}, {x + 0.012f, 0.455f, 0.05f}}};
        k.add(shapes::tube(loop, 0.004f, 6), white);
    }
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.15f;
}

// A board with five hooks; a coat, a bag and a scarf hang there, and a hat.
void coat_hooks(Kit& k) {
    const Vec3f s = k.wanted({1.05f, 0.98f, 0.2f});
    const int wood = k.main(k.style.wood), metal = k.material(k.style.metal);
    const float board = s.y - 0.12f, reach = 0.075f;
    k.board(wood, {0, board, 0.011f}, {s.x, 0.12f, 0.022f}, 0.006f);
    const auto hook_x = [&](int i) { return (static_cast<float>(i) - 2.f) * 0.205f * s.x; };
    for (int i = 0; i < 5; ++i) {
        const float x = hook_x(i), y = board + 0.055f;
        const std::array<Vec3f, 5> bow{{{x, y, 0.02f},
                                        {x, y - 0.022f, 0.045f},
                                        {x, y - 0.02f, reach},
                                        {x, y + 0.008f, reach + 0.012f},
                                        {x, y + 0.02f, reach + 0.012f}}};
        k.add(shapes::tube(bow, 0.006f, 8), metal);
        k.add(shapes::ball({x, y + 0.022f, reach + 0.012f}, {0.01f, 0.01f, 0.01f}, 10), metal);
        k.board(metal, {x, y - 0.03f, 0.024f}, {0.026f, 0.06f, 0.006f}, 0.002f);
    }
    // A coat hangs from its collar: narrow there, wider below, in folds.
    const auto coat = [&](int hook, float down, float width, int cloth) {
        const float x = hook_x(hook), top = board + 0.05f;
        const std::uint32_t seed = k.seed();
        k.add(shapes::slab(36, 18, 0.016f,
                           [=](float u, float v) {
                               const float open = 0.16f + 0.84f * std::min(1.f, 2.6f * v) + 0.06f * v,
                                           a = (u - 0.5f) * 3.f;
                               const float fold = 1.f + 0.16f * v * std::sin(9.f * a) +
                                                  0.1f * shapes::wobble({3 * a, 4 * v, 0}, seed);
                               return Vec3f{x + 0.5f * width * open * std::sin(a) / std::sin(1.5f), top - down * v,
                                            0.028f + 0.085f * open * std::cos(a) * fold};
                           }),
              cloth);
    };
    coat(0, std::min(0.9f, board + 0.02f), 0.3f, k.material(tinted(k.style.fabric2, k.accent())));
    coat(3, std::min(0.62f, board), 0.26f,
         k.material(tinted(k.style.fabric, lerp(k.accent(), {0.12f, 0.1f, 0.08f}, 0.45f))));
    // A scarf over one hook, a straw hat on another.
    const int scarf = k.material(tinted(*material_named("wool"), k.accent()));
    for (const float side : {-1.f, 1.f})
        k.add(shapes::slab(8, 16, 0.01f,
                           [&, side](float u, float v) {
                               return Vec3f{hook_x(1) + side * (0.018f + 0.02f * v) + (u - 0.5f) * 0.075f,
                                            board + 0.07f - (side > 0 ? 0.52f : 0.44f) * v,
                                            0.05f + 0.02f * std::sin(2.6f * v) + 0.006f * std::sin(12.f * u)};
                           }),
              scarf);
    const int straw = k.material(*material_named("rattan"));
    const std::array<Vec2f, 6> brim{Vec2f{0.15f, 0.f}, {0.085f, 0.012f}, {0.08f, 0.03f},
                                    {0.076f, 0.075f},  {0.06f, 0.088f},  {0.f, 0.09f}};
    Mesh hat = shapes::shade(brim, 36);
    shapes::turn(hat, {1, 0, 0}, 78);
    k.add(std::move(hat), straw, {hook_x(4), board + 0.03f, 0.05f});
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.82f;
}

// A frame on four chains with pots and pans around it.
void pot_rack(Kit& k) {
    const int metal = k.main(*material_named("copper")),
              iron = k.material(plain("wrought iron", {0.035f, 0.034f, 0.033f}, 0.5f));
    const float hx = 0.45f, hz = 0.2f, rail = -0.62f;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) {
            k.rod(iron, {sx * hx * 0.8f, rail, sz * hz}, {sx * hx * 0.62f, -0.01f, sz * hz * 0.4f}, 0.004f, -1, 8);
            k.add(shapes::prism(shapes::circle(0.02f, 16), -0.012f, 0.f), iron, {sx * hx * 0.62f, 0, sz * hz * 0.4f});
        }
    for (const float sz : {-1.f, 1.f}) k.rod(iron, {-hx, rail, sz * hz}, {hx, rail, sz * hz}, 0.01f, -1, 12);
    for (int i = -2; i <= 2; ++i)
        k.rod(iron, {0.5f * hx * static_cast<float>(i), rail, -hz}, {0.5f * hx * static_cast<float>(i), rail, hz},
              i == -2 || i == 2 ? 0.01f : 0.005f, -1, 10);
    for (const float sz : {-1.f, 1.f})
        for (int i = 0; i < 4; ++i) {
            const float x = (static_cast<float>(i) - 1.5f) * 0.225f + 0.02f * sz,
                        r = std::array{0.082f, 0.07f, 0.092f, 0.064f}[static_cast<std::size_t>(sz > 0 ? i : 3 - i)] *
                            k.dice.uniform(0.94f, 1.05f),
                        deep = i % 2 == 0 ? 0.045f : 0.08f;
            const float handle = 0.13f + 0.05f * k.dice.uniform(), middle = rail - 0.05f - handle - r;
            k.rod(iron, {x, rail - 0.004f, sz * hz}, {x, rail - 0.05f, sz * hz}, 0.004f, -1, 6);
            k.rod(metal, {x, rail - 0.045f, sz * hz}, {x, middle + 0.95f * r, sz * hz}, 0.008f, 0.01f, 8);
            // Its polished bottom to the outside.
            const std::array<Vec2f, 5> bowl{
                Vec2f{0.78f * r, 0.f}, {0.9f * r, 0.006f}, {0.97f * r, 0.02f}, {r, deep}, {r + 0.004f, deep + 0.004f}};
            Mesh pan = shapes::vessel(bowl, 0.004f, 28);
            shapes::turn(pan, {1, 0, 0}, sz > 0 ? -90.f : 90.f);
            k.add(std::move(pan), metal, {x, middle, sz * (hz + 0.5f * deep)});
        }
    k.piece.mount = Mount::ceiling;
}

constexpr Entry kKeepsakes[] = {{"dog", dog},
                                {"typewriter", typewriter},
                                {"record_player", record_player},
                                {"crystal_ball", crystal_ball},
                                {"bunting", bunting},
                                {"garland", garland},
                                {"christmas_stocking", christmas_stocking},
                                {"coat_hooks", coat_hooks},
                                {"pot_rack", pot_rack}};

}  // namespace

std::span<const Entry> keepsakes() { return kKeepsakes; }

}  // namespace fastscene::furniture
