#include "fastscene/trace/response.h"

#include <algorithm>
#include <cmath>

#include "fastscene/trace/film.h"
#include "fastscene/trace/noise.h"

namespace fastscene {
namespace {

// Rough dielectrics reflect so little and so broadly that the ambient light approximates it. The transition is gradual,
// because patterns vary the roughness (concrete) and a hard limit would show as an outline.
constexpr float kMirrorRoughness = 0.43f, kMattRoughness = 0.55f;
constexpr float kKeptUnderMatt = 0.5f,
                kMattCoat = 0.8f;  // share of the coat's reflection that is taken from the base and returned diffusely
float mirrored_share(float roughness, float metal) {
    return metal < 0.5f ? 1.f - smooth_step(kMirrorRoughness, kMattRoughness, roughness) : 1.f;
}

}  // namespace

Vec3f Coat::at(float facing) const { return across + (grazing - across) * std::pow(1.f - facing, 5.f); }
Vec3f Coat::mean() const { return across + (grazing - across) * (1.f / 21); }  // the fifth power integrates to 1/21

Coat coat_of(const Material& m, Vec3f albedo, float roughness) {
    const Vec3f across = lerp(Vec3f{m.specular, m.specular, m.specular}, albedo, m.metal);
    const float smoothness = 1.f - roughness, alpha = roughness * roughness;
    return {across,
            {std::max(smoothness, across.x), std::max(smoothness, across.y), std::max(smoothness, across.z)},
            mirrored_share(roughness, m.metal),
            alpha > 1e-3f ? alpha : 0.f};
}

Response response_of(const SurfacePointInfo& s, Vec3f direction) {
    const Material& m = *s.material;
    const float facing = std::clamp(-dot(s.bumped, direction), 0.02f, 1.f);
    const Coat coat = coat_of(m, s.texture.albedo, s.texture.roughness);
    Vec3f fresnel = coat.at(facing);
    if (m.mirror > 0) fresnel = lerp(fresnel, Vec3f{0.92f, 0.93f, 0.92f}, m.mirror);

    Response r;
    Vec3f base = s.texture.albedo * (1.f - m.metal);
    if (m.mirror > 0.5f) {
        r.specular = fresnel;
        return r;
    }
    base = base * (1.f - max_component(fresnel) * std::lerp(kKeptUnderMatt, 1.f, coat.sharp));
    r.diffuse = base * (1.f - m.transmission) + fresnel * (kMattCoat * (1.f - coat.sharp));
    if (m.sheen > 0) {
        // Fibers that stand up are lit and seen along their whole length at grazing angles (after Estevez and Kulla
        // 2017, fitted by a power of the cosine).
        const float grazing = std::pow(1.f - std::max(0.f, -dot(s.bumped, direction)), 3.f);
        r.diffuse = r.diffuse * (1.f - 0.5f * m.sheen) +
                    (s.texture.albedo * 0.7f + Vec3f{0.25f, 0.25f, 0.25f}) * (m.sheen * grazing);
    }
    r.behind = base * m.transmission;
    r.specular = fresnel * coat.sharp;
    if (coat.sharp > 0) r.alpha = coat.alpha;
    return r;
}

bool is_clear(const Material& m) {
    return m.transmission >= 0.75f && m.pattern == Pattern::plain && m.roughness < 0.2f &&
           max_component(m.emission) == 0.f;
}

bool is_flame(const Material& m) { return m.burns && max_component(m.emission) > 0; }
bool lets_light_pass(const Material& m) { return is_clear(m) || is_flame(m); }

Vec3f flame_as_seen(const Look& look, const SurfacePointInfo& s, Vec3f direction) {
    // In a round flame the way inside is the cosine at its surface; half of it is counted at each side. The light falls
    // off faster than that, since flames are thinner towards their edges.
    const float facing = std::abs(dot(s.normal, direction));
    return lamp_as_seen(look, s.material->emission) * (0.5f * facing * facing);
}

Vec3f dye_of(const SurfacePointInfo& s) {
    return lerp(Vec3f{1, 1, 1}, s.texture.albedo / std::max(0.01f, max_component(s.texture.albedo)), 0.4f);
}

Pane pane_of(const SurfacePointInfo& s, Vec3f direction) {
    constexpr float kAcross = 0.04f, kVeil = 0.06f;  // reflectance at normal incidence
    const float slant = 1.f - std::min(1.f, std::abs(dot(s.normal, direction))), slant2 = slant * slant,
                fresnel = kAcross + (1 - kAcross) * slant2 * slant2 * slant;
    return {dye_of(s) * ((1 - fresnel) * (1 - kVeil)), fresnel, kVeil};
}

Vec3f mean_reflectance(const Material& m, Vec3f albedo) {
    if (m.mirror > 0.5f) return Vec3f{0.92f, 0.93f, 0.92f};
    const Coat coat = coat_of(m, albedo, m.roughness);
    const Vec3f fresnel = coat.mean(),
                base = albedo *
                       ((1.f - m.metal) * (1.f - max_component(fresnel) * std::lerp(kKeptUnderMatt, 1.f, coat.sharp)));
    return base + fresnel * std::lerp(kMattCoat, 1.f, coat.sharp);
}

Vec3f ggx_half(Vec3f n, float alpha, Vec2f u) {
    if (!(alpha > 0)) return n;
    const float phi = 2 * kPi * u.y;
    const float cosine = std::sqrt((1 - u.x) / (1 + (alpha * alpha - 1) * u.x)),
                sine = std::sqrt(std::max(0.f, 1 - cosine * cosine));
    Vec3f s, t;
    make_frame(n, s, t);
    return s * (sine * std::cos(phi)) + t * (sine * std::sin(phi)) + n * cosine;
}

float ggx_pdf(Vec3f n, float alpha, Vec3f direction, Vec3f out) {
    const Vec3f half = normalize(out - direction);
    const float c = dot(n, half), o = dot(out, half);
    if (!(c > 0 && o > 1e-4f) || !(alpha > 0)) return 0;
    const float a2 = alpha * alpha, k = c * c * (a2 - 1) + 1;
    return a2 / (kPi * k * k) * c / (4 * o);
}

namespace {

// Reflection of the sun's disc by a GGX lobe at least `least_alpha` wide, towards -direction, per unit of irradiance.
// Zero for perfect mirrors.
float sun_spread(const Sky& sky, Vec3f normal, float alpha, float least_alpha, Vec3f direction) {
    const float cosine = dot(normal, sky.sun_dir);
    return alpha > 0 && cosine > 0 ? ggx_pdf(normal, std::max(alpha, least_alpha), direction, sky.sun_dir) / cosine
                                   : 0.f;
}

}  // namespace

Vec3f sun_glint(const Sky& sky, const SurfacePointInfo& surface, const Response& response, Vec3f direction, Vec3f sun,
                float least_alpha) {
    return response.specular * sun * sun_spread(sky, surface.bumped, response.alpha, least_alpha, direction);
}

Vec3f sun_reflected(const Sky& sky, Vec3f reflectance, const Coat& coat, float transmission, Vec3f normal,
                    Vec3f direction, bool behind) {
    const Vec3f even = (reflectance - coat.mean() * coat.sharp) * (1 / kPi);
    if (behind) return even * transmission;
    const float facing = std::clamp(-dot(normal, direction), 0.02f, 1.f);
    return even * (1.f - transmission) +
           coat.at(facing) * (coat.sharp * sun_spread(sky, normal, coat.alpha, kWideSun, direction));
}

Vec3f cosine_direction(Vec3f n, Vec2f u) {
    Vec3f s, t;
    make_frame(n, s, t);
    const float r = std::sqrt(u.x), phi = 2 * kPi * u.y;
    return s * (r * std::cos(phi)) + t * (r * std::sin(phi)) + n * std::sqrt(std::max(0.f, 1 - u.x));
}

}  // namespace fastscene
