// Walls before corners that are cut off, and vaults: domes, cones, barrels, with their ribs, cornice and oculus.
#include <cmath>

#include "fastscene/rooms/shapes.h"
#include "fastscene/rooms/shell_kit.h"

namespace fastscene::shell {
namespace {

constexpr float kRib = 0.11f, kRibDepth = 0.07f;  // half its width; how far it stands proud of the vault
constexpr int kAlongProfile = 24;                 // facets from the wall to the top
constexpr float kFlange = 0.215f;                 // metres: how far a vault lies on its walls, and beyond
constexpr float kCurvedWall = 0.2f;               // metres: thickness
constexpr float kLap = 0.04f, kReach = 0.005f;    // metres: of curved walls behind it; of slabs into walls

Vec2f inward_of(Vec2f a, Vec2f b) {
    const Vec2f along = (b - a) * (1.f / length(b - a));
    return {along.y, -along.x};
}

// A grid of `columns` + 1 by `rows` + 1 vertices, seen from where the normals point.
class Grid {
  public:
    Grid(int columns, int rows, int material, int object = -1) : columns_(columns), rows_(rows) {
        mesh_.material = material, mesh_.object = object;
    }
    // Column by column.
    void add(Vec3f position, Vec3f normal, Vec3f coords) {
        mesh_.positions.push_back(position), mesh_.normals.push_back(normal), mesh_.coords.push_back(coords);
    }
    Mesh take() {
        for (int i = 0; i < columns_; ++i)
            for (int k = 0; k < rows_; ++k) {
                const auto a = static_cast<std::uint32_t>(i * (rows_ + 1) + k), b = a + 1,
                           d = a + static_cast<std::uint32_t>(rows_) + 1, c = d + 1;
                add_triangle(a, b, c), add_triangle(a, c, d);
            }
        return std::move(mesh_);
    }

  private:
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const Vec3f n = cross(mesh_.positions[b] - mesh_.positions[a], mesh_.positions[c] - mesh_.positions[a]);
        constexpr float kNone = 1e-9f;  // square metres: at the top of a dome all vertices meet
        if (!(length(n) > kNone)) return;
        const bool turned = dot(n, mesh_.normals[a] + mesh_.normals[b] + mesh_.normals[c]) < 0;
        mesh_.triangles.insert(mesh_.triangles.end(), {a, turned ? c : b, turned ? b : c});
    }

    int columns_, rows_;
    Mesh mesh_;
};

// ---- domes and cones

// The inside of a dome or cone over the room's outline. `at` in [0, 1] goes from the wall to the top.
struct Cap {
    const Plan& plan;
    Vec2f middle;
    int rows;
    Vec2f level(float at) const {  // share of the way that is left, and of the rise that is done
        if (plan.vault == Vault::cone) return {1 - at, at};
        return {std::cos(0.5f * kPi * at), std::sin(0.5f * kPi * at)};
    }
    Vec3f point(Vec2f foot, float at) const {
        const auto [out, up] = level(at);
        const Vec2f way = foot - middle;
        const float far = length(way), in = (plan.oculus + (far - plan.oculus) * out) / far;
        return {middle.x + way.x * in, plan.spring + (plan.height - plan.spring) * up, middle.y + way.y * in};
    }
    // Of the facet above the wall from a to b.
    Vec3f normal(Vec2f a, Vec2f b, float at) const {
        constexpr float kStep = 0.01f;
        const Vec2f between = (a + b) * 0.5f;
        const float low = std::max(0.f, std::min(at, 1 - kStep)), high = low + kStep;
        const Vec3f up = point(between, high) - point(between, low), along{b.x - a.x, 0, b.y - a.y};
        const Vec3f n = normalize(cross(up, along));
        return n.y > 0 ? -n : n;
    }
};

// Whether the wall turns so little at a point that both its sides are parts of one curve.
bool is_smooth(Vec2f before, Vec2f at, Vec2f after) {
    constexpr float kCosine = 0.9f;  // of 26 degrees
    return dot(inward_of(before, at), inward_of(at, after)) > kCosine;
}

void build_cap(const Plan& plan, Vec2f middle, int material, Room& room) {
    const std::vector<Vec2f> outline = plan.outline();
    const std::size_t n = outline.size();
    const Cap cap{plan, middle, plan.vault == Vault::cone ? 8 : kAlongProfile};
    const bool half = plan.vault == Vault::barrel;  // over an apse
    const auto corner = [&](std::size_t i) { return outline[i % n]; };
    const float slope = std::hypot(0.5f * std::min(plan.width, plan.depth), plan.height - plan.spring);
    float along = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2f a = corner(i), b = corner(i + 1), before = corner(i + n - 1), after = corner(i + 2);
        if (half && std::min(a.y, b.y) < middle.y - 1e-3f) continue;
        Grid grid(1, cap.rows + 1, material);
        for (const bool end : {false, true}) {
            // It begins on the wall, so that no light comes in between them.
            const Vec2f foot = end ? b : a, beyond = foot + (foot - middle) * (kFlange / length(foot - middle));
            grid.add({beyond.x, plan.spring, beyond.y}, {0, -1, 0}, {along, -kFlange, 0});
            for (int k = 0; k <= cap.rows; ++k) {
                const float at = static_cast<float>(k) / static_cast<float>(cap.rows);
                Vec3f normal = cap.normal(a, b, at);
                if (!end && is_smooth(before, a, b)) normal = normalize(normal + cap.normal(before, a, at));
                if (end && is_smooth(a, b, after)) normal = normalize(normal + cap.normal(b, after, at));
                grid.add(cap.point(foot, at), normal, {along + (end ? length(b - a) : 0.f), at * slope, 0});
            }
        }
        room.meshes.push_back(grid.take());
        along += length(b - a);
    }
}

// ---- ribs

// A rib along a line of points, at right angles to `side`; `inward` points into the room at each.
void build_rib(const std::vector<Vec3f>& line, const std::vector<Vec3f>& inward, Vec3f side, int material, Room& room) {
    const auto strip = [&](float u0, float w0, float u1, float w1, const auto& normal) {
        Grid grid(static_cast<int>(line.size()) - 1, 1, material);
        float run = 0;
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (i > 0) run += length(line[i] - line[i - 1]);
            for (const auto& [u, w] : {std::pair{u0, w0}, std::pair{u1, w1}})
                grid.add(line[i] + side * u + inward[i] * w, normal(i), {run, u + w, 0});
        }
        room.meshes.push_back(grid.take());
    };
    strip(-kRib, kRibDepth, kRib, kRibDepth, [&](std::size_t i) { return inward[i]; });
    strip(-kRib, 0, -kRib, kRibDepth, [&](std::size_t) { return -side; });
    strip(kRib, kRibDepth, kRib, 0, [&](std::size_t) { return side; });
}

// Up the creases of the outline, or, where it has none, at eight places around it.
void build_cap_ribs(const Plan& plan, int material, Room& room) {
    const std::vector<Vec2f> outline = plan.outline();
    const std::size_t n = outline.size();
    std::vector<Vec2f> feet;
    for (std::size_t i = 0; i < n; ++i)
        if (!is_smooth(outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n])) feet.push_back(outline[i]);
    if (feet.empty())
        for (std::size_t i = 0; i < 8; ++i) feet.push_back(outline[i * n / 8]);
    const Cap cap{plan, {}, kAlongProfile};
    constexpr float kEnd = 0.93f;  // they end at the ring about the top
    for (const Vec2f foot : feet) {
        const Vec3f out = normalize(Vec3f{foot.x, 0, foot.y}), side{-out.z, 0, out.x};
        std::vector<Vec3f> line, inward;
        for (int k = 0; k <= cap.rows; ++k) {
            const float at = kEnd * static_cast<float>(k) / static_cast<float>(cap.rows);
            line.push_back(cap.point(foot, at));
            const Vec3f up = cap.point(foot, at + 0.01f) - cap.point(foot, std::max(0.f, at - 0.01f));
            const Vec3f normal = normalize(cross(up, side));
            inward.push_back(normal.y > 0 ? -normal : normal);
        }
        build_rib(line, inward, side, material, room);
    }
    // The ring where they meet.
    const float radius = std::max(0.22f, plan.oculus + 0.06f);
    Mesh ring = shapes::ring(radius, 0.06f, 48);
    ring.material = material;
    const float height = plan.oculus > 0 ? plan.height - 0.02f : plan.height - 0.05f;
    room.meshes.push_back(shapes::move(ring, {0, height, 0}));
}

// ---- barrel vaults

struct Barrel {
    const Plan& plan;
    Vec3f point(float at, float z) const {  // from wall 1 over the top to wall 3
        return {plan.width / 2 * std::cos(kPi * at), plan.spring + (plan.height - plan.spring) * std::sin(kPi * at), z};
    }
    Vec3f inward(float at) const {
        return -normalize(
            Vec3f{std::cos(kPi * at) * (plan.height - plan.spring), std::sin(kPi * at) * plan.width / 2, 0});
    }
};

void build_barrel(const Plan& plan, int material, Room& room) {
    constexpr int kSteps = 2 * kAlongProfile;
    const Barrel barrel{plan};
    // It lies on all four walls.
    const bool apse = conch_from(plan) < plan.depth / 2 - kHair_m;
    const float near = -plan.depth / 2 - kFlange, far = apse ? conch_from(plan) : plan.depth / 2 + kFlange;
    Grid grid(kSteps + 2, 1, material);
    float run = 0;
    const auto flange = [&](float side) {
        for (const float z : {near, far})
            grid.add({side * (plan.width / 2 + kFlange), plan.spring, z}, {0, -1, 0}, {z, run - side * kFlange, 0});
    };
    flange(1);
    for (int i = 0; i <= kSteps; ++i) {
        const float at = static_cast<float>(i) / kSteps;
        if (i > 0) run += length(barrel.point(at, 0) - barrel.point(at - 1.f / kSteps, 0));
        for (const float z : {near, far}) grid.add(barrel.point(at, z), barrel.inward(at), {z, run, 0});
    }
    flange(-1);
    room.meshes.push_back(grid.take());
    if (apse) build_cap(plan, {0, far}, material, room);
}

void build_barrel_ribs(const Plan& plan, int material, Room& room) {
    constexpr float kPitch = 2.4f;  // metres
    constexpr int kSteps = 2 * kAlongProfile;
    const Barrel barrel{plan};
    const float near = -plan.depth / 2, far = conch_from(plan);
    const int count = std::max(2, static_cast<int>(std::lround((far - near) / kPitch)));
    const bool apse = far < plan.depth / 2 - kHair_m;  // it has an arch before it
    for (int i = 1; i < count + (apse ? 1 : 0); ++i) {
        const float z = near + (far - near) * static_cast<float>(i) / static_cast<float>(count);
        std::vector<Vec3f> line, inward;
        for (int k = 0; k <= kSteps; ++k) {
            const float at = static_cast<float>(k) / kSteps;
            line.push_back(barrel.point(at, z)), inward.push_back(barrel.inward(at));
        }
        build_rib(line, inward, {0, 0, 1}, material, room);
    }
}

// ---- the opening at the top

// A drum around it, and the bars of a lantern.
void build_oculus(const Plan& plan, const Materials& m, Room& room) {
    const float r = plan.oculus, y0 = plan.height, y1 = plan.height + kCeilingThickness;
    RoomObject object;
    object.kind = object.name = "skylight";
    object.source = "built-in";
    object.requested = plan.asked("skylight") != nullptr;
    object.size_m = {2 * r, kCeilingThickness, 2 * r};
    object.world_from_object.translation = {0, y0, 0};
    room.objects.push_back(object);
    const auto index = static_cast<int>(room.objects.size()) - 1;
    constexpr int kAround = 48, kBars = 4;
    Grid drum(kAround, 1, m.trim, index);
    for (int i = 0; i <= kAround; ++i) {
        const float a = 2 * kPi * static_cast<float>(i) / kAround;
        const Vec3f out{std::cos(a), 0, std::sin(a)};
        for (const float y : {y0, y1}) drum.add(out * r + Vec3f{0, y, 0}, -out, {a * r, y, 0});
    }
    room.meshes.push_back(drum.take());
    constexpr float kBar = 0.018f;  // half its width
    for (int i = 0; i < kBars; ++i) {
        const float a = kPi * static_cast<float>(i) / kBars;
        const WallFace face{{-r * std::cos(a), 0, -r * std::sin(a)},
                            {std::cos(a), 0, std::sin(a)},
                            {std::sin(a), 0, -std::cos(a)},
                            2 * r};
        WallBuilder(face, room)
            .box(0, 2 * r, y1 - 0.06f, y1 - 0.02f - kHair_m * static_cast<float>(i), -kBar, kBar, m.trim, index);
    }
    room.portals.push_back({{-r, y1, -r}, {2 * r, 0, 0}, {0, 0, 2 * r}});
}

void build_cornice(const Plan& plan, int trim, Room& room) {
    const bool apse = conch_from(plan) < plan.depth / 2 - kHair_m;
    for (const WallFace& face : plan.faces()) {
        const bool below_arch = plan.vault == Vault::barrel && (face.wall == 2 || (face.wall == 0 && !apse));
        if (face.behind > 0 || below_arch) continue;
        const WallBuilder wall(face, room);
        wall.box(0, face.length, plan.spring - 0.1f, plan.spring + 0.02f, 0, 0.06f, trim);
        wall.box(0, face.length, plan.spring - 0.16f, plan.spring - 0.1f, 0, 0.03f, trim);
    }
}

}  // namespace

void build_cut_corners(const Plan& plan, int material, Room& room) {
    // A vault that only met them edge to edge would let light in.
    const float top = plan.vault != Vault::flat ? plan.spring + kLap : plan.height + kCeilingThickness;
    for (const Block& b : plan.blocks) {
        if (!cuts_corner(b)) continue;
        const std::vector<Vec2f> edge = cut_edge(b);
        const std::size_t last = edge.size() - 1;
        const auto normal_at = [&](std::size_t i) {
            const Vec2f before = inward_of(edge[i > 0 ? i - 1 : 0], edge[i > 0 ? i : 1]),
                        after = inward_of(edge[i < last ? i : last - 1], edge[i < last ? i + 1 : last]);
            return (before + after) * (1.f / length(before + after));
        };
        // At both ends it goes on along the end of the wall that it meets.
        const auto beyond = [&](Vec2f at) {
            const bool side = std::abs(std::abs(at.x) - plan.width / 2) < kHair_m;
            return at + (side ? Vec2f{std::copysign(kFlange, at.x), 0} : Vec2f{0, std::copysign(kFlange, at.y)});
        };
        Grid inside(static_cast<int>(last) + 2, 1, material), outside(static_cast<int>(last), 1, material);
        float along = 0;
        const auto column = [&](Grid& grid, Vec2f at, Vec2f normal) {
            for (const float y : {-kFloorThickness, top})
                grid.add({at.x, y, at.y}, {normal.x, 0, normal.y}, {along, y, 0});
        };
        column(inside, beyond(edge.front()), normal_at(0));
        for (std::size_t i = 0; i <= last; ++i) {
            if (i > 0) along += length(edge[i] - edge[i - 1]);
            const Vec2f normal = normal_at(i);
            column(inside, edge[i], normal);
            column(outside, edge[i] - normal * kCurvedWall, normal * -1.f);
        }
        column(inside, beyond(edge.back()), normal_at(last));
        room.meshes.push_back(inside.take());
        room.meshes.push_back(outside.take());
    }
}

void build_slab(const Plan& plan, float y0, float y1, int material, Room& room) {
    std::vector<Vec2f> outline = plan.outline();
    for (Vec2f& p : outline) p = p * (1.f + kReach / length(p));
    for (const float y : {y0, y1}) {
        Mesh face;
        face.material = material;
        for (const Vec2f p : outline) {
            face.positions.push_back({p.x, y, p.y});
            face.coords.push_back({p.x, y, p.y});
            face.normals.push_back({0, y == y0 ? -1.f : 1.f, 0});
        }
        // A fan: the outline is convex, and its order is counterclockwise seen from above.
        for (std::uint32_t i = 1; i + 1 < outline.size(); ++i)
            face.triangles.insert(face.triangles.end(), {0u, y == y0 ? i + 1 : i, y == y0 ? i : i + 1});
        room.meshes.push_back(std::move(face));
    }
}

void build_gable(const Plan& plan, int wall, int material, Room& room) {
    if (wall % 2 == 1 || (wall == 0 && conch_from(plan) < plan.depth / 2 - kHair_m)) return;
    const WallFace face = plan.wall(wall);
    const Barrel barrel{plan};
    constexpr int kSteps = 2 * kAlongProfile;
    Grid grid(kSteps, 1, material);
    for (int i = 0; i <= kSteps; ++i) {
        const Vec3f top = barrel.point(static_cast<float>(i) / kSteps, face.origin.z);
        for (const float y : {plan.spring, top.y}) grid.add({top.x, y, top.z}, face.inward, {top.x, y, top.z});
    }
    room.meshes.push_back(grid.take());
}

void build_vault(const Plan& plan, const Materials& m, Room& room) {
    const bool ribs = plan.style.mouldings != Mouldings::none && plan.relief == WallRelief::flat;
    if (plan.vault == Vault::barrel) {
        build_barrel(plan, m.ceiling, room);
        if (ribs) build_barrel_ribs(plan, m.trim, room);
    } else {
        build_cap(plan, {}, m.ceiling, room);
        if (ribs) build_cap_ribs(plan, m.trim, room);
    }
    if (ribs) build_cornice(plan, m.trim, room);
    if (plan.oculus > 0) build_oculus(plan, m, room);
}

}  // namespace fastscene::shell
