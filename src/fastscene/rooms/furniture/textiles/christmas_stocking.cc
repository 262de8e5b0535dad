// Christmas stocking.
#include <array>
#include <utility>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Three on a rail: what hangs at the fireplace in December.
void build_christmas_stocking(Kit& k) {
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
        const float x = 0.28f * (static_cast<float>(i) - 1.f), lean = k.rng.uniform(-5.f, 5.f);
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

}  // namespace fastscene::furniture
