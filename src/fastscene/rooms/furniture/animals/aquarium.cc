// Aquarium.
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/plants/foliage.h"

namespace fastscene::furniture {

void build_aquarium(Kit& k) {
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
        k.add(blade({k.rng.uniform(-0.4f, 0.4f), 0.78f, k.rng.uniform(-0.12f, 0.12f)}, around(k.rng.uniform(0, kTau)),
                    0.08f, 0.02f, k.rng.uniform(2.f, 4.f), 0.3f, 1.1f),
              green);
    for (int i = 0; i < 6; ++i)
        k.add(shapes::ball({k.rng.uniform(-0.36f, 0.36f), k.rng.uniform(0.86f, 1.12f), k.rng.uniform(-0.1f, 0.12f)},
                           {0.035f, 0.016f, 0.008f}, 12),
              k.material(plain("fish", i % 2 ? Vec3f{0.7f, 0.25f, 0.04f} : k.accent(), 0.3f)));
    k.piece.against_wall = true;
    k.piece.clearance_front_m = 0.6f;
}

}  // namespace fastscene::furniture
