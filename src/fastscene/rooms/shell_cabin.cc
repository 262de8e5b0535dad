// Cabins of vehicles: panes set in rubber, doors of glass, the curve below the ceiling, the tunnel outside.
#include <cmath>

#include "fastscene/rooms/shapes.h"
#include "fastscene/rooms/shell_kit.h"

namespace fastscene::shell {
namespace {

constexpr float kPaneOuter = -0.045f, kPaneInner = -0.008f;  // depth of a leaf of a door in its panel

// A leaf from u0 to u1: a frame about a pane with rounded corners, and the seal of that.
struct Leaf {
    float stile, head, foot;  // widths of the frame
};
void build_leaf(const WallBuilder& wall, const Opening& o, float u0, float u1, const Leaf& leaf, int frame, int rubber,
                int object) {
    Opening pane = o;
    pane.shape = Opening::Shape::rounded;
    pane.u0 = u0 + leaf.stile, pane.u1 = u1 - leaf.stile;
    pane.y0 = o.y0 + leaf.foot, pane.y1 = o.y1 - leaf.head;
    wall.box(u0, pane.u0, o.y0, o.y1, kPaneOuter, kPaneInner, frame, object);
    wall.box(pane.u1, u1, o.y0, o.y1, kPaneOuter, kPaneInner, frame, object);
    wall.box(pane.u0, pane.u1, o.y0, pane.y0, kPaneOuter, kPaneInner, frame, object);
    wall.box(pane.u0, pane.u1, pane.y1, o.y1, kPaneOuter, kPaneInner, frame, object);
    fill_corners(wall, pane, kPaneOuter, kPaneInner, frame, object);
    ring(wall, pane, -0.01f, 0.016f, kPaneOuter - kHair_m, kPaneInner + 0.006f, rubber, object);
}

void build_doors(const Opening& o, const WallBuilder& wall, Room& room, int rubber, int object) {
    const bool sliding = o.glazing == Glazing::sliding_doors;
    const int frame = add_material(room, sliding ? painted("door leaf", {0.5f, 0.51f, 0.52f}, 0.32f)
                                                 : painted("door leaf", {0.05f, 0.052f, 0.056f}, 0.4f)),
              yellow = add_material(room, painted("safety yellow", {0.72f, 0.47f, 0.02f}, 0.35f));
    const Leaf leaf = sliding ? Leaf{0.1f, 0.14f, 0.8f} : Leaf{0.045f, 0.06f, 0.09f};
    const float middle = (o.u0 + o.u1) / 2;
    constexpr float kSeal = 0.014f;
    build_leaf(wall, o, o.u0, middle - kSeal, leaf, frame, rubber, object);
    build_leaf(wall, o, middle + kSeal, o.u1, leaf, frame, rubber, object);
    wall.box(middle - kSeal, middle + kSeal, o.y0, o.y1, kPaneOuter, kPaneInner + 0.004f, rubber, object);
    if (!sliding)  // bars to hold on to
        for (const float side : {-1.f, 1.f}) {
            const float u = middle + side * (kSeal + 0.075f);
            wall.box(u - 0.014f, u + 0.014f, 0.75f, 1.5f, 0.03f, 0.058f, yellow, object);
            for (const float y : {0.78f, 1.44f})
                wall.box(u - 0.01f, u + 0.01f, y, y + 0.02f, kPaneInner, 0.03f, yellow, object);
        }
    // The portal, and the edge of the floor.
    constexpr float kPortal = 0.06f, kProud = 0.012f;
    const int portal = sliding ? frame : rubber;
    wall.box(o.u0 - kPortal, o.u0, 0, o.y1 + kPortal, 0, kProud, portal, object);
    wall.box(o.u1, o.u1 + kPortal, 0, o.y1 + kPortal, 0, kProud, portal, object);
    wall.box(o.u0, o.u1, o.y1, o.y1 + kPortal, 0, kProud, portal, object);
    wall.box(o.u0, o.u1, 0.f, 0.008f, kPaneInner, 0.09f, yellow, object);
}

}  // namespace

void build_cabin_opening(const Plan& plan, const Opening& o, const WallBuilder& wall, Room& room, int object) {
    const PromptObject* wish = plan.asked("window");
    const Material seal = painted("rubber", {0.018f, 0.018f, 0.019f}, 0.55f);
    const int rubber = add_material(room, wish ? as_asked(plan, "window", seal) : seal);
    if (is_doors(o.glazing)) return build_doors(o, wall, room, rubber, object);
    ring(wall, o, -0.022f, 0.028f, -plan.wall_thickness() - 0.004f, 0.007f, rubber, object);
    if (o.glazing != Glazing::windscreen) return;
    // Two panes, a wiper below each.
    const float middle = (o.u0 + o.u1) / 2, wide = (o.u1 - o.u0) / 2;
    wall.box(middle - 0.012f, middle + 0.012f, o.y0, o.y1, -0.04f, -0.015f, rubber, object);
    for (const float side : {-1.f, 1.f}) {
        const float u = middle + side * 0.5f * wide;
        wall.box(u - 0.38f * wide, u + 0.38f * wide, o.y0 + 0.075f, o.y0 + 0.093f, -0.075f, -0.06f, rubber, object);
        wall.box(u - 0.008f, u + 0.008f, o.y0 - 0.02f, o.y0 + 0.08f, -0.09f, -0.075f, rubber, object);
    }
}

void build_cove(const Plan& plan, int material, Room& room) {
    constexpr int kSteps = 10;
    const float w = plan.width / 2, d = plan.depth / 2, r = plan.cove;
    for (const float side : {-1.f, 1.f}) {
        Mesh curve = shapes::sheet(1, kSteps, [&](float u, float v) {
            const float a = 0.5f * kPi * v, z = side > 0 ? std::lerp(-d, d, u) : std::lerp(d, -d, u);
            return Vec3f{side * (w - r + r * std::cos(a)), plan.height - r + r * std::sin(a), z};
        });
        curve.material = material;
        room.meshes.push_back(std::move(curve));
    }
}

void build_tunnel(const Plan& plan, Room& room) {
    constexpr float kBeside = 0.75f, kAbove = 0.9f, kBelow = 1.f, kBeyond = 14.f, kThick = 0.2f, kRing = 1.4f;
    const Material concrete = painted("tunnel", {0.12f, 0.115f, 0.105f}, 0.9f);
    const int wall = add_material(room, concrete), rib = add_material(room, painted("rib", {0.2f, 0.19f, 0.17f}, 0.9f)),
              cable = add_material(room, painted("cable", {0.02f, 0.02f, 0.022f}, 0.6f));
    Material light = painted("tunnel lamp", {0.7f, 0.7f, 0.65f}, 0.5f);
    light.emission = {9.f, 8.f, 6.f};
    const int lamp = add_material(room, light);
    const float w = plan.width / 2 + kBeside, d = plan.depth / 2 + kBeyond, low = -kBelow, high = plan.height + kAbove;
    const auto box = [&](Vec3f a, Vec3f b, int material) { room.meshes.push_back(box_mesh(a, b, material, -1)); };
    box({-w, low - kThick, -d}, {w, low, d}, wall), box({-w, high, -d}, {w, high + kThick, d}, wall);
    for (const float end : {-1.f, 1.f})
        box({-w, low, std::min(end * d, end * (d + kThick))}, {w, high, std::max(end * d, end * (d + kThick))}, wall);
    for (const float side : {-1.f, 1.f}) {
        const auto along = [&](float out, float in, float y0, float y1, float z0, float z1, int material) {
            box({std::min(side * (w + out), side * (w - in)), y0, z0},
                {std::max(side * (w + out), side * (w - in)), y1, z1}, material);
        };
        along(kThick, 0, low, high, -d, d, wall);
        for (float z = -d + kRing; z < d; z += kRing) along(0, 0.07f, low, high, z, z + 0.16f, rib);
        for (const float y : {0.95f, 1.08f, 1.62f}) along(-0.1f, 0.15f, y, y + 0.045f, -d, d, cable);
        constexpr float kLamps = 4 * kRing;
        for (float z = -d + 0.5f * kLamps; z < d; z += kLamps) along(0, 0.12f, 1.35f, 1.43f, z, z + 0.35f, lamp);
    }
}

}  // namespace fastscene::shell
