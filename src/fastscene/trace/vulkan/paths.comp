// Path tracing without a cache (trace/path.cc): an invocation a pixel, which starts its next path when one ends, so
// that its neighbours do not wait for the longest. The one place where a path meets a surface is the loop's body.
#version 460
#include "tables.glsl"
#include "traverse.glsl"
#include "surface.glsl"
#include "outdoors.glsl"
#include "lights.glsl"
#include "camera.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push {
    World w;
    Camera camera;
    Words pixels;      // x | y << 16
    InOutVec4s sums;   // of radiance, a pixel of the list
    uint count, first, samples;
    float pixel_angle;
};

const int kMaxBounces = 48, kSureBounces = 3;

// The BSDF towards -direction for light from `towards`, including the cosine, and the pdf of sampling it.
struct Scatter {
    vec3 value;
    float pdf;
};
Scatter scatter_of(SurfacePoint s, Response r, vec3 direction, float p_specular, float p_behind, vec3 towards) {
    const float cosine = dot(s.normal, towards);
    if (!(cosine > 0)) return Scatter(r.behind * (-cosine / kPi), p_behind * -cosine / kPi);
    Scatter e = Scatter(r.diffuse * (max(0, dot(s.bumped, towards)) / kPi), (1 - p_specular - p_behind) * cosine / kPi);
    if (r.alpha > 0) {
        const float d = ggx_pdf(s.bumped, r.alpha, direction, towards);
        e.value += r.specular * d;
        e.pdf += p_specular * d;
    }
    return e;
}

void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    const uint place = pixels.at[i];
    const uvec2 pixel = uvec2(place & 0xffff, place >> 16);
    const Lens lens = lens_of(camera);
    const vec4 sun_and_share = world_sun(w);
    vec3 total = sums.at[i].xyz;

    Sampler random;
    bool alive = false;
    uint path = first;
    // Of the path: what it has gathered, and its next ray.
    vec3 sum, throughput, origin, direction;
    float width, travelled;
    bool is_first, looking;
    int bounce;
    // How it came to the next surface.
    float arrival_pdf;
    bool arrival_lights;
    vec3 arrival_from, arrival_normal;
    for (;; ++bounce) {
        if (!alive) {
            if (path == first + samples) break;
            random = Sampler(key_of_pixel(lens, pixel), path++, 0);
            const Ray ray = camera_ray(lens, vec2(pixel) + next2(random));
            origin = ray.origin, direction = ray.direction;
            sum = vec3(0), throughput = vec3(1), width = pixel_angle, travelled = 0;
            is_first = looking = alive = true;
            bounce = 0, arrival_pdf = 0, arrival_lights = false;
            arrival_from = arrival_normal = vec3(0);
        }
        const bool clearly = looking && !(arrival_pdf > 0);
        const Hit hit = trace_ray(w, origin, direction, kFar, clearly ? 0 : kLit);
        HitSurface on = HitSurface(kNone, 0, vec3(0), false);
        if (hit.place != kNone) on = hit_surface(w, hit, direction);
        float mis_weight = 1;
        if (arrival_lights)
            mis_weight = power_heuristic(arrival_pdf, light_pdf(w, arrival_from, arrival_normal, direction, on.triangle,
                                                                on.mesh, on.normal, on.back, hit.distance));
        if (hit.place == kNone) {
            total += sum + throughput * outside_of(w, direction, clearly) * mis_weight;
            alive = false;
            continue;
        }
        travelled += hit.distance;
        const float slant = max(0.08f, abs(dot(on.normal, direction)));
        Material m = w.materials.at[w.meshes.at[on.mesh].x];
        const SurfacePoint s = surface_at(w, m, hit, on, origin, direction, width * travelled / sqrt(slant), is_first);
        const vec3 ahead = dot(direction, s.normal) > 0 ? s.normal : -s.normal;
        bool passes = false;
        if (clearly && is_flame(m)) {
            sum += throughput * flame_as_seen(world_ground(w).w, m.emission, s.normal, direction);
            origin = s.position + ahead * kSurfaceOffset;
            passes = true;
        } else {
            sum += throughput * (clearly ? lamp_seen(w, m.emission) : m.emission) * s.texture.shown * mis_weight;
            if (clearly && is_clear(m)) {
                const Pane pane = pane_of(s.texture.albedo, s.normal, direction);
                const float way = next(random);
                if (way >= pane.veil) {
                    const bool mirrors = way < pane.veil + pane.mirrored;
                    if (mirrors) direction = normalize(direction - s.normal * (2 * dot(direction, s.normal)));
                    else throughput = throughput * pane.through / (1 - pane.veil - pane.mirrored);
                    if (mirrors) is_first = false;
                    origin = s.position + (dot(direction, s.normal) > 0 ? s.normal : -s.normal) * kSurfaceOffset;
                    passes = true;
                }
            }
        }
        if (passes) {
            if (bounce + 1 == kMaxBounces) total += sum, alive = false;
            continue;
        }

        const Response r = response_of(m, s.texture, s.bumped, direction);
        const float diffuse = luminance(r.diffuse), behind = luminance(r.behind), specular = luminance(r.specular),
                    all = diffuse + behind + specular;
        if (!(all > 0)) {
            total += sum, alive = false;
            continue;
        }
        const float p_specular = specular / all, p_behind = behind / all;
        float next_pdf = 0;
        bool next_lights = diffuse + behind > 0 || r.alpha > 0;
        vec3 next_normal = s.normal;
        const float kind = next(random);
        const bool backwards = kind >= p_specular && kind < p_specular + p_behind;
        if (next_lights) {
            // Of a thin sheet one side is sampled, chosen by its transmission.
            const float ask_behind = p_behind > 0 ? p_behind / max(1e-6f, 1 - (r.alpha > 0 ? 0 : p_specular)) : 0;
            bool side = false;
            if (ask_behind > 0) side = next(random) < ask_behind;
            next_normal = side ? -s.normal : s.normal;
            const vec3 from = s.position + next_normal * kSurfaceOffset;
            const float which = next(random);
            const vec2 uv = next2(random);
            const LightSample light = draw_light(w, s.position, next_normal, which, uv);
            vec3 lamp = vec3(0);
            if (light.pdf > 0) {
                const Scatter scatter = scatter_of(s, r, direction, p_specular, p_behind, light.direction);
                lamp = scatter.value * light.radiance * (light_weight(light, scatter.pdf) / light.pdf);
            }
            const vec2 disc = next2(random);
            const vec3 facing = side ? next_normal : s.bumped;
            const vec3 sun = sun_unblocked(w, facing) * (looking ? sun_and_share.w : 1);
            vec3 sunlit = vec3(0);
            if (luminance(sun) > 0) {
                sunlit = (side ? r.behind : r.diffuse) * sun * (1.f / kPi);
                if (!side)
                    sunlit += sun_glint(sun_and_share.xyz, s.bumped, r, direction, sun,
                                        is_first ? kSharpestSun : kWideSun);
            }
            vec3 found = vec3(0);
            for (int k = 0; k < 2; ++k) {
                const vec3 value = k == 0 ? lamp : sunlit;
                if (!(luminance(value) > 0)) continue;
                // The sun's ray starts off the surface by the normal that it is judged by.
                if (!is_blocked(w, k == 0 ? from : s.position + facing * kSurfaceOffset,
                                k == 0 ? light.direction : sun_direction(w, disc), k == 0 ? light.far : kFar))
                    found += value;
            }
            sum += throughput * found * (1 / (ask_behind > 0 ? (side ? ask_behind : 1 - ask_behind) : 1));
        }
        const vec2 u = next2(random);
        vec3 way;
        bool ends = false;
        if (kind < p_specular) {
            const vec3 between = ggx_half(s.bumped, r.alpha, u);
            way = direction - between * (2 * dot(direction, between));
            if (!(dot(way, s.normal) > 0.01f)) {
                if (r.alpha > 0) ends = true;
                way = direction - s.normal * (2 * dot(direction, s.normal));
            }
            width = max(width, 0.3f * r.alpha);
        } else {
            way = cosine_direction(backwards ? -s.normal : s.normal, u);
            width = max(width, 0.2f);
        }
        is_first = false;
        if (!(kind < p_specular)) looking = false;
        way = normalize(way);
        if (kind < p_specular && r.alpha == 0) {
            throughput = throughput * r.specular / p_specular;
            next_lights = false;
        } else {
            const Scatter scatter = scatter_of(s, r, direction, p_specular, p_behind, way);
            if (!(scatter.pdf > 0)) ends = true;
            throughput = throughput * scatter.value / max(scatter.pdf, 1e-30f);
            next_pdf = scatter.pdf;
            // Lights hit on the other side count in full only if that side could not have been chosen.
            if (next_lights && p_behind > 0) next_normal = dot(way, s.normal) < 0 ? -s.normal : s.normal;
        }
        if (!ends && bounce >= kSureBounces) {
            const float survive = clamp(max_component(throughput), 0.05f, 0.95f);
            if (next(random) > survive) ends = true;
            throughput = throughput / survive;
        }
        if (ends || bounce + 1 == kMaxBounces) {
            total += sum, alive = false;
            continue;
        }
        origin = s.position + (dot(way, s.normal) > 0 ? s.normal : -s.normal) * kSurfaceOffset;
        direction = way;
        arrival_pdf = next_pdf, arrival_lights = next_lights;
        arrival_from = s.position, arrival_normal = next_normal;
    }
    sums.at[i] = vec4(total, 0);
}
