// Dining tables.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fastscene/rooms/furniture/forms.h"
#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/tables/table_parts.h"

namespace fastscene::furniture {
namespace {

// A thick top on two crossed trestles and a stretcher.
void trestle_table(Kit& k, Vec3f s) {
    const int wood = k.main(k.style.wood, k.request.holder_material != kTableCloth),
              frame = k.style.legs == LegType::metal_frame ? k.material(k.style.metal) : wood;
    k.board(wood, {0, s.y - 0.05f, 0}, {s.x, 0.05f, s.z}, 0.008f);
    const float x = 0.5f * s.x - 0.26f, z = 0.5f * s.z - 0.1f, y = s.y - 0.045f;
    for (const float sx : {-1.f, 1.f}) {
        for (const float sz : {-1.f, 1.f}) {
            Mesh leg = shapes::box({0.06f, std::hypot(y, 2 * z), 0.05f}, 0.006f);
            shapes::lay_grain(leg, {k.rng.uniform(0, 3), 0, 0});
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

}  // namespace

void build_dining_table(Kit& k) {
    using enum DiningTableForm;
    const DiningTableForm form = form_for(k, k.style.forms.dining_table);
    const bool sized = k.request.size_m.x > 0.f || k.request.size_m.z > 0.f;
    const Vec3f s = k.wanted({1.7f, 0.75f, 0.9f});
    const bool round = form == pedestal && !sized;
    // Under a cloth, whose corners are stretched, nobody sees how large the top is.
    constexpr Vec3f kHidden{0.07f, 0.014f, 0.07f};
    const Vec3f board = has_cloth(k) ? s - kHidden : s;
    if (form == trestle) trestle_table(k, board);
    else if (round) round_table(k, 0.75f * s.x, s.y, 0.035f);
    else plain_table(k, board, 0.04f);
    constexpr float kDown = 0.24f;
    if (!has_cloth(k)) return;
    if (round) lay_cloth_on(k, shapes::circle(0.375f * s.x, 72), s.y, kDown);
    else drape_cloth_over(k, s, kDown);
}

void build_dining_table_round(Kit& k) {
    const float d = k.wanted({1.2f, 0.75f, 1.2f}).x;
    round_table(k, d, 0.75f, 0.035f);
    if (has_cloth(k)) lay_cloth_on(k, shapes::circle(0.5f * d, 72), 0.75f, 0.3f);
}

}  // namespace fastscene::furniture
