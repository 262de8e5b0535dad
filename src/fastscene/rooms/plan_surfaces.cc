// What walls and floors are made of before the prompt's own wishes: no two rooms of a style are painted alike, and wet rooms are tiled.
#include <algorithm>
#include <array>

#include "fastscene/rooms/plan_parts.h"

namespace fastscene {
namespace {

// Paints that go with a style; the first is its own.
struct Paints {
    std::string_view style;
    std::array<const char*, 5> colors;
};
constexpr Paints kPaints[] = {
    {"modern", {"white", "white", "light gray", "greige", "off white"}},       {"scandinavian", {"white", "white", "light sage", "light duck egg", "linen"}},
    {"japandi", {"greige", "oatmeal", "linen", "light clay", "off white"}},    {"industrial", {"ash", "off white", "stone", "gray", "ash"}},
    {"classic", {"ivory", "light sage", "light sky", "champagne", "ivory"}},   {"boho", {"cream", "light terracotta", "cream", "light dusty pink", "sand"}},
    {"rustic", {"cream", "cream", "light olive", "linen", "wheat"}},           {"mid-century", {"off white", "light mustard", "off white", "light teal", "cream"}},
    {"mediterranean", {"ivory", "white", "sand", "light terracotta", "cream"}}, {"art deco", {"champagne", "blush", "champagne", "light emerald", "ivory"}},
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
            if (const auto color = color_named(paints.colors[static_cast<std::size_t>(dice.index(static_cast<int>(paints.colors.size())))]))
                plan.style.wall.color_a = plan.style.wall.color_b = plan.style.wall.color_c = *color;
}

void tile_wet_room(Plan& plan, Random& dice) {
    for (const Tiles& tiles : kTiles) {
        if (plan.style.name != tiles.style) continue;
        cover(plan.style.accent_wall, tiles.wall, tiles.color, tiles.grout, tiles.size_m);
        plan.accent = true;
        // All around, or one wall; dark tiles all around make a cave.
        if (luminance(plan.style.accent_wall.color_a) > 0.25f && dice.chance(0.5f)) plan.style.wall = plan.style.accent_wall;
        cover(plan.style.floor, tiles.floor, tiles.floor_a, tiles.floor_b, tiles.floor_m);
    }
}

}  // namespace fastscene
