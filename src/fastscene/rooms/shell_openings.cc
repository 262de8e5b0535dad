// Windows, doors, doorways, and the slopes of an attic with their skylights.
#include <array>
#include <cmath>

#include "fastscene/rooms/shell_kit.h"

namespace fastscene::shell {
namespace {

// Object frame of a thing on a wall: x along (to the left as seen from inside, so that the frame is right-handed), y
// up, z inward.
Rigid on_wall(const WallFace& face, Vec3f base) {
    return {Mat3f::from_columns(-face.along, {0, 1, 0}, face.inward), base};
}

void add_portal(Room& room, Vec3f corner, Vec3f u, Vec3f v, Vec3f inward) {
    room.portals.push_back(dot(cross(u, v), inward) > 0 ? Portal{corner, u, v} : Portal{corner + u, -u, v});
}

// It covers the wall below the window.
void build_sill(const Opening& o, const WallBuilder& wall, int material, int object) {
    wall.box(o.u0 - kSillBeside, o.u1 + kSillBeside, o.y0 - kSillThickness, o.y0 + kHair_m, -kRevealDepth, kSillReach,
             material, object);
}

// Frame, bars and casing of a window that is not square; only an arched one has a sill.
void build_shaped_window(const Plan& plan, const Opening& o, const WallBuilder& wall, Room& room, int frame,
                         int object) {
    const float w0 = -0.17f, w1 = -kRevealDepth, bar = 0.05f, middle = (o.u0 + o.u1) / 2;
    ring(wall, o, -bar, 0, w0, w1, frame, object);
    const auto upright = [&](float u, float half) {
        const auto [low, high] = extent_at(o, u);
        wall.box(u - half, u + half, low + 0.5f * bar, high - 0.5f * bar, w0 + kHair_m, w1 - kHair_m, frame, object);
    };
    if (o.shape == Opening::Shape::round) {
        // A porthole has one pane and a heavy ring; larger ones have a cross.
        constexpr float kPorthole = 0.75f;
        if (o.u1 - o.u0 > kPorthole) {
            upright(middle, 0.018f);
            const float y = (o.y0 + o.y1) / 2;
            wall.box(o.u0 + 0.5f * bar, middle - 0.018f, y - 0.016f, y + 0.016f, w0 + 0.006f, w1 - 0.006f, frame,
                     object);
            wall.box(middle + 0.018f, o.u1 - 0.5f * bar, y - 0.016f, y + 0.016f, w0 + 0.006f, w1 - 0.006f, frame,
                     object);
        }
        const bool porthole = o.u1 - o.u0 <= kPorthole;
        const PromptObject* asked = plan.asked("window");
        const bool said = asked && (!asked->color.empty() || !asked->material.empty());
        const int rim = porthole && !said ? add_material(room, *material_named("brass")) : frame;
        ring(wall, o, -0.012f, porthole ? 0.07f : 0.06f, 0, 0.03f, rim, object);
        for (int i = 0; porthole && i < 8; ++i) {  // bolts
            const float a = (static_cast<float>(i) + 0.5f) * kPi / 4, r = (o.u1 - o.u0) / 2 + 0.04f;
            const Vec2f at{middle + r * std::cos(a), (o.y0 + o.y1) / 2 + r * std::sin(a)};
            wall.box(at.x - 0.011f, at.x + 0.011f, at.y - 0.011f, at.y + 0.011f, 0.03f, 0.04f, rim, object);
        }
        return;
    }
    const float spring = o.y1 - arch_rise(o);
    wall.box(o.u0, o.u0 + bar, o.y0, spring, w0, w1, frame, object);
    wall.box(o.u1 - bar, o.u1, o.y0, spring, w0, w1, frame, object);
    wall.box(o.u0 + bar, o.u1 - bar, o.y0, o.y0 + bar, w0, w1, frame, object);
    wall.box(o.u0 + bar, o.u1 - bar, spring - 0.02f, spring + 0.02f, w0 + 0.008f, w1 - 0.008f, frame, object);
    const int columns = std::max(2, static_cast<int>(std::ceil((o.u1 - o.u0) / 0.6f)));
    for (int i = 1; i < columns; ++i)
        upright(o.u0 + (o.u1 - o.u0) * static_cast<float>(i) / static_cast<float>(columns), 0.02f);
    const int rows = std::max(1, plan.style.window_rows);
    for (int i = 1; i < rows; ++i) {
        const float y = o.y0 + (spring - o.y0) * static_cast<float>(i) / static_cast<float>(rows);
        wall.box(o.u0 + bar, o.u1 - bar, y - 0.014f, y + 0.014f, w0 + 0.008f, w1 - 0.008f, frame, object);
    }
    build_sill(o, wall, frame, object);
    if (plan.style.mouldings == Mouldings::none) return;
    wall.box(o.u0 - kCasing, o.u0, o.y0, spring, 0, 0.025f, frame, object);
    wall.box(o.u1, o.u1 + kCasing, o.y0, spring, 0, 0.025f, frame, object);
    ring(wall, o, 0, kCasing, 0, 0.025f, frame, object);
}

void build_window(const Plan& plan, const Opening& o, Room& room, const Materials& m) {
    const WallFace face = plan.wall(o.wall);
    const WallBuilder wall(face, room);
    const int object = opening_object(plan, room, is_doors(o.glazing) ? "door" : "window", o, face,
                                      plan.wall_thickness());
    const int frame = plan.asked("window") ? add_material(room, as_asked(plan, "window", plan.style.trim)) : m.trim;
    // The light comes in through the outer face of the wall; u x v points into the room.
    if (!plan.tunnel)
        add_portal(room, face.point(o.u0, o.y0) - face.inward * plan.wall_thickness(), face.along * (o.u1 - o.u0),
                   {0, o.y1 - o.y0, 0}, face.inward);
    if (o.shape == Opening::Shape::rounded || is_doors(o.glazing))
        return build_cabin_opening(plan, o, wall, room, object);
    if (!plan.glazed && !plan.asked("window")) return build_arcade_arch(o, face, room, m.wall, object);
    if (o.shape != Opening::Shape::square) return build_shaped_window(plan, o, wall, room, frame, object);
    // Frame and bars stand in the outer half of the wall, so that there is a reveal inside.
    const float w0 = -0.17f, w1 = -kRevealDepth, bar = 0.05f;
    wall.box(o.u0, o.u0 + bar, o.y0, o.y1, w0, w1, frame, object);
    wall.box(o.u1 - bar, o.u1, o.y0, o.y1, w0, w1, frame, object);
    wall.box(o.u0 + bar, o.u1 - bar, o.y0, o.y0 + bar, w0, w1, frame, object);
    wall.box(o.u0 + bar, o.u1 - bar, o.y1 - bar, o.y1, w0, w1, frame, object);
    const int columns = std::max(plan.style.window_columns, static_cast<int>(std::ceil((o.u1 - o.u0) / 1.1f))),
              rows = plan.style.window_rows;
    for (int i = 1; i < columns; ++i) {
        const float u = o.u0 + (o.u1 - o.u0) * static_cast<float>(i) / static_cast<float>(columns);
        wall.box(u - 0.022f, u + 0.022f, o.y0 + bar, o.y1 - bar, w0, w1, frame, object);
    }
    for (int i = 1; i < rows; ++i) {
        const float y = o.y0 + (o.y1 - o.y0) * static_cast<float>(i) / static_cast<float>(rows);
        wall.box(o.u0 + bar, o.u1 - bar, y - 0.014f, y + 0.014f, w0 + 0.008f, w1 - 0.008f, frame, object);
    }
    // The sill, and a casing on the wall where the style has mouldings.
    build_sill(o, wall, frame, object);
    if (plan.style.mouldings != Mouldings::none) {
        wall.box(o.u0 - 0.08f, o.u0, o.y0, o.y1, 0, 0.025f, frame, object);
        wall.box(o.u1, o.u1 + 0.08f, o.y0, o.y1, 0, 0.025f, frame, object);
        wall.box(o.u0 - 0.08f, o.u1 + 0.08f, o.y1, o.y1 + 0.08f, 0, 0.025f, frame, object);
    }
}

// A cased opening through the wall; the floor goes on behind a saddle of wood.
void build_doorway(const Plan& plan, const Opening& o, Room& room, int trim) {
    if (plan.asked("doorway")) trim = add_material(room, as_asked(plan, "doorway", plan.style.trim));
    const WallFace face = plan.wall(o.wall);
    const WallBuilder wall(face, room);
    const int object = opening_object(plan, room, "doorway", o, face, kWallThickness);
    constexpr float kJamb = 0.02f, kProud = 0.02f;
    const int saddle = add_material(room, plan.style.wood);
    wall.box(o.u0 + kJamb, o.u1 - kJamb, -0.05f, 0.006f, -kWallThickness - 0.01f, 0.01f, saddle, object);
    if (o.shape != Opening::Shape::square) {
        const float spring = o.y1 - arch_rise(o);
        for (const auto& [w0, w1] : {std::pair{0.f, kProud}, std::pair{-kWallThickness - kProud, -kWallThickness}}) {
            wall.box(o.u0 - kCasing, o.u0 + kJamb, 0, spring, w0, w1, trim, object);
            wall.box(o.u1 - kJamb, o.u1 + kCasing, 0, spring, w0, w1, trim, object);
            ring(wall, o, -kJamb, kCasing, w0, w1, trim, object);
        }
        wall.box(o.u0, o.u0 + kJamb, 0, spring, -kWallThickness, 0, trim, object);
        wall.box(o.u1 - kJamb, o.u1, 0, spring, -kWallThickness, 0, trim, object);
        return ring(wall, o, -kJamb, 0, -kWallThickness, 0, trim, object);
    }
    for (const auto& [w0, w1] : {std::pair{0.f, kProud}, std::pair{-kWallThickness - kProud, -kWallThickness}}) {
        wall.box(o.u0 - kCasing, o.u0 + kJamb, 0, o.y1 + kCasing, w0, w1, trim, object);
        wall.box(o.u1 - kJamb, o.u1 + kCasing, 0, o.y1 + kCasing, w0, w1, trim, object);
        wall.box(o.u0 + kJamb, o.u1 - kJamb, o.y1 - kJamb, o.y1 + kCasing, w0, w1, trim, object);
    }
    wall.box(o.u0, o.u0 + kJamb, 0, o.y1, -kWallThickness, 0, trim, object);
    wall.box(o.u1 - kJamb, o.u1, 0, o.y1, -kWallThickness, 0, trim, object);
    wall.box(o.u0 + kJamb, o.u1 - kJamb, o.y1 - kJamb, o.y1, -kWallThickness, 0, trim, object);
}

// A point of the slope above a side wall: z along the room, s metres up the slope, `out` metres behind its face.
struct Slope {
    const Plan& plan;
    float side;  // +1: wall 1, -1: wall 3
    float length() const { return std::hypot(plan.slope_run, plan.height - plan.knee); }
    Vec3f up() const { return normalize(Vec3f{-side * plan.slope_run, plan.height - plan.knee, 0}); }
    Vec3f inward() const { return normalize(Vec3f{-side * (plan.height - plan.knee), -plan.slope_run, 0}); }
    Vec3f point(float z, float s, float out) const {
        return Vec3f{side * plan.width / 2, plan.knee, z} + up() * s - inward() * out;
    }
};

// A box on the slope.
void slope_box(const Slope& slope, Room& room, float z0, float z1, float s0, float s1, float out0, float out1,
               int material, int object = -1) {
    if (!(z1 > z0 && s1 > s0 && out1 > out0)) return;
    Mesh mesh = box_mesh({s0, out0, z0}, {s1, out1, z1}, material, object);
    for (Vec3f& p : mesh.positions) p = slope.point(p.z, p.x, p.y);
    for (Vec3f& n : mesh.normals) n = slope.up() * n.x - slope.inward() * n.y + Vec3f{0, 0, n.z};
    // The frame (s, out, z) is left-handed on one side of the room.
    if (dot(cross(slope.up(), -slope.inward()), Vec3f{0, 0, 1}) < 0)
        for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
            std::swap(mesh.triangles[t + 1], mesh.triangles[t + 2]);
    room.meshes.push_back(std::move(mesh));
}

void build_slope(const Plan& plan, int wall, const Materials& m, Room& room) {
    const Slope slope{plan, wall == 1 ? 1.f : -1.f};
    constexpr float kThick = 0.16f, kBeyond = 0.12f;  // the slab reaches beyond its ends, so that nothing shines in
    const float d = plan.depth / 2 + kWallThickness, low = -kBeyond, high = slope.length() + kBeyond;
    std::vector<Skylight> holes;
    for (const Skylight& k : plan.skylights)
        if (k.wall == wall) holes.push_back(k);
    std::sort(holes.begin(), holes.end(), [](const Skylight& a, const Skylight& b) { return a.z0 < b.z0; });
    float z = -d;
    for (const Skylight& k : holes) {
        slope_box(slope, room, z, k.z0, low, high, 0, kThick, m.ceiling);
        slope_box(slope, room, k.z0, k.z1, low, k.s0, 0, kThick, m.ceiling);
        slope_box(slope, room, k.z0, k.z1, k.s1, high, 0, kThick, m.ceiling);
        z = k.z1;

        RoomObject object;
        object.kind = object.name = "skylight";
        object.source = "built-in";
        object.size_m = {k.z1 - k.z0, k.s1 - k.s0, kThick};
        const WallFace face = plan.wall(wall);  // upright like every object: its front looks into the room
        object.world_from_object = on_wall(face, slope.point((k.z0 + k.z1) / 2, k.s0, 0));
        room.objects.push_back(object);
        const auto index = static_cast<int>(room.objects.size()) - 1;
        constexpr float kBar = 0.06f;
        slope_box(slope, room, k.z0, k.z0 + kBar, k.s0, k.s1, 0.05f, 0.12f, m.trim, index);
        slope_box(slope, room, k.z1 - kBar, k.z1, k.s0, k.s1, 0.05f, 0.12f, m.trim, index);
        slope_box(slope, room, k.z0 + kBar, k.z1 - kBar, k.s0, k.s0 + kBar, 0.05f, 0.12f, m.trim, index);
        slope_box(slope, room, k.z0 + kBar, k.z1 - kBar, k.s1 - kBar, k.s1, 0.05f, 0.12f, m.trim, index);
        add_portal(room, slope.point(k.z0, k.s0, kThick), Vec3f{0, 0, k.z1 - k.z0}, slope.up() * (k.s1 - k.s0),
                   slope.inward());
    }
    slope_box(slope, room, z, d, low, high, 0, kThick, m.ceiling);
}

}  // namespace

int opening_object(const Plan& plan, Room& room, const char* kind, const Opening& o, const WallFace& face,
                   float depth) {
    RoomObject object;
    object.kind = kind;
    if (const PromptObject* wish = plan.asked(kind)) object.color = wish->color;
    object.name = object.color.empty() ? kind : object.color + " " + kind;
    object.world_from_object = on_wall(face, face.point((o.u0 + o.u1) / 2, o.y0));
    object.size_m = {o.u1 - o.u0, o.y1 - o.y0, depth};
    object.source = "built-in";
    object.requested = o.requested;
    room.objects.push_back(object);
    return static_cast<int>(room.objects.size()) - 1;
}

std::pair<float, float> extent_at(const Opening& o, float u) {
    if (o.shape == Opening::Shape::square) return {o.y0, o.y1};
    const bool round = o.shape == Opening::Shape::round;
    const float rise = round ? (o.y1 - o.y0) / 2 : arch_rise(o), x = (u - (o.u0 + o.u1) / 2) / ((o.u1 - o.u0) / 2),
                lift = rise * std::sqrt(std::max(0.f, 1.f - x * x));
    return {round ? o.y1 - rise - lift : o.y0, o.y1 - rise + lift};
}

void build_openings(const Plan& plan, const Materials& m, Room& room) {
    Random rng(room.seed, "door");
    for (const Opening& o : plan.openings) {
        if (o.kind == Opening::Kind::window) build_window(plan, o, room, m);
        else if (o.kind == Opening::Kind::door) build_door(plan, o, room, m.trim, rng);
        else if (!plan.joined) build_doorway(plan, o, room, m.trim);
    }
}

void build_skylights(const Plan& plan, const Materials& m, Room& room) {
    for (const int wall : {1, 3}) build_slope(plan, wall, m, room);
}

}  // namespace fastscene::shell
