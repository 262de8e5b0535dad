// Reflection model: how a surface point reflects light. C++ calls these through trace/response.h.
#ifndef FASTSCENE_TRACE_KERNEL_RESPONSE_H
#define FASTSCENE_TRACE_KERNEL_RESPONSE_H

#include "fastscene/trace/kernel/film.h"
#include "fastscene/trace/kernel/material.h"
#include "fastscene/trace/kernel/noise.h"
#include "fastscene/trace/kernel/response_types.h"

KERNEL_BEGIN

// Rough dielectrics reflect so little and so broadly that the ambient light approximates it. The transition is gradual,
// because patterns vary the roughness (concrete) and a hard limit would show as an outline.
const float kMirrorRoughness = 0.43f, kMattRoughness = 0.55f;
// share of the coat's reflection that is taken from the base and returned diffusely
const float kKeptUnderMatt = 0.5f, kMattCoat = 0.8f;
static float mirrored_share(float roughness, float metal) {
    return metal < 0.5f ? 1.f - smooth_step(kMirrorRoughness, kMattRoughness, roughness) : 1.f;
}
// What mirror glass reflects.
static Vec3f mirror_tone() { return vec3(0.92f, 0.93f, 0.92f); }

// Reflectance by the cosine between direction and normal.
static Vec3f coat_at(IN(Coat) c, float facing) { return c.across + (c.grazing - c.across) * pow(1.f - facing, 5.f); }
// Cosine-weighted mean over the hemisphere: the fifth power integrates to 1/21.
static Vec3f coat_mean(IN(Coat) c) { return c.across + (c.grazing - c.across) * (1.f / 21); }

Coat coat_of(IN(Material) m, Vec3f albedo, float roughness, float metal) {
    const Vec3f across = lerp(vec3(m.specular, m.specular, m.specular), albedo, metal);
    const float smoothness = 1.f - roughness, alpha = roughness * roughness;
    Coat c;
    c.across = across;
    c.grazing = vec3(max(smoothness, across.x), max(smoothness, across.y), max(smoothness, across.z));
    c.sharp = mirrored_share(roughness, metal);
    c.alpha = alpha > 1e-3f ? alpha : 0.f;
    return c;
}

Response response_of(IN(Material) m, IN(TextureValue) texture, Vec3f bumped, Vec3f direction) {
    const float facing = clamp(-dot(bumped, direction), 0.02f, 1.f);
    const Coat coat = coat_of(m, texture.albedo, texture.roughness, texture.metal);
    Vec3f fresnel = coat_at(coat, facing);
    if (m.mirror > 0) fresnel = lerp(fresnel, mirror_tone(), m.mirror);

    Response r;
    r.diffuse = r.behind = vec3(0, 0, 0);
    r.specular = fresnel;
    r.alpha = 0;
    if (m.mirror > 0.5f) return r;
    Vec3f base = texture.albedo * (1.f - texture.metal);
    base = base * (1.f - max_component(fresnel) * lerp(kKeptUnderMatt, 1.f, coat.sharp));
    r.diffuse = base * (1.f - m.transmission) + fresnel * (kMattCoat * (1.f - coat.sharp));
    if (m.sheen > 0) {
        // Fibers that stand up are lit and seen along their whole length at grazing angles (after Estevez and Kulla
        // 2017, fitted by a power of the cosine).
        const float grazing = pow(max(0.f, 1.f - max(0.f, -dot(bumped, direction))), 3.f);
        r.diffuse = r.diffuse * (1.f - 0.5f * m.sheen) +
                    (texture.albedo * 0.7f + vec3(0.25f, 0.25f, 0.25f)) * (m.sheen * grazing);
    }
    r.behind = base * m.transmission;
    r.specular = fresnel * coat.sharp;
    if (coat.sharp > 0) r.alpha = coat.alpha;
    return r;
}

bool is_clear(IN(Material) m) {
    return m.transmission >= 0.75f && m.pattern == PATTERN(plain) && m.roughness < 0.2f &&
           max_component(m.emission) == 0.f;
}

bool is_flame(IN(Material) m) { return bool(m.burns) && max_component(m.emission) > 0; }

bool lets_light_pass(IN(Material) m) { return is_clear(m) || is_flame(m); }

// `normal`: the shading normal, without relief.
Vec3f flame_as_seen(float exposure_ev, Vec3f emission, Vec3f normal, Vec3f direction) {
    // In a round flame the way inside is the cosine at its surface; half of it is counted at each side. The light falls
    // off faster than that, since flames are thinner towards their edges.
    const float facing = abs(dot(normal, direction));
    return lamp_as_seen(exposure_ev, emission) * (0.5f * facing * facing);
}

Vec3f dye_of(Vec3f albedo) { return lerp(vec3(1, 1, 1), albedo / max(0.01f, max_component(albedo)), 0.4f); }

Pane pane_of(Vec3f albedo, Vec3f normal, Vec3f direction) {
    const float kAcross = 0.04f, kVeil = 0.06f;  // reflectance at normal incidence
    const float slant = 1.f - min(1.f, abs(dot(normal, direction))), slant2 = slant * slant,
                fresnel = kAcross + (1 - kAcross) * slant2 * slant2 * slant;
    Pane p;
    p.through = dye_of(albedo) * ((1 - fresnel) * (1 - kVeil));
    p.mirrored = fresnel;
    p.veil = kVeil;
    return p;
}

Vec3f mean_reflectance(IN(Material) m, Vec3f albedo, float metal) {
    if (m.mirror > 0.5f) return mirror_tone();
    const Coat coat = coat_of(m, albedo, m.roughness, metal);
    const Vec3f fresnel = coat_mean(coat),
                base = albedo *
                       ((1.f - metal) * (1.f - max_component(fresnel) * lerp(kKeptUnderMatt, 1.f, coat.sharp)));
    return base + fresnel * lerp(kMattCoat, 1.f, coat.sharp);
}

Vec3f ggx_half(Vec3f n, float alpha, Vec2f u) {
    if (!(alpha > 0)) return n;
    const float phi = 2 * kPi * u.y;
    const float cosine = sqrt((1 - u.x) / (1 + (alpha * alpha - 1) * u.x)), sine = sqrt(max(0.f, 1 - cosine * cosine));
    Vec3f s, t;
    make_frame(n, s, t);
    return s * (sine * cos(phi)) + t * (sine * sin(phi)) + n * cosine;
}

float ggx_pdf(Vec3f n, float alpha, Vec3f direction, Vec3f outgoing) {
    const Vec3f halfway = normalize(outgoing - direction);
    const float c = dot(n, halfway), o = dot(outgoing, halfway);
    if (!(c > 0 && o > 1e-4f) || !(alpha > 0)) return 0;
    const float a2 = alpha * alpha, k = c * c * (a2 - 1) + 1;
    return a2 / (kPi * k * k) * c / (4 * o);
}

// Reflection of the sun's disc by a GGX lobe at least `least_alpha` wide, towards -direction, per unit of irradiance.
// Zero for perfect mirrors.
static float sun_spread(Vec3f sun_dir, Vec3f normal, float alpha, float least_alpha, Vec3f direction) {
    const float cosine = dot(normal, sun_dir);
    return alpha > 0 && cosine > 0 ? ggx_pdf(normal, max(alpha, least_alpha), direction, sun_dir) / cosine : 0.f;
}

Vec3f sun_glint(Vec3f sun_dir, Vec3f bumped, IN(Response) response, Vec3f direction, Vec3f sun, float least_alpha) {
    return response.specular * sun * sun_spread(sun_dir, bumped, response.alpha, least_alpha, direction);
}

Vec3f sun_reflected(Vec3f sun_dir, Vec3f reflectance, IN(Coat) coat, float transmission, Vec3f normal, Vec3f direction,
                    bool behind) {
    const Vec3f even = (reflectance - coat_mean(coat) * coat.sharp) * (1 / kPi);
    if (behind) return even * transmission;
    const float facing = clamp(-dot(normal, direction), 0.02f, 1.f);
    return even * (1.f - transmission) +
           coat_at(coat, facing) * (coat.sharp * sun_spread(sun_dir, normal, coat.alpha, kWideSun, direction));
}

Vec3f cosine_direction(Vec3f n, Vec2f u) {
    Vec3f s, t;
    make_frame(n, s, t);
    const float r = sqrt(u.x), phi = 2 * kPi * u.y;
    return s * (r * cos(phi)) + t * (r * sin(phi)) + n * sqrt(max(0.f, 1 - u.x));
}

KERNEL_END

#endif
