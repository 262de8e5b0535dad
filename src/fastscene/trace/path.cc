#include "fastscene/trace/path.h"

#include <algorithm>
#include <cmath>

#include "fastscene/trace/film.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/surface.h"

namespace fastscene {
namespace {

constexpr int kMaxBounces = 48;
constexpr int kSureBounces = 3;  // Russian roulette starts after this many bounces

// How a path arrived at its next vertex; its pdf gives the MIS weight of lights that it hits.
struct Arrival {
    float pdf = 0;        // of the direction, at the surface it left; 0: camera or perfect mirror, light counts in full
    bool lights = false;  // whether lights were sampled at that surface
    Vec3f from, normal;
};

// The BSDF towards -direction for light from `out`, including the cosine, and the pdf of sampling `out`.
struct Scatter {
    Vec3f value;
    float pdf = 0;
};
struct Local {
    const SurfacePointInfo& s;
    const Response& r;
    Vec3f direction;
    float p_specular, p_behind;  // lobe selection probabilities; the remainder is diffuse

    Scatter towards(Vec3f out) const {
        Scatter e;
        const float cosine = dot(s.normal, out);
        if (cosine > 0) {
            e.value = r.diffuse * (std::max(0.f, dot(s.bumped, out)) / kPi);
            e.pdf = (1 - p_specular - p_behind) * cosine / kPi;
            if (r.alpha > 0) {
                const float d = ggx_pdf(s.bumped, r.alpha, direction, out);
                e.value += r.specular * d;
                e.pdf += p_specular * d;
            }
        } else {
            e.value = r.behind * (-cosine / kPi);
            e.pdf = p_behind * -cosine / kPi;
        }
        return e;
    }
};

// Next-event estimation: one lamp or window, and the sun. `first`: the camera sees this surface directly; `looking`:
// directly or through mirrors.
Vec3f sample_lights(const PathScene& scene, const Local& local, bool behind, bool first, bool looking,
                    Sampler& sampler) {
    const SurfacePointInfo& s = local.s;
    const Vec3f normal = behind ? -s.normal : s.normal;
    Vec3f sum{};
    const float which = sampler.next();
    const Vec2f uv = sampler.next2();
    const Lights::LightSample light = scene.lights.draw(scene.room, s.position, normal, which, uv);
    if (light.pdf > 0) {
        const Scatter scatter = local.towards(light.direction);
        const Vec3f value = scatter.value * light.radiance;
        if (luminance(value) > 0 &&
            !scene.bvh.blocked(offset_from(s.position, normal), light.direction, 0.f, light.far))
            sum += value * (light.weight(scatter.pdf) / light.pdf);
    }
    // No MIS for the sun: rays cannot hit it, its disc is not in the sky.
    const Vec2f disc = sampler.next2();
    const Vec3f facing = behind ? normal : s.bumped;
    const Vec3f sun = scene.lights.sun(scene.room, scene.bvh, s.position, facing, disc) *
                      (looking ? scene.room.look.sun_seen : 1.f);
    if (luminance(sun) > 0) sum += (behind ? local.r.behind : local.r.diffuse) * sun * (1.f / kPi);
    if (luminance(sun) > 0 && !behind)
        sum += sun_glint(scene.room.sky, s, local.r, local.direction, sun, first ? kSharpestSun : kWideSun);
    return sum;
}

}  // namespace

Vec3f path_radiance(const PathScene& scene, Vec3f origin, Vec3f direction, float pixel_angle, Sampler& sampler) {
    Vec3f sum{}, throughput{1, 1, 1};
    Arrival arrival;
    float width = pixel_angle, travelled = 0;
    bool first = true;    // directly visible to the camera
    bool looking = true;  // visible to the camera, directly or through mirrors; the rest is illumination only
    for (int bounce = 0; bounce < kMaxBounces; ++bounce) {
        // Panes are transparent to the camera, also in perfect mirrors; to light they do not exist.
        const bool clearly = looking && !(arrival.pdf > 0);
        const RayHit hit = clearly ? scene.bvh.first_hit(origin, direction) : scene.bvh.first_lit(origin, direction);
        float mis_weight = 1;
        if (arrival.lights)
            mis_weight = power_heuristic(arrival.pdf,
                                         scene.lights.pdf(scene.room, arrival.from, arrival.normal, direction, hit));
        if (!hit)
            return sum + throughput *
                             (clearly ? outside_as_seen(scene.room.sky, scene.room.look,
                                                        scene.lights.outdoors().seen(direction))
                                      : scene.lights.outdoors().light(direction)) *
                             mis_weight;
        travelled += hit.distance;
        const float slant = std::max(0.08f, std::abs(dot(hit.normal, direction)));
        const SurfacePointInfo s = surface_at(scene.room, hit, origin, direction, width * travelled / std::sqrt(slant),
                                              first);
        const Material& m = *s.material;
        if (clearly && is_flame(m)) {
            sum += throughput * flame_as_seen(scene.room.look, s, direction);
            origin = offset_from(s.position, dot(direction, s.normal) > 0 ? s.normal : -s.normal);
            continue;
        }
        sum += throughput * (clearly ? emission_as_seen(scene.room.look, s) : s.emission()) * mis_weight;
        if (clearly && is_clear(m)) {
            const Pane pane = pane_of(s, direction);
            const float way = sampler.next();
            if (way >= pane.veil) {
                const bool mirrors = way < pane.veil + pane.mirrored;
                if (mirrors) direction = normalize(direction - s.normal * (2 * dot(direction, s.normal)));
                else throughput = throughput * pane.through / (1 - pane.veil - pane.mirrored);
                first &= !mirrors;
                origin = offset_from(s.position, dot(direction, s.normal) > 0 ? s.normal : -s.normal);
                continue;
            }
        }

        const Response r = response_of(s, direction);
        const float diffuse = luminance(r.diffuse), behind = luminance(r.behind), specular = luminance(r.specular),
                    all = diffuse + behind + specular;
        if (!(all > 0)) return sum;
        const Local local{s, r, direction, specular / all, behind / all};

        Arrival next;
        next.lights = diffuse + behind > 0 || r.alpha > 0;
        const float kind = sampler.next();
        const bool backwards = kind >= local.p_specular && kind < local.p_specular + local.p_behind;
        if (next.lights) {
            next.from = s.position;
            // Of a thin sheet one side is sampled, chosen by its transmission.
            const float ask_behind = local.p_behind > 0
                                         ? local.p_behind /
                                               std::max(1e-6f, 1.f - (r.alpha > 0 ? 0.f : local.p_specular))
                                         : 0.f;
            const bool side = ask_behind > 0 && sampler.next() < ask_behind;
            next.normal = side ? -s.normal : s.normal;
            sum += throughput * sample_lights(scene, local, side, first, looking, sampler) *
                   (1.f / (ask_behind > 0 ? (side ? ask_behind : 1 - ask_behind) : 1.f));
        }
        const Vec2f u = sampler.next2();
        Vec3f out;
        if (kind < local.p_specular) {
            const Vec3f half = ggx_half(s.bumped, r.alpha, u);
            out = direction - half * (2 * dot(direction, half));
            if (!(dot(out, s.normal) > 0.01f)) {
                if (r.alpha > 0) return sum;
                out = direction - s.normal * (2 * dot(direction, s.normal));
            }
            width = std::max(width, 0.3f * r.alpha);
        } else {
            out = cosine_direction(backwards ? -s.normal : s.normal, u);
            width = std::max(width, 0.2f);
        }
        first = false;
        looking &= kind < local.p_specular;
        out = normalize(out);
        if (kind < local.p_specular && r.alpha == 0) {
            throughput = throughput * r.specular / local.p_specular;
            next.lights = false;
        } else {
            const Scatter scatter = local.towards(out);
            if (!(scatter.pdf > 0)) return sum;
            throughput = throughput * scatter.value / scatter.pdf;
            next.pdf = scatter.pdf;
            // Lights were sampled on one side only; light hit on the other side counts in full only if that side could
            // not have been chosen.
            if (next.lights && local.p_behind > 0) {
                const bool other = dot(out, s.normal) < 0;
                next.normal = other ? -s.normal : s.normal;
            }
        }
        origin = offset_from(s.position, dot(out, s.normal) > 0 ? s.normal : -s.normal);
        direction = out;
        arrival = next;
        if (bounce >= kSureBounces) {
            const float survive = std::clamp(max_component(throughput), 0.05f, 0.95f);
            if (sampler.next() > survive) break;
            throughput = throughput / survive;
        }
    }
    return sum;
}

}  // namespace fastscene
