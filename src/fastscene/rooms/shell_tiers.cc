// Tiers and the steps that lead up to them: solid boxes with the floor's material on top and noses over their risers.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "fastscene/rooms/shell_kit.h"
#include "fastscene/scene/raised_floor.h"

namespace fastscene::shell {
namespace {

constexpr float kTop_m = 0.025f;                          // thickness of what one treads on
constexpr float kEdge_m = 0.035f, kEdgeThick_m = 0.004f;  // the strip along a step's edge that one sees in the dark
constexpr float kLamp_m = 0.012f, kLampBelow_m = 0.05f, kLampShare = 0.7f;  // of a step's width
constexpr float kBeside_m = 0.02f;
constexpr float kSkirting_m = 0.09f;

// The four sides of a platform: which way they look.
constexpr std::array<Vec2f, 4> kSides{Vec2f{0, 1}, {1, 0}, {0, -1}, {-1, 0}};

struct Look {
    int top, riser, edge, lamp, trim;
    bool lit;
};

Vec2f middle_of(const Platform& p) { return (p.low + p.high) * 0.5f; }
Vec2f half_of(const Platform& p) { return (p.high - p.low) * 0.5f; }

// The floor just beyond a side; nothing: a wall.
std::optional<float> beyond(const Plan& plan, const Platform& p, Vec2f side) {
    const Vec2f half = half_of(p),
                at = middle_of(p) + Vec2f{side.x * (half.x + kBeside_m), side.y * (half.y + kBeside_m)};
    if (std::abs(at.x) > plan.width / 2 || std::abs(at.y) > plan.depth / 2) return {};
    return plan.floor_at(at);
}

int add_object(const Platform& p, Room& room) {
    RoomObject object;
    object.kind = object.name = p.kind == Platform::Kind::tier ? kTier : kTierStep;
    std::replace(object.name.begin(), object.name.end(), '_', ' ');
    object.source = "built-in";
    object.world_from_object.translation = {middle_of(p).x, 0, middle_of(p).y};
    object.size_m = {p.high.x - p.low.x, p.height, p.high.y - p.low.y};
    room.objects.push_back(object);
    return static_cast<int>(room.objects.size()) - 1;
}

// A strip along a side of a platform: from `out` to `in` metres inside of its edge, between two heights.
void strip(const Platform& p, Vec2f side, float out, float in, float y0, float y1, float share, int material,
           int object, Room& room) {
    const Vec2f half = half_of(p), across{std::abs(side.y) * half.x * share, std::abs(side.x) * half.y * share},
                edge = middle_of(p) + Vec2f{side.x * half.x, side.y * half.y};
    const Vec2f a = edge - side * out - across, b = edge - side * in + across;
    room.meshes.push_back(box_mesh({std::min(a.x, b.x), y0, std::min(a.y, b.y)},
                                   {std::max(a.x, b.x), y1, std::max(a.y, b.y)}, material, object));
}

// The side from which one comes: what lies behind is higher, or a wall behind the last tier.
Vec2f front_of_platform(const Plan& plan, const Platform& p) {
    for (const Vec2f side : kSides) {
        const auto there = beyond(plan, p, side), back = beyond(plan, p, side * -1.f);
        if (there && *there < p.height && (back ? *back > p.height : p.kind == Platform::Kind::tier)) return side;
    }
    return {};
}

void build_edge(const Platform& p, Vec2f front, const Look& look, int object, Room& room) {
    strip(p, front, -kStepNose_m, kEdge_m, p.height - kHair_m, p.height + kEdgeThick_m, 1, look.edge, object, room);
}

// The edges of a tier: above each flight of steps that leads up to it, or all along where there is none.
void build_edges_of_tier(const Plan& plan, const Platform& tier, const Look& look, int object, Room& room) {
    bool steps = false;
    for (const Platform& p : plan.platforms) {
        if (p.kind != Platform::Kind::step) continue;
        steps = true;
        const Vec2f front = front_of_platform(plan, p);
        if (front == Vec2f{} || beyond(plan, p, front * -1.f) != tier.height) continue;
        strip(p, front * -1.f, -kEdge_m, kStepNose_m, tier.height - kHair_m, tier.height + kEdgeThick_m, 1, look.edge,
              object, room);
    }
    const Vec2f front = front_of_platform(plan, tier);
    if (!steps && front != Vec2f{}) build_edge(tier, front, look, object, room);
}

void build_platform(const Plan& plan, const Platform& p, const Look& look, Room& room) {
    const int object = add_object(p, room);
    room.meshes.push_back(box_mesh({p.low.x, 0, p.low.y}, {p.high.x, p.height - kTop_m, p.high.y}, look.riser, object));
    Vec2f low = p.low, high = p.high;
    for (const Vec2f side : kSides)
        if (const auto there = beyond(plan, p, side); there && *there < p.height)
            (side.x + side.y > 0 ? high : low) = (side.x + side.y > 0 ? high : low) + side * kStepNose_m;
    room.meshes.push_back(box_mesh({low.x, p.height - kTop_m, low.y}, {high.x, p.height, high.y}, look.top, object));
    if (p.kind == Platform::Kind::tier) return build_edges_of_tier(plan, p, look, object, room);
    const Vec2f front = front_of_platform(plan, p);
    if (front == Vec2f{}) return;
    build_edge(p, front, look, object, room);
    if (look.lit)
        strip(p, front, -4 * kHair_m, kHair_m, p.height - kLampBelow_m - kLamp_m, p.height - kLampBelow_m, kLampShare,
              look.lamp, object, room);
}

// Skirting along the walls at a tier's height.
void build_tier_skirting(const Plan& plan, const Platform& p, const Look& look, Room& room) {
    constexpr float kOut = 0.02f;
    const Vec2f at = middle_of(p), half = half_of(p);
    const auto touches = [](float a, float b) { return std::abs(a - b) < kBeside_m; };
    if (touches(at.x + half.x, plan.width / 2))
        strip(p, {1, 0}, 0, kOut, p.height, p.height + kSkirting_m, 1, look.trim, -1, room);
    if (touches(at.x - half.x, -plan.width / 2))
        strip(p, {-1, 0}, 0, kOut, p.height, p.height + kSkirting_m, 1, look.trim, -1, room);
    const float share = (half.x - kOut) / half.x;  // between those of the side walls
    if (touches(at.y + half.y, plan.depth / 2))
        strip(p, {0, 1}, 0, kOut, p.height, p.height + kSkirting_m, share, look.trim, -1, room);
    if (touches(at.y - half.y, -plan.depth / 2))
        strip(p, {0, -1}, 0, kOut, p.height, p.height + kSkirting_m, share, look.trim, -1, room);
}

}  // namespace

void build_platforms(const Plan& plan, const Materials& m, Room& room) {
    if (plan.platforms.empty()) return;
    // Boards end at the edge: risers below them are of plain wood. What is soft goes over it.
    Material riser = plan.style.floor;
    if (riser.pattern == Pattern::herringbone || riser.pattern == Pattern::parquet ||
        riser.pattern == Pattern::planks) {
        riser.pattern = Pattern::wood;
        riser.name += " riser";
    }
    Material lamp;
    lamp.name = "step light";
    lamp.color_a = lamp.color_b = lamp.color_c = {0.7f, 0.68f, 0.64f};
    lamp.emission = plan.style.lamp_light;
    // Halls without windows are dark while one looks at what they are for: their steps have lights.
    const bool lit = std::none_of(plan.openings.begin(), plan.openings.end(),
                                  [](const Opening& o) { return o.kind == Opening::Kind::window; });
    const Look look{m.floor,
                    add_material(room, riser),
                    add_material(room, plan.style.metal),
                    lit ? add_material(room, lamp) : -1,
                    m.trim,
                    lit};
    for (const Platform& p : plan.platforms) {
        build_platform(plan, p, look, room);
        if (p.kind == Platform::Kind::tier && plan.relief == WallRelief::flat && !plan.cabin)
            build_tier_skirting(plan, p, look, room);
    }
}

}  // namespace fastscene::shell
