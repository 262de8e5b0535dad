// A cat, sitting or asleep.
#include <array>
#include <cmath>
#include <vector>

#include "fastscene/rooms/furniture/animals/coat.h"
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {
namespace {

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
    const int fur = k.main(coat_of(kCoats[static_cast<std::size_t>(k.rng.index(4))]));
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

}  // namespace

void build_cat(Kit& k) {
    if (k.request.pattern == kAsleep) return cat_asleep(k);
    const Vec3f coats[] = {{0.35f, 0.18f, 0.07f}, {0.06f, 0.055f, 0.05f}, {0.5f, 0.48f, 0.44f}};
    Material m = plain("fur", coats[k.rng.index(3)], 0.95f);
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

}  // namespace fastscene::furniture
