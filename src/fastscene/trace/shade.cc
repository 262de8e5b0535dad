#include "fastscene/trace/shade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fastscene/trace/sky.h"
#include "fastscene/trace/surface.h"

namespace fastscene {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
// Rougher dielectrics mirror so little and so widely that the cache's own light stands for it.
constexpr float kMirrorRoughness = 0.5f;

// Light that a diffuse surface sends back: through thin sheets also from behind.
Vec3f diffuse_radiance(const Material& m, Vec3f albedo, Vec3f front, Vec3f back) {
    return albedo * (front * (1.f - m.transmission) + back * m.transmission) * (1.f / kPi);
}

// A half vector of the GGX distribution about n.
Vec3f ggx_half(Vec3f n, float alpha, Random& random) {
    const float u = random.uniform(), phi = 2 * kPi * random.uniform();
    const float cosine = std::sqrt((1 - u) / (1 + (alpha * alpha - 1) * u)), sine = std::sqrt(std::max(0.f, 1 - cosine * cosine));
    Vec3f s, t;
    make_frame(n, s, t);
    return s * (sine * std::cos(phi)) + t * (sine * std::sin(phi)) + n * cosine;
}

// What the mirrored ray meets; its light comes from the cache, its own mirror images are left out.
Vec3f mirrored_radiance(const ShadeScene& scene, Vec3f origin, Vec3f direction, float angle, int mirrors, Random& random) {
    const RayHit hit = scene.bvh.first_hit(origin, direction);
    if (!hit) return sky_radiance(scene.room.sky, direction);
    const SurfacePointInfo s = surface_at(scene.room, hit, origin, direction, angle * hit.distance, false);
    const Material& m = *s.material;
    if (m.mirror > 0.5f && mirrors > 0) {
        const Vec3f out = direction - s.normal * (2 * dot(direction, s.normal));
        return mirrored_radiance(scene, s.position + s.normal * 1e-3f, out, angle, mirrors - 1, random);
    }
    Vec3f front = scene.light.near(s.position, s.normal, true), back{};
    if (m.transmission > 0) back = scene.light.near(s.position, -s.normal, true);
    return diffuse_radiance(m, s.texture.albedo, front, back) + m.emission;
}

}  // namespace

Shaded shade_ray(const ShadeScene& scene, Vec3f origin, Vec3f direction, float pixel_angle, Random& random) {
    const RayHit hit = scene.bvh.first_hit(origin, direction);
    if (!hit) return {sky_radiance(scene.room.sky, direction), {}};
    // A surface seen at a slant lies under a longer footprint; the geometric mean keeps patterns crisp and calm.
    const float slant = std::max(0.08f, std::abs(dot(hit.normal, direction)));
    const SurfacePointInfo s = surface_at(scene.room, hit, origin, direction, pixel_angle * hit.distance / std::sqrt(slant), true);
    const Material& m = *s.material;

    // Light on the front and, for thin sheets, from behind. The relief turns the sun's light; the rest is too even to show it.
    Vec3f front = scene.light.at(s.position, s.normal) + scene.lights.sun(scene.room, scene.bvh, s.position, s.bumped, random);
    // Relief darkens where it leans away from the light above.
    const float lean = dot(s.bumped - s.normal, Vec3f{0, -1, 0});
    front = front * std::clamp(1.f + 0.8f * lean, 0.5f, 1.4f);
    Vec3f back{};
    if (m.transmission > 0) back = scene.light.at(s.position, -s.normal) + scene.lights.sun(scene.room, scene.bvh, s.position, -s.normal, random);

    Shaded out{diffuse_radiance(m, s.texture.albedo, front, back) * (1.f - m.metal) + m.emission, s.texture.albedo};
    const float facing = std::clamp(-dot(s.bumped, direction), 0.02f, 1.f);
    const float grazing = std::pow(1.f - facing, 5.f), smoothness = 1.f - s.texture.roughness;
    // Schlick; rough surfaces gain less at grazing angles.
    const Vec3f f0 = lerp(Vec3f{m.specular, m.specular, m.specular}, s.texture.albedo, m.metal);
    const Vec3f edge{std::max(smoothness, f0.x), std::max(smoothness, f0.y), std::max(smoothness, f0.z)};
    Vec3f fresnel = f0 + (edge - f0) * grazing;
    if (m.mirror > 0) fresnel = lerp(fresnel, Vec3f{0.92f, 0.93f, 0.92f}, m.mirror);
    if (m.mirror < 0.5f && m.metal < 0.5f && s.texture.roughness > kMirrorRoughness) {
        out.radiance = out.radiance * (1.f - max_component(fresnel) * 0.5f) + fresnel * front * (1.f / kPi) * 0.8f;
        return out;
    }
    const float alpha = m.mirror > 0.5f ? 0.f : s.texture.roughness * s.texture.roughness;
    const Vec3f half = alpha > 1e-3f ? ggx_half(s.bumped, alpha, random) : s.bumped;
    Vec3f mirrored = direction - half * (2 * dot(direction, half));
    if (!(dot(mirrored, s.normal) > 0.01f)) mirrored = direction - s.normal * (2 * dot(direction, s.normal));
    Vec3f seen = mirrored_radiance(scene, s.position + s.normal * 1e-3f, normalize(mirrored), pixel_angle + 0.3f * alpha, 3, random);
    // A single bright thing met by chance would sparkle: it is held to a few times the light around.
    const float limit = 6.f * (luminance(front) / kPi + 0.05f), bright = luminance(seen);
    if (alpha > 1e-3f && bright > limit) seen = seen * (limit / bright);
    out.radiance = out.radiance * (1.f - max_component(fresnel)) + fresnel * seen;
    if (m.mirror > 0.5f) out.radiance = fresnel * seen;
    return out;
}

}  // namespace fastscene
