#include "fastscene/trace/lights.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fastscene/trace/irradiance_cells.h"
#include "fastscene/trace/response.h"
#include "fastscene/trace/texture.h"

namespace fastscene {
namespace {

constexpr float kLargeArea = 0.5f;
constexpr float kSunRadius = 0.008f;  // angular radius in radians: 0.9 degrees across

// metres: closer lamps count as this far away, which bounds the variance of single samples in the cache
constexpr float kNearest = 0.03f;

// RMS radiance seen through a window that faces `into`, as its sampling weight: uneven light deserves more samples. The
// sky alone would not do: at night lit windows across the street outshine it by far, and undersampling them leaves
// blotches.
float brightness_behind(const Outdoors& outdoors, Vec3f into) {
    constexpr std::uint32_t kWays = 1024;
    float squares = 0;
    for (std::uint32_t i = 0; i < kWays; ++i) {
        const float bright = luminance(outdoors.light(cosine_direction(-into, irradiance::r2_point(i, {0.5f, 0.5f}))));
        squares += bright * bright;
    }
    return std::max(1e-6f, std::sqrt(squares / kWays));
}

std::array<Vec3f, 3> corners(const Room& room, int mesh, int triangle) {
    const Mesh& m = room.meshes[static_cast<std::size_t>(mesh)];
    const std::size_t t = 3 * static_cast<std::size_t>(triangle);
    return {m.positions[m.triangles[t]], m.positions[m.triangles[t + 1]], m.positions[m.triangles[t + 2]]};
}
float area_of(const std::array<Vec3f, 3>& t) { return 0.5f * length(cross(t[1] - t[0], t[2] - t[0])); }
const Material& material_of(const Room& room, int mesh) {
    return room.materials[static_cast<std::size_t>(room.meshes[static_cast<std::size_t>(mesh)].material)];
}
// What light sampling has of a picture is its mean: rays that meet it see it blurred, and sharp reflections, which do
// not, give samples little weight.
Vec3f emission_of(const Room& room, int mesh) { return mean_emission(material_of(room, mesh)); }
// Share of an emissive triangle's light that gets away from it. It only weights samples, so a few rays will do.
float openness(const SceneBvh& bvh, const std::array<Vec3f, 3>& abc, Vec3f normal, bool two_sided) {
    constexpr std::uint32_t kRays = 16;
    constexpr float kAway_m = 0.3f;  // what is caught within this distance lights nothing but the lamp itself
    constexpr float kLeast = 0.1f;   // rays may have missed a gap, and light through it is rare but bright
    std::uint32_t open = 0;
    for (std::uint32_t i = 0; i < kRays; ++i) {
        const Vec2f on = irradiance::r2_point(i, {0.25f, 0.75f});
        const float r = std::sqrt(on.x);
        const Vec3f at = abc[0] * (1 - r) + abc[1] * (r * (1 - on.y)) + abc[2] * (r * on.y),
                    side = two_sided && i % 2 == 1 ? -normal : normal,
                    way = cosine_direction(side, irradiance::r2_point(i, {0.5f, 0.5f}));
        open += !bvh.blocked(offset_from(at, side), way, 0.f, kAway_m);
    }
    return std::max(kLeast, static_cast<float>(open) / kRays);
}
LightTree::Emitter box_of(std::initializer_list<Vec3f> points) {
    LightTree::Emitter e{*points.begin(), *points.begin(), {}, {}};
    for (const Vec3f p : points) {
        e.center += p / static_cast<float>(points.size());
        for (std::size_t a = 0; a < 3; ++a) e.low[a] = std::min(e.low[a], p[a]), e.high[a] = std::max(e.high[a], p[a]);
    }
    return e;
}

}  // namespace

Lights::Lights(const Room& room, float outside_detail, const SceneBvh* bvh, std::shared_ptr<const Outdoors> outdoors)
    : outdoors_(outdoors ? std::move(outdoors) : std::make_shared<const Outdoors>(room, outside_detail)),
      first_of_mesh_(room.meshes.size(), -1),
      large_(room.meshes.size(), false) {
    for (const Mesh& mesh : room.meshes) closed_.push_back(is_closed(mesh));
    std::vector<LightTree::Emitter> tree;
    for (std::size_t i = 0; i < room.portals.size(); ++i) {
        const Portal& p = room.portals[i];
        const Vec3f across = cross(p.edge_u, p.edge_v);
        const float area = length(across);
        if (!(area > 0)) continue;
        const Vec3f inwards = across / area;
        emitters_.push_back({.portal = static_cast<std::int32_t>(i)});
        tree.push_back(box_of({p.corner, p.corner + p.edge_u, p.corner + p.edge_v, p.corner + p.edge_u + p.edge_v}));
        tree.back().normal = inwards;
        tree.back().power = area * brightness_behind(*outdoors_, inwards);
    }
    for (std::size_t m = 0; m < room.meshes.size(); ++m) {
        const int count = static_cast<int>(room.meshes[m].triangles.size() / 3);
        const float bright = luminance(emission_of(room, static_cast<int>(m)));
        if (!(bright > 0)) continue;
        float whole = 0;
        for (int t = 0; t < count; ++t) whole += area_of(corners(room, static_cast<int>(m), t));
        if (whole > kLargeArea && !is_flame(material_of(room, static_cast<int>(m)))) {
            large_[m] = true;
            continue;
        }
        first_of_mesh_[m] = static_cast<std::int32_t>(emitters_.size());
        for (int t = 0; t < count; ++t) {
            const auto abc = corners(room, static_cast<int>(m), t);
            emitters_.push_back({.mesh = static_cast<std::int32_t>(m), .triangle = t});
            tree.push_back(box_of({abc[0], abc[1], abc[2]}));
            tree.back().normal = normalize(cross(abc[1] - abc[0], abc[2] - abc[0]));
            tree.back().two_sided = !closed_[m];  // a thin shade emits on both sides, a solid on the outside
            tree.back().power = area_of(abc) * bright *
                                (bvh ? openness(*bvh, abc, tree.back().normal, tree.back().two_sided) : 1.f);
        }
    }
    tree_.emplace(tree);
}

// Summed over all windows that lie in this direction, one behind the other.
float Lights::portal_pdf(const Room& room, Vec3f position, Vec3f normal, Vec3f direction) const {
    float sum = 0;
    const Vec3f from = offset_from(position, normal);
    for (std::size_t i = 0; i < emitters_.size() && emitters_[i].portal >= 0; ++i) {
        const Portal& p = room.portals[static_cast<std::size_t>(emitters_[i].portal)];
        const Vec3f across = cross(p.edge_u, p.edge_v);
        const float area = length(across), cosine = -dot(across, direction) / area;
        if (!(cosine > 1e-5f)) continue;
        const float far = dot(p.corner - from, across) / (-cosine * area);
        if (!(far > 0)) continue;
        const Vec3f at = from + direction * far - p.corner;
        const float u = dot(at, p.edge_u) / dot(p.edge_u, p.edge_u), v = dot(at, p.edge_v) / dot(p.edge_v, p.edge_v);
        if (u >= 0 && u <= 1 && v >= 0 && v <= 1)
            sum += tree_->probability(static_cast<int>(i), position, normal) * far * far / (cosine * area);
    }
    return sum;
}

Lights::LightSample Lights::draw(const Room& room, Vec3f position, Vec3f normal, float which, Vec2f uv) const {
    LightSample out;
    const LightTree::SampledEmitter drawn = tree_->draw(position, normal, which);
    if (drawn.emitter < 0) return out;
    const Emitter& emitter = emitters_[static_cast<std::size_t>(drawn.emitter)];
    const Vec3f from = offset_from(position, normal);
    if (emitter.portal >= 0) {
        const Portal& p = room.portals[static_cast<std::size_t>(emitter.portal)];
        out.direction = normalize(p.corner + p.edge_u * uv.x + p.edge_v * uv.y - from);
        out.far = kFar;
        out.radiance = outdoors_->light(out.direction);
        out.pdf = portal_pdf(room, position, normal, out.direction);
        return out;
    }
    const auto [a, b, c] = corners(room, emitter.mesh, emitter.triangle);
    const float r = std::sqrt(uv.x);
    const Vec3f to = a * (1 - r) + b * (r * (1 - uv.y)) + c * (r * uv.y) - from;
    const float far = length(to);
    if (!(far > 1e-4f)) return out;
    out.direction = to / far;
    // The back of a thin solid (a screen) does not emit, though its front may be too close behind to block the shadow
    // ray.
    const float away = dot(normalize(cross(b - a, c - a)), out.direction);
    const float there = closed_[static_cast<std::size_t>(emitter.mesh)] ? -away : std::abs(away);
    if (!(there > 1e-5f)) return out;
    out.far = far * 0.999f - kSurfaceOffset;  // up to just before the lamp's own surface
    out.radiance = emission_of(room, emitter.mesh);
    out.alone = is_flame(material_of(room, emitter.mesh));
    out.pdf = drawn.probability * far * far / (there * area_of({a, b, c}));
    return out;
}

float Lights::pdf(const Room& room, Vec3f position, Vec3f normal, Vec3f direction, const RayHit& hit) const {
    if (emitters_.empty()) return 0;
    if (!hit) return portal_pdf(room, position, normal, direction);
    const std::int32_t first = first_of_mesh_[static_cast<std::size_t>(hit.mesh)];
    if (first < 0 || (hit.back && closed_[static_cast<std::size_t>(hit.mesh)])) return 0;
    const float there = std::abs(dot(hit.normal, direction));
    return tree_->probability(first + hit.triangle, position, normal) * hit.distance * hit.distance /
           (std::max(1e-5f, there) * area_of(corners(room, hit.mesh, hit.triangle)));
}

DirectedLight Lights::sample(const Room& room, const SceneBvh& bvh, Vec3f position, Vec3f normal, float which,
                             Vec2f uv) const {
    const LightSample light = draw(room, position, normal, which, uv);
    const float here = dot(normal, light.direction);
    if (!(light.pdf > 0 && here > 0) || bvh.blocked(offset_from(position, normal), light.direction, 0.f, light.far))
        return {};
    const float near = light.far < kNearest ? light.far * light.far / (kNearest * kNearest) : 1.f;
    return {light.radiance * (here * near / light.pdf), light.direction};
}

Vec3f Lights::sun(const Room& room, const SceneBvh& bvh, Vec3f position, Vec3f normal, Vec2f uv) const {
    const Sky& sky = room.sky;
    if (!(luminance(sky.sun_irradiance) > 0)) return {};
    const float cosine = dot(normal, sky.sun_dir);
    if (!(cosine > 0)) return {};
    Vec3f s, t;
    make_frame(sky.sun_dir, s, t);
    const float r = kSunRadius * std::sqrt(uv.x), phi = 6.2831853f * uv.y;
    const Vec3f direction = normalize(sky.sun_dir + s * (r * std::cos(phi)) + t * (r * std::sin(phi)));
    if (bvh.blocked(offset_from(position, normal), direction, 0.f, kFar)) return {};
    return sky.sun_irradiance * cosine;
}

}  // namespace fastscene
