// The reflection model (trace/response.cc).
const float kMirrorRoughness = 0.43, kMattRoughness = 0.55, kKeptUnderMatt = 0.5, kMattCoat = 0.8;
const float kSharpestSun = 0.1, kWideSun = 0.2;

struct Response {
    vec3 diffuse, behind, specular;
    float alpha;
};
struct Coat {
    vec3 across, grazing;
    float sharp, alpha;
};
vec3 coat_at(Coat c, float facing) { return c.across + (c.grazing - c.across) * pow(max(0, 1 - facing), 5.0); }
vec3 coat_mean(Coat c) { return c.across + (c.grazing - c.across) * (1.f / 21); }
Coat no_coat() { return Coat(vec3(0), vec3(0), 0, 0); }
Coat coat_of(Material m, vec3 albedo, float roughness) {
    const vec3 across = mix(vec3(m.specular), albedo, m.metal);
    const float smoothness = 1 - roughness, alpha = roughness * roughness;
    return Coat(across, max(vec3(smoothness), across),
                m.metal < 0.5f ? 1 - smooth_step(kMirrorRoughness, kMattRoughness, roughness) : 1,
                alpha > 1e-3f ? alpha : 0);
}
Response response_of(Material m, SurfacePoint s, vec3 direction) {
    const float facing = clamp(-dot(s.bumped, direction), 0.02f, 1.f);
    const Coat coat = coat_of(m, s.albedo, s.roughness);
    vec3 fresnel = coat_at(coat, facing);
    if (m.mirror > 0) fresnel = mix(fresnel, vec3(0.92f, 0.93f, 0.92f), m.mirror);
    Response r = Response(vec3(0), vec3(0), vec3(0), 0);
    if (m.mirror > 0.5f) {
        r.specular = fresnel;
        return r;
    }
    const vec3 base = s.albedo * (1 - m.metal) * (1 - max_component(fresnel) * mix(kKeptUnderMatt, 1.f, coat.sharp));
    r.diffuse = base * (1 - m.transmission) + fresnel * (kMattCoat * (1 - coat.sharp));
    if (m.sheen > 0) {
        const float grazing = pow(max(0, 1 - max(0, -dot(s.bumped, direction))), 3.0);
        r.diffuse = r.diffuse * (1 - 0.5f * m.sheen) + (s.albedo * 0.7f + 0.25f) * (m.sheen * grazing);
    }
    r.behind = base * m.transmission;
    r.specular = fresnel * coat.sharp;
    if (coat.sharp > 0) r.alpha = coat.alpha;
    return r;
}
bool is_clear(Material m) {
    return m.transmission >= 0.75f && m.pattern == Pattern_plain && m.roughness < 0.2f &&
           max_component(m.emission) == 0;
}
bool is_flame(Material m) { return m.burns != 0 && max_component(m.emission) > 0; }
vec3 flame_as_seen(World w, vec3 emission, vec3 normal, vec3 direction) {
    const float facing = abs(dot(normal, direction));
    return lamp_as_seen(w, emission) * (0.5f * facing * facing);
}
vec3 dye_of(vec3 albedo) { return mix(vec3(1), albedo / max(0.01f, max_component(albedo)), 0.4f); }
struct Pane {
    vec3 through;
    float mirrored, veil;
};
Pane pane_of(SurfacePoint s, vec3 direction) {
    const float slant = 1 - min(1, abs(dot(s.normal, direction))), slant2 = slant * slant,
                fresnel = 0.04f + 0.96f * slant2 * slant2 * slant;
    return Pane(dye_of(s.albedo) * ((1 - fresnel) * (1 - 0.06f)), fresnel, 0.06f);
}
vec3 mean_reflectance(Material m, vec3 albedo) {
    if (m.mirror > 0.5f) return vec3(0.92f, 0.93f, 0.92f);
    const Coat coat = coat_of(m, albedo, m.roughness);
    const vec3 fresnel = coat_mean(coat),
               base = albedo * ((1 - m.metal) * (1 - max_component(fresnel) * mix(kKeptUnderMatt, 1.f, coat.sharp)));
    return base + fresnel * mix(kMattCoat, 1.f, coat.sharp);
}
vec3 ggx_half(vec3 n, float alpha, vec2 u) {
    if (!(alpha > 0)) return n;
    const float phi = 2 * kPi * u.y, cosine = sqrt((1 - u.x) / (1 + (alpha * alpha - 1) * u.x)),
                sine = sqrt(max(0, 1 - cosine * cosine));
    vec3 s, t;
    make_frame(n, s, t);
    return s * (sine * cos(phi)) + t * (sine * sin(phi)) + n * cosine;
}
float ggx_pdf(vec3 n, float alpha, vec3 direction, vec3 towards) {
    const vec3 between = normalized(towards - direction);
    const float c = dot(n, between), o = dot(towards, between);
    if (!(c > 0 && o > 1e-4f) || !(alpha > 0)) return 0;
    const float a2 = alpha * alpha, k = c * c * (a2 - 1) + 1;
    return a2 / (kPi * k * k) * c / (4 * o);
}
float sun_spread(vec3 sun, vec3 normal, float alpha, float least_alpha, vec3 direction) {
    const float cosine = dot(normal, sun);
    return alpha > 0 && cosine > 0 ? ggx_pdf(normal, max(alpha, least_alpha), direction, sun) / cosine : 0;
}
vec3 sun_glint(vec3 sun_dir, vec3 bumped, Response r, vec3 direction, vec3 sun, float least_alpha) {
    return r.specular * sun * sun_spread(sun_dir, bumped, r.alpha, least_alpha, direction);
}
vec3 sun_reflected(vec3 sun_dir, vec3 reflectance, Coat coat, float transmission, vec3 normal, vec3 direction,
                   bool behind) {
    const vec3 even = (reflectance - coat_mean(coat) * coat.sharp) * (1 / kPi);
    if (behind) return even * transmission;
    const float facing = clamp(-dot(normal, direction), 0.02f, 1.f);
    return even * (1 - transmission) +
           coat_at(coat, facing) * (coat.sharp * sun_spread(sun_dir, normal, coat.alpha, kWideSun, direction));
}
vec3 cosine_direction(vec3 n, vec2 u) {
    vec3 s, t;
    make_frame(n, s, t);
    const float r = sqrt(u.x), phi = 2 * kPi * u.y;
    return s * (r * cos(phi)) + t * (r * sin(phi)) + n * sqrt(max(0, 1 - u.x));
}
