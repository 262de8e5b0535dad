// What runs along the walls and the ceiling: skirting, mouldings, panelling, beams, coffers, the bases of columns.
#include <cmath>

#include "fastscene/rooms/shell_kit.h"

namespace fastscene::shell {
namespace {

constexpr float kSkirting = 0.09f, kDado = 0.95f;

void build_skirting(const Plan& plan, const WallFace& face, Room& room, int trim) {
    const WallBuilder wall(face, room);
    const float high = plan.style.mouldings == Mouldings::rich ? 0.14f : kSkirting;
    for (const auto& [u0, u1] : between_openings(plan, face, 0, high, kCasing)) wall.box(u0, u1, 0, high, 0, 0.02f, trim);
    if (plan.style.mouldings == Mouldings::none || plan.knee > 0) return;
    // One plain profile: finer ones are thinner than the light is sampled.
    wall.box(0, face.length, plan.height - 0.1f, plan.height, 0, 0.06f, trim);
}

// Parts of the shell that a prompt may ask for are objects of the room, so that they can be found in it.
int part_object(const Plan& plan, Room& room, const char* klass, Vec3f size) {
    RoomObject object;
    object.klass = object.name = klass;
    object.source = "built-in";
    object.size_m = size;
    object.requested = std::find(plan.asked_parts.begin(), plan.asked_parts.end(), klass) != plan.asked_parts.end();
    room.objects.push_back(object);
    return static_cast<int>(room.objects.size()) - 1;
}

// Frames below a rail (rich) or upright boards (plain).
void build_panelling(const Plan& plan, const WallFace& face, Room& room, int trim, int object) {
    const WallBuilder wall(face, room);
    const float top = plan.knee > 0 && face.wall % 2 == 1 ? std::min(kDado, plan.knee - 0.1f) : kDado;
    constexpr float kBack = 0.008f, kProud = 0.022f, kFrame = 0.06f;
    for (const auto& [u0, u1] : between_openings(plan, face, 0.05f, top + 0.06f, kCasing)) {
        if (u1 - u0 < 0.15f) continue;
        wall.box(u0, u1, 0, top, 0, kBack, trim, object);
        wall.box(u0, u1, top, top + 0.05f, 0, 0.035f, trim, object);
        if (plan.style.mouldings == Mouldings::rich) {
            const int count = std::max(1, static_cast<int>(std::lround((u1 - u0) / 0.75f)));
            const float step = (u1 - u0) / static_cast<float>(count);
            for (int i = 0; i < count; ++i) {
                const float a = u0 + step * static_cast<float>(i) + 0.09f, b = a + step - 0.18f, y0 = 0.26f, y1 = top - 0.1f;
                if (b - a < 2.5f * kFrame) continue;
                wall.box(a, b, y0, y0 + 0.03f, kBack, kProud, trim, object);
                wall.box(a, b, y1 - 0.03f, y1, kBack, kProud, trim, object);
                wall.box(a, a + 0.03f, y0 + 0.03f, y1 - 0.03f, kBack, kProud, trim, object);
                wall.box(b - 0.03f, b, y0 + 0.03f, y1 - 0.03f, kBack, kProud, trim, object);
            }
        } else {
            for (float u = u0; u + 0.1f < u1; u += 0.118f) wall.box(u + 0.004f, std::min(u + 0.112f, u1), 0.02f, top, kBack, 0.017f, trim, object);
        }
    }
}

void build_beams(const Plan& plan, Room& room) {
    // Old, dark wood: the color of new furniture would shout along a whole ceiling.
    Material wood = plan.style.wood;
    const Vec3f aged{0.16f, 0.1f, 0.06f};
    wood.color_a = lerp(wood.color_a * 0.6f, aged, 0.5f);
    wood.color_b = lerp(wood.color_b * 0.6f, aged * 0.6f, 0.5f);
    wood.color_c = wood.color_b;
    wood.bump_m = std::max(wood.bump_m, 0.001f);
    const int material = add_material(room, wood);
    const int object = part_object(plan, room, "beams", {plan.width, 0.18f, plan.depth});
    const int count = std::max(2, static_cast<int>(plan.depth / 1.1f));
    for (int i = 0; i < count; ++i) {
        const float z = -plan.depth / 2 + plan.depth * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
        if (plan.knee > 0) {
            // Collar beams hang below the flat part of the roof.
            const float half = plan.width / 2 - plan.slope_run * 0.62f, y = plan.knee + (plan.height - plan.knee) * 0.86f;
            if (y > 2.25f && i % 2 == 0) room.meshes.push_back(box_mesh({-half, y, z - 0.06f}, {half, y + 0.14f, z + 0.06f}, material, object));
            continue;
        }
        Mesh beam = box_mesh({-plan.width / 2, plan.height - 0.18f, z - 0.08f}, {plan.width / 2, plan.height, z + 0.08f}, material, object);
        // The grain runs along the beam, and no two are cut from the same place.
        for (Vec3f& c : beam.coords) c = {c.z + 0.37f * static_cast<float>(i), c.x, c.y};
        room.meshes.push_back(std::move(beam));
    }
}

// A grid of shallow beams along the ceiling.
void build_coffers(const Plan& plan, Room& room, int trim) {
    constexpr float kDeep = 0.12f, kWide = 0.16f;
    const float w = plan.width / 2, d = plan.depth / 2;
    const int columns = std::max(2, static_cast<int>(std::lround(plan.width / 1.25f))),
              rows = std::max(2, static_cast<int>(std::lround(plan.depth / 1.25f)));
    for (int i = 0; i <= columns; ++i) {
        const float x = -w + plan.width * static_cast<float>(i) / static_cast<float>(columns);
        room.meshes.push_back(
            box_mesh({std::max(-w, x - kWide / 2), plan.height - kDeep, -d}, {std::min(w, x + kWide / 2), plan.height, d}, trim, -1));
    }
    for (int i = 0; i <= rows; ++i) {
        const float z = -d + plan.depth * static_cast<float>(i) / static_cast<float>(rows);
        // A hair lower than the others, so that no two faces lie in one plane.
        room.meshes.push_back(
            box_mesh({-w, plan.height - kDeep - 0.002f, std::max(-d, z - kWide / 2)}, {w, plan.height, std::min(d, z + kWide / 2)}, trim, -1));
    }
}

// Base and capital.
void build_columns(const Plan& plan, Room& room, int wall, int trim) {
    for (const Block& b : plan.blocks) {
        if (b.kind != Block::Kind::column) continue;
        const int object = part_object(plan, room, "column", {b.high.x - b.low.x, plan.height, b.high.y - b.low.y});
        room.objects.back().world_from_object.translation = {(b.low.x + b.high.x) / 2, 0, (b.low.y + b.high.y) / 2};
        room.meshes.push_back(box_mesh({b.low.x, 0, b.low.y}, {b.high.x, plan.height, b.high.y}, wall, object));
        const auto collar = [&](float y0, float y1, float out) {
            room.meshes.push_back(box_mesh({b.low.x - out, y0, b.low.y - out}, {b.high.x + out, y1, b.high.y + out}, trim, object));
        };
        collar(0, 0.12f, 0.02f);
        collar(plan.height - 0.1f, plan.height - 0.001f, kCapitalReach);
    }
}

}  // namespace

void build_trim(const Plan& plan, const Materials& m, Room& room) {
    const int panels = plan.panelling ? part_object(plan, room, "wainscoting", {plan.width, kDado, plan.depth}) : -1;
    for (const WallFace& face : plan.faces()) {
        if (plan.joined && face.wall == 2) continue;
        build_skirting(plan, face, room, m.trim);
        if (plan.panelling) build_panelling(plan, face, room, m.trim, panels);
    }
    build_columns(plan, room, m.wall, m.trim);
    if (plan.beams) build_beams(plan, room);
    if (plan.coffers) build_coffers(plan, room, m.trim);
}

}  // namespace fastscene::shell
