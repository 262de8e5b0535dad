// Bean bag.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"
#include "fastscene/rooms/furniture/seats/upholstery.h"

namespace fastscene::furniture {

// A sack that has given way under who sat in it: flat below, a hollow for the seat, a soft peak behind.
void build_bean_bag(Kit& k) {
    Material m = k.style.fabric2;
    m.name = "bean bag";
    const int cloth = k.main(m);
    const std::uint32_t seed = k.seed();
    Mesh bag = shapes::ball({0, 0, 0}, {1, 1, 1}, 64);
    for (Vec3f& p : bag.positions) {
        const Vec3f d = normalize(p);
        const float around = std::atan2(d.x, d.z), up = std::max(0.f, d.y),
                    behind = eased(0.35f, -0.75f, d.z / std::max(0.3f, std::sqrt(d.x * d.x + d.z * d.z) + 0.25f * up));
        // Wider near the floor, where the filling goes; six panels meet in seams.
        const float belly = 1.f + 0.13f * std::exp(-8.f * (d.y + 0.35f) * (d.y + 0.35f)),
                    seam = std::exp(-std::pow(std::sin(3.f * around + 0.5f) / 0.16f, 2.f)) *
                           (1.f - 0.7f * std::fabs(d.y));
        const float fold = shapes::wobble(d * 3.2f, seed) +
                           0.55f * shapes::wobble({around * 5.f, d.y * 2.f, 3.f}, seed + 1) +
                           0.3f * shapes::wobble(d * 13.f, seed + 2);
        const float r = belly * (1.f - 0.028f * seam) + 0.02f * fold;
        float x = 0.43f * d.x * r, z = 0.45f * d.z * r, y = d.y < 0 ? 0.25f + 0.25f * d.y : 0.25f + 0.27f * d.y;
        y = std::max(y, 0.012f + 0.004f * fold);   // it lies on the floor
        y += 0.36f * std::pow(up, 0.8f) * behind;  // the back
        z -= 0.12f * up * behind;
        const float hx = x / 0.26f, hz = (z - 0.07f) / 0.24f;
        y -= 0.15f * up * std::exp(-hx * hx - hz * hz);  // the hollow
        y += (0.012f * fold - 0.012f * seam) * (0.3f + up);
        p = {x, std::max(0.f, y), z};
    }
    shapes::smooth_normals(bag);
    shapes::lay_grain(bag);
    // A loop to carry it by, at the peak.
    float peak = 0;
    Vec3f at;
    for (const Vec3f& p : bag.positions)
        if (p.y > peak) peak = p.y, at = p;
    k.add(std::move(bag), cloth);
    std::vector<Vec3f> loop;
    for (int i = 0; i <= 12; ++i) {
        const float a = kPi * static_cast<float>(i) / 12.f;
        loop.push_back(at + Vec3f{0.045f * std::cos(a), -0.012f + 0.05f * std::sin(a), 0.01f});
    }
    k.add(shapes::tube(loop, 0.007f, 6), cloth);
    k.top(0.4f, 0, 0.08f, 0.15f, 0.13f);
    k.piece.clearance_front_m = 0.4f;
}

}  // namespace fastscene::furniture
