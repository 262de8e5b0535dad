// What walls and floors are made of before the prompt's own wishes: no two rooms of a style are painted alike, and wet
// rooms are tiled.
#include <algorithm>
#include <array>
#include <bit>
#include <iterator>

#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {
namespace {

// Walls light each other: a paint looks stronger on them than on its card, so that a paler one is bought.
Vec3f as_wall(Vec3f card) {
    constexpr float kPaler = 0.38f;
    const float l = luminance(card);
    return lerp(card, Vec3f{l, l, l} * 1.1f, kPaler);
}

}  // namespace

void choose_paint(const PromptSpec& spec, Plan& plan, Random& rng) {
    // A room whose color the prompt speaks of keeps plain walls beside it.
    if (!spec.colors.empty() || spec.mood == "airy" || spec.light == "bright") return;
    const std::vector<Vec3f>& paints = plan.style.paints;
    const Vec3f card = paints[static_cast<std::size_t>(rng.index(static_cast<int>(paints.size())))];
    plan.style.wall.color_a = plan.style.wall.color_b = plan.style.wall.color_c = as_wall(card);
}

void deepen_paint(const PromptSpec& spec, Plan& plan) {
    if (!spec.colors.empty() || !spec.mood.empty() || spec.light == "bright" || !room_type(spec.room).deep_paints)
        return;
    Random rng(hash_name(spec.text) ^ std::bit_cast<std::uint32_t>(plan.depth), "deep paint");
    const std::vector<Vec3f>& paints = plan.style.deep_paints;
    if (paints.empty() || !rng.chance(0.6f)) return;
    plan.style.wall.color_a = plan.style.wall.color_b = plan.style.wall.color_c =
        paints[static_cast<std::size_t>(rng.index(static_cast<int>(paints.size())))];
    plan.accent = false;
}

void tile_wet_room(Plan& plan, Random& rng) {
    plan.style.accent_wall = plan.style.wet_wall;
    plan.accent = true;
    // All around, or one wall; dark tiles all around make a cave.
    if (luminance(plan.style.accent_wall.color_a) > 0.25f && rng.chance(0.5f)) plan.style.wall = plan.style.accent_wall;
    plan.style.floor = plan.style.wet_floor;
}

void choose_ceiling(const PromptSpec& spec, Plan& plan) {
    const auto speaks_of = [&](std::string_view kind) {
        return std::any_of(spec.objects.begin(), spec.objects.end(),
                           [&](const PromptObject& o) { return o.kind == kind; });
    };
    // A generator of its own: what the ceiling is like changes nothing else.
    Random rng(hash_name(spec.text) ^ std::bit_cast<std::uint32_t>(plan.width), "ceiling");
    const float boards = rng.uniform(), tray = rng.uniform(), spots = rng.uniform();
    plan.recessed_lights = wish_for(spec, "recessed_lights") != nullptr && plan.vault == Vault::flat &&
                           !(plan.mezzanine.depth > 0);
    if (room_type(spec.room).ceiling || speaks_of("ceiling") || !spec.everything.kind.empty()) return;
    const bool wet = room_type(spec.room).wet, flat = !(plan.knee > 0) && !plan.beams && !plan.coffers &&
                                                      plan.vault == Vault::flat && !(plan.mezzanine.depth > 0);
    const Style& style = plan.style;
    if (boards < style.ceiling_boards_probability && !wet && plan.vault == Vault::flat) {
        plan.style.ceiling = style.ceiling_boards;
        return;
    }
    // Below the step there is room for curtain rods, and no corner of the room cuts it.
    const bool high = std::all_of(plan.openings.begin(), plan.openings.end(),
                                  [&](const Opening& o) { return o.y1 < plan.height - kTrayStep - 0.2f; });
    plan.tray = room_type(spec.room).lived_in && flat && high && !wet && plan.blocks.empty() && plan.width > 2.8f &&
                tray < style.tray_probability;
    // Who speaks of lamps in the ceiling, this way or that, has those.
    if (!speaks_of("recessed_lights") && !speaks_of("ceiling_lamp"))
        plan.recessed_lights = flat && plan.height < 3.15f &&
                               spots < std::max(wet ? 0.5f : 0.f, style.recessed_lights_probability);
}

}  // namespace fastscene
