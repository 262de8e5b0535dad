// Outlines that are no box, and vaults: octagons, round rooms, apses; domes, cones and barrel vaults.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {
namespace {

constexpr const char* kOpenTop = "open";  // the lexicon's size of a dome with an oculus
constexpr float kLeastAcross = 3.8f;      // metres: of an octagonal or round room whose size was not said
constexpr float kDoorWall = 1.5f;         // metres: a flat piece of wall that takes a door or a window
constexpr float kLeastSpring = 2.25f;     // metres: a vault springs above people's heads
constexpr float kUsualSpring = 2.55f;     // … and above doors and windows

void cut(Plan& plan, Block::Kind kind, float x, float z, bool near_too) {
    const float w = plan.width / 2, d = plan.depth / 2;
    for (const float sx : {-1.f, 1.f})
        for (const float sz : {-1.f, 1.f}) {
            if (sz < 0 && !near_too) continue;
            const Vec2f corner{sx * w, sz * d}, inner{sx * (w - x), sz * (d - z)};
            plan.blocks.push_back({kind,
                                   {std::min(corner.x, inner.x), std::min(corner.y, inner.y)},
                                   {std::max(corner.x, inner.x), std::max(corner.y, inner.y)}});
        }
}

// What of a side is cut off at each of its ends, so that this much of it stays flat.
float cut_for(float side, float flat) { return std::max(0.4f, (side - flat) / 2); }

}  // namespace

Outline outline_asked(const PromptSpec& spec) {
    if (wants_corners(spec) || is_below_roof(spec)) return Outline::box;
    if (wish_for(spec, "apse")) return Outline::apse;
    for (std::size_t i = 0; i < kNamesOf<Outline>.size(); ++i)
        if (kNamesOf<Outline>[i] == spec.outline) return static_cast<Outline>(i);
    return room_type(spec.room).outline;
}

void cut_corners(Outline outline, Plan& plan) {
    if (outline != Outline::apse && !plan.measured)
        plan.width = plan.depth = std::max(kLeastAcross, std::sqrt(plan.width * plan.depth) * 1.04f);
    // An accent on one flat piece of wall of many looks like a mistake.
    if (outline != Outline::apse) plan.accent = false;
    const float side = std::min(plan.width, plan.depth);
    switch (outline) {
        case Outline::box: return;
        case Outline::octagon: {
            const float off = std::min(side * (1.f - std::numbers::sqrt2_v<float> / 2), cut_for(side, kDoorWall));
            return cut(plan, Block::Kind::cut, off, off, true);
        }
        case Outline::round: {
            const float flat = std::max(kDoorWall, 0.28f * side);
            return cut(plan, Block::Kind::curve, cut_for(plan.width, flat), cut_for(plan.depth, flat), true);
        }
        case Outline::apse: {
            const float off = std::min(cut_for(plan.width, kDoorWall), 0.4f * plan.depth);
            return cut(plan, Block::Kind::curve, cut_for(plan.width, kDoorWall), off, false);
        }
    }
}

std::vector<Vec2f> round_outline(Vec2f size) {
    Plan plan;
    plan.width = size.x, plan.depth = size.y, plan.measured = true;
    cut_corners(Outline::round, plan);
    return plan.outline();
}

void raise_vault(PromptSpec& spec, Plan& plan) {
    const RoomType& type = room_type(spec.room);
    const PromptObject* wish = wish_for(spec, "vault");
    if (wish_for(spec, "vault", true)) return;
    Vault vault = type.vault;
    if (wish)
        vault = wish->pattern == kNamesOf<Vault>[static_cast<std::size_t>(Vault::barrel)] ? Vault::barrel : Vault::dome;
    if (vault == Vault::flat) return;
    if (plan.knee > 0) {
        if (wish) report(spec, *wish, wish->count, "not below a sloped ceiling");
        return;
    }
    const float side = vault == Vault::barrel ? plan.width : std::min(plan.width, plan.depth);
    float rise = vault == type.vault ? type.rise_m : std::clamp(0.28f * side, 0.6f, 1.8f);
    const bool said = spec.size_m.y > 0;
    if (!said) plan.height = std::max(plan.height, kUsualSpring + rise);
    constexpr float kLeastRise = 0.3f;
    rise = std::min(rise, plan.height - kLeastSpring);
    if (rise < kLeastRise) {
        if (wish) report(spec, *wish, wish->count, "the room is too low for it");
        return;
    }
    plan.vault = vault;
    plan.spring = plan.height - rise;
    const bool open = wish_for(spec, "skylight") || (wish && wish->size == kOpenTop);
    constexpr float kShare = 0.14f;  // of the narrower side
    if (vault == Vault::dome) plan.oculus = open ? std::clamp(kShare * side, 0.4f, 1.2f) : type.oculus_m;
    if (wish) {
        PromptObject surface = *wish;
        surface.pattern.clear();  // that is its shape
        apply_wish(plan.style.ceiling, surface, true);
    }
    if (const PromptObject* beams = wish_for(spec, "beams")) report(spec, *beams, beams->count, "not below a vault");
    if (const PromptObject* coffers = wish_for(spec, "coffers"); coffers && plan.coffers)
        report(spec, *coffers, coffers->count, "not below a vault");
    plan.beams = plan.coffers = false;
}

}  // namespace fastscene
