#include "fastscene/depth/painted_room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "fastscene/base/check.h"
#include "fastscene/depth/paint.h"
#include "fastscene/image/color.h"

namespace fastscene {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

// A box or its inscribed ellipsoid, rotated about its vertical axis. Room frame: y down, the camera at the origin.
struct Thing {
    Vec3f center, half;
    float c = 1, s = 0;  // cosine and sine of the rotation
    bool round = false;
    bool shines = false, window = false;
    Paint paint;
};

struct Scene {
    Vec3f low, high;             // the room's box
    std::array<Paint, 6> sides;  // -x +x ceiling floor -z +z
    std::vector<Thing> things;
    std::vector<Vec3f> lamps;
    float ambient = 0.4f, corner = 0.3f;  // light is reduced by this in corners
    bool shadows = true;
};

struct Hit {
    float t = kFar;
    Vec3f normal, local;  // local: position on the object, for its pattern
    const Paint* paint = nullptr;
    const Thing* thing = nullptr;  // null: the room's box

    bool lights() const { return thing && (thing->shines || thing->window); }
};

Vec3f turned(Vec3f v, float c, float s) { return {c * v.x - s * v.z, v.y, s * v.x + c * v.z}; }

// Distance at which a ray enters a box around the origin; kFar if it misses or starts inside.
float enter_box(Vec3f o, Vec3f d, Vec3f half, std::size_t& axis) {
    float near = 0, far = kFar;
    axis = 3;
    for (std::size_t a = 0; a < 3; ++a) {
        const float inverse = 1 / d[a];
        float t0 = (-half[a] - o[a]) * inverse, t1 = (half[a] - o[a]) * inverse;
        if (t0 > t1) std::swap(t0, t1);
        if (t0 > near) near = t0, axis = a;
        far = std::min(far, t1);
    }
    return near <= far && axis < 3 ? near : kFar;
}

float enter_ellipsoid(Vec3f o, Vec3f d, Vec3f half) {
    const Vec3f p{o.x / half.x, o.y / half.y, o.z / half.z}, q{d.x / half.x, d.y / half.y, d.z / half.z};
    const float a = dot(q, q), b = dot(p, q), root = b * b - a * (dot(p, p) - 1);
    if (root < 0) return kFar;
    const float t = (-b - std::sqrt(root)) / a;
    return t > 0 ? t : kFar;
}

void meet(const Thing& thing, Vec3f o, Vec3f d, Hit& hit) {
    const Vec3f lo = turned(o - thing.center, thing.c, -thing.s), ld = turned(d, thing.c, -thing.s);
    std::size_t axis = 3;
    const float t = thing.round ? enter_ellipsoid(lo, ld, thing.half) : enter_box(lo, ld, thing.half, axis);
    if (!(t < hit.t)) return;
    hit.t = t;
    hit.local = lo + ld * t;
    Vec3f n{};
    if (thing.round)
        n = normalize(Vec3f{hit.local.x / (thing.half.x * thing.half.x), hit.local.y / (thing.half.y * thing.half.y),
                            hit.local.z / (thing.half.z * thing.half.z)});
    else n[axis] = ld[axis] > 0 ? -1.f : 1.f;
    hit.normal = turned(n, thing.c, thing.s);
    hit.paint = &thing.paint;
    hit.thing = &thing;
}

Hit first_hit(const Scene& scene, Vec3f d) {
    Hit hit;
    for (std::size_t a = 0; a < 3; ++a) {
        const float t = d[a] > 0 ? scene.high[a] / d[a] : d[a] < 0 ? scene.low[a] / d[a] : kFar;
        if (!(t < hit.t)) continue;
        hit.t = t;
        hit.normal = {};
        hit.normal[a] = d[a] > 0 ? -1.f : 1.f;
        hit.paint = &scene.sides[2 * a + (d[a] > 0)];
        hit.local = d * t;
    }
    for (const Thing& thing : scene.things) meet(thing, {}, d, hit);
    return hit;
}

bool is_shadowed(const Scene& scene, Vec3f from, Vec3f lamp) {
    const Vec3f to = lamp - from;
    for (const Thing& thing : scene.things) {
        Hit hit;
        hit.t = 0.98f;
        meet(thing, from, to, hit);
        if (hit.thing && !hit.lights()) return true;
    }
    return false;
}

Vec3f light_at(const Scene& scene, Vec3f p, const Hit& hit) {
    const Vec3f albedo = color_of(*hit.paint, hit.local, hit.normal);
    if (hit.lights()) return albedo * 3.f;
    float open = 1;  // ambient occlusion in corners
    for (std::size_t a = 0; a < 3; ++a)
        if (std::abs(hit.normal[a]) < 0.7f)
            open *= (1 - scene.corner * std::exp(-(p[a] - scene.low[a]) / 0.4f)) *
                    (1 - scene.corner * std::exp(-(scene.high[a] - p[a]) / 0.4f));
    float light = scene.ambient * open * (1 - 0.15f * hit.normal.y);
    for (const Vec3f lamp : scene.lamps) {
        const Vec3f to = lamp - p;
        const float square = dot(to, to), facing = dot(to, hit.normal) / std::sqrt(square);
        if (facing <= 0 || (scene.shadows && is_shadowed(scene, p + hit.normal * 0.01f, lamp))) continue;
        light += 2.f * facing / (1 + square) / static_cast<float>(scene.lamps.size());
    }
    return albedo * light;
}

// ---- randomization ----

// Whether the camera is at least a hand's breadth away from it.
bool clear_of_camera(const Thing& t) {
    const Vec3f o = turned(-t.center, t.c, -t.s);
    Vec3f gap;
    for (std::size_t a = 0; a < 3; ++a) gap[a] = std::max(0.f, std::abs(o[a]) - t.half[a]);
    return length(gap) > 0.25f;
}

void add(Scene& scene, Thing thing) {
    if (clear_of_camera(thing)) scene.things.push_back(thing);
}

// A box standing on the floor, by center, size and rotation.
Thing standing(const Scene& scene, Vec3f size, float x, float z, float turn) {
    Thing t;
    t.half = size * 0.5f;
    t.center = {x, scene.high.y - t.half.y, z};
    t.c = std::cos(turn), t.s = std::sin(turn);
    return t;
}

// A table: a top and four legs; a seat: a box and a back.
void add_furniture(Scene& scene, Random& rng) {
    const float room = std::min(scene.high.x - scene.low.x, scene.high.z - scene.low.z);
    Vec3f size{rng.uniform(0.3f, 2.2f), rng.chance(0.65f) ? rng.uniform(0.3f, 1.f) : rng.uniform(1.f, 2.3f),
               rng.uniform(0.3f, 1.f)};
    size.x = std::min(size.x, 0.6f * room);
    size.y = std::min(size.y, 0.95f * (scene.high.y - scene.low.y));
    float turn = static_cast<float>(rng.index(4)) * kPi / 2;
    float x = rng.uniform(scene.low.x, scene.high.x), z = rng.uniform(scene.low.z, scene.high.z);
    if (rng.chance(0.7f)) {  // back against a wall
        const float back = size.z / 2 + 0.02f;
        const int wall = rng.index(4);
        turn = static_cast<float>(wall) * kPi / 2;
        if (wall == 0) z = scene.low.z + back;
        if (wall == 2) z = scene.high.z - back;
        if (wall == 1) x = scene.high.x - back;
        if (wall == 3) x = scene.low.x + back;
    } else if (rng.chance(0.4f)) {
        turn += rng.uniform(-0.6f, 0.6f);
    }
    Thing body = standing(scene, size, x, z, turn);
    body.paint = random_paint(rng, 0.04f, 0.8f, 0.6f);
    const float kind = rng.uniform();
    if (kind < 0.25f && size.y < 1.1f) {
        Thing top = body;
        top.half.y = 0.025f;
        top.center.y = scene.high.y - size.y + 0.025f;
        add(scene, top);
        for (const float sx : {-1.f, 1.f})
            for (const float sz : {-1.f, 1.f}) {
                const Vec3f at = turned({sx * (body.half.x - 0.04f), 0, sz * (body.half.z - 0.04f)}, body.c, body.s);
                Thing leg = standing(scene, {0.05f, size.y - 0.05f, 0.05f}, x + at.x, z + at.z, turn);
                leg.paint = body.paint;
                add(scene, leg);
            }
    } else if (kind < 0.45f && size.y < 1.1f) {
        Thing seat = standing(scene, {size.x, 0.45f * size.y, size.z}, x, z, turn);
        seat.paint = body.paint;
        add(scene, seat);
        const Vec3f at = turned({0, 0, -0.4f * size.z}, body.c, body.s);
        Thing back = standing(scene, {size.x, size.y, 0.2f * size.z}, x + at.x, z + at.z, turn);
        back.paint = body.paint;
        add(scene, back);
    } else {
        body.round = kind > 0.93f;
        add(scene, body);
    }
    if (size.y < 1.2f && rng.chance(0.4f)) {  // an object on top
        Thing on = standing(scene, {rng.uniform(0.05f, 0.4f), rng.uniform(0.05f, 0.5f), rng.uniform(0.05f, 0.3f)}, x, z,
                            rng.uniform(0, kPi));
        on.center.y -= size.y;
        on.round = rng.chance(0.5f);
        on.paint = random_paint(rng, 0.04f, 0.8f, 0.6f);
        add(scene, on);
    }
}

// A thin panel on a wall: a picture, a window, a door, a curtain.
void add_sheet(Scene& scene, Random& rng) {
    const int wall = rng.index(4);
    const bool along_x = wall % 2 == 0;
    const float span = along_x ? scene.high.x - scene.low.x : scene.high.z - scene.low.z,
                tall = scene.high.y - scene.low.y;
    const float width = std::min(0.8f * span, rng.uniform(0.3f, 2.2f)), kind = rng.uniform();
    const bool door = kind<0.25f, window = kind> 0.6f;
    const float height = door ? std::min(2.05f, 0.9f * tall) : rng.uniform(0.3f, 0.6f) * tall,
                along = rng.uniform(0, span - width) + width / 2;
    const float thick = kind > 0.5f && !window ? 0.12f : 0.03f,
                y = door ? scene.high.y - height / 2
                         : scene.low.y + rng.uniform(0.5f, 0.6f) * (tall - height) + height / 2;
    Thing t;
    t.half = along_x ? Vec3f{width / 2, height / 2, thick / 2} : Vec3f{thick / 2, height / 2, width / 2};
    t.center = along_x ? Vec3f{scene.low.x + along, y, wall == 0 ? scene.low.z : scene.high.z}
                       : Vec3f{wall == 1 ? scene.high.x : scene.low.x, y, scene.low.z + along};
    t.paint = random_paint(rng, 0.05f, 0.9f, 0.3f);
    t.window = window;
    add(scene, t);
}

// A corner cut off from the room: L-shaped rooms, pillars.
void add_corner(Scene& scene, Random& rng) {
    const float w = scene.high.x - scene.low.x, d = scene.high.z - scene.low.z, tall = scene.high.y - scene.low.y;
    const float x = rng.uniform(0.05f, 0.45f) * w, z = rng.uniform(0.05f, 0.45f) * d;
    Thing t = standing(scene, {x, tall, z}, rng.chance(0.5f) ? scene.low.x + x / 2 : scene.high.x - x / 2,
                       rng.chance(0.5f) ? scene.low.z + z / 2 : scene.high.z - z / 2, 0);
    t.paint = scene.sides[rng.chance(0.5f) ? 0 : 4];
    if (clear_of_camera(t)) scene.things.push_back(t);
}

Scene random_scene(Random& rng) {
    Scene scene;
    const auto two = [&](float least) {
        const float span = std::exp(rng.uniform(std::log(2.f), std::log(9.f))), share = rng.uniform(0.15f, 0.85f);
        return Vec2f{-std::max(least, share * span), std::max(least, (1 - share) * span)};
    };
    const Vec2f x = two(0.5f), z = two(0.5f);
    const float below = rng.uniform(0.7f, 2.f);
    scene.low = {x.x, -std::max(0.4f, rng.uniform(2.2f, 3.4f) - below), z.x};
    scene.high = {x.y, below, z.y};
    const Paint walls = random_paint(rng, 0.2f, 0.85f, 0.7f);
    for (Paint& side : scene.sides) side = rng.chance(0.25f) ? random_paint(rng, 0.15f, 0.85f, 0.6f) : walls;
    scene.sides[2] = random_paint(rng, 0.45f, 0.9f, 0.85f);
    scene.sides[3] = random_paint(rng, 0.05f, 0.6f, 0.3f);
    scene.ambient = rng.uniform(0.25f, 0.7f);
    scene.corner = rng.uniform(0.1f, 0.5f);
    scene.shadows = rng.chance(0.7f);
    if (rng.chance(0.35f)) add_corner(scene, rng);
    if (rng.chance(0.12f)) add_corner(scene, rng);
    for (int i = rng.index(15); i > 0; --i) add_furniture(scene, rng);
    for (int i = rng.index(8); i > 0; --i) add_sheet(scene, rng);
    for (int i = 1 + rng.index(3); i > 0; --i) {
        const Vec3f at{rng.uniform(0.8f * scene.low.x, 0.8f * scene.high.x), scene.low.y + rng.uniform(0.1f, 0.6f),
                       rng.uniform(0.8f * scene.low.z, 0.8f * scene.high.z)};
        scene.lamps.push_back(at);
        Thing shade;
        shade.center = at;
        shade.half = {rng.uniform(0.06f, 0.25f), rng.uniform(0.04f, 0.15f), 0.15f};
        shade.half.z = shade.half.x;
        shade.round = rng.chance(0.6f);
        shade.paint = random_paint(rng, 0.4f, 0.9f, 1);
        shade.shines = true;
        if (rng.chance(0.7f)) add(scene, shade);
    }
    return scene;
}

}  // namespace

DepthExample painted_room(EquirectSize size, Random& rng) {
    FASTSCENE_CHECK(size.width > 0 && size.height > 0);
    const Scene scene = random_scene(rng);
    const float yaw = rng.uniform(0, kPi / 2), c = std::cos(yaw), s = std::sin(yaw);
    ImageColor light(size.width, size.height);
    ImageF range(size.width, size.height);
    double mean = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Vec3f d = turned(direction_of_pixel(x, y, size), c, s);
            const Hit hit = first_hit(scene, d);
            range.at(x, y) = hit.thing && hit.thing->window ? 0.f : hit.t;
            // A second ray besides the center's antialiases edges.
            const Vec3f beside = turned(
                direction_at(Vec2f{static_cast<float>(x) + rng.uniform(), static_cast<float>(y) + rng.uniform()}, size),
                c, s);
            const Hit other = first_hit(scene, beside);
            light.at(x, y) = (light_at(scene, d * hit.t, hit) + light_at(scene, beside * other.t, other)) * 0.5f;
            mean += luminance(light.at(x, y));
        }
    // Automatic exposure.
    const float gain = 0.3f / std::max(1e-4f, static_cast<float>(mean / static_cast<double>(light.size())));
    for (Vec3f& v : light.pixels) v = v * gain;
    return {srgb8_from_linear(light), std::move(range)};
}

}  // namespace fastscene
