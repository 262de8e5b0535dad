#include <array>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/shapes.h"
#include "fastscene/rooms/shell_kit.h"

namespace fastscene {
namespace {

using namespace shell;

// Walls of logs or rock: their crests are in the wall's face, all else lies behind it, so that what stands or hangs at
// a wall needs to know nothing of it.
constexpr float kLogGroove = 0.06f, kRockDepth = 0.16f;
float relief_depth(const Plan& plan) {
    return plan.relief == WallRelief::logs ? kLogGroove : plan.relief == WallRelief::rock ? kRockDepth : 0.f;
}

// Logs one on the other, their grain along them.
void build_logs(const WallFace& face, float u0, float u1, float y0, float y1, int material, Room& room) {
    constexpr float kLog = 0.24f, kEven = 6.f;  // usual height; between the grains of two logs
    constexpr int kAcross = 10;
    const int rows = std::max(1, static_cast<int>(std::lround((y1 - y0) / kLog)));
    const float high = (y1 - y0) / static_cast<float>(rows);
    for (int row = 0; row < rows; ++row) {
        const float low = y0 + high * static_cast<float>(row);
        Mesh log = shapes::sheet(1, kAcross, [&](float u, float v) {
            const float across = -std::cos(kPi * v);
            return face.point(std::lerp(u1, u0, u), low + high * (0.5f + 0.5f * across)) -
                   face.inward * (kLogGroove * (1.f - std::sqrt(std::max(0.f, 1.f - across * across))));
        });
        for (std::size_t i = 0; i < log.positions.size(); ++i) {
            const Vec3f p = log.positions[i] - face.origin;
            log.coords[i] = {p.y, dot(p, face.along) + kEven * static_cast<float>(row), dot(p, face.inward)};
        }
        log.material = material;
        room.meshes.push_back(std::move(log));
    }
}

// Rock that juts out here and there, and ends evenly where it meets other walls and openings.
void build_rock(const WallFace& face, float u0, float u1, float y0, float y1, int material, Room& room) {
    constexpr float kCell = 0.09f, kEven = 0.35f;
    const auto steps = [](float length) { return std::max(1, static_cast<int>(std::lround(length / kCell))); };
    Mesh rock = shapes::sheet(steps(u1 - u0), steps(y1 - y0), [&](float u, float v) {
        const float at = std::lerp(u1, u0, u), y = std::lerp(y0, y1, v);
        const Vec3f p = face.point(at, y);
        const float rough = 0.62f * shapes::wobble(p * 1.3f, 11) + 0.26f * shapes::wobble(p * 3.4f, 12) +
                            0.12f * shapes::wobble(p * 8.f, 13),
                    even = std::clamp(std::min(at - u0, u1 - at) / kEven, 0.f, 1.f);
        return p - face.inward * (kRockDepth * even * std::clamp(0.5f + 0.75f * rough, 0.f, 1.f));
    });
    for (std::size_t i = 0; i < rock.positions.size(); ++i) {
        const Vec3f p = rock.positions[i] - face.origin;
        rock.coords[i] = {dot(p, face.along), p.y, dot(p, face.inward)};
    }
    rock.material = material;
    room.meshes.push_back(std::move(rock));
}

// The wall around its openings: columns between openings, and what is below and above each.
void build_wall(const Plan& plan, int index, Room& room, int material) {
    const WallFace face = plan.wall(index);
    const WallBuilder wall(face, room);
    // Far and near walls reach over the corners, so that the shell is closed. Where the box is cut, nothing of them is
    // hidden in the room's corners: light that is cached there would show at the edges.
    const float over = index % 2 == 0 ? plan.wall_thickness() : 0.f;
    const auto [first, last] = plan.uncut_span(index);
    const bool cut = has_cut_corners(plan);
    const float low = cut ? -kFloorThickness : 0.f;
    std::vector<Opening> holes;
    for (const Opening& o : plan.openings)
        if (o.wall == index && o.kind != Opening::Kind::door) holes.push_back(o);
    std::sort(holes.begin(), holes.end(), [](const Opening& a, const Opening& b) { return a.u0 < b.u0; });
    // A side wall below a slope ends with it.
    const float top = plan.knee > 0 && index % 2 == 1 ? plan.knee + 0.02f
                      : plan.vault != Vault::flat     ? plan.spring
                      : cut                           ? plan.height + kCeilingThickness
                                                      : plan.height;
    const float behind = relief_depth(plan);
    const auto solid = [&](float u0, float u1, float y0, float y1) {
        wall.box(u0, u1, y0, y1, -plan.wall_thickness(), -behind, material);
        if (!(behind > 0 && y1 > y0)) return;
        const float from = std::max(u0, 0.f), to = std::min(u1, face.length);
        if (!(to > from)) return;
        if (plan.relief == WallRelief::logs) build_logs(face, from, to, y0, y1, material, room);
        else build_rock(face, from, to, y0, y1, material, room);
    };
    float u = first > 0 ? first : -over;
    for (const Opening& hole : holes) {
        solid(u, hole.u0, low, top);
        solid(hole.u0, hole.u1, low, hole.y0);
        solid(hole.u0, hole.u1, hole.y1, top);
        if (behind > 0) {  // what the frame is set into
            constexpr float kJamb = 0.03f;
            for (const auto& [from, to] : {std::pair{hole.u0 - kJamb, hole.u0}, {hole.u1, hole.u1 + kJamb}})
                wall.box(from, to, hole.y0, hole.y1, -behind, 0, material);
            for (const auto& [from, to] : {std::pair{hole.y0 - kJamb, hole.y0}, {hole.y1, hole.y1 + kJamb}})
                wall.box(hole.u0 - kJamb, hole.u1 + kJamb, std::max(from, 0.f), to, -behind, 0, material);
        }
        fill_corners(wall, hole, -plan.wall_thickness(), 0, material, -1);
        u = hole.u1;
    }
    solid(u, last < face.length ? last : face.length + over, low, top);
}

void build_blocks(const Plan& plan, const Materials& m, Room& room) {
    for (const Block& b : plan.blocks) {
        if (cuts_corner(b) || b.kind == Block::Kind::stairs) continue;  // no boxes
        if (b.kind == Block::Kind::column) continue;                    // with its base and capital: shell_trim.cc
        const int material = b.kind == Block::Kind::breast ? m.of_far_wall : m.wall;
        room.meshes.push_back(box_mesh({b.low.x, 0, b.low.y}, {b.high.x, plan.height, b.high.y}, material, -1));
    }
}

// Meshes, portals and objects of `part`, moved, become part of `room`.
void merge(Room& room, Room part, const Rigid& room_from_part) {
    const auto materials = static_cast<int>(room.materials.size()), objects = static_cast<int>(room.objects.size());
    room.materials.insert(room.materials.end(), part.materials.begin(), part.materials.end());
    for (Mesh& mesh : part.meshes) {
        mesh.material += materials;
        if (mesh.object >= 0) mesh.object += objects;
        for (Vec3f& p : mesh.positions) p = room_from_part * p;
        for (Vec3f& n : mesh.normals) n = room_from_part.rotation * n;
        room.meshes.push_back(std::move(mesh));
    }
    for (RoomObject& object : part.objects) {
        object.world_from_object = room_from_part * object.world_from_object;
        room.objects.push_back(std::move(object));
    }
    for (const Portal& p : part.portals)
        room.portals.push_back(
            {room_from_part * p.corner, room_from_part.rotation * p.edge_u, room_from_part.rotation * p.edge_v});
}

}  // namespace

namespace shell {

void fill_corners(const WallBuilder& wall, const Opening& o, float w0, float w1, int material, int object) {
    if (o.shape == Opening::Shape::square) return;
    const std::vector<Vec2f> inner = edge_of(o, 0);
    if (o.shape == Opening::Shape::rounded) {
        const std::array<Vec2f, 4> corners{Vec2f{o.u1, o.y1}, {o.u0, o.y1}, {o.u0, o.y0}, {o.u1, o.y0}};
        for (std::size_t i = 0; i < 4; ++i) {
            const auto from = inner.begin() + static_cast<std::ptrdiff_t>(i * (kCornerSteps + 1));
            wall.band({from, from + kCornerSteps + 1}, std::vector(kCornerSteps + 1, corners[i]), w0, w1, material,
                      object);
        }
        return;
    }
    std::vector<Vec2f> outer = inner;
    const Vec2f middle{(o.u0 + o.u1) / 2, (o.y0 + o.y1) / 2}, half{(o.u1 - o.u0) / 2, (o.y1 - o.y0) / 2};
    for (Vec2f& p : outer) {
        const Vec2f d = p - middle;
        if (o.shape == Opening::Shape::arched) p.y = o.y1;
        else p = middle + d * (1.f / std::max(std::abs(d.x) / half.x, std::abs(d.y) / half.y));
    }
    wall.band(inner, outer, w0, w1, material, object);
}

void WallBuilder::slanted_box(float u0, float u1, float y0, float y1, float w0, float w1, int material,
                              int object) const {
    Mesh mesh = box_mesh({u0, y0, w0}, {u1, y1, w1}, material, object);
    for (Vec3f& p : mesh.positions) p = face_.point(p.x, p.y) + face_.inward * p.z;
    for (Vec3f& n : mesh.normals) n = face_.along * n.x + Vec3f{0, n.y, 0} + face_.inward * n.z;
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)  // (along, up, inward) is left-handed
        std::swap(mesh.triangles[t + 1], mesh.triangles[t + 2]);
    room_.meshes.push_back(std::move(mesh));
}

void WallBuilder::band(const std::vector<Vec2f>& inner, const std::vector<Vec2f>& outer, float w0, float w1,
                       int material, int object) const {
    Mesh mesh;
    mesh.material = material;
    mesh.object = object;
    // Each face by itself: its edges are sharp.
    const auto quad = [&](std::array<Vec3f, 4> p) {
        std::swap(p[1], p[3]);
        const Vec3f normal = cross(p[2] - p[0], p[3] - p[1]);
        if (!(length(normal) > 1e-9f)) return;
        const auto base = static_cast<std::uint32_t>(mesh.positions.size());
        for (const Vec3f& corner : p) {
            mesh.positions.push_back(corner);
            mesh.coords.push_back(corner);
            mesh.normals.push_back(normalize(normal));
        }
        // Where the lines touch, at the top of an arch, one of the two triangles is none.
        for (const auto& [b, c] : {std::pair{1u, 2u}, std::pair{2u, 3u}})
            if (length(cross(p[b] - p[0], p[c] - p[0])) > 1e-8f)
                mesh.triangles.insert(mesh.triangles.end(), {base, base + b, base + c});
    };
    const auto at = [&](Vec2f p, float w) { return face_.point(p.x, p.y) + face_.inward * w; };
    const std::size_t last = inner.size() - 1;
    // Along, up and inward are left-handed (the room's x, y and -z are): corners are listed as in a right-handed frame
    // and turned by quad.
    for (std::size_t i = 0; i < last; ++i) {
        quad({at(inner[i], w1), at(outer[i], w1), at(outer[i + 1], w1), at(inner[i + 1], w1)});
        quad({at(inner[i], w0), at(inner[i + 1], w0), at(outer[i + 1], w0), at(outer[i], w0)});
        quad({at(inner[i], w0), at(inner[i], w1), at(inner[i + 1], w1), at(inner[i + 1], w0)});
        quad({at(outer[i], w1), at(outer[i], w0), at(outer[i + 1], w0), at(outer[i + 1], w1)});
    }
    if (length(inner[0] - inner[last]) > 1e-4f) {
        quad({at(inner[0], w0), at(outer[0], w0), at(outer[0], w1), at(inner[0], w1)});
        quad({at(outer[last], w0), at(inner[last], w0), at(inner[last], w1), at(outer[last], w1)});
    }
    room_.meshes.push_back(std::move(mesh));
}

std::vector<Vec2f> edge_of(const Opening& o, float grow) {
    if (o.shape == Opening::Shape::rounded) {
        constexpr float kRadius = 0.11f;
        const float r = std::min({kRadius, 0.4f * (o.u1 - o.u0), 0.4f * (o.y1 - o.y0)});
        std::vector<Vec2f> out;
        for (int corner = 0; corner < 4; ++corner)
            for (int i = 0; i <= kCornerSteps; ++i) {
                const float a = 0.5f * kPi * (static_cast<float>(corner) + static_cast<float>(i) / kCornerSteps);
                const Vec2f middle{corner == 0 || corner == 3 ? o.u1 - r : o.u0 + r, corner < 2 ? o.y1 - r : o.y0 + r};
                out.push_back(middle + Vec2f{std::cos(a), std::sin(a)} * (r + grow));
            }
        out.push_back(out.front());
        return out;
    }
    const bool round = o.shape == Opening::Shape::round;
    const int steps = round ? 64 : 32;  // corners of a square about a circle are among them
    const float rise = round ? (o.y1 - o.y0) / 2 : arch_rise(o), span = (o.u1 - o.u0) / 2;
    const Vec2f middle{(o.u0 + o.u1) / 2, o.y1 - rise};
    std::vector<Vec2f> out;
    for (int i = 0; i <= steps; ++i) {
        const float a = (round ? 2.f : 1.f) * kPi * static_cast<float>(i) / static_cast<float>(steps);
        out.push_back(middle + Vec2f{(span + grow) * std::cos(a), (rise + grow) * std::sin(a)});
    }
    return out;
}

Material as_asked(const Plan& plan, std::string_view kind, Material usual) {
    const PromptObject* asked = plan.asked(kind);
    if (!asked) return usual;
    PromptObject wish = *asked;
    // Just "wooden" is the room's own wood. What is built of steel is not polished, and of a glass door or window it is
    // the pane.
    if (wish.material == "wood" && usual.pattern != Pattern::wood) usual = plan.style.wood;
    if (is_one_of(wish.material, {"wood", "glass"})) wish.material.clear();
    if (is_one_of(wish.material, {"steel", "metal", "chrome", "aluminium"})) wish.material = "iron";
    apply_wish(usual, wish);
    return usual;
}

std::vector<std::pair<float, float>> between_openings(const Plan& plan, const WallFace& face, float y0, float y1,
                                                      float margin) {
    std::vector<std::pair<float, float>> taken, out;
    for (const Opening& o : plan.openings)
        if (o.wall == face.wall && o.y0 < y1 && o.y1 > y0)
            taken.push_back({o.u0 - face.from - margin, o.u1 - face.from + margin});
    std::sort(taken.begin(), taken.end());
    float u = 0;
    for (const auto& [a, b] : taken) {
        if (a > u) out.push_back({u, std::min(a, face.length)});
        u = std::max(u, b);
    }
    if (face.length > u) out.push_back({u, face.length});
    return out;
}

}  // namespace shell

void build_shell(const Plan& plan, Room& room) {
    const Style& style = plan.style;
    Materials m{add_material(room, style.wall), add_material(room, style.accent_wall), add_material(room, style.trim),
                add_material(room, style.floor), add_material(room, style.ceiling)};
    const float w = plan.width / 2 + kWallThickness, d = plan.depth / 2 + kWallThickness,
                near = plan.joined ? plan.depth / 2 : d;
    if (has_cut_corners(plan)) build_slab(plan, -kFloorThickness, 0, m.floor, room);
    else room.meshes.push_back(box_mesh({-w, -kFloorThickness, -near}, {w, 0, d}, m.floor, -1));
    const float flat_half = plan.knee > 0 ? plan.width / 2 - plan.slope_run + 0.05f : w;
    if (has_cut_corners(plan) && plan.vault == Vault::flat)
        build_slab(plan, plan.height, plan.height + kCeilingThickness, m.ceiling, room);
    else if (plan.vault == Vault::flat)
        room.meshes.push_back(
            box_mesh({-flat_half, plan.height, -near}, {flat_half, plan.height + kCeilingThickness, d}, m.ceiling, -1));
    const bool all = plan.accent && style.accent_wall.pattern == style.wall.pattern &&
                     style.accent_wall.color_a == style.wall.color_a;
    const auto material_of = [&](int wall) {
        if (const auto& own = plan.own_walls[static_cast<std::size_t>(wall)]) return add_material(room, *own);
        return plan.accent && (wall == plan.accent_wall || all) ? m.accent : m.wall;
    };
    for (int i = 0; i < 4; ++i) {
        if (plan.joined && i == 2) continue;
        const int material = material_of(i);
        if (i == 0) m.of_far_wall = plan.own_walls[0] || (plan.accent && plan.accent_wall == 0) ? material : m.wall;
        build_wall(plan, i, room, material);
        if (plan.vault == Vault::barrel) build_gable(plan, i, material, room);
    }
    if (plan.vault != Vault::flat) build_vault(plan, m, room);
    build_blocks(plan, m, room);
    build_platforms(plan, m, room);
    build_cut_corners(plan, m.wall, room);
    build_openings(plan, m, room);
    if (plan.knee > 0) build_skylights(plan, m, room);
    build_trim(plan, m, room);
    if (plan.cove > 0) build_cove(plan, m.ceiling, room);
    if (plan.tunnel) build_tunnel(plan, room);
    if (plan.mezzanine.depth > 0) build_mezzanine(plan, m, room);
    if (plan.next && !(plan.mezzanine.depth > 0)) {
        Room next;
        next.seed = room.seed + 1;
        build_shell(plan.next->plan, next);
        merge(room, std::move(next), plan.next->room_from_next);
    }
}

}  // namespace fastscene
