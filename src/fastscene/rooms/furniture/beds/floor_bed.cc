// A bed on the floor.
#include "fastscene/rooms/furniture/beds/bedding.h"
#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Bedding on the floor: a futon on mats of straw, a mattress on pallets, or on nothing.
void build_floor_bed(Kit& k) {
    using enum FloorBedForm;
    const FloorBedForm form = form_for(k, k.style.forms.floor_bed);
    const float width = 1.42f, length = 1.98f,
                base = form == mats      ? 0.035f
                       : form == pallets ? 0.13f
                                         : 0.f,
                thick = form == mats ? 0.13f : 0.2f, top = base + thick;
    Material quilt = tinted(k.style.fabric, lerp(k.style.fabric.color_a, {0.75f, 0.72f, 0.66f}, 0.5f));
    quilt.name = "duvet", quilt.pattern = Pattern::fabric;
    const int duvet = k.main(quilt), linen = k.material(tinted(k.style.fabric, {0.74f, 0.72f, 0.68f})),
              second = accent_cloth(k);
    if (form == mats) {
        Material straw = *material_named("wicker");
        straw.name = "tatami", straw.color_a = {0.52f, 0.47f, 0.28f}, straw.color_b = {0.42f, 0.37f, 0.2f},
        straw.scale_m = 0.014f, straw.bump_m = 0.001f;
        const int tatami = k.material(straw),
                  edge = k.material(plain("tatami border", k.style.fabric2.color_a * 0.6f, 0.85f));
        for (const float s : {-1.f, 1.f}) {
            k.board(tatami, {s * 0.5f * (width + 0.34f) * 0.5f, 0, 0},
                    {0.5f * (width + 0.34f) - 0.004f, base, length + 0.3f}, 0.004f);
            for (const float e : {-1.f, 1.f})
                k.board(edge, {s * 0.25f * (width + 0.34f) + e * (0.25f * (width + 0.34f) - 0.018f), 0.001f, 0},
                        {0.03f, base + 0.001f, length + 0.301f}, 0.002f);
        }
    }
    if (form == pallets) {
        const int wood = k.material(k.style.wood2);
        constexpr int kBoards = 12;
        for (int i = 0; i < kBoards; ++i)
            k.board(wood, {0, base - 0.022f, (length + 0.26f) * ((static_cast<float>(i) + 0.5f) / kBoards - 0.5f)},
                    {width + 0.3f, 0.022f, 0.14f}, 0.004f);
        for (const float x : {-1.f, 0.f, 1.f}) {
            k.board(wood, {x * 0.5f * (width + 0.18f), 0, 0}, {0.1f, 0.02f, length + 0.26f}, 0.004f);
            for (const float z : {-1.f, 0.f, 1.f})
                k.board(wood, {x * 0.5f * (width + 0.18f), 0.018f, z * 0.5f * (length + 0.1f)},
                        {0.1f, base - 0.04f, 0.14f}, 0.006f);
        }
    }
    k.soft(linen, {0, base, 0}, {width, thick, length}, {0.06f, 0.014f, 0.003f, 12});
    const Bedding bedding{{width, top, length}, 0.f};
    const DrapedCloth cover = over_mattress(bedding, -0.36f, 0.5f * length + 0.1f, {.drop_m = thick - 0.03f}, k.seed());
    k.add_soft(cloth_mesh(cover, 0.03f), duvet, kDrapedCrease);
    k.soft(linen, {0, top + 0.034f, -0.31f}, {width + 0.06f, 0.065f, 0.32f}, {0.028f, 0.012f, 0.004f, 18});
    for (const float s : {-1.f, 1.f}) {
        put_pillow(k, linen, {s * 0.34f, top + 0.01f, -0.5f * length + 0.32f}, {0.66f, 0.44f, 0.18f}, 66.f,
                   k.rng.uniform(-6, 6));
        put_pillow(k, s < 0 ? duvet : second,
                   {s * 0.33f + k.rng.uniform(-0.04f, 0.04f), top + 0.07f, -0.5f * length + 0.42f},
                   {0.58f, 0.4f, 0.15f}, 60.f, k.rng.uniform(-9, 9));
    }
    const float throw_z = 0.4f, throw_end = 0.78f;
    Covers across{.drop_m = thick - 0.04f, .thick_m = 0.014f, .slack = 0.015f};
    lay_over(bedding, cover, throw_z, throw_end, across);
    k.add_soft(cloth_mesh(over_mattress(bedding, throw_z, throw_end, across, k.seed()), 0.014f), second, kDrapedCrease);
    k.top(top + 0.06f, 0, 0.1f, 0.36f * width, 0.22f);
    k.piece.clearance_front_m = 0.5f;
    k.piece.clearance_side_m = 0.4f;
    k.piece.against_wall = true;
}

}  // namespace fastscene::furniture
