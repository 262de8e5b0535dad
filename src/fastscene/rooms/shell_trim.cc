// What runs along the walls and the ceiling: skirting, mouldings, panelling, beams, coffers, the bases of columns.
#include <cmath>
#include <tuple>

#include "fastscene/rooms/shapes.h"
#include "fastscene/rooms/shell_kit.h"

namespace fastscene::shell {
namespace {

constexpr float kSkirting = 0.09f, kDado = 0.95f;

// Strips of two walls meet in a corner: those along z lie a hair lower.
float lowered(const WallFace& face) { return std::abs(face.along.z) > 0.5f ? kHair_m : 0.f; }

void build_skirting(const Plan& plan, const WallFace& face, Room& room, int trim) {
    const WallBuilder wall(face, room);
    const float high = plan.style.mouldings == Mouldings::rich ? 0.14f : kSkirting;
    for (const auto& [u0, u1] : between_openings(plan, face, 0, high, kCasing))
        wall.box(u0, u1, 0, high - lowered(face), 0, 0.02f, trim);
    if (plan.style.mouldings == Mouldings::none || plan.knee > 0) return;
    // One plain profile: finer ones are thinner than the light is sampled.
    wall.box(0, face.length, plan.height - 0.1f - lowered(face), plan.height, 0, 0.06f, trim);
}

// Frames below a rail (rich) or upright boards (plain).
void build_panelling(const Plan& plan, const WallFace& face, Room& room, int trim, int object) {
    const WallBuilder wall(face, room);
    const float top = plan.knee > 0 && face.wall % 2 == 1 ? std::min(kDado, plan.knee - 0.1f) : kDado;
    constexpr float kBack = 0.008f, kProud = 0.022f, kFrame = 0.06f;
    for (const auto& [u0, u1] : between_openings(plan, face, 0.05f, top + 0.06f, kCasing)) {
        if (u1 - u0 < 0.15f) continue;
        wall.box(u0 + kHair_m, u1 - kHair_m, 0, top, 0, kBack, trim, object);  // ends within the skirting
        wall.box(u0, u1, top - lowered(face), top + 0.05f - lowered(face), 0, 0.035f, trim, object);
        if (plan.style.mouldings == Mouldings::rich) {
            const int count = std::max(1, static_cast<int>(std::lround((u1 - u0) / 0.75f)));
            const float step = (u1 - u0) / static_cast<float>(count);
            for (int i = 0; i < count; ++i) {
                const float a = u0 + step * static_cast<float>(i) + 0.09f, b = a + step - 0.18f, y0 = 0.26f,
                            y1 = top - 0.1f;
                if (b - a < 2.5f * kFrame) continue;
                wall.box(a, b, y0, y0 + 0.03f, kBack, kProud, trim, object);
                wall.box(a, b, y1 - 0.03f, y1, kBack, kProud, trim, object);
                wall.box(a, a + 0.03f, y0 + 0.03f, y1 - 0.03f, kBack, kProud, trim, object);
                wall.box(b - 0.03f, b, y0 + 0.03f, y1 - 0.03f, kBack, kProud, trim, object);
            }
        } else {
            for (float u = u0; u + 0.1f < u1; u += 0.118f)
                wall.box(u + 0.004f, std::min(u + 0.112f, u1 - kHair_m), 0.02f, top, kBack, 0.017f, trim, object);
        }
    }
}

// How far the room goes to both sides, that far from its middle towards either end.
float half_width_at(const Plan& plan, float off) {
    float half = plan.width / 2;
    for (const Block& b : plan.blocks) {
        if (!cuts_corner(b)) continue;
        const std::vector<Vec2f> edge = cut_edge(b);
        for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
            const Vec2f p = edge[i], q = edge[i + 1];
            if ((std::abs(p.y) < off) == (std::abs(q.y) < off)) continue;
            half = std::min(half,
                            std::abs(std::lerp(p.x, q.x, (off - std::abs(p.y)) / (std::abs(q.y) - std::abs(p.y)))));
        }
    }
    return half;
}

void build_beams(const Plan& plan, Room& room) {
    // Old, dark wood: the color of new furniture would shout along a whole ceiling.
    Material wood = plan.style.wood;
    const Vec3f aged{0.16f, 0.1f, 0.06f};
    wood.color_a = lerp(wood.color_a * 0.6f, aged, 0.5f);
    wood.color_b = lerp(wood.color_b * 0.6f, aged * 0.6f, 0.5f);
    wood.color_c = wood.color_b;
    wood.bump_m = std::max(wood.bump_m, 0.001f);
    const int material = add_material(room, as_asked(plan, "beams", wood));
    const int object = part_object(plan, room, "beams", {plan.width, kBeamDepth, plan.depth});
    room.objects.back().world_from_object.translation = {0, plan.height - kBeamDepth, 0};
    const int count = beam_count(plan);
    for (int i = 0; i < count; ++i) {
        const float z = beam_z(plan, i);
        if (plan.knee > 0) {
            // Collar beams hang below the flat part of the roof.
            const float half = plan.width / 2 - plan.slope_run * 0.62f,
                        y = plan.knee + (plan.height - plan.knee) * 0.86f;
            if (y > 2.25f && i % 2 == 0)
                room.meshes.push_back(box_mesh({-half, y, z - 0.06f}, {half, y + 0.14f, z + 0.06f}, material, object));
            continue;
        }
        const float half = has_cut_corners(plan) ? half_width_at(plan, std::abs(z) + kBeamWidth / 2) : plan.width / 2;
        Mesh beam = box_mesh({-half, plan.height - kBeamDepth, z - kBeamWidth / 2},
                             {half, plan.height, z + kBeamWidth / 2}, material, object);
        // The grain runs along the beam, and no two are cut from the same place.
        for (Vec3f& c : beam.coords) c = {c.z + 0.37f * static_cast<float>(i), c.x, c.y};
        room.meshes.push_back(std::move(beam));
    }
}

struct Coffers {
    int columns = 2, rows = 2;  // along x and z
};

Coffers coffers_of(const Plan& plan) {
    const auto count = [](float side) { return std::max(2, static_cast<int>(std::lround(side / 1.25f))); };
    return {count(plan.width), count(plan.depth)};
}

// A grid of shallow beams along the ceiling.
void build_coffers(const Plan& plan, Room& room, int trim) {
    constexpr float kDeep = 0.12f, kWide = 0.16f;
    const float w = plan.width / 2, d = plan.depth / 2;
    const auto [columns, rows] = coffers_of(plan);
    for (int i = 0; i <= columns; ++i) {
        const float x = -w + plan.width * static_cast<float>(i) / static_cast<float>(columns);
        room.meshes.push_back(box_mesh({std::max(-w, x - kWide / 2), plan.height - kDeep, -d},
                                       {std::min(w, x + kWide / 2), plan.height, d}, trim, -1));
    }
    for (int i = 0; i <= rows; ++i) {
        const float z = -d + plan.depth * static_cast<float>(i) / static_cast<float>(rows);
        // A hair lower than the others, so that no two faces lie in one plane.
        room.meshes.push_back(box_mesh({-w, plan.height - kDeep - 0.002f, std::max(-d, z - kWide / 2)},
                                       {w, plan.height, std::min(d, z + kWide / 2)}, trim, -1));
    }
}

// A border along the walls, lower than the middle; in rich rooms with a second, smaller step.
void build_tray(const Plan& plan, Room& room, int ceiling) {
    const auto border = [&](float wide, float low, float high) {
        const float w = plan.width / 2, d = plan.depth / 2;
        for (const float s : {-1.f, 1.f}) {
            room.meshes.push_back(box_mesh({std::min(s * w, s * (w - wide)), low, -d},
                                           {std::max(s * w, s * (w - wide)), high, d}, ceiling, -1));
            room.meshes.push_back(box_mesh({wide - w, low, std::min(s * d, s * (d - wide))},
                                           {w - wide, high, std::max(s * d, s * (d - wide))}, ceiling, -1));
        }
    };
    if (plan.style.mouldings == Mouldings::rich) {
        border(kTrayBorder + 0.16f, plan.height - 0.5f * kTrayStep, plan.height + 0.01f);
        border(kTrayBorder, plan.height - kTrayStep, plan.height - 0.5f * kTrayStep);
    } else {
        border(kTrayBorder, plan.height - kTrayStep, plan.height + 0.01f);
    }
}

// Where small lamps are sunk into the ceiling: in rows along the walls, between beams, in the middle of coffers, within
// the flat part between two slopes.
std::vector<Vec3f> recessed_places(const Plan& plan) {
    const float y = plan.height - (plan.tray ? kTrayStep : 0.f), in = plan.tray ? 0.5f * kTrayBorder : 0.75f;
    float x = plan.width / 2 - (plan.knee > 0 ? plan.slope_run + 0.3f : in);
    bool two_rows = plan.width > 3.4f && x > 0.4f;
    std::vector<float> along;
    if (plan.beams && !(plan.knee > 0)) {
        for (int i = 0; i + 1 < beam_count(plan); ++i) along.push_back((beam_z(plan, i) + beam_z(plan, i + 1)) / 2);
    } else if (plan.coffers) {
        const Coffers grid = coffers_of(plan);
        x = plan.width / 2 * (1.f - 1.f / static_cast<float>(grid.columns));
        two_rows = true;
        for (int i = 0; i < grid.rows; ++i)
            along.push_back(plan.depth * ((static_cast<float>(i) + 0.5f) / static_cast<float>(grid.rows) - 0.5f));
    } else {
        const float z = plan.depth / 2 - in;
        const int count = std::max(2, static_cast<int>(std::lround(2 * z / 1.5f)));
        for (int i = 0; i < count; ++i)
            along.push_back(z * ((2.f * static_cast<float>(i) + 1.f) / static_cast<float>(count) - 1.f));
    }
    std::vector<Vec3f> places;
    for (const float z : along)
        for (const float side : two_rows ? std::vector{-x, x} : std::vector{0.f})
            if (std::none_of(plan.blocks.begin(), plan.blocks.end(), [&](const Block& b) {
                    return side > b.low.x - 0.1f && side < b.high.x + 0.1f && z > b.low.y - 0.1f && z < b.high.y + 0.1f;
                }))
                places.push_back({side, y, z});
    return places;
}

// How bright they are by the hour is the room's business.
void build_recessed_lights(const Plan& plan, Room& room) {
    Material light;
    light.name = "recessed light";
    light.color_a = light.color_b = light.color_c = {0.7f, 0.68f, 0.64f};
    light.emission = plan.style.lamp_light * 1.5f;
    const int rim = add_material(room, as_asked(plan, "recessed_lights", plan.style.metal)),
              glow = add_material(room, light);
    constexpr float kProud = 0.008f;
    const int object = part_object(plan, room, "recessed_lights", {plan.width, kProud, plan.depth});
    room.objects.back().world_from_object.translation = {0, plan.height - (plan.tray ? kTrayStep : 0.f) - kProud, 0};
    for (const Vec3f at : recessed_places(plan))
        for (const auto& [radius, low, material] : {std::tuple{0.05f, 0.005f, rim}, std::tuple{0.038f, kProud, glow}}) {
            Mesh disc = shapes::prism(shapes::circle(radius, 20), -low, 0.f, 0.001f);
            disc.material = material;
            disc.object = object;
            room.meshes.push_back(shapes::move(disc, at));
        }
}

// Two colors of light below the ceiling: one ahead and to the right, one behind and to the left.
void build_neon(const Plan& plan, Room& room) {
    const auto tube = [&](Vec3f radiance) {
        Material m;
        m.name = kNeon;
        m.emission = radiance;
        return add_material(room, m);
    };
    Vec3f ahead{2.6f, 0.16f, 1.3f}, behind{0.16f, 0.5f, 2.8f};
    if (plan.neon_color) {
        // As strong as the others, and as pure; one side leans to blue, so that the room keeps two lights.
        Vec3f c = *plan.neon_color;
        c = c / std::max(0.01f, max_component(c));
        for (std::size_t a = 0; a < 3; ++a) c[a] = std::max(0.04f, c[a] * c[a]);
        ahead = c * 2.7f;
        behind = lerp(c * 2.6f, behind, 0.3f);
    }
    const int pink = tube(ahead), blue = tube(behind);
    const float below = plan.beams                                ? 0.21f
                        : plan.tray                               ? kTrayStep + 0.03f
                        : plan.style.mouldings != Mouldings::none ? 0.12f
                                                                  : 0.03f;
    for (const WallFace& face : plan.faces()) {
        if ((plan.joined && face.wall == 2) || face.behind > 0) continue;
        const WallBuilder wall(face, room);
        const float y = (plan.knee > 0 && face.wall % 2 == 1 ? plan.knee : plan.wall_top()) - below;
        wall.box(0.03f, face.length - 0.03f, y - 0.022f, y, 0.001f, 0.014f,
                 face.wall == 0 || face.wall == 1 ? pink : blue);
    }
}

// Base and capital.
void build_columns(const Plan& plan, Room& room, int trim) {
    const auto is_column = [](const Block& b) { return b.kind == Block::Kind::column; };
    if (std::none_of(plan.blocks.begin(), plan.blocks.end(), is_column)) return;
    const int shaft = add_material(room, as_asked(plan, "column", plan.style.wall));
    for (const Block& b : plan.blocks) {
        if (!is_column(b)) continue;
        const int object = part_object(plan, room, "column", {b.high.x - b.low.x, plan.height, b.high.y - b.low.y});
        room.objects.back().world_from_object.translation = {(b.low.x + b.high.x) / 2, 0, (b.low.y + b.high.y) / 2};
        room.meshes.push_back(box_mesh({b.low.x, 0, b.low.y}, {b.high.x, plan.height, b.high.y}, shaft, object));
        const auto collar = [&](float y0, float y1, float out) {
            room.meshes.push_back(
                box_mesh({b.low.x - out, y0, b.low.y - out}, {b.high.x + out, y1, b.high.y + out}, trim, object));
        };
        collar(0, 0.12f, 0.02f);
        collar(plan.height - 0.1f, plan.height - 0.001f, kCapitalReach);
    }
}

}  // namespace

// Parts of the shell that a prompt may ask for are objects of the room, so that they can be found in it.
int part_object(const Plan& plan, Room& room, const char* kind, Vec3f size) {
    const PromptObject* wish = plan.asked(kind);
    RoomObject object;
    object.kind = kind;
    object.color = wish ? wish->color : "";
    object.name = object.color.empty() ? kind : object.color + " " + kind;
    object.source = "built-in";
    object.size_m = size;
    object.requested = wish != nullptr;
    room.objects.push_back(object);
    return static_cast<int>(room.objects.size()) - 1;
}

void build_trim(const Plan& plan, const Materials& m, Room& room) {
    int panels = -1, panel = m.trim;
    if (plan.panelling) {
        panels = part_object(plan, room, "wainscoting", {plan.width, kDado, plan.depth});
        panel = add_material(room, as_asked(plan, "wainscoting", plan.style.trim));
    }
    for (const WallFace& face : plan.faces()) {
        if ((plan.joined && face.wall == 2) || face.behind > 0) continue;
        if (plan.relief == WallRelief::flat && !plan.cabin) build_skirting(plan, face, room, m.trim);
        if (plan.panelling) build_panelling(plan, face, room, panel, panels);
    }
    build_columns(plan, room, m.trim);
    if (plan.beams) build_beams(plan, room);
    if (plan.coffers) build_coffers(plan, room, m.trim);
    if (plan.tray) build_tray(plan, room, m.ceiling);
    if (plan.recessed_lights) build_recessed_lights(plan, room);
    if (plan.neon) build_neon(plan, room);
}

}  // namespace fastscene::shell
