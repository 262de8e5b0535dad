#include "fastscene/rooms/plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/prints.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {
namespace {

constexpr float kLowCeiling = 2.25f, kHighCeiling = 3.2f, kNarrowest = 1.9f;

// Words such as "oak" and "walnut" are woods before they are colors.
void apply_floor_wish(Material& m, PromptObject wish, std::span<const Vec3f> palette) {
    if (wish.material.empty() || wish.material == "wood")
        if (const auto wood = wish.color.empty() ? std::nullopt : material_named(wish.color);
            wood && wood->pattern == Pattern::wood)
            wish.material = wish.color;
    if (wish.material.empty() && wish.pattern.empty() && wish.color == "terracotta") wish.material = "tile";
    // A herringbone is laid of wood, ornaments are those of tiles, when nothing else is said.
    if (wish.material.empty() && is_one_of(wish.pattern, {"herringbone", "zigzag"})) wish.material = "wood";
    if (wish.material.empty() && is_print(wish.pattern) && !is_one_of(wish.pattern, {"checkered", "striped"}))
        wish.material = "tile";
    apply_wish(m, wish, true, palette);
    // Checkered without a word of color: black and white.
    if (wish.pattern == "checkered" && wish.color.empty() && wish.material != "wood")
        m.color_a = m.color_c = *color_named("off white"), m.color_b = *color_named("charcoal");
}

// Who asks for much gets a larger room: square metres of what is wished, beyond what the usual size has space for.
float room_for_wishes(const PromptSpec& spec) {
    float wanted = 0;
    for (const PromptObject& o : spec.objects)
        if (!o.forbidden) wanted += 1.2f * o.size_m.x * static_cast<float>(o.count);
    for (const PromptObject& o : spec.objects)
        if (const Thing* thing = find_thing(o.kind); thing && !o.forbidden)
            wanted += thing->floor_m2 * static_cast<float>(std::min(o.count, 12));
    constexpr float kUsual = 9.f, kGain = 0.022f, kMost = 1.28f;
    return std::clamp(1.f + kGain * (wanted - kUsual), 1.f, kMost);
}

}  // namespace

bool is_shell(std::string_view kind) { return has_role(kind, Role::shell); }

namespace {

// What no room of ours has yet is said so.
void report_unbuilt(PromptSpec& spec) {
    for (const PromptObject& wish : spec.objects)
        if (!wish.forbidden && has_role(wish.kind, Role::unbuilt))
            for (int i = 0; i < wish.count; ++i)
                spec.not_placed.push_back(wish.words + ": rooms are not built with one yet");
}

// "A bedroom in lavender and white": cloth, rug, curtains and small things are of these colors, too, or beside a
// neutral.
void dress_in(const std::vector<std::string>& names, Style& style) {
    std::vector<Vec3f> colors;
    for (const std::string& name : names)
        if (const auto color = color_named(name)) colors.push_back(*color);
    if (colors.empty()) return;
    const Vec3f first = colors.front(), second = colors.size() > 1 ? colors[1] : *color_named("ivory"),
                light{0.72f, 0.7f, 0.66f};
    const auto tint = [](Material& m, Vec3f color) {
        const float ratio = luminance(m.color_b) / std::max(0.02f, luminance(m.color_a));
        m.color_a = m.color_c = color;
        m.color_b = color * std::clamp(ratio, 0.6f, 1.2f);
    };
    tint(style.fabric2, first);
    tint(style.fabric, second);
    tint(style.curtain, lerp(first, light, 0.65f));
    // White on white shows nothing: in rooms of neutrals alone rugs, pictures and small things stay as the style has
    // them.
    const auto neutral = [](Vec3f c) { return std::max({c.x, c.y, c.z}) - std::min({c.x, c.y, c.z}) < 0.12f; };
    std::erase_if(colors, neutral);
    if (colors.empty()) return;
    style.rug.color_a = lerp(second, light, 0.35f);
    style.rug.color_b = colors.front();
    style.rug.color_c = lerp(colors.front(), light, 0.5f);
    // Every other small thing; the rest keeps the room from being a uniform.
    for (std::size_t i = 0; i < style.palette.size(); i += 2) style.palette[i] = colors[i / 2 % colors.size()];
}

// Years without anybody: paint comes off, dust takes the colors, metal rusts.
void leave_to_decay(Plan& plan) {
    constexpr Vec3f kDust{0.2f, 0.18f, 0.15f}, kRust{0.2f, 0.085f, 0.04f};
    Style& s = plan.style;
    for (Material* m : {&s.wall, &s.accent_wall, &s.ceiling}) print_on(*m, "peeling", PrintGround::paper, {}, {});
    for (Material* m : {&s.floor, &s.trim, &s.wood, &s.wood2, &s.fabric, &s.fabric2, &s.leather, &s.curtain, &s.rug}) {
        for (Vec3f* c : {&m->color_a, &m->color_b, &m->color_c}) *c = lerp(*c, kDust, 0.5f);
        m->roughness = std::max(m->roughness, 0.8f);
    }
    for (Material* m : {&s.metal, &s.tap}) {
        m->color_a = m->color_b = m->color_c = lerp(m->color_a, kRust, 0.75f);
        m->metal *= 0.3f, m->roughness = std::max(m->roughness, 0.75f);
    }
    for (Vec3f& c : s.palette) c = lerp(c, kDust, 0.6f);
    plan.tray = false;
}

// "Walnut and brass": the wood and the metal of whatever stands there.
void apply_accents(const std::vector<std::string>& accents, Style& style) {
    for (const std::string& name : accents)
        if (const auto m = material_named(name)) {
            if (m->metal > 0.5f) style.metal = *m;
            if (m->pattern == Pattern::wood) style.wood = style.wood2 = *m;
        }
}

// Some pieces are at home in one style: who names none, but a rocking chair, means no glass and chrome.
void suggest_style(PromptSpec& spec) {
    for (const PromptObject& o : spec.objects)
        if (const Thing* thing = find_thing(o.kind); thing && !thing->style.empty() && spec.style.empty() &&
                                                     !o.forbidden &&
                                                     !(o.kind == "cobweb" && spec.clutter == "abandoned")) {
            spec.style = thing->style;
            spec.assumed.push_back("style: " + spec.style + ", as the " + o.words);
        }
    if (spec.style.empty() && spec.clutter == "abandoned") {  // what was left decades ago is not of today
        const StyleMood mood = room_type(spec.room).high_ceiling ? StyleMood::abandoned_loft : StyleMood::abandoned;
        spec.style = styles_for(mood).front();
        spec.assumed.push_back("style: " + spec.style + ", as abandoned suggests");
    }
}

// "A pink bathroom", "a blue study": a color of no piece is that of a wall at least; tiles have it all around.
void paint_in(const std::string& name, bool wet, Plan& plan) {
    const auto color = color_named(name);
    if (!color) return;
    Material& m = plan.style.accent_wall;
    if (!wet) m = plan.style.wall;
    m.color_a = *color;
    if (m.pattern == Pattern::plaster) m.color_b = m.color_c = *color;
    plan.accent = true;
    if (wet && luminance(*color) > 0.12f) plan.style.wall = m;
}

// What is of the kind of room, whatever the style.
void take_surfaces(const RoomType& type, Plan& plan) {
    if (type.floor) plan.style.floor = *type.floor;
    if (type.wall) plan.style.wall = *type.wall;
    if (type.ceiling) plan.style.ceiling = *type.ceiling;
}

}  // namespace

Plan make_plan(PromptSpec& spec, Random& rng) {
    if (spec.room.empty()) {
        // What the furniture asks for says what room it is.
        // Where several rooms are meant, the first in the order of guesses.
        const RoomType* guess = nullptr;
        for (const PromptObject& o : spec.objects) {
            const Thing* thing = find_thing(o.kind);
            const RoomType* type = thing && !o.forbidden ? find_room_type(thing->room) : nullptr;
            if (type && type->guess_rank > 0 && (!guess || type->guess_rank < guess->guess_rank)) guess = type;
        }
        spec.room = (guess ? *guess : default_room_type()).name;
        spec.assumed.push_back("room: " + room_title(spec.room));
    }
    suggest_style(spec);
    if (spec.style.empty()) {
        const bool bright = spec.light == "bright" || spec.weather == "sunny" || spec.mood == "airy";
        std::vector<std::string> choice = styles_for(spec.mood == "cozy" ? StyleMood::cozy
                                                     : room_type(spec.room).for_children || spec.mood == "colorful"
                                                         ? StyleMood::children
                                                     : spec.light == "neon" ? StyleMood::neon
                                                     : !spec.colors.empty() ? StyleMood::colored
                                                     : bright               ? StyleMood::bright
                                                                            : StyleMood::usual);
        if (!room_type(spec.room).styles.empty()) choice = room_type(spec.room).styles;
        spec.style = choice[static_cast<std::size_t>(rng.index(static_cast<int>(choice.size())))];
        spec.assumed.push_back("style: " + spec.style);
    }
    Plan plan;
    plan.style = style_named(spec.style);
    const RoomType& type = room_type(spec.room);
    const float factor = spec.size == "large"   ? std::max(1.18f, room_for_wishes(spec))
                         : spec.size == "small" ? 0.88f
                                                : room_for_wishes(spec);
    plan.width = rng.uniform(type.width_low_m, type.width_high_m) * factor;
    plan.depth = rng.uniform(type.depth_low_m, type.depth_high_m) * factor;
    if (spec.size == "narrow") plan.width = std::max(kNarrowest, std::min(0.72f * plan.width, 0.7f * plan.depth));
    plan.height = is_hall(spec) ? std::max(3.2f, plan.style.ceiling_m) : plan.style.ceiling_m;
    if (type.height_low_m > 0) plan.height = rng.uniform(type.height_low_m, type.height_high_m);
    if (const PromptObject* ceiling = wish_for(spec, "ceiling"); ceiling && !ceiling->size.empty())
        plan.height = ceiling->size == "small" ? kLowCeiling : std::max(kHighCeiling, plan.height + 0.4f);
    take_measures(spec, plan);
    // What is asked to hang above a door needs wall there.
    for (const PromptObject& o : spec.objects)
        if (!o.forbidden && o.relation == "above" && (o.relation_to == "door" || o.relation_to == "doorway"))
            plan.height = std::max(plan.height, 2.75f);
    plan.beams = (plan.style.beams && type.beams) || wish_for(spec, "beams");
    plan.accent = type.accent_wall && rng.chance(0.6f);

    // Children and cheerful people paint a wall in a color they love.
    if (type.for_children || spec.mood == "colorful") {
        plan.accent = true;
        plan.style.accent_wall = plan.style.wall;
        plan.style.accent_wall.color_a = plan.style.accent_wall.color_b = plan.style.accent_wall.color_c = lerp(
            plan.style.palette[static_cast<std::size_t>(rng.index(3))], {0.8f, 0.8f, 0.78f}, 0.3f);
    }

    const bool wet = type.wet;
    choose_paint(spec, plan, rng);
    deepen_paint(spec, plan);
    if (wet) tile_wet_room(plan, rng);
    take_surfaces(type, plan);
    apply_accents(spec.accents, plan.style);
    cover_everything(spec.everything, plan);
    avoid_colors(spec);
    const auto stands_before = [](const PromptObject& wish) {
        return wish.kind == "wall" && !wish.forbidden && wish.relation == "behind" && !wish.relation_to.empty();
    };
    for (PromptObject& wish : spec.objects) {
        if (wish.forbidden) continue;
        if (wish.kind == "wall" && wish.words.starts_with("wallpaper") && wish.pattern.empty() &&
            wish.material.empty()) {
            wish.pattern = plan.style.wallpaper;
            spec.assumed.push_back("pattern of the " + wish.words + ": " + wish.pattern);
        }
        if (stands_before(wish)) continue;
        if (wish.kind == "wall") {
            // "a brick wall" is one wall; "white walls" are all.
            const bool one = wish.words == "wall" || wish.words == "accent wall";
            const bool accent = one && (wish.material == "brick" || wish.material == "wood" ||
                                        wish.material == "stone" || wish.words == "accent wall");
            if (!accent && wish.material.empty()) plan.accent = false;
            apply_wish(accent ? plan.style.accent_wall : plan.style.wall, wish, true, plan.style.palette);
            if (accent || wish.material == "brick") plan.accent = true;
            if (!accent && !wish.material.empty()) plan.style.accent_wall = plan.style.wall;
        }
        if (wish.kind == "floor") apply_floor_wish(plan.style.floor, wish, plan.style.palette);
        if (wish.kind == "fittings") apply_fittings(plan.style, wish);
        if (wish.kind == "ceiling") apply_wish(plan.style.ceiling, wish, true);
        if (wish.kind == "curtain" && !wish.color.empty()) apply_wish(plan.style.curtain, wish);
        // Tiles that belong to no noun are the bathroom's walls ("a bathroom with blue tiles").
    }
    // "Wallpaper behind the bed" is on that wall alone: which one it is, the layout decides.
    for (const PromptObject& wish : spec.objects)
        if (stands_before(wish)) {
            plan.style.accent_wall = plan.style.wall;
            apply_wish(plan.style.accent_wall, wish, true, plan.style.palette);
            plan.accent = true;
        }
    if (!spec.colors.empty() && spec.everything.color.empty()) {
        paint_in(spec.colors.front(), wet, plan);
        dress_in(spec.colors, plan.style);
    }
    if (spec.clutter == "abandoned") leave_to_decay(plan);
    if (spec.clutter == "renovation") {  // one wall is still raw
        plan.style.accent_wall = plan.style.wall;
        print_on(plan.style.accent_wall, "peeling", PrintGround::paper, {}, {});
        plan.accent = true;
    }
    plan.style.shelves = type.shelves;
    report_unbuilt(spec);
    shape_plan(spec, plan, rng);
    tell_measures(spec, plan);
    add_tiers(spec, plan);
    add_windows(spec, plan, rng);
    lift_windows(spec, plan);
    add_door(spec, plan, rng);
    choose_ceiling(spec, plan);
    plan.neon = spec.light == "neon";
    if (!spec.light_color.empty()) plan.neon_color = color_named(spec.light_color);
    open_plan(spec, plan, rng);
    return plan;
}

}  // namespace fastscene
