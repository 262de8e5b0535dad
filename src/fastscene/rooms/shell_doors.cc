// The room's door: one leaf or two, of panels, planks, steel or glass, set before the wall, with casing and handles.
#include <cmath>

#include "fastscene/rooms/materials.h"
#include "fastscene/rooms/shell_kit.h"

namespace fastscene::shell {
namespace {

constexpr float kWidestLeaf = 1.25f;                    // metres; wider doors have two leaves
constexpr float kLeafBack = -0.01f, kLeafFace = 0.02f;  // depth of a leaf
constexpr float kLeafFoot = 0.005f;                     // its lower edge
constexpr float kLeafSeam = 0.006f;                     // between two leaves
constexpr float kHandleHeight = 1.02f;                  // height of handles
constexpr float kLockRail = 0.95f;                      // middle of the rail between two panels

// A leaf, and the side at which it opens: +1: at its end of greater u.
struct DoorLeaf {
    float u0, u1, opens;
    float width() const { return u1 - u0; }
    // So far from the edge at which it opens, or from that at its hinges.
    float from_edge(float by) const { return opens > 0 ? u1 - by : u0 + by; }
    float from_hinge(float by) const { return opens > 0 ? u0 + by : u1 - by; }
};

struct DoorBuilder {
    const Plan& plan;
    const Opening& o;
    const WallBuilder& wall;
    Room& room;
    int object, leaf, metal;

    void box_between(float a, float b, float y0, float y1, float w0, float w1, int material) const {
        wall.box(std::min(a, b), std::max(a, b), y0, y1, w0, w1, material, object);
    }
    // A board of the leaf, from the line `y0` up to the door's edge less `inset`.
    void board(float u0, float u1, float y0, float inset, float w0, float w1, int material) const {
        if (o.shape == Opening::Shape::square) return wall.box(u0, u1, y0, o.y1 - inset, w0, w1, material, object);
        constexpr int kSteps = 10;
        std::vector<Vec2f> low, high;
        for (int i = kSteps; i >= 0; --i) {  // as edge_of: from greater u to smaller
            const float u = u0 + (u1 - u0) * static_cast<float>(i) / kSteps;
            low.push_back({u, y0});
            high.push_back({u, std::max(y0 + kHair_m, extent_at(o, u).second - inset)});
        }
        wall.band(low, high, w0, w1, material, object);
    }
    void plain_leaf(const DoorLeaf& l) const { board(l.u0, l.u1, kLeafFoot, 0, kLeafBack, kLeafFace, leaf); }

    void lever(const DoorLeaf& l) const {
        const float at = l.from_edge(0.07f), end = l.from_edge(0.19f);
        wall.box(at - 0.012f, at + 0.012f, kHandleHeight - 0.03f, kHandleHeight + 0.03f, kLeafFace, kLeafFace + 0.008f,
                 metal, object);
        wall.box(at - 0.008f, at + 0.008f, kHandleHeight - 0.008f, kHandleHeight + 0.01f, 0.028f, 0.065f, metal,
                 object);
        box_between(at, end, kHandleHeight - 0.008f, kHandleHeight + 0.01f, 0.052f, 0.066f, metal);
    }
    // An upright bar to pull at.
    void pull(const DoorLeaf& l) const {
        constexpr float kHalf = 0.011f, kLow = 0.8f, kHigh = 1.4f, kOff = 0.075f;
        const float u = l.from_edge(0.1f);
        wall.box(u - kHalf, u + kHalf, kLow, kHigh, kOff - 0.022f, kOff, metal, object);
        for (const float y : {kLow + 0.06f, kHigh - 0.06f})
            wall.box(u - kHalf, u + kHalf, y - kHalf, y + kHalf, kLeafFace, kOff - 0.022f, metal, object);
    }
    // A bar to push, across the leaf.
    void push_bar(const DoorLeaf& l) const {
        constexpr float kBeside = 0.09f;
        wall.box(l.u0 + kBeside, l.u1 - kBeside, kHandleHeight - 0.035f, kHandleHeight + 0.035f, 0.05f, 0.085f, metal,
                 object);
        for (const float u : {l.u0 + kBeside, l.u1 - kBeside - 0.06f})
            wall.box(u, u + 0.06f, kHandleHeight - 0.045f, kHandleHeight + 0.045f, kLeafFace, 0.075f, metal, object);
    }
    void kick_plate(const DoorLeaf& l) const {
        constexpr float kBeside = 0.03f, kHigh = 0.22f, kThick = 0.003f;
        wall.box(l.u0 + kBeside, l.u1 - kBeside, 0.03f, kHigh, kLeafFace, kLeafFace + kThick, metal, object);
    }

    // Two panels stand proud of the leaf, the upper one as round as the door.
    void panelled(const DoorLeaf& l) const {
        const float inset = 0.13f, u0 = l.u0 + inset, u1 = l.u1 - inset;
        plain_leaf(l);
        wall.box(u0, u1, 0.2f, kLockRail - 0.06f, kLeafFace, 0.04f, leaf, object);
        board(u0, u1, kLockRail + 0.08f, inset, kLeafFace, 0.04f, leaf);
    }

    // A plain leaf with a narrow pane beside its handle.
    void flush(const DoorLeaf& l) const {
        plain_leaf(l);
        const float a = l.from_edge(0.14f), b = l.from_edge(0.26f);
        constexpr float kLow = 1.15f, kHigh = 1.85f, kBead = 0.018f;
        const int pane = add_material(room, painted("pane", {0.03f, 0.035f, 0.04f}, 0.06f));
        box_between(a, b, kLow, kHigh, kLeafFace, kLeafFace + 0.003f, pane);
        const float low = std::min(a, b), high = std::max(a, b);
        wall.box(low - kBead, low, kLow - kBead, kHigh + kBead, kLeafFace, 0.028f, leaf, object);
        wall.box(high, high + kBead, kLow - kBead, kHigh + kBead, kLeafFace, 0.028f, leaf, object);
        wall.box(low, high, kLow - kBead, kLow, kLeafFace, 0.028f, leaf, object);
        wall.box(low, high, kHigh, kHigh + kBead, kLeafFace, 0.028f, leaf, object);
        kick_plate(l);
    }

    // A frame about one tall pane of etched glass.
    void glazed(const DoorLeaf& l) const {
        constexpr float kStile = 0.085f, kBottom = 0.2f, kTop = 0.1f;
        const int pane = add_material(room, painted("etched glass", {0.6f, 0.66f, 0.66f}, 0.35f));
        wall.box(l.u0, l.u0 + kStile, kLeafFoot, o.y1, kLeafBack, kLeafFace, leaf, object);
        wall.box(l.u1 - kStile, l.u1, kLeafFoot, o.y1, kLeafBack, kLeafFace, leaf, object);
        wall.box(l.u0 + kStile, l.u1 - kStile, kLeafFoot, kBottom, kLeafBack, kLeafFace, leaf, object);
        wall.box(l.u0 + kStile, l.u1 - kStile, o.y1 - kTop, o.y1, kLeafBack, kLeafFace, leaf, object);
        wall.box(l.u0 + kStile, l.u1 - kStile, kBottom, o.y1 - kTop, kLeafBack, 0.008f, pane, object);
    }

    // Upright planks with grooves between them, iron straps from the hinges, a ring to pull at.
    void planked(const DoorLeaf& l) const {
        constexpr float kPlank = 0.15f, kGroove = 0.005f, kStrap = 0.028f, kIron = 0.012f;
        const int count = std::max(3, static_cast<int>(std::lround(l.width() / kPlank)));
        const float wide = l.width() / static_cast<float>(count);
        board(l.u0, l.u1, kLeafFoot, kGroove, kLeafBack, 0.012f, leaf);
        for (int i = 0; i < count; ++i) {
            const float u0 = l.u0 + wide * static_cast<float>(i);
            board(u0 + kGroove / 2, u0 + wide - kGroove / 2, kLeafFoot, 0, 0.012f, kLeafFace, leaf);
        }
        const float spring = o.shape == Opening::Shape::square ? o.y1 : o.y1 - arch_rise(o);
        for (const float y : {0.32f, spring - 0.3f}) {
            const float a = l.from_hinge(0.015f), b = l.from_hinge(0.8f * l.width());
            box_between(a, b, y - kStrap, y + kStrap, kLeafFace, kLeafFace + kIron, metal);
            for (float u = 0.1f; u < 0.8f * l.width(); u += 0.16f) {
                const float at = l.from_hinge(u);
                wall.box(at - 0.012f, at + 0.012f, y - 0.012f, y + 0.012f, kLeafFace + kIron, kLeafFace + 0.02f, metal,
                         object);
            }
        }
        Opening hoop;
        hoop.shape = Opening::Shape::round;
        const float u = l.from_edge(0.1f), y = kHandleHeight - 0.02f, radius = 0.055f;
        hoop.u0 = u - radius, hoop.u1 = u + radius, hoop.y0 = y - radius, hoop.y1 = y + radius;
        ring(wall, hoop, -0.013f, 0, kLeafFace + 0.012f, kLeafFace + 0.025f, metal, object);
        wall.box(u - 0.03f, u + 0.03f, y + radius - 0.03f, y + radius + 0.04f, kLeafFace, kLeafFace + 0.028f, metal,
                 object);
    }

    void steel(const DoorLeaf& l) const {
        plain_leaf(l);
        kick_plate(l);
        push_bar(l);
    }

    void build(const DoorLeaf& l, bool pair) const {
        switch (plan.door.form) {
            case DoorForm::flush: flush(l); break;
            case DoorForm::glazed: glazed(l); break;
            case DoorForm::planked: return planked(l);
            case DoorForm::steel: return steel(l);
            default: panelled(l);
        }
        if (pair || plan.door.form == DoorForm::glazed) pull(l);
        else lever(l);
    }
};

// What doors of a form are usually made of.
Material usual_leaf(const Plan& plan, const Material& of_style) {
    if (plan.door.material) return *plan.door.material;
    switch (plan.door.form) {
        case DoorForm::planked: return plan.style.wood;
        case DoorForm::steel: return painted("steel door", {0.3f, 0.32f, 0.34f}, 0.4f);
        case DoorForm::glazed: return plan.style.metal;
        default: return of_style;
    }
}

}  // namespace

void build_door(const Plan& plan, const Opening& o, Room& room, int trim, Random& rng) {
    const WallFace face = plan.wall(o.wall);
    const WallBuilder wall(face, room);
    const int object = opening_object(plan, room, "door", o, face, 0.05f);
    const Material of_style = rng.chance(0.5f) ? plan.style.trim : plan.style.wood;
    const int leaf = add_material(room, as_asked(plan, "door", usual_leaf(plan, of_style)));
    const bool planked = plan.door.form == DoorForm::planked;
    const int metal = add_material(room, planked ? *material_named("wrought iron") : plan.style.metal);
    const DoorBuilder door{plan, o, wall, room, object, leaf, metal};
    if (o.u1 - o.u0 > kWidestLeaf) {
        const float middle = (o.u0 + o.u1) / 2;
        door.build({o.u0, middle - kLeafSeam / 2, 1}, true);
        door.build({middle + kLeafSeam / 2, o.u1, -1}, true);
        constexpr float kRebate = 0.02f;  // behind the seam: the wall does not shine through
        door.board(middle - kRebate, middle + kRebate, kLeafFoot, kRebate, kLeafBack, 0.005f, leaf);
    } else {
        door.build({o.u0, o.u1, o.u0 < face.length / 2 ? 1.f : -1.f}, false);
    }
    const bool framed = plan.door.form == DoorForm::steel || plan.door.form == DoorForm::glazed;
    const float casing = framed ? 0.05f : kCasing, proud = framed ? 0.03f : 0.045f;
    if (framed) trim = leaf;
    const float legs = o.shape == Opening::Shape::square ? o.y1 + casing : o.y1 - arch_rise(o);
    for (const auto& [u0, u1] : {std::pair{o.u0 - casing, o.u0}, std::pair{o.u1, o.u1 + casing}})
        wall.box(u0, u1, 0, legs, 0, proud, trim, object);
    if (o.shape == Opening::Shape::square) wall.box(o.u0, o.u1, o.y1, o.y1 + casing, 0, proud, trim, object);
    else ring(wall, o, 0, casing, 0, proud, trim, object);
}

}  // namespace fastscene::shell
