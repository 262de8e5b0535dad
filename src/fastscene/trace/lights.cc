#include "fastscene/trace/lights.h"

#include <algorithm>
#include <cmath>

#include "fastscene/trace/irradiance_cells.h"
#include "fastscene/trace/response.h"

namespace fastscene {
namespace {

constexpr float kLargeArea = 0.5f;
constexpr float kSunRadius = 0.008f;   // of its disc, in radians: 0.9 degrees across

// Nearer than this a lamp's part is no brighter to the cache: keeps single samples from burning holes.
constexpr float kNearest = 0.03f;

std::size_t pick(const float* cumulative, std::size_t count, float u) {
    const float wanted = u * cumulative[count - 1];
    return std::min(count - 1, static_cast<std::size_t>(std::upper_bound(cumulative, cumulative + count, wanted) - cumulative));
}

// Radiance of all that is seen through a window that shines along `into`, the root of its mean square: what is uneven is to be asked more often. Not the
// sky's alone: by night it is far darker than a town's lit windows, and a light that is asked a hundred times too seldom leaves clouds.
float brightness_behind(const SkyTable& sky, Vec3f into) {
    constexpr std::uint32_t kWays = 1024;
    float squares = 0;
    for (std::uint32_t i = 0; i < kWays; ++i) {
        const float bright = luminance(sky.at(cosine_direction(-into, irradiance::r2_point(i, {0.5f, 0.5f}))));
        squares += bright * bright;
    }
    return std::max(1e-6f, std::sqrt(squares / kWays));
}

std::array<Vec3f, 3> corners(const Room& room, int mesh, int triangle) {
    const Mesh& m = room.meshes[static_cast<std::size_t>(mesh)];
    const std::size_t t = 3 * static_cast<std::size_t>(triangle);
    return {m.positions[m.triangles[t]], m.positions[m.triangles[t + 1]], m.positions[m.triangles[t + 2]]};
}
Vec3f emission_of(const Room& room, int mesh) {
    return room.materials[static_cast<std::size_t>(room.meshes[static_cast<std::size_t>(mesh)].material)].emission;
}

}  // namespace

std::size_t Lights::facing_of(Vec3f n, bool one_sided) {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (std::abs(n[k]) > std::abs(n[axis])) axis = k;
    const auto field = [&](float v) { return static_cast<std::size_t>(std::clamp((v / std::abs(n[axis]) + 1) * 1.5f, 0.f, 2.f)); };
    return ((2 * axis + (n[axis] < 0)) * 3 + field(n[(axis + 1) % 3])) * 3 + field(n[(axis + 2) % 3]) + (one_sided ? kFacings / 2 : 0);
}

// By power, distance and which way they face. The ceiling about a flat lamp sees a strip of its rim; drawn by power alone, five samples of six would
// go to its underside.
std::array<float, Lights::kFacings> Lights::Light::shares_at(Vec3f position) const {
    std::array<float, kFacings> cumulative;
    float sum = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Part& part = parts[i];
        const Vec3f to = part.center - position;
        const float d2 = dot(to, to), cosine = -dot(part.normal, to) / std::sqrt(std::max(d2, 1e-8f));
        // A part is bent and near ones fill much of the sky, so none is given up wholly.
        const float facing = (part.one_sided ? std::max(0.f, cosine) : std::abs(cosine)) + 0.03f;
        cumulative[i] = sum += part.cumulative.back() * facing / std::max(d2, 0.25f * part.area + 1e-4f);
    }
    return cumulative;
}

// What glows of one object is one light as far as it lies together, within `width_m`: the candles of a chandelier, but not the spots of a ceiling, of which
// a place wants to ask the one above it. Cut where there is a gap, into halves about as large.
void Lights::cut(Group group, float width_m, std::vector<Group>& out) {
    Vec3f low = group[0].center, high = low;
    for (const Glowing& g : group)
        for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], g.center[a]), high[a] = std::max(high[a], g.center[a]);
    const Vec3f extent = high - low;
    const std::size_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    if (extent[axis] <= width_m) {
        out.push_back(std::move(group));
        return;
    }
    std::stable_sort(group.begin(), group.end(), [&](const Glowing& a, const Glowing& b) { return a.center[axis] < b.center[axis]; });
    std::size_t at = 1;
    float best = -1;
    for (std::size_t i = 1; i < group.size(); ++i) {
        const float gap = group[i].center[axis] - group[i - 1].center[axis];
        const float worth = gap * static_cast<float>(std::min(i, group.size() - i));
        if (worth > best) best = worth, at = i;
    }
    const auto middle = group.begin() + static_cast<std::ptrdiff_t>(at);
    cut(Group(group.begin(), middle), width_m, out);
    cut(Group(middle, group.end()), width_m, out);
}

Lights::Lights(const Room& room) : light_of_triangle_(room.meshes.size()), large_(room.meshes.size(), false) {
    for (const Mesh& mesh : room.meshes) closed_.push_back(is_closed(mesh));
    // What glows, object by object; what belongs to none, mesh by mesh.
    std::vector<Group> objects;
    std::vector<int> group_of_object(room.objects.size(), -1);
    for (std::size_t m = 0; m < room.meshes.size(); ++m) {
        const Mesh& mesh = room.meshes[m];
        const float bright = luminance(emission_of(room, static_cast<int>(m)));
        if (!(bright > 0)) continue;
        Group glowing;
        float whole = 0;
        for (std::size_t t = 0; t < mesh.triangles.size() / 3; ++t) {
            const auto [a, b, c] = corners(room, static_cast<int>(m), static_cast<int>(t));
            const Vec3f across = cross(b - a, c - a);
            const float area = 0.5f * length(across);
            if (!(area > 0)) continue;
            whole += area;
            glowing.push_back({static_cast<std::int32_t>(m), static_cast<std::int32_t>(t), (a + b + c) * (1.f / 3), across, area, area * bright});
        }
        if (glowing.empty()) continue;
        if (whole > kLargeArea) {
            large_[m] = true;
            continue;
        }
        light_of_triangle_[m].assign(mesh.triangles.size() / 3, kNoLight);
        const bool owned = mesh.object >= 0 && static_cast<std::size_t>(mesh.object) < group_of_object.size();
        int group = owned ? group_of_object[static_cast<std::size_t>(mesh.object)] : -1;
        if (group < 0) {
            group = static_cast<int>(objects.size());
            objects.emplace_back();
            if (owned) group_of_object[static_cast<std::size_t>(mesh.object)] = group;
        }
        Group& all = objects[static_cast<std::size_t>(group)];
        all.insert(all.end(), glowing.begin(), glowing.end());
    }
    for (std::size_t i = 0; i < room.portals.size(); ++i) add_portal(room, static_cast<int>(i));
    const std::size_t windows = lights_.size();
    // As finely as can be weighed at every place; beyond that an object is one light.
    std::vector<Group> groups;
    for (const float width_m : {0.6f, 1.2f, 2.4f, kFar}) {
        groups.clear();
        for (const Group& object : objects) cut(object, width_m, groups);
        if (groups.size() + windows <= static_cast<std::size_t>(kMost)) break;
    }
    for (const Group& group : groups) add_lamp(group);
    keep_strongest();
}

void Lights::add_lamp(const Group& group) {
    Light light;
    light.part_of_facing.fill(-1);
    for (const Glowing& g : group) {
        const bool one_sided = closed_[static_cast<std::size_t>(g.mesh)];
        light.center = (light.center * light.area + g.center * g.area) / (light.area + g.area);
        light.area += g.area;
        light.power += g.power;
        std::int8_t& k = light.part_of_facing[facing_of(g.across, one_sided)];
        if (k < 0) {
            k = static_cast<std::int8_t>(light.parts.size());
            light.parts.emplace_back();
        }
        Part& part = light.parts[static_cast<std::size_t>(k)];
        part.one_sided = one_sided;
        part.center = (part.center * part.area + g.center * g.area) / (part.area + g.area);
        part.normal = (part.normal * part.area + g.across * 0.5f) / (part.area + g.area);
        part.area += g.area;
        part.triangles.push_back({g.mesh, g.triangle});
        part.cumulative.push_back((part.cumulative.empty() ? 0.f : part.cumulative.back()) + g.power);
        light_of_triangle_[static_cast<std::size_t>(g.mesh)][static_cast<std::size_t>(g.triangle)] = static_cast<std::int16_t>(lights_.size());
    }
    lights_.push_back(std::move(light));
}

void Lights::add_portal(const Room& room, int portal) {
    if (!sky_) sky_.emplace(room.sky);
    const Portal& p = room.portals[static_cast<std::size_t>(portal)];
    Light light;
    light.portal = portal;
    light.center = p.corner + p.edge_u * 0.5f + p.edge_v * 0.5f;
    const Vec3f across = cross(p.edge_u, p.edge_v);
    light.area = length(across);
    if (!(light.area > 0)) return;
    light.direction = across / light.area;
    light.power = light.area * brightness_behind(*sky_, light.direction);
    lights_.push_back(std::move(light));
}

// More than can be weighed at every place: the weakest are found by gathering, as large ones are.
void Lights::keep_strongest() {
    if (lights_.size() <= static_cast<std::size_t>(kMost)) return;
    std::vector<int> order(lights_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return lights_[static_cast<std::size_t>(a)].power > lights_[static_cast<std::size_t>(b)].power; });
    std::vector<Light> kept;
    std::vector<std::int16_t> place(lights_.size(), kNoLight);
    for (std::int16_t i = 0; i < kMost; ++i) {
        place[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])] = i;
        kept.push_back(std::move(lights_[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])]));
    }
    for (std::size_t m = 0; m < light_of_triangle_.size(); ++m)
        for (std::int16_t& light : light_of_triangle_[m]) {
            if (light == kNoLight) continue;
            light = place[static_cast<std::size_t>(light)];
            if (light == kNoLight) large_[m] = true;   // an object is one light here, so all of the mesh is
        }
    lights_ = std::move(kept);
}

Lights::Choice Lights::choice_at(Vec3f position, Vec3f normal) const {
    Choice choice;
    float sum = 0;
    for (const Light& light : lights_) {
        const Vec3f to = light.center - position;
        const float d2 = dot(to, to), far = std::sqrt(d2);
        // Generous with what lies near the horizon: its far end may stand above it.
        const float above =
            std::clamp(dot(normal, to) / std::max(far, 1e-4f) + 0.5f * std::sqrt(light.area) / std::max(far, 0.05f), 0.f, 1.f) + 0.01f;
        float facing = 1.f;
        if (light.portal >= 0) facing = std::max(0.f, -dot(light.direction, to) / std::max(far, 1e-4f)) + 0.02f;
        sum += light.power * above * facing / std::max(d2, 0.25f * light.area + 0.01f);
        choice.cumulative[static_cast<std::size_t>(choice.count++)] = sum;
    }
    if (!(sum > 0)) choice.count = 0;
    return choice;
}

float Lights::portal_density(const Room& room, const Choice& choice, Vec3f position, Vec3f direction) const {
    float sum = 0;
    for (int i = 0; i < choice.count; ++i) {
        const Light& light = lights_[static_cast<std::size_t>(i)];
        const float cosine = -dot(light.direction, direction);
        if (light.portal < 0 || !(cosine > 1e-5f)) continue;
        const Portal& p = room.portals[static_cast<std::size_t>(light.portal)];
        const float far = dot(p.corner - position, light.direction) / -cosine;
        if (!(far > 0)) continue;
        const Vec3f at = position + direction * far - p.corner;
        const float u = dot(at, p.edge_u) / dot(p.edge_u, p.edge_u), v = dot(at, p.edge_v) / dot(p.edge_v, p.edge_v);
        if (u >= 0 && u <= 1 && v >= 0 && v <= 1) sum += choice.chance(i) * far * far / (cosine * light.area);
    }
    return sum;
}

Lights::Towards Lights::draw(const Room& room, const Choice& choice, Vec3f position, Vec3f normal, Vec2f which, Vec2f uv) const {
    Towards out;
    if (choice.count == 0) return out;
    const std::size_t i = pick(choice.cumulative.data(), static_cast<std::size_t>(choice.count), which.x);
    const Light& light = lights_[i];
    const float chance = choice.chance(static_cast<int>(i));
    if (!(chance > 0)) return out;
    const Vec3f from = offset_from(position, normal);
    if (light.portal >= 0) {
        const Portal& p = room.portals[static_cast<std::size_t>(light.portal)];
        const Vec3f to = p.corner + p.edge_u * uv.x + p.edge_v * uv.y - from;
        out.direction = normalize(to);
        out.far = kFar;
        out.radiance = sky_->at(out.direction);
        out.density = portal_density(room, choice, from, out.direction);
        return out;
    }
    const auto shares = light.shares_at(position);
    const float all = shares[light.parts.size() - 1];
    const std::size_t k = pick(shares.data(), light.parts.size(), which.y);
    const Part& part = light.parts[k];
    // What is left of the number after the part was drawn is as even as the number was.
    const float below = k ? shares[k - 1] : 0.f, share = (shares[k] - below) / all;
    const float within = std::clamp((which.y * all - below) / (shares[k] - below), 0.f, 0.999999f);
    const std::size_t t = pick(part.cumulative.data(), part.cumulative.size(), within);
    const Triangle triangle = part.triangles[t];
    const auto [a, b, c] = corners(room, triangle.mesh, triangle.triangle);
    const float r = std::sqrt(uv.x);
    const Vec3f to = a * (1 - r) + b * (r * (1 - uv.y)) + c * (r * uv.y) - from;
    const float far = length(to);
    if (!(far > 1e-4f)) return out;
    out.direction = to / far;
    const Vec3f emission = emission_of(room, triangle.mesh);
    // A thin shade shines to both sides. The back of a solid does not, though its front may be too near it to stop the ray of shadow (a screen).
    const float away = dot(normalize(cross(b - a, c - a)), out.direction), there = part.one_sided ? -away : std::abs(away);
    if (!(there > 1e-5f)) return out;
    out.far = far * 0.999f - kSurfaceOffset;  // up to just before the lamp's own surface
    out.radiance = emission;
    out.density = chance * share * luminance(emission) / part.cumulative.back() * far * far / there;
    return out;
}

float Lights::density(const Room& room, const Choice& choice, Vec3f position, Vec3f direction, const RayHit& hit) const {
    if (choice.count == 0) return 0;
    if (!hit) return portal_density(room, choice, position, direction);
    const std::vector<std::int16_t>& light_of = light_of_triangle_[static_cast<std::size_t>(hit.mesh)];
    const int i = light_of.empty() ? kNoLight : light_of[static_cast<std::size_t>(hit.triangle)];
    if (i == kNoLight || (hit.back && closed_[static_cast<std::size_t>(hit.mesh)])) return 0;
    const Light& light = lights_[static_cast<std::size_t>(i)];
    const auto [a, b, c] = corners(room, hit.mesh, hit.triangle);
    const std::int8_t found = light.part_of_facing[facing_of(cross(b - a, c - a), closed_[static_cast<std::size_t>(hit.mesh)])];
    if (found < 0) return 0;
    const std::size_t k = static_cast<std::size_t>(found);
    const Part& part = light.parts[k];
    const auto shares = light.shares_at(position);
    const float share = (shares[k] - (k ? shares[k - 1] : 0.f)) / shares[light.parts.size() - 1];
    const float there = std::abs(dot(hit.normal, direction));
    return choice.chance(i) * share * luminance(emission_of(room, hit.mesh)) / part.cumulative.back() * hit.distance * hit.distance /
           std::max(1e-5f, there);
}

Vec3f Lights::sample(const Room& room, const SceneBvh& bvh, const Choice& choice, Vec3f position, Vec3f normal, Vec2f which, Vec2f uv) const {
    const Towards light = draw(room, choice, position, normal, which, uv);
    const float here = dot(normal, light.direction);
    if (!(light.density > 0 && here > 0) || bvh.blocked(offset_from(position, normal), light.direction, 0.f, light.far)) return {};
    const float near = light.far < kNearest ? light.far * light.far / (kNearest * kNearest) : 1.f;
    return light.radiance * (here * near / light.density);
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
