// Pipes.
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Pipes along a wall, with elbows, flanges, a valve and a gauge.
void build_pipes(Kit& k) {
    const Vec3f s = k.wanted({1.7f, 1.5f, 0.2f});
    const int metal = k.main(*material_named("copper")), brass = k.material(*material_named("brass")),
              iron = k.material(plain("cast iron", {0.05f, 0.046f, 0.043f}, 0.6f)),
              red = k.material(plain("valve wheel", {0.4f, 0.04f, 0.03f}, 0.4f)),
              dial = k.material(plain("dial", {0.7f, 0.68f, 0.6f}, 0.4f));
    const auto run = [&](std::vector<Vec3f> corners, float r, int material) {
        // Elbows: each corner becomes a short bend.
        std::vector<Vec3f> path{corners.front()};
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            const Vec3f in = normalize(corners[i] - corners[i - 1]), out = normalize(corners[i + 1] - corners[i]);
            const float bend = 2.2f * r;
            for (int j = 0; j <= 6; ++j) {
                const float t = static_cast<float>(j) / 6.f;
                path.push_back(corners[i] - in * (bend * (1 - t) * (1 - t)) + out * (bend * t * t));
            }
            for (const Vec3f& p : {corners[i] - in * bend, corners[i] + out * bend}) {
                const Vec3f along = p == corners[i] - in * bend ? in : out;
                k.rod(brass, p - along * (0.35f * r), p + along * (0.35f * r), 1.28f * r, -1, 16);
            }
        }
        path.push_back(corners.back());
        k.add(shapes::tube(path, r, 16), material);
        for (std::size_t i = 0; i + 1 < corners.size(); ++i)
            if (const Vec3f way = corners[i + 1] - corners[i]; length(way) > 0.7f) {
                const Vec3f p = corners[i] + way * 0.5f, along = normalize(way);
                k.rod(iron, p - along * 0.012f, p + along * 0.012f, 1.5f * r, -1, 18);
                k.rod(iron, {p.x, p.y, 0}, p, 0.4f * r, -1, 8);  // its bracket
            }
    };
    const float w = 0.5f * s.x, h = s.y;
    run({{-w, 0.2f * h, 0.09f}, {0.12f * w, 0.2f * h, 0.09f}, {0.12f * w, 0.86f * h, 0.09f}, {w, 0.86f * h, 0.09f}},
        0.042f, metal);
    run({{-0.62f * w, 0.f, 0.07f}, {-0.62f * w, 0.7f * h, 0.07f}, {-0.1f * w, 0.7f * h, 0.07f}, {-0.1f * w, h, 0.07f}},
        0.027f, metal);
    run({{0.6f * w, 0.f, 0.06f}, {0.6f * w, 0.55f * h, 0.06f}, {w, 0.55f * h, 0.06f}}, 0.02f, brass);
    // The valve's wheel and the gauge face the room.
    const Vec3f valve{-0.3f * w, 0.2f * h, 0.09f}, gauge{-0.62f * w, 0.46f * h, 0.07f};
    k.add(shapes::ball(valve, {0.06f, 0.06f, 0.06f}, 16), brass);
    k.rod(brass, valve, valve + Vec3f{0, 0, 0.1f}, 0.014f, -1, 10);
    Mesh wheel = shapes::ring(0.075f, 0.01f, 24);
    shapes::turn(wheel, {1, 0, 0}, 90);
    k.add(std::move(wheel), red, valve + Vec3f{0, 0, 0.095f});
    for (int i = 0; i < 2; ++i) {
        const float a = 0.4f + 1.5708f * static_cast<float>(i);
        const Vec3f d{0.07f * std::cos(a), 0.07f * std::sin(a), 0.095f};
        k.rod(red, valve + Vec3f{-d.x, -d.y, d.z}, valve + d, 0.006f, -1, 8);
    }
    k.rod(brass, gauge + Vec3f{0, 0, 0.02f}, gauge + Vec3f{0, 0, 0.07f}, 0.065f, -1, 24);
    k.rod(dial, gauge + Vec3f{0, 0, 0.07f}, gauge + Vec3f{0, 0, 0.0725f}, 0.055f, -1, 24);
    k.rod(iron, gauge + Vec3f{0, 0, 0.074f}, gauge + Vec3f{0.028f, 0.03f, 0.074f}, 0.003f, 0.0015f, 6);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 0.9f;
}

}  // namespace fastscene::furniture
