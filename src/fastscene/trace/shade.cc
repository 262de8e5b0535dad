#include "fastscene/trace/shade.h"

#include <algorithm>
#include <cmath>

#include "fastscene/trace/film.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/surface.h"

namespace fastscene {
namespace {

// What a reflected ray hits: a light that could also have been sampled (lamp or sky), and other surfaces.
struct Mirrored {
    Vec3f light, rest;
    RayHit hit;
};
// Hits are shaded from the cache, as if matt. `sharp`: as sharp as for the camera itself.
Mirrored mirrored_radiance(const ShadeScene& scene, Vec3f origin, Vec3f direction, float angle, bool sharp,
                           int mirrors) {
    const RayHit hit = sharp && mirrors > 0 ? scene.bvh.first_hit(origin, direction)
                                            : scene.bvh.first_lit(origin, direction);
    if (!hit)
        return {sharp ? outside_as_seen(scene.room.sky, scene.room.look, scene.lights.outdoors().seen(direction))
                      : scene.lights.outdoors().light(direction),
                {},
                hit};
    const SurfacePointInfo s = surface_at(scene.room, hit, origin, direction, angle * hit.distance, false);
    const Material& m = *s.material;
    if (m.mirror > 0.5f && mirrors > 0) {
        const Vec3f out = direction - s.normal * (2 * dot(direction, s.normal));
        const Mirrored behind = mirrored_radiance(scene, s.position + s.normal * 1e-3f, out, angle, sharp, mirrors - 1);
        return {{}, behind.light + behind.rest, hit};
    }
    if (is_clear(m)) {
        const Mirrored behind = mirrored_radiance(scene, s.position + direction * 1e-3f, direction, angle, sharp,
                                                  mirrors - 1);
        const Vec3f dye = dye_of(s);
        return {behind.light * dye, behind.rest * dye, hit};
    }
    // Interpolated between cells, since a polished floor would show their borders.
    const IrradianceCache::Reading front = scene.light.read(s.position, s.normal),
                                   back = m.transmission > 0 ? scene.light.read(s.position, -s.normal)
                                                             : IrradianceCache::Reading{};
    const Vec3f reflectance = mean_reflectance(m, s.texture.albedo, s.texture.metal);
    const Coat coat = m.mirror > 0.5f ? Coat{} : coat_of(m, s.texture.albedo, s.texture.roughness, s.texture.metal);
    const auto reflected = [&](bool behind) {
        return sun_reflected(scene.room.sky, reflectance, coat, m.transmission, s.normal, direction, behind);
    };
    const Vec3f even = reflectance * (front.irradiance * (1.f - m.transmission) + back.irradiance * m.transmission) *
                       (1.f / kPi),
                sun = front.sun * reflected(false) + back.sun * reflected(true);
    return {sharp ? emission_as_seen(scene.room.look, s) : s.emission(), even + sun * scene.room.look.sun_seen, hit};
}

// The glossy reflection: one sample of the GGX lobe and one light sample, combined by MIS. Light sampling finds small
// lights, the lobe finds near ones and those in smooth surfaces.
Vec3f glossy_radiance(const ShadeScene& scene, const SurfacePointInfo& s, const Response& r, Vec3f direction,
                      float pixel_angle, Vec3f front, Sampler& sampler) {
    const Vec3f half = ggx_half(s.bumped, r.alpha, sampler.next2());
    Vec3f out = direction - half * (2 * dot(direction, half));
    if (!(dot(out, s.normal) > 0.01f)) out = direction - s.normal * (2 * dot(direction, s.normal));
    out = normalize(out);
    const Vec3f origin = offset_from(s.position, s.normal);
    Mirrored seen = mirrored_radiance(scene, origin, out, pixel_angle + 0.3f * r.alpha, r.alpha == 0, 3);
    if (r.alpha == 0) return seen.light + seen.rest;
    Vec3f asked{};
    const float which = sampler.next();
    const Vec2f uv = sampler.next2();
    const Lights::LightSample light = scene.lights.draw(scene.room, s.position, s.normal, which, uv);
    if (light.pdf > 0 && dot(light.direction, s.normal) > 0.01f) {
        const float cone = ggx_pdf(s.bumped, r.alpha, direction, light.direction);
        if (cone > 0 && !scene.bvh.blocked(origin, light.direction, 0.f, light.far))
            asked = light.radiance * (cone * light.weight(cone) / light.pdf);
    }
    if (max_component(seen.light) > 0) {
        const float pdf = scene.lights.pdf(scene.room, s.position, s.normal, out, seen.hit);
        seen.light = seen.light * power_heuristic(ggx_pdf(s.bumped, r.alpha, direction, out), pdf);
    }
    Vec3f met = seen.light + seen.rest;
    // Fireflies: a bright light hit by a lobe sample is clamped to a few times the surrounding light.
    const float limit = 6.f * (luminance(front) / kPi + 0.05f), bright = luminance(met);
    if (bright > limit) met = met * (limit / bright);
    return asked + met;
}

// Probability with which a frugal picture traces a reflection (Russian roulette), by its share of the reflected light.
// A 4 % coat over a light wall would cost three quarters of the rays for a twentieth of the light.
float reflection_probability(const Response& r) {
    constexpr float kOften = 4.f, kLeast = 0.15f;
    if (r.alpha == 0) return 1;  // mirror images must be sharp
    const float specular = luminance(r.specular), all = specular + luminance(r.diffuse) + luminance(r.behind);
    return std::clamp(kOften * specular / std::max(1e-6f, all), kLeast, 1.f);
}

// Irradiance of the relief at a point without direct sun: from the cache, or where that is too coarse, from a fresh
// one-sample estimate.
Vec3f light_at(const ShadeScene& scene, const SurfacePointInfo& s, Sampler& sampler) {
    const IrradianceCache::Reading reading = scene.light.read(s.position, s.normal);
    constexpr float kTrusted = 0.98f;
    const float relief = relief_light(reading.direction, s.normal, s.bumped);
    if (!scene.contacts || reading.trust > kTrusted) return reading.irradiance * relief;
    const IrradianceCache::Place here{s.position, s.normal};
    const float which = sampler.next();
    const Vec2f uv = sampler.next2(), way = sampler.next2();
    const Vec3f asked = scene.light.direct(scene.room, scene.bvh, scene.lights, here, which, uv).irradiance();
    const Vec3f found = scene.light.bounced(scene.room, scene.bvh, scene.lights, here, way).irradiance;
    return (reading.irradiance * reading.trust + (asked + found) * (1 - reading.trust)) * relief;
}

}  // namespace

namespace {

constexpr int kMostPanes = 16;  // maximum number of glass surfaces and flames along a view ray
constexpr float kBehindPane_m = 1e-3f;

// `travelled`: metres that the ray has covered, through glass.
Shaded shade_from(const ShadeScene& scene, Vec3f origin, Vec3f direction, float pixel_angle, float travelled, int panes,
                  Sampler& sampler);

// Shades a clear glass surface `s`: what is behind it, `veil` and its reflection.
Shaded seen_through(const ShadeScene& scene, const SurfacePointInfo& s, const Shaded& veil, Vec3f direction,
                    float pixel_angle, float travelled, int panes, Sampler& sampler) {
    const Pane pane = pane_of(s, direction);
    Shaded out = shade_from(scene, s.position + direction * kBehindPane_m, direction, pixel_angle, travelled, panes - 1,
                            sampler);
    for (Vec3f* light : {&out.radiance, &out.light, &out.sun, &out.mirrored, &out.diffuse, &out.specular})
        *light = *light * pane.through;
    const Vec3f mirror = normalize(direction - s.normal * (2 * dot(direction, s.normal)));
    const Mirrored seen = mirrored_radiance(scene, offset_from(s.position, s.normal), mirror, pixel_angle, true, 1);
    out.radiance += veil.radiance * pane.veil + (seen.light + seen.rest) * pane.mirrored;
    return out;
}

Shaded shade_from(const ShadeScene& scene, Vec3f origin, Vec3f direction, float pixel_angle, float travelled, int panes,
                  Sampler& sampler) {
    const RayHit hit = scene.bvh.first_hit(origin, direction);
    Shaded out{};
    if (!hit) {
        out.radiance = outside_as_seen(scene.room.sky, scene.room.look, scene.lights.outdoors().seen(direction));
        return out;
    }
    // On a slanted surface the footprint is stretched; the geometric mean of its axes keeps patterns sharp without
    // aliasing.
    const float slant = std::max(0.08f, std::abs(dot(hit.normal, direction)));
    const SurfacePointInfo s = surface_at(scene.room, hit, origin, direction,
                                          pixel_angle * (travelled + hit.distance) / std::sqrt(slant), true);
    const Material& m = *s.material;
    if (is_flame(m) && panes > 0) {
        out = shade_from(scene, s.position + direction * kBehindPane_m, direction, pixel_angle,
                         travelled + hit.distance, panes - 1, sampler);
        out.radiance += flame_as_seen(scene.room.look, s, direction);
        return out;
    }
    Response r = response_of(s, direction);
    if (m.mirror <= 0.5f && max_component(r.specular) > 0) r.alpha = std::max(r.alpha, scene.min_alpha);
    out.albedo = s.texture.albedo;
    out.position = s.position;
    out.normal = s.normal;

    // Light on the front, and from behind for thin sheets.
    const Vec2f disc = sampler.next2();
    const auto sun = [&](Vec3f normal) {
        return scene.lights.sun(scene.room, scene.bvh, s.position, normal, disc) * scene.room.look.sun_seen;
    };
    const Vec3f front = light_at(scene, s, sampler), front_sun = sun(s.bumped);
    out.diffuse = r.diffuse;
    out.light = r.diffuse * front * (1.f / kPi);
    out.sun = r.diffuse * front_sun * (1.f / kPi);
    if (m.transmission > 0) {
        out.diffuse += r.behind;
        out.light += r.behind * scene.light.at(s.position, -s.normal) * (1.f / kPi);
        out.sun += r.behind * sun(-s.normal) * (1.f / kPi);
    }
    if (max_component(r.specular) > 0) {
        out.specular = r.specular;
        const float probability = scene.frugal ? reflection_probability(r) : 1.f;
        if (probability == 1.f || sampler.next() < probability)
            out.mirrored = r.specular *
                           glossy_radiance(scene, s, r, direction, pixel_angle, front + front_sun, sampler) /
                           probability;
        if (luminance(front_sun) > 0)
            out.mirrored += sun_glint(scene.room.sky, s, r, direction, front_sun, kSharpestSun);
    }
    out.radiance = emission_as_seen(scene.room.look, s) + out.light + out.sun + out.mirrored;
    if (panes > 0 && is_clear(m))
        return seen_through(scene, s, out, direction, pixel_angle, travelled + hit.distance, panes, sampler);
    return out;
}

}  // namespace

Shaded shade_ray(const ShadeScene& scene, Vec3f origin, Vec3f direction, float pixel_angle, Sampler& sampler) {
    return shade_from(scene, origin, direction, pixel_angle, 0.f, kMostPanes, sampler);
}

Met met_by_ray(const ShadeScene& scene, Vec3f origin, Vec3f direction) {
    for (int panes = kMostPanes;; --panes) {
        const RayHit hit = scene.bvh.first_hit(origin, direction);
        if (!hit) return {};
        const Mesh& mesh = scene.room.meshes[static_cast<std::size_t>(hit.mesh)];
        const Vec3f position = origin + direction * hit.distance;
        if (panes == 0 || !is_clear(scene.room.materials[static_cast<std::size_t>(mesh.material)])) {
            const Vec3f normal = shading_normal(mesh, hit);
            return {position, hit.back ? -normal : normal};
        }
        origin = position + direction * kBehindPane_m;
    }
}

}  // namespace fastscene
