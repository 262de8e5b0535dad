// Dog.
#include <array>
#include <utility>

#include "fastscene/rooms/furniture/animals/coat.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/storage/carcass.h"

namespace fastscene::furniture {

// It lies with its head on its paws, eyes closed, the tail around it. The skin is the same for all dogs: made once.
void build_dog(Kit& k) {
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
    const Vec3f tone = kCoats[static_cast<std::size_t>(k.rng.index(4))];
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

}  // namespace fastscene::furniture
