#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/rooms/plan.h"
#include "fastscene/scene/box.h"

namespace fastscene {
namespace {

// Builds boxes in wall coordinates: u along, y up, w into the room (negative: into the wall).
class WallBuilder {
  public:
    WallBuilder(const WallFace& face, Room& room) : face_(face), room_(room) {}
    void box(float u0, float u1, float y0, float y1, float w0, float w1, int material, int object = -1) const {
        if (!(u1 > u0 && y1 > y0 && w1 > w0)) return;
        const Vec3f a = face_.point(u0, y0) + face_.inward * w0, b = face_.point(u1, y1) + face_.inward * w1;
        room_.meshes.push_back(box_mesh({std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}, {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)},
                                           material, object));
    }

  private:
    const WallFace& face_;
    Room& room_;
};

int add_material(Room& room, Material m) {
    room.materials.push_back(std::move(m));
    return static_cast<int>(room.materials.size()) - 1;
}

Material painted(Material base, const std::string& color) {
    if (const auto c = color.empty() ? std::nullopt : color_named(color)) base.color_a = base.color_b = base.color_c = *c;
    return base;
}

// Object frame of a thing on a wall: x along (to the left as seen from inside, so that the frame is right-handed), y up, z inward.
Rigid on_wall(const WallFace& face, Vec3f base) {
    return {Mat3f::from_columns(-face.along, {0, 1, 0}, face.inward), base};
}

// The wall around its openings: columns between openings, and what is below and above each.
void build_wall(const Plan& plan, int index, Room& room, int material) {
    const WallFace face = plan.wall(index);
    const WallBuilder wall(face, room);
    // Far and near walls reach over the corners, so that the shell is closed.
    const float over = index % 2 == 0 ? kWallThickness : 0.f;
    std::vector<Opening> holes;
    for (const Opening& o : plan.openings)
        if (o.wall == index && o.kind == Opening::Kind::window) holes.push_back(o);
    std::sort(holes.begin(), holes.end(), [](const Opening& a, const Opening& b) { return a.u0 < b.u0; });
    float u = -over;
    for (const Opening& hole : holes) {
        wall.box(u, hole.u0, 0, plan.height, -kWallThickness, 0, material);
        wall.box(hole.u0, hole.u1, 0, hole.y0, -kWallThickness, 0, material);
        wall.box(hole.u0, hole.u1, hole.y1, plan.height, -kWallThickness, 0, material);
        u = hole.u1;
    }
    wall.box(u, face.length + over, 0, plan.height, -kWallThickness, 0, material);
}

void build_skirting(const Plan& plan, int index, Room& room, int trim) {
    const WallFace face = plan.wall(index);
    const WallBuilder wall(face, room);
    float u = 0;
    for (const Opening& o : plan.openings)
        if (o.wall == index && o.kind == Opening::Kind::door) {
            wall.box(u, o.u0 - 0.08f, 0, 0.09f, 0, 0.02f, trim);
            u = o.u1 + 0.08f;
        }
    wall.box(u, face.length, 0, 0.09f, 0, 0.02f, trim);
    if (plan.style.mouldings == Mouldings::none) return;
    // One plain profile: finer ones are thinner than the light is sampled.
    wall.box(0, face.length, plan.height - 0.1f, plan.height, 0, 0.06f, trim);
    if (plan.style.mouldings != Mouldings::rich) return;
    // A dado rail, interrupted by openings.
    u = 0;
    std::vector<Opening> breaks;
    for (const Opening& o : plan.openings)
        if (o.wall == index && o.y0 < 1.f) breaks.push_back(o);
    std::sort(breaks.begin(), breaks.end(), [](const Opening& a, const Opening& b) { return a.u0 < b.u0; });
    for (const Opening& o : breaks) {
        wall.box(u, o.u0 - 0.08f, 0.92f, 0.98f, 0, 0.025f, trim);
        u = o.u1 + 0.08f;
    }
    wall.box(u, face.length, 0.92f, 0.98f, 0, 0.025f, trim);
}

int add_object(Room& room, const char* klass, const Opening& o, const WallFace& face, float depth) {
    RoomObject object;
    object.klass = klass;
    object.name = o.color.empty() ? klass : o.color + " " + klass;
    object.color = o.color;
    object.world_from_object = on_wall(face, face.point((o.u0 + o.u1) / 2, o.y0));
    object.size_m = {o.u1 - o.u0, o.y1 - o.y0, depth};
    object.source = "built-in";
    object.requested = o.requested;
    room.objects.push_back(object);
    return static_cast<int>(room.objects.size()) - 1;
}

void build_window(const Plan& plan, const Opening& o, Room& room, int trim) {
    const WallFace face = plan.wall(o.wall);
    const WallBuilder wall(face, room);
    const int object = add_object(room, "window", o, face, kWallThickness);
    const int frame = o.color.empty() ? trim : add_material(room, painted(plan.style.trim, o.color));
    // Frame and bars stand in the outer half of the wall, so that there is a reveal inside.
    const float w0 = -0.17f, w1 = -0.12f, bar = 0.05f;
    wall.box(o.u0, o.u0 + bar, o.y0, o.y1, w0, w1, frame, object);
    wall.box(o.u1 - bar, o.u1, o.y0, o.y1, w0, w1, frame, object);
    wall.box(o.u0 + bar, o.u1 - bar, o.y0, o.y0 + bar, w0, w1, frame, object);
    wall.box(o.u0 + bar, o.u1 - bar, o.y1 - bar, o.y1, w0, w1, frame, object);
    const int columns = std::max(plan.style.window_columns, static_cast<int>(std::ceil((o.u1 - o.u0) / 1.1f))), rows = plan.style.window_rows;
    for (int i = 1; i < columns; ++i) {
        const float u = o.u0 + (o.u1 - o.u0) * static_cast<float>(i) / static_cast<float>(columns);
        wall.box(u - 0.022f, u + 0.022f, o.y0 + bar, o.y1 - bar, w0, w1, frame, object);
    }
    for (int i = 1; i < rows; ++i) {
        const float y = o.y0 + (o.y1 - o.y0) * static_cast<float>(i) / static_cast<float>(rows);
        wall.box(o.u0 + bar, o.u1 - bar, y - 0.014f, y + 0.014f, w0 + 0.008f, w1 - 0.008f, frame, object);
    }
    // The sill, and a casing on the wall where the style has mouldings.
    wall.box(o.u0 - 0.05f, o.u1 + 0.05f, o.y0 - 0.03f, o.y0, -0.12f, 0.04f, frame, object);
    if (plan.style.mouldings != Mouldings::none) {
        wall.box(o.u0 - 0.08f, o.u0, o.y0, o.y1, 0, 0.025f, frame, object);
        wall.box(o.u1, o.u1 + 0.08f, o.y0, o.y1, 0, 0.025f, frame, object);
        wall.box(o.u0 - 0.08f, o.u1 + 0.08f, o.y1, o.y1 + 0.08f, 0, 0.025f, frame, object);
    }
    // The light comes in through the outer face of the wall; u x v points into the room.
    const Vec3f corner = face.point(o.u0, o.y0) - face.inward * kWallThickness;
    const Vec3f u = face.along * (o.u1 - o.u0), v{0, o.y1 - o.y0, 0};
    room.portals.push_back(dot(cross(u, v), face.inward) > 0 ? Portal{corner, u, v} : Portal{corner + u, -u, v});
}

void build_door(const Plan& plan, const Opening& o, Room& room, int trim, Random& dice) {
    const WallFace face = plan.wall(o.wall);
    const WallBuilder wall(face, room);
    const int object = add_object(room, "door", o, face, 0.05f);
    Material leaf = painted(dice.chance(0.5f) ? plan.style.trim : plan.style.wood, o.color);
    const int door = add_material(room, leaf), metal = add_material(room, plan.style.metal);
    wall.box(o.u0, o.u1, 0.005f, o.y1, -0.01f, 0.02f, door, object);
    // Two panels stand proud of the leaf.
    const float inset = 0.13f, middle = 0.95f;
    wall.box(o.u0 + inset, o.u1 - inset, 0.2f, middle - 0.06f, 0.02f, 0.04f, door, object);
    wall.box(o.u0 + inset, o.u1 - inset, middle + 0.08f, o.y1 - inset, 0.02f, 0.04f, door, object);
    for (const auto& [u0, u1] : {std::pair{o.u0 - 0.08f, o.u0}, std::pair{o.u1, o.u1 + 0.08f}}) wall.box(u0, u1, 0, o.y1 + 0.08f, 0, 0.045f, trim, object);
    wall.box(o.u0, o.u1, o.y1, o.y1 + 0.08f, 0, 0.045f, trim, object);
    const float handle = o.u0 < face.length / 2 ? o.u1 - 0.07f : o.u0 + 0.07f, reach = o.u0 < face.length / 2 ? -0.12f : 0.12f;
    wall.box(handle - 0.012f, handle + 0.012f, 0.99f, 1.05f, 0.02f, 0.028f, metal, object);
    wall.box(handle - 0.008f, handle + 0.008f, 1.012f, 1.03f, 0.028f, 0.065f, metal, object);
    wall.box(std::min(handle, handle + reach), std::max(handle, handle + reach), 1.012f, 1.03f, 0.052f, 0.066f, metal, object);
}

void build_beams(const Plan& plan, Room& room) {
    Material wood = plan.style.wood;
    wood.bump_m = std::max(wood.bump_m, 0.001f);
    const int material = add_material(room, wood);
    const int count = std::max(2, static_cast<int>(plan.depth / 1.1f));
    for (int i = 0; i < count; ++i) {
        const float z = -plan.depth / 2 + plan.depth * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
        room.meshes.push_back(box_mesh({-plan.width / 2, plan.height - 0.18f, z - 0.08f}, {plan.width / 2, plan.height, z + 0.08f}, material, -1));
    }
}

}  // namespace

void build_shell(const Plan& plan, Room& room) {
    const Style& style = plan.style;
    const int wall = add_material(room, style.wall), accent = add_material(room, style.accent_wall), trim = add_material(room, style.trim);
    const int floor = add_material(room, style.floor), ceiling = add_material(room, style.ceiling);
    const float w = plan.width / 2 + kWallThickness, d = plan.depth / 2 + kWallThickness;
    room.meshes.push_back(box_mesh({-w, -0.2f, -d}, {w, 0, d}, floor, -1));
    room.meshes.push_back(box_mesh({-w, plan.height, -d}, {w, plan.height + 0.2f, d}, ceiling, -1));
    const bool all = plan.accent && style.accent_wall.pattern == style.wall.pattern && style.accent_wall.color_a == style.wall.color_a;
    for (int i = 0; i < 4; ++i) {
        build_wall(plan, i, room, plan.accent && (i == 0 || all) ? accent : wall);
        build_skirting(plan, i, room, trim);
    }
    Random dice(room.seed, "door");
    for (const Opening& o : plan.openings) o.kind == Opening::Kind::window ? build_window(plan, o, room, trim) : build_door(plan, o, room, trim, dice);
    if (plan.beams) build_beams(plan, room);
}

}  // namespace fastscene
