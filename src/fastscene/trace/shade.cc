#include "fastscene/trace/shade.h"

#include <algorithm>
#include <cmath>

#include "fastscene/trace/film.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/sky.h"
#include "fastscene/trace/surface.h"

namespace fastscene {
namespace {

// What the mirrored ray meets: a lamp or the sky, which could have been asked as well, and what they light.
struct Mirrored {
    Vec3f light, rest;
    RayHit hit;
};
// Its light comes from the cache, its own gloss is taken for matt. `sharp`: seen as clearly as by the camera itself.
Mirrored mirrored_radiance(const ShadeScene& scene, Vec3f origin, Vec3f direction, float angle, bool sharp,
                           int mirrors) {
    const RayHit hit = sharp && mirrors > 0 ? scene.bvh.first_hit(origin, direction)
                                            : scene.bvh.first_lit(origin, direction);
    if (!hit)
        return {sharp ? outside_as_seen(scene.room.sky, scene.room.look, direction)
                      : sky_radiance(scene.room.sky, direction),
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
    // Between cells, or a polished floor would show them.
    const IrradianceCache::Reading front = scene.light.read(s.position, s.normal),
                                   back = m.transmission > 0 ? scene.light.read(s.position, -s.normal)
                                                             : IrradianceCache::Reading{};
    const Vec3f reflectance = mean_reflectance(m, s.texture.albedo);
    const Coat coat = m.mirror > 0.5f ? Coat{} : coat_of(m, s.texture.albedo, s.texture.roughness);
    const auto reflected = [&](bool behind) {
        return sun_reflected(scene.room.sky, reflectance, coat, m.transmission, s.normal, direction, behind);
    };
    const Vec3f even = reflectance * (front.irradiance * (1.f - m.transmission) + back.irradiance * m.transmission) *
                       (1.f / kPi),
                sun = front.sun * reflected(false) + back.sun * reflected(true);
    return {sharp ? lamp_as_seen(scene.room.look, m.emission) : m.emission, even + sun * scene.room.look.sun_seen, hit};
}

// What a glossy surface mirrors, by one ray into its mirror cone and one to a lamp or window, each weighed by how well
// it finds such light: small lights are found by asking, near and smooth ones by the cone.
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
            asked = light.radiance * (cone * power_heuristic(light.pdf, cone) / light.pdf);
    }
    if (max_component(seen.light) > 0) {
        const float pdf = scene.lights.pdf(scene.room, s.position, s.normal, out, seen.hit);
        seen.light = seen.light * power_heuristic(ggx_pdf(s.bumped, r.alpha, direction, out), pdf);
    }
    Vec3f met = seen.light + seen.rest;
    // A single bright thing met by chance would sparkle: it is held to a few times the light around.
    const float limit = 6.f * (luminance(front) / kPi + 0.05f), bright = luminance(met);
    if (bright > limit) met = met * (limit / bright);
    return asked + met;
}

// How probable it is that a frugal picture traces what a surface mirrors: the more, the more of what it sends on that
// is. A coat of 4 % over a light wall costs three rays of four and adds a twentieth.
float reflection_probability(const Response& r) {
    constexpr float kOften = 4.f, kLeast = 0.15f;
    if (r.alpha == 0) return 1;  // a mirror's image is sharp
    const float specular = luminance(r.specular), all = specular + luminance(r.diffuse) + luminance(r.behind);
    return std::clamp(kOften * specular / std::max(1e-6f, all), kLeast, 1.f);
}

// Light on a surface, without the sun's own: from the cache, and where that is too coarse, one estimate of the very
// point.
Vec3f light_at(const ShadeScene& scene, const SurfacePointInfo& s, Sampler& sampler) {
    const IrradianceCache::Reading reading = scene.light.read(s.position, s.normal);
    constexpr float kTrusted = 0.98f;
    if (!scene.contacts || reading.trust > kTrusted) return reading.irradiance;
    const IrradianceCache::Place here{s.position, s.normal};
    const float which = sampler.next();
    const Vec2f uv = sampler.next2(), way = sampler.next2();
    const Vec3f asked = scene.light.direct(scene.room, scene.bvh, scene.lights, here, which, uv);
    const Vec3f found = scene.light.bounced(scene.room, scene.bvh, scene.lights, here, way).irradiance;
    return reading.irradiance * reading.trust + (asked + found) * (1 - reading.trust);
}

}  // namespace

namespace {

constexpr int kMostPanes = 8;  // surfaces of glass that are looked through
constexpr float kBehindPane_m = 1e-3f;

// `travelled`: how far the ray has come through glass.
Shaded shade_from(const ShadeScene& scene, Vec3f origin, Vec3f direction, float pixel_angle, float travelled, int panes,
                  Sampler& sampler);

// The surface of glass `s` shaded as `veil`: what is behind it, a veil, and what it mirrors.
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
        out.radiance = outside_as_seen(scene.room.sky, scene.room.look, direction);
        return out;
    }
    // A surface seen at a slant lies under a longer footprint; the geometric mean keeps patterns crisp and calm.
    const float slant = std::max(0.08f, std::abs(dot(hit.normal, direction)));
    const SurfacePointInfo s = surface_at(scene.room, hit, origin, direction,
                                          pixel_angle * (travelled + hit.distance) / std::sqrt(slant), true);
    const Material& m = *s.material;
    Response r = response_of(s, direction);
    if (m.mirror <= 0.5f && max_component(r.specular) > 0) r.alpha = std::max(r.alpha, scene.min_alpha);
    out.albedo = s.texture.albedo;
    out.position = s.position;
    out.normal = s.normal;

    // Light on the front and, for thin sheets, from behind. The relief turns the sun's light; the rest is too even to
    // show it.
    const Vec2f disc = sampler.next2();
    const auto sun = [&](Vec3f normal) {
        return scene.lights.sun(scene.room, scene.bvh, s.position, normal, disc) * scene.room.look.sun_seen;
    };
    // Relief darkens where it leans away from the light above.
    const float lean = dot(s.bumped - s.normal, Vec3f{0, -1, 0}), relief = std::clamp(1.f + 0.8f * lean, 0.5f, 1.4f);
    const Vec3f front = light_at(scene, s, sampler) * relief, front_sun = sun(s.bumped) * relief;
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
    out.radiance = lamp_as_seen(scene.room.look, m.emission) + out.light + out.sun + out.mirrored;
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
