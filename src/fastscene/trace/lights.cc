#include "fastscene/trace/lights.h"

#include <algorithm>
#include <cmath>

#include "fastscene/trace/sky.h"

namespace fastscene {
namespace {

constexpr float kLargeArea = 0.5f;
constexpr float kSunRadius = 0.008f;   // of its disc, in radians: 0.9 degrees across
constexpr float kOffset = 4e-4f;

// Nearer than this a lamp is no brighter: keeps single samples from burning holes.
constexpr float kNearest = 0.03f;

std::size_t pick(const std::vector<float>& cumulative, float u) {
    const float wanted = u * cumulative.back();
    const auto at = std::upper_bound(cumulative.begin(), cumulative.end(), wanted);
    return std::min(cumulative.size() - 1, static_cast<std::size_t>(at - cumulative.begin()));
}

}  // namespace

Lights::Lights(const Room& room) : large_(room.meshes.size(), false) {
    for (std::size_t m = 0; m < room.meshes.size(); ++m) {
        const Mesh& mesh = room.meshes[m];
        const Vec3f emission = room.materials[static_cast<std::size_t>(mesh.material)].emission;
        if (!(luminance(emission) > 0)) continue;
        Light light;
        light.mesh = static_cast<int>(m);
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
            const Vec3f a = mesh.positions[mesh.triangles[t]], b = mesh.positions[mesh.triangles[t + 1]], c = mesh.positions[mesh.triangles[t + 2]];
            const float area = 0.5f * length(cross(b - a, c - a));
            light.area += area;
            light.center += (a + b + c) * (area / 3);
            light.cumulative.push_back(light.area);
        }
        if (!(light.area > 0)) continue;
        light.center = light.center / light.area;
        light.power = light.area * luminance(emission);
        if (light.area > kLargeArea) large_[m] = true;
        else lights_.push_back(std::move(light));
    }
    for (std::size_t i = 0; i < room.portals.size(); ++i) {
        const Portal& p = room.portals[i];
        Light light;
        light.portal = static_cast<int>(i);
        light.center = p.corner + p.edge_u * 0.5f + p.edge_v * 0.5f;
        const Vec3f across = cross(p.edge_u, p.edge_v);
        light.area = length(across);
        if (!(light.area > 0)) continue;
        light.direction = across / light.area;
        light.power = light.area * (luminance(room.sky.horizon) + luminance(room.sky.zenith) + 0.5f * luminance(room.sky.ground)) * 0.4f;
        lights_.push_back(std::move(light));
    }
}

Lights::Choice Lights::choice_at(Vec3f position, Vec3f normal) const {
    Choice choice;
    float sum = 0;
    for (const Light& light : lights_) {
        const Vec3f to = light.center - position;
        const float d2 = dot(to, to), far = std::sqrt(d2);
        // Generous with what lies near the horizon: its far end may stand above it.
        const float above = std::clamp(dot(normal, to) / std::max(far, 1e-4f) + 0.5f * std::sqrt(light.area) / std::max(far, 0.05f), 0.f, 1.f) + 0.01f;
        float facing = 1.f;
        if (light.portal >= 0) facing = std::max(0.f, -dot(light.direction, to) / std::max(far, 1e-4f)) + 0.02f;
        sum += light.power * above * facing / std::max(d2, 0.25f * light.area + 0.01f);
        choice.cumulative.push_back(sum);
    }
    if (!(sum > 0)) choice.cumulative.clear();
    return choice;
}

Vec3f Lights::sample(const Room& room, const SceneBvh& bvh, const Choice& choice, Vec3f position, Vec3f normal, float which, Vec2f uv, Random& random) const {
    if (choice.cumulative.empty()) return {};
    const std::size_t i = pick(choice.cumulative, which);
    const Light& light = lights_[i];
    const float chance = (choice.cumulative[i] - (i ? choice.cumulative[i - 1] : 0.f)) / choice.cumulative.back();
    if (!(chance > 0)) return {};
    const float u = uv.x, v = uv.y, w = random.uniform();
    Vec3f target, facing;
    if (light.portal >= 0) {
        const Portal& p = room.portals[static_cast<std::size_t>(light.portal)];
        target = p.corner + p.edge_u * u + p.edge_v * v;
        facing = light.direction;
    } else {
        const Mesh& mesh = room.meshes[static_cast<std::size_t>(light.mesh)];
        const std::size_t t = 3 * pick(light.cumulative, w);
        const Vec3f a = mesh.positions[mesh.triangles[t]], b = mesh.positions[mesh.triangles[t + 1]], c = mesh.positions[mesh.triangles[t + 2]];
        const float r = std::sqrt(u);
        target = a * (1 - r) + b * (r * (1 - v)) + c * (r * v);
        facing = normalize(cross(b - a, c - a));
    }
    const Vec3f from = position + normal * kOffset, to = target - from;
    const float far = length(to);
    if (!(far > 1e-4f)) return {};
    const Vec3f direction = to / far;
    const float here = dot(normal, direction);
    if (!(here > 0)) return {};
    float there = -dot(facing, direction);
    if (light.mesh >= 0) there = std::abs(there);  // a thin shade shines to both sides
    if (!(there > 0)) return {};
    const float geometry = here * there / std::max(far * far, kNearest * kNearest) * light.area / chance;
    // Up to just before the lamp's own surface.
    if (bvh.blocked(from, direction, 0.f, far * 0.999f - kOffset)) return {};
    if (light.portal >= 0) return sky_radiance(room.sky, direction) * geometry;
    return room.materials[static_cast<std::size_t>(room.meshes[static_cast<std::size_t>(light.mesh)].material)].emission * geometry;
}

Vec3f Lights::sun(const Room& room, const SceneBvh& bvh, Vec3f position, Vec3f normal, Random& random) const {
    const Sky& sky = room.sky;
    if (!(luminance(sky.sun_irradiance) > 0)) return {};
    const float cosine = dot(normal, sky.sun_dir);
    if (!(cosine > 0)) return {};
    Vec3f s, t;
    make_frame(sky.sun_dir, s, t);
    const float r = kSunRadius * std::sqrt(random.uniform()), phi = 6.2831853f * random.uniform();
    const Vec3f direction = normalize(sky.sun_dir + s * (r * std::cos(phi)) + t * (r * std::sin(phi)));
    if (bvh.blocked(position + normal * kOffset, direction, 0.f, kFar)) return {};
    return sky.sun_irradiance * cosine;
}

}  // namespace fastscene
