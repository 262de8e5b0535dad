// Silhouettes that pieces of several kinds share.
#include "fastscene/rooms/furniture/forms.h"

#include <utility>

namespace fastscene::furniture {

void feet(Kit& k, int wood, float width, float depth, float high, float lean) {
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) {
            const Vec3f top{sx * (0.5f * width - 0.1f), high + 0.01f, sz * (0.5f * depth - 0.09f)};
            k.rod(wood, {top.x + sx * lean, 0, top.z + sz * lean}, top, 0.015f, 0.024f, 12);
        }
}

void buttons(Kit& k, int cloth, float x0, float x1, float y0, float y1, float z, float step) {
    int row = 0;
    for (float y = y0; y <= y1; y += 0.7f * step, ++row)
        for (float x = x0 + (row % 2 ? 0.5f * step : 0.f); x <= x1 + 1e-4f; x += step)
            k.add(shapes::ball({x, y, z}, {0.014f, 0.014f, 0.008f}, 8), cloth);
}

bool is_woven(const Kit& k) {
    return k.request.pattern == "wicker" || k.request.material == "rattan" || k.request.material == "wicker" ||
           k.request.material == "cane";
}

int woven_main(Kit& k) {
    const int cane = k.main(*material_named("wicker"));
    k.piece.materials[static_cast<std::size_t>(cane)].scale_m = 0.036f;
    return cane;
}

int accent_cloth(Kit& k) {
    Material m = tinted(k.style.fabric2, k.accent());
    const int kind = k.rng.index(4);
    if (kind == 1)
        m.pattern = Pattern::stripes, m.scale_m = 0.02f, m.color_b = Vec3f{0.7f, 0.67f, 0.6f}, m.color_c = m.color_a;
    if (kind == 2) m.pattern = Pattern::knit, m.scale_m = 0.012f, m.bump_m = 0.002f;
    return k.material(m);
}

void put_pillow(Kit& k, int mat, Vec3f at, Vec3f size, float lean_deg, float yaw_deg) {
    Mesh m = shapes::pillow(size, k.seed());
    shapes::turn(m, {1, 0, 0}, -lean_deg);
    shapes::turn(m, {0, 1, 0}, yaw_deg);
    k.add_soft(std::move(m), mat, kPillowCrease, at);
}

}  // namespace fastscene::furniture
