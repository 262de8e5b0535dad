// What walls and floors are made of before the prompt's own wishes: no two rooms of a style are painted alike, and wet
// rooms are tiled.
#include <algorithm>
#include <array>
#include <bit>
#include <iterator>

#include "fastscene/rooms/plan_parts.h"

namespace fastscene {
namespace {

// Paints that go with a style; the first is its own.
struct Paints {
    std::string_view style;
    std::array<const char*, 5> colors;
};
constexpr Paints kPaints[] = {
    {"modern", {"white", "white", "light gray", "greige", "off white"}},
    {"scandinavian", {"white", "white", "light sage", "light duck egg", "linen"}},
    {"japandi", {"greige", "oatmeal", "linen", "light clay", "off white"}},
    {"industrial", {"ash", "off white", "stone", "gray", "ash"}},
    {"classic", {"ivory", "light sage", "light sky", "champagne", "ivory"}},
    {"boho", {"cream", "light terracotta", "cream", "light dusty pink", "sand"}},
    {"rustic", {"cream", "cream", "light olive", "linen", "wheat"}},
    {"mid-century", {"off white", "light mustard", "off white", "light teal", "cream"}},
    {"mediterranean", {"ivory", "white", "off white", "white", "cream"}},
    {"art deco", {"champagne", "blush", "champagne", "light emerald", "ivory"}},
};

// Libraries and studies may be dark: the lamp and the books shine in them.
constexpr std::pair<std::string_view, std::array<const char*, 3>> kDeepPaints[] = {
    {"classic", {"bottle green", "burgundy", "navy"}}, {"art deco", {"bottle green", "navy", "petrol"}},
    {"mid-century", {"petrol", "forest", "tobacco"}},  {"modern", {"charcoal", "petrol", "slate"}},
    {"rustic", {"forest", "umber", "brick"}},          {"industrial", {"charcoal", "slate", "umber"}},
};

struct Tiles {
    std::string_view style;
    Pattern wall;
    const char *color, *grout;
    float size_m;
    Pattern floor;
    const char *floor_a, *floor_b;
    float floor_m;
};
constexpr Tiles kTiles[] = {
    {"modern", Pattern::tile, "white", "silver", 0.3f, Pattern::terrazzo, "silver", "slate", 0.03f},
    {"scandinavian", Pattern::subway, "white", "silver", 0.075f, Pattern::tile, "ash", "white", 0.2f},
    {"japandi", Pattern::tile, "greige", "linen", 0.1f, Pattern::tile, "taupe", "greige", 0.6f},
    {"industrial", Pattern::subway, "charcoal", "gray", 0.075f, Pattern::concrete, "gray", "slate", 0.6f},
    {"classic", Pattern::marble, "white", "silver", 0.6f, Pattern::checker, "ivory", "slate", 0.3f},
    {"boho", Pattern::tile, "dusty pink", "cream", 0.1f, Pattern::terrazzo, "cream", "terracotta", 0.035f},
    {"rustic", Pattern::subway, "cream", "sand", 0.075f, Pattern::tile, "clay", "sand", 0.3f},
    {"mid-century", Pattern::tile, "petrol", "white", 0.1f, Pattern::terrazzo, "white", "mustard", 0.03f},
    {"mediterranean", Pattern::tile, "cobalt", "white", 0.12f, Pattern::tile, "terracotta", "sand", 0.3f},
    {"art deco", Pattern::subway, "bottle green", "champagne", 0.075f, Pattern::checker, "ivory", "charcoal", 0.3f},
};

// Walls light each other: a paint looks stronger on them than on its card, so that a paler one is bought.
Vec3f as_wall(Vec3f card) {
    constexpr float kPaler = 0.38f;
    const float l = luminance(card);
    return lerp(card, Vec3f{l, l, l} * 1.1f, kPaler);
}

// Boards or panels that a ceiling of a style may have, and how often.
struct Ceiling {
    std::string_view style;
    float boards, tray, spots;
    Pattern pattern;
    const char *color, *joint;
    float width_m;
};
constexpr Ceiling kCeilings[] = {
    {"modern", 0.f, 0.85f, 0.85f, Pattern::planks, "white", "white", 0.12f},
    {"scandinavian", 0.7f, 0.7f, 0.3f, Pattern::planks, "white", "off white", 0.11f},
    {"japandi", 0.6f, 0.8f, 0.5f, Pattern::planks, "natural", "oak", 0.09f},
    {"industrial", 0.f, 0.f, 0.f, Pattern::planks, "white", "white", 0.12f},
    {"classic", 0.f, 0.8f, 0.f, Pattern::planks, "white", "white", 0.12f},
    {"boho", 0.65f, 0.5f, 0.f, Pattern::planks, "off white", "cream", 0.13f},
    {"rustic", 0.8f, 0.f, 0.f, Pattern::planks, "natural", "oak", 0.15f},
    {"mid-century", 0.65f, 0.6f, 0.3f, Pattern::planks, "natural", "oak", 0.1f},
    {"mediterranean", 0.6f, 0.f, 0.f, Pattern::planks, "natural", "oak", 0.15f},
    {"art deco", 0.f, 0.85f, 0.2f, Pattern::planks, "white", "white", 0.12f},
};

void cover(Material& m, Pattern pattern, const char* a, const char* b, float scale) {
    const Vec3f first = *color_named(a), second = *color_named(b);
    m = *material_named(pattern == Pattern::marble     ? "marble"
                        : pattern == Pattern::terrazzo ? "terrazzo"
                        : pattern == Pattern::concrete ? "concrete"
                                                       : "tile");
    m.pattern = pattern;
    m.color_a = first;
    m.color_b = second;
    m.color_c = pattern == Pattern::terrazzo ? second * 0.6f : first;
    m.scale_m = scale;
}

}  // namespace

void choose_paint(const PromptSpec& spec, Plan& plan, Random& dice) {
    // A room whose color the prompt speaks of keeps plain walls beside it.
    if (!spec.colors.empty() || spec.mood == "airy" || spec.light == "bright") return;
    for (const Paints& paints : kPaints)
        if (plan.style.name == paints.style)
            if (const auto color = color_named(
                    paints.colors[static_cast<std::size_t>(dice.index(static_cast<int>(paints.colors.size())))]))
                plan.style.wall.color_a = plan.style.wall.color_b = plan.style.wall.color_c = as_wall(*color);
}

void deepen_paint(const PromptSpec& spec, Plan& plan) {
    if (!spec.colors.empty() || !spec.mood.empty() || spec.light == "bright" || spec.room != "study") return;
    Random dice(hash_name(spec.text) ^ std::bit_cast<std::uint32_t>(plan.depth), "deep paint");
    const bool deep = dice.chance(0.6f);
    const int which = dice.index(3);
    for (const auto& [style, colors] : kDeepPaints)
        if (deep && plan.style.name == style) {
            plan.style.wall.color_a = plan.style.wall.color_b = plan.style.wall.color_c = *color_named(
                colors[static_cast<std::size_t>(which)]);
            plan.accent = false;
        }
}

void tile_wet_room(Plan& plan, Random& dice) {
    for (const Tiles& tiles : kTiles) {
        if (plan.style.name != tiles.style) continue;
        cover(plan.style.accent_wall, tiles.wall, tiles.color, tiles.grout, tiles.size_m);
        plan.accent = true;
        // All around, or one wall; dark tiles all around make a cave.
        if (luminance(plan.style.accent_wall.color_a) > 0.25f && dice.chance(0.5f))
            plan.style.wall = plan.style.accent_wall;
        cover(plan.style.floor, tiles.floor, tiles.floor_a, tiles.floor_b, tiles.floor_m);
    }
}

Shelves shelves_of(std::string_view room) {
    if (room == "bathroom" || room == "laundry") return Shelves::bath;
    return room == "kitchen" ? Shelves::kitchen : room == "kids" ? Shelves::toys : Shelves::books;
}

void choose_ceiling(const PromptSpec& spec, Plan& plan) {
    const auto speaks_of = [&](std::string_view klass) {
        return std::any_of(spec.objects.begin(), spec.objects.end(),
                           [&](const PromptObject& o) { return o.klass == klass; });
    };
    // Dice of its own: what the ceiling is like changes nothing else.
    Random dice(hash_name(spec.text) ^ std::bit_cast<std::uint32_t>(plan.width), "ceiling");
    const float boards = dice.uniform(), tray = dice.uniform(), spots = dice.uniform();
    plan.recessed_lights = wish_for(spec, "recessed_lights") != nullptr;
    const auto row = std::find_if(std::begin(kCeilings), std::end(kCeilings),
                                  [&](const Ceiling& c) { return plan.style.name == c.style; });
    if (row == std::end(kCeilings) || speaks_of("ceiling") || !spec.everything.klass.empty()) return;
    const bool wet = spec.room == "bathroom" || spec.room == "laundry",
               flat = !(plan.knee > 0) && !plan.beams && !plan.coffers;
    if (boards < row->boards && !wet) {
        const std::string name = std::string(row->color) + " ceiling boards";
        Material& m = plan.style.ceiling;
        m = *material_named("planks");
        m.name = name;
        m.color_a = m.color_c = *color_named(row->color);
        m.color_b = *color_named(row->joint);
        m.scale_m = row->width_m;
        m.roughness = 0.7f;
        return;
    }
    // Below the step there is room for curtain rods, and no corner of the room cuts it.
    const bool high = std::all_of(plan.openings.begin(), plan.openings.end(),
                                  [&](const Opening& o) { return o.y1 < plan.height - kTrayStep - 0.2f; });
    plan.tray = flat && high && !wet && plan.blocks.empty() && plan.width > 2.8f && tray < row->tray;
    // Who speaks of lamps in the ceiling, this way or that, has those.
    if (!speaks_of("recessed_lights") && !speaks_of("ceiling_lamp"))
        plan.recessed_lights = flat && plan.height < 3.15f && spots < (wet ? std::max(0.5f, row->spots) : row->spots);
}

}  // namespace fastscene
