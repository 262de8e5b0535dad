// Gears.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fastscene/rooms/furniture/kit.h"

namespace fastscene::furniture {

// Toothed wheels that mesh, on a wall.
void build_gears(Kit& k) {
    const int metal = k.main(*material_named("brass")), copper = k.material(*material_named("copper")),
              iron = k.material(plain("cast iron", {0.06f, 0.055f, 0.05f}, 0.5f));
    constexpr float kTooth = 0.021f;  // of the radius for each tooth
    const auto wheel = [&](Vec3f at, int teeth, float phase, int material) {
        const float r = kTooth * static_cast<float>(teeth) / 2.f + 0.02f, tooth = 0.026f;
        std::vector<Vec2f> outline;
        for (int i = 0; i < teeth; ++i)
            for (const auto& [part, out] : {std::pair{0.f, 0.f}, std::pair{0.32f, 0.f}, std::pair{0.44f, 1.f},
                                            std::pair{0.8f, 1.f}, std::pair{0.92f, 0.f}}) {
                const float a = kTau * (static_cast<float>(i) + part + phase) / static_cast<float>(teeth),
                            d = r - 0.5f * tooth + tooth * out;
                outline.push_back({d * std::sin(a), -d * std::cos(a)});
            }
        // The rim, in pieces, so that one sees between the spokes.
        const float hole = 0.68f * r, thick = 0.018f;
        Mesh rim;
        const auto face = [&](std::array<Vec3f, 4> corner, Vec3f normal) {
            const auto first = static_cast<std::uint32_t>(rim.positions.size());
            for (const Vec3f& c : corner) rim.positions.push_back(c), rim.normals.push_back(normal);
            const bool turned = dot(cross(corner[1] - corner[0], corner[2] - corner[0]), normal) < 0;
            for (const std::array<std::uint32_t, 3> t : {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 2, 3}})
                rim.triangles.insert(rim.triangles.end(),
                                     {first + t[0], first + t[turned ? 2 : 1], first + t[turned ? 1 : 2]});
        };
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vec2f p = outline[i], q = outline[(i + 1) % outline.size()];
            const Vec2f pi = p * (hole / std::hypot(p.x, p.y)), qi = q * (hole / std::hypot(q.x, q.y)),
                        middle = (p + q) * 0.5f;
            const auto on = [](Vec2f v, float z) { return Vec3f{v.x, v.y, z}; };
            for (const float z : {-thick, thick})
                face({on(p, z), on(q, z), on(qi, z), on(pi, z)}, {0, 0, z > 0 ? 1.f : -1.f});
            Vec3f out = normalize(Vec3f{q.y - p.y, p.x - q.x, 0});
            if (dot(out, on(middle, 0)) < 0) out = out * -1.f;
            face({on(p, -thick), on(q, -thick), on(q, thick), on(p, thick)}, out);
            face({on(pi, -thick), on(qi, -thick), on(qi, thick), on(pi, thick)}, normalize(on(middle, 0)) * -1.f);
        }
        shapes::lay_grain(rim);
        k.add(std::move(rim), material, at);
        const int spokes = teeth > 20 ? 6 : 4;
        for (int i = 0; i < spokes; ++i) {
            const float a = kTau * static_cast<float>(i) / static_cast<float>(spokes) + phase;
            k.rod(material, at, at + Vec3f{0.74f * r * std::sin(a), 0.74f * r * std::cos(a), 0}, 0.09f * r, 0.07f * r,
                  10);
        }
        k.rod(material, at - Vec3f{0, 0, 0.024f}, at + Vec3f{0, 0, 0.026f}, 0.24f * r, -1, 24);
        k.rod(iron, {at.x, at.y, 0}, at + Vec3f{0, 0, 0.04f}, 0.09f * r, -1, 14);
        return r;
    };
    const Vec3f middle{-0.1f, 0.42f, 0.05f};
    const float large = wheel(middle, 30, 0.f, metal);
    const auto beside = [&](int teeth, float angle, float z, float phase, int material) {
        const float r = kTooth * static_cast<float>(teeth) / 2.f + 0.02f, far = large + r;
        return wheel({middle.x + far * std::cos(angle), middle.y + far * std::sin(angle), z}, teeth, phase, material);
    };
    beside(18, 0.55f, 0.05f, 0.5f, copper);
    beside(12, 2.2f, 0.05f, 0.2f, iron);
    beside(14, -0.75f, 0.05f, 0.35f, metal);
    k.piece.mount = Mount::wall;
    k.piece.hang_height_m = 1.25f;
}

}  // namespace fastscene::furniture
