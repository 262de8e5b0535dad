// Camera rays shaded from the irradiance cache (trace/shade.cc): an invocation a pixel, for a round of its rays. What a
// ray meets on its way, panes, flames and what mirrors show, are states of one loop, so that there is one place at
// which surfaces are looked up.
#version 460
#include "tables.glsl"
#include "traverse.glsl"
#include "surface.glsl"
#include "outdoors.glsl"
#include "lights.glsl"
#include "cache.glsl"
#include "camera.glsl"
#include "film.glsl"
#include "pixels.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push {
    World w;
    Camera camera;
    Words list;        // of this submission: numbers of pixels
    Words pixels;      // by number: x | y << 16
    InOutVec4s sums;   // by number
    InOutWords more;   // by place in the list: whether the pixel needs more rays
    uint count, round, samples, least;
    uint options;
    float ray_angle, noise, min_alpha;
};
const uint kContacts = 1, kFrugal = 2, kDenoise = 4, kDevelop = 8;

const int kMostPanes = 16, kMirrors = 3;
const float kBehindPane = 1e-3, kTrusted = 0.98;
const uint kView = 0, kGlossy = 1, kPane = 2;  // what the loop's ray is for

float reflection_probability(Response r) {
    if (r.alpha == 0) return 1;
    const float specular = luminance(r.specular), all = specular + luminance(r.diffuse) + luminance(r.behind);
    return clamp(4 * specular / max(1e-6f, all), 0.15f, 1.f);
}
Shaded nothing_shaded() {
    return Shaded(vec3(0), vec3(0), vec3(0), vec3(0), vec3(0), vec3(0), vec3(0), vec3(0), vec3(0));
}

void main() {
    if (gl_GlobalInvocationID.x >= count) return;
    const uint number = list.at[gl_GlobalInvocationID.x], place = pixels.at[number];
    const uvec2 pixel = uvec2(place & 0xffff, place >> 16);
    const Lens lens = lens_of(camera);
    const vec3 sun_dir = world_sun(w).xyz;
    const float sun_seen = world_sun(w).w;
    uint taken = uint(row_of(sums, number * kPixelRows).w);
    const uint end = taken + round;

    Sampler random;
    bool alive = false;
    uint state = kView;
    // The loop's ray.
    vec3 origin, direction;
    // The camera's ray so far.
    float travelled;
    int panes;
    vec3 through, passed;  // what glass lets through, and radiance gathered in front of the last surface
    Shaded seen;
    vec3 view;             // its direction
    // At the last surface.
    vec3 position, normal, bumped, specular, asked, emitted;
    float alpha, probability, limit;
    bool is_pane;
    Pane pane;
    // A mirrored ray.
    bool sharp, to_rest, was_met;
    int mirrors;
    float angle;
    vec3 factor, first_direction;
    for (;;) {
        if (!alive) {
            if (taken == end) break;
            random = Sampler(key_of_pixel(lens, pixel), taken++, 0);
            const Ray ray = camera_ray(lens, vec2(pixel) + next2(random));
            origin = ray.origin, direction = view = ray.direction;
            alive = true, state = kView, travelled = 0, panes = kMostPanes, through = vec3(1), passed = vec3(0);
        }
        const bool is_view = state == kView;
        const Hit hit = trace_ray(w, origin, direction, kFar, is_view || (sharp && mirrors > 0) ? 0 : kLit);
        const bool met = hit.place != kNone;
        bool ends = false;          // the camera's ray is done
        bool is_reflected = false;  // a mirrored ray is done, with:
        vec3 found_light = vec3(0), found_rest = vec3(0);
        HitSurface on = HitSurface(kNone, 0, vec3(0), false);
        bool shades = false;  // the view's surface is complete but for its glossy reflection
        bool has_gloss = false;
        if (!met) {
            const vec3 outside = outside_of(w, direction, is_view || sharp);
            if (is_view) {
                seen = nothing_shaded();
                seen.radiance = outside;
                ends = true;
            } else {
                found_light = outside;
                is_reflected = true;
            }
        } else {
            on = hit_surface(w, hit, direction);
            const float slant = max(0.08f, abs(dot(on.normal, direction)));
            const float footprint = is_view ? ray_angle * (travelled + hit.distance) / sqrt(slant)
                                            : angle * hit.distance;
            Material m = w.materials.at[w.meshes.at[on.mesh].x];
            const SurfacePoint s = surface_at(w, m, hit, on, origin, direction, footprint, is_view);
            const bool clear = is_clear(m);
            if (is_view && is_flame(m) && panes > 0) {
                passed += through * flame_as_seen(world_ground(w).w, m.emission, s.normal, direction);
                origin = s.position + direction * kBehindPane;
                travelled += hit.distance;
                --panes;
                continue;
            }
            if (!is_view && m.mirror > 0.5f && mirrors > 0) {
                direction = direction - s.normal * (2 * dot(direction, s.normal));
                origin = s.position + s.normal * 1e-3f;
                to_rest = true;
                --mirrors;
                continue;
            }
            if (!is_view && clear) {
                factor *= dye_of(s.texture.albedo);
                origin = s.position + direction * 1e-3f;
                --mirrors;
                continue;
            }
            Reading readings[2];
            readings[1] = Reading(vec3(0), vec3(0), vec3(0), 0);
            const int sides = m.transmission > 0 ? 2 : 1;
            for (int side = 0; side < sides; ++side)
                readings[side] = read_cache(w, s.position, side == 0 ? s.normal : -s.normal);
            if (!is_view) {
                const vec3 reflectance = mean_reflectance(m, s.texture.albedo, s.texture.metal);
                Coat coat = Coat(vec3(0), vec3(0), 0, 0);
                if (!(m.mirror > 0.5f))
                    coat = coat_of(m, s.texture.albedo, s.texture.roughness, s.texture.metal);
                const vec3 even = reflectance *
                                  (readings[0].irradiance * (1 - m.transmission) +
                                   readings[1].irradiance * m.transmission) * (1.f / kPi),
                           sun = readings[0].sun * sun_reflected(sun_dir, reflectance, coat, m.transmission, s.normal,
                                                                 direction, false) +
                                 readings[1].sun * sun_reflected(sun_dir, reflectance, coat, m.transmission, s.normal,
                                                                 direction, true);
                found_light = (sharp ? lamp_seen(w, m.emission) : m.emission) * s.texture.shown;
                found_rest = even + sun * sun_seen;
                is_reflected = true;
            } else {
                shades = true;
                Response r = response_of(m, s.texture, s.bumped, direction);
                if (m.mirror <= 0.5f && max_component(r.specular) > 0) r.alpha = max(r.alpha, min_alpha);
                seen = nothing_shaded();
                seen.albedo = s.texture.albedo, seen.position = s.position, seen.normal = s.normal;
                position = s.position, normal = s.normal, bumped = s.bumped, specular = r.specular, alpha = r.alpha;
                emitted = lamp_seen(w, m.emission) * s.texture.shown;
                is_pane = panes > 0 && clear;
                if (is_pane) pane = pane_of(s.texture.albedo, s.normal, direction);

                const vec2 disc = next2(random);
                const bool fresh = (options & kContacts) != 0 && !(readings[0].trust > kTrusted);
                float which[2] = float[2](0, 0);
                vec2 uv[2] = vec2[2](vec2(0), vec2(0)), way = vec2(0);
                if (fresh) {
                    which[0] = next(random);
                    uv[0] = next2(random);
                    way = next2(random);
                }
                vec3 mirror = direction;
                if (max_component(r.specular) > 0) {
                    seen.specular = r.specular;
                    probability = (options & kFrugal) != 0 ? reflection_probability(r) : 1;
                    has_gloss = true;
                    if (probability != 1) has_gloss = next(random) < probability;
                    if (has_gloss) {
                        const vec3 between = ggx_half(s.bumped, r.alpha, next2(random));
                        mirror = direction - between * (2 * dot(direction, between));
                        if (!(dot(mirror, s.normal) > 0.01f))
                            mirror = direction - s.normal * (2 * dot(direction, s.normal));
                        mirror = normalize(mirror);
                        if (r.alpha != 0) {
                            which[1] = next(random);
                            uv[1] = next2(random);
                        }
                    }
                }
                // Rays to lights: a lamp or window for the surface, then for its gloss; a sunlit patch; the sun.
                ShadowRay rays[5];
                for (int k = 0; k < 5; ++k) rays[k] = no_ray();
                for (int k = 0; k < 2; ++k) {
                    if (k == 0 ? !fresh : !(has_gloss && r.alpha != 0)) continue;
                    const LightSample light = draw_light(w, s.position, s.normal, which[k], uv[k]);
                    const float here = dot(s.normal, light.direction);
                    if (!(light.pdf > 0)) continue;
                    vec3 value = vec3(0);
                    if (k == 0) {
                        const float near = light.far < kNearest ? light.far * light.far / (kNearest * kNearest) : 1;
                        if (here > 0) value = light.radiance * (here * near / light.pdf);
                    } else if (here > 0.01f) {
                        const float cone = ggx_pdf(s.bumped, r.alpha, direction, light.direction);
                        if (cone > 0) value = light.radiance * (cone * light_weight(light, cone) / light.pdf);
                    }
                    rays[k] = ShadowRay(s.position + s.normal * kSurfaceOffset, light.direction, light.far, value);
                }
                if (fresh) rays[2] = ask_sunlit(w, s.position, s.normal, which[0]);
                const vec3 to_sun = sun_direction(w, disc);
                rays[3] = ShadowRay(s.position + s.bumped * kSurfaceOffset, to_sun, kFar, sun_unblocked(w, s.bumped));
                if (m.transmission > 0)
                    rays[4] = ShadowRay(s.position - s.normal * kSurfaceOffset, to_sun, kFar,
                                        sun_unblocked(w, -s.normal));
                for (int k = 0; k < 5; ++k)
                    if (max_component(rays[k].irradiance) > 0 &&
                        is_blocked(w, rays[k].origin, rays[k].direction, rays[k].far))
                        rays[k].irradiance = vec3(0);
                vec3 front = readings[0].irradiance;
                if (fresh) {
                    const vec3 toward = cosine_direction(s.normal, way),
                               from = s.position + s.normal * distance_epsilon(s.position);
                    const vec3 bounced = bounce_of(w, trace_ray(w, from, toward, kFar, kLit), from, toward).irradiance;
                    front = front * readings[0].trust +
                            (rays[0].irradiance + rays[2].irradiance + bounced) * (1 - readings[0].trust);
                }
                front *= relief_light(readings[0].direction, s.normal, s.bumped);
                const vec3 front_sun = rays[3].irradiance * sun_seen;
                seen.diffuse = r.diffuse;
                seen.light = r.diffuse * front * (1.f / kPi);
                seen.sun = r.diffuse * front_sun * (1.f / kPi);
                if (m.transmission > 0) {
                    seen.diffuse += r.behind;
                    seen.light += r.behind * readings[1].irradiance * (1.f / kPi);
                    seen.sun += r.behind * (rays[4].irradiance * sun_seen) * (1.f / kPi);
                }
                if (max_component(r.specular) > 0 && luminance(front_sun) > 0)
                    seen.mirrored += sun_glint(sun_dir, s.bumped, r, direction, front_sun, kSharpestSun);
                asked = rays[1].irradiance;
                limit = 6 * (luminance(front + front_sun) / kPi + 0.05f);
                travelled += hit.distance;
                view = direction;
                if (has_gloss) {
                    state = kGlossy;
                    origin = s.position + s.normal * kSurfaceOffset;
                    direction = first_direction = mirror;
                    sharp = r.alpha == 0, to_rest = false, mirrors = kMirrors, angle = ray_angle + 0.3f * r.alpha;
                    factor = vec3(1);
                    continue;
                }
            }
        }
        if (is_reflected) {
            found_light *= factor, found_rest *= factor;
            if (to_rest) found_rest += found_light, found_light = vec3(0);
            if (state == kGlossy) {
                vec3 reflected = found_light + found_rest;
                if (alpha != 0) {
                    if (max_component(found_light) > 0) {
                        // Light met at once: through mirrors it would be with the rest.
                        const float pdf = light_pdf(w, position, normal, first_direction, on.triangle, on.mesh,
                                                    on.normal, on.back, hit.distance);
                        found_light *= power_heuristic(ggx_pdf(bumped, alpha, view, first_direction), pdf);
                    }
                    reflected = found_light + found_rest;
                    const float bright = luminance(reflected);
                    if (bright > limit) reflected *= limit / bright;
                    reflected += asked;
                }
                seen.mirrored += specular * reflected / probability;
                shades = true;
            } else {
                passed += through * (found_light + found_rest) * pane.mirrored;
                through *= pane.through;
                state = kView;
                origin = position + view * kBehindPane, direction = view;
                --panes;
                continue;
            }
        }
        if (shades) {
            seen.radiance = emitted + seen.light + seen.sun + seen.mirrored;
            if (is_pane) {
                passed += through * seen.radiance * pane.veil;
                state = kPane;
                origin = position + normal * kSurfaceOffset;
                direction = normalize(view - normal * (2 * dot(view, normal)));
                sharp = true, to_rest = false, mirrors = 1, angle = ray_angle, factor = vec3(1);
                continue;
            }
            ends = true;
        }
        if (ends) {
            seen.radiance = passed + through * seen.radiance;
            seen.light *= through, seen.sun *= through, seen.mirrored *= through;
            seen.diffuse *= through, seen.specular *= through;
            add_to_pixel(sums, number, seen, (options & kDevelop) != 0 ? develop(w, seen.radiance) : seen.radiance);
            alive = false;
        }
    }
    more.at[gl_GlobalInvocationID.x] =
        taken < least || needs_more(sums, number, (options & kDenoise) != 0, noise, float(samples)) ? 1 : 0;
}
