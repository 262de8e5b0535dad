#include "fastscene/trace/shade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fastscene/trace/response.h"
#include "fastscene/trace/sky.h"
#include "fastscene/trace/surface.h"

namespace fastscene {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// What the mirrored ray meets; its light comes from the cache, its own mirror images are left out.
Vec3f mirrored_radiance(const ShadeScene& scene, Vec3f origin, Vec3f direction, float angle, int mirrors) {
    const RayHit hit = scene.bvh.first_hit(origin, direction);
    if (!hit) return sky_radiance(scene.room.sky, direction);
    const SurfacePointInfo s = surface_at(scene.room, hit, origin, direction, angle * hit.distance, false);
    const Material& m = *s.material;
    if (m.mirror > 0.5f && mirrors > 0) {
        const Vec3f out = direction - s.normal * (2 * dot(direction, s.normal));
        return mirrored_radiance(scene, s.position + s.normal * 1e-3f, out, angle, mirrors - 1);
    }
    Vec3f front = scene.light.near(s.position, s.normal, true), back{};
    if (m.transmission > 0) back = scene.light.near(s.position, -s.normal, true);
    return s.texture.albedo * (front * (1.f - m.transmission) + back * m.transmission) * (1.f / kPi) + m.emission;
}

}  // namespace

Shaded shade_ray(const ShadeScene& scene, Vec3f origin, Vec3f direction, float pixel_angle, Random& random) {
    const RayHit hit = scene.bvh.first_hit(origin, direction);
    if (!hit) return {sky_radiance(scene.room.sky, direction), {}};
    // A surface seen at a slant lies under a longer footprint; the geometric mean keeps patterns crisp and calm.
    const float slant = std::max(0.08f, std::abs(dot(hit.normal, direction)));
    const SurfacePointInfo s = surface_at(scene.room, hit, origin, direction, pixel_angle * hit.distance / std::sqrt(slant), true);
    const Material& m = *s.material;

    const Response r = response_of(s, direction);

    // Light on the front and, for thin sheets, from behind. The relief turns the sun's light; the rest is too even to show it.
    const auto sun = [&](Vec3f normal) { return scene.lights.sun(scene.room, scene.bvh, s.position, normal, {random.uniform(), random.uniform()}); };
    Shaded out{m.emission, s.texture.albedo};
    // Relief darkens where it leans away from the light above.
    const float lean = dot(s.bumped - s.normal, Vec3f{0, -1, 0});
    const Vec3f front = (scene.light.at(s.position, s.normal) + sun(s.bumped)) * std::clamp(1.f + 0.8f * lean, 0.5f, 1.4f);
    out.radiance += r.diffuse * front * (1.f / kPi);
    if (m.transmission > 0) out.radiance += r.behind * (scene.light.at(s.position, -s.normal) + sun(-s.normal)) * (1.f / kPi);
    if (!(max_component(r.shine) > 0)) return out;

    const Vec3f half = ggx_half(s.bumped, r.alpha, {random.uniform(), random.uniform()});
    Vec3f mirrored = direction - half * (2 * dot(direction, half));
    if (!(dot(mirrored, s.normal) > 0.01f)) mirrored = direction - s.normal * (2 * dot(direction, s.normal));
    Vec3f seen = mirrored_radiance(scene, offset_from(s.position, s.normal), normalize(mirrored), pixel_angle + 0.3f * r.alpha, 3);
    // A single bright thing met by chance would sparkle: it is held to a few times the light around.
    const float limit = 6.f * (luminance(front) / kPi + 0.05f), bright = luminance(seen);
    if (r.alpha > 0 && bright > limit) seen = seen * (limit / bright);
    out.radiance += r.shine * seen;
    return out;
}

}  // namespace fastscene
