#include "fastscene/rooms/plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/prints.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {
namespace {

constexpr float kSmallSill = 1.25f;  // metres, of small windows: nobody looks in
constexpr float kLowCeiling = 2.25f, kHighCeiling = 3.2f, kNarrowest = 1.9f;
constexpr float kThreshold = 0.05f, kLintel = 0.14f;  // below and above a window from floor to ceiling

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

float free_margin(float length, float wanted) { return std::max(0.25f, (length - wanted) / 2); }

// The end of a door that stands at the left of its wall, with its casing and a hand of wall.
constexpr float kDoorWidth = 0.88f, kDoorMargin = 0.28f, kClearOfDoor = kDoorMargin + kDoorWidth + 0.3f;

// What is asked to stand at windows shapes them: low things fit below a sill that is high enough, a picture hangs above
// a window that ends low enough, and between two windows there must be wall.
struct AtWindows {
    bool below = false, above = false, between = false;
    float beside = 0;  // metres of wall that what stands on both sides of one takes at each
};
bool is_small_or_hung(std::string_view kind) {
    return furnishing::is_small(kind) || has_role(kind, Role::beside_window);
}
AtWindows at_windows(const PromptSpec& spec) {
    AtWindows at;
    for (const PromptObject& o : spec.objects) {
        if (o.forbidden || o.relation_to != "window" || o.kind == "curtain" || o.kind == "rug") continue;
        at.below = at.below || o.relation == "under" || o.relation == "in front of" || o.relation == "next to";
        at.above = at.above || o.relation == "above";
        if (o.relation == "on both sides of" && !is_small_or_hung(o.kind))
            at.beside = std::max(at.beside, o.kind == "bed" ? 1.95f : has_role(o.kind, Role::bed) ? 1.25f : 1.f);
        at.between = at.between || (o.relation == "between" && o.relation_and == "window");
    }
    return at;
}

// Two windows in one wall with a piece of wall between them.
bool add_window_pair(const PromptSpec& spec, Plan& plan, const PromptObject* wish, Random& rng) {
    constexpr float kBetween = 1.35f, kBeside = 0.35f;
    const int first = rng.chance(0.5f) ? 1 : 3;
    for (const int w : {first, 4 - first, 0}) {
        const auto [low, high] = plan.free_span(w, 2.1f);
        const float wide = std::min(1.3f, (high - low - kBetween) / 2 - kBeside);
        if (wide < 0.6f) continue;
        for (const float middle : {(low + high - kBetween - wide) / 2, (low + high + kBetween + wide) / 2}) {
            Opening window;
            window.wall = w;
            window.u0 = middle - wide / 2, window.u1 = middle + wide / 2;
            window.y0 = room_type(spec.room).windows.size == WindowSize::small ? kSmallSill : 0.9f;
            window.y1 = std::min(plan.height - 0.25f, 2.2f);
            window.requested = wish != nullptr;
            plan.openings.push_back(window);
        }
        return true;
    }
    return false;
}

// One after the other along whole walls: a church, a classroom, a shop's front.
void add_regular_windows(const RoomWindows& like, Plan& plan) {
    constexpr float kLintelAbove = 0.2f, kCorner = 0.45f, kNarrowestPane = 0.4f;
    for (const int wall : like.walls) {
        const auto [low, high] = plan.free_span(wall, 2.1f);
        const float from = wall == 2 ? low + kClearOfDoor : low + kCorner, to = high - kCorner, length = to - from;
        const int count = std::max(1, static_cast<int>((length + like.every_m - like.width_m) / like.every_m));
        const float wide = std::min(like.width_m, length / static_cast<float>(count) - 0.1f);
        if (wide < kNarrowestPane) continue;
        for (int i = 0; i < count; ++i) {
            Opening window;
            window.wall = wall;
            const float middle = from + length * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
            window.u0 = middle - wide / 2, window.u1 = middle + wide / 2;
            window.y1 = std::min(plan.height - kLintelAbove, like.head_m);
            window.y0 = std::min(like.sill_m, window.y1 - 0.4f);
            if (like.arched) window.shape = Opening::Shape::arched;
            if (like.round) {  // hung from its head
                window.shape = Opening::Shape::round;
                window.y0 = window.y1 - wide;
            }
            plan.openings.push_back(window);
        }
    }
}

void add_windows(PromptSpec& spec, Plan& plan, Random& rng) {
    const PromptObject* wish = wish_for(spec, "window");
    if (wish_for(spec, "window", true)) return;
    if (const RoomWindows& like = room_type(spec.room).windows; like.regular && !wish && !(plan.knee > 0))
        return add_regular_windows(like, plan);
    const AtWindows asked = at_windows(spec);
    const bool paired = asked.between && (!wish || wish->count <= 2) && !(plan.knee > 0);
    if (paired && add_window_pair(spec, plan, wish, rng)) {
        plan.bay = false;  // its recess is an alcove then
        return;
    }
    const RoomWindows& usually = room_type(spec.room).windows;
    const bool large = (wish && wish->size == "large") || usually.size == WindowSize::large || is_hall(spec) ||
                       spec.mood == "airy" || spec.light == "bright";
    const bool small = (wish && wish->size == "small") || usually.size == WindowSize::small;
    constexpr int kOfHalls = 3;
    int count = wish                                     ? std::clamp(wish->count, 1, 4)
                : usually.count > 0                      ? usually.count
                : is_hall(spec)                          ? kOfHalls
                : rng.chance(usually.second_probability) ? 2
                                                         : 1;
    const bool opens = !spec.next_room.empty() || wish_for(spec, "doorway");
    if (opens && (!wish || !wish->counted)) count = std::min(count, 2);  // a wall is left for the doorway
    // Blinds and shutters are square, and so are their windows.
    const bool blinds = std::any_of(spec.objects.begin(), spec.objects.end(),
                                    [](const PromptObject& o) { return !o.forbidden && furnishing::is_blind(o.kind); });
    if (blinds && shape_of(wish) != Opening::Shape::square)
        spec.assumed.push_back("shape of the " + wish->words + ": square, as its blinds are");
    // The first window faces the visitor or stands to his right: there it lights what he looks at.
    const bool right = rng.chance(0.5f);
    const int first = usually.first_on_far_wall || plan.bay || plan.knee > 0 ? 0
                      : right                                                ? 1
                                                                             : 3,
              second = right ? 1 : 3;
    const int order[4] = {first, first == 0 ? second : 0, first == 0 ? 4 - second : 4 - first, 2};
    if (plan.knee > 0 && !wish) count = 1;
    for (int i = 4; wish && i < wish->count; ++i) spec.not_placed.push_back(wish->words + ": a room has at most four");
    for (int i = 0; i < count; ++i) {
        Opening window;
        window.wall = order[i];
        // On the free part of the wall; below a slope there is none.
        const auto [low, high] = plan.free_span(window.wall, 2.1f);
        const float length = high - low;
        if (length < 1.1f) {
            if (wish) spec.not_placed.push_back(wish->words + ": no free wall for it");
            continue;
        }
        const bool bay = plan.bay && window.wall == 0;
        const float margin = wants_corners(spec) ? 2 * kCornerMargin : 0.6f;
        const float usual = bay ? length - 0.3f
                                : std::min(std::max(0.6f, length - margin), large   ? rng.uniform(2.2f, 3.0f)
                                                                            : small ? rng.uniform(0.7f, 0.9f)
                                                                                    : rng.uniform(1.3f, 1.8f));
        window.y0 = std::max(bay ? 0.5f : large ? 0.4f : small ? kSmallSill : 0.85f, usually.least_sill_m);
        if (asked.below) window.y0 = std::max(window.y0, 0.9f);
        window.y1 = std::min(plan.height - (asked.above ? 0.7f : 0.25f), large ? 2.45f : 2.2f);
        if (wish && wish->pattern == kFullHeight && !bay) window.y0 = kThreshold, window.y1 = plan.height - kLintel;
        window.shape = bay || blinds ? Opening::Shape::square : shape_of(wish);
        float width = usual;
        if (asked.beside > 0 && !bay) width = std::clamp(length - 2 * asked.beside, 0.7f, usual);
        if (window.shape == Opening::Shape::arched) {  // upright, up to the ceiling
            width = std::min(usual, large ? 1.5f : small ? 0.7f : 1.2f);
            window.y1 = std::min(plan.height - (asked.above ? 0.7f : 0.22f), large ? 2.7f : 2.4f);
        } else if (window.shape ==
                   Opening::Shape::round) {  // a porthole at the height of the eyes, a larger one about there
            constexpr float kEyes = 1.55f;
            width = std::min(usual, wish->words.starts_with("porthole") ? (large ? 0.75f : 0.6f)
                                    : large                             ? 1.5f
                                    : small                             ? 0.7f
                                                                        : 1.05f);
            window.y0 = std::max(window.y0 < 1.f ? 0.5f : window.y0 - 0.2f, kEyes - width / 2),
            window.y1 = window.y0 + width;
        }
        const float slack = wants_corners(spec) || asked.beside > 0 ? 0.f : free_margin(length, width) - 0.25f;
        window.u0 = low + (bay ? 0.15f : free_margin(length, width) + slack * rng.uniform(-0.5f, 0.5f));
        window.u1 = window.u0 + width;
        if (window.wall == 2) {  // beside the door
            window.u1 = high - 0.3f;
            if (window.shape == Opening::Shape::round) window.shape = Opening::Shape::square;  // what is left is narrow
            window.u0 = std::max(std::max(low, 0.f) + kClearOfDoor, window.u1 - width);
            if (!(window.u1 - window.u0 >= 0.5f)) {
                if (wish) spec.not_placed.push_back(wish->words + ": no free wall for the fourth");
                continue;
            }
        }
        window.requested = wish != nullptr;
        plan.openings.push_back(window);
    }
}

void add_door(PromptSpec& spec, Plan& plan, Random& rng) {
    if (wish_for(spec, "door", true)) return;
    Opening door;
    door.kind = Opening::Kind::door;
    door.wall = 2;
    const PromptObject* wish = wish_for(spec, "door");
    door.requested = wish != nullptr;
    const auto [low, high] = plan.free_span(2, 2.1f);
    for (int i = 1; wish && i < wish->count; ++i) spec.not_placed.push_back(wish->words + ": a room has one");
    const bool shared = std::any_of(plan.openings.begin(), plan.openings.end(),
                                    [](const Opening& o) { return o.wall == 2; });
    const float margin = wants_corners(spec) && !shared
                             ? std::clamp((high - low - kDoorWidth) / 2, kDoorMargin, kCornerMargin)
                             : kDoorMargin;
    door.u0 = rng.chance(0.5f) || shared ? low + margin : high - margin - kDoorWidth;
    if (room_type(spec.room).middle_door && !shared) door.u0 = (low + high - kDoorWidth) / 2;
    door.u1 = door.u0 + kDoorWidth;
    door.y1 = 2.06f;
    if (shape_of(wish) != Opening::Shape::square)
        door.shape = Opening::Shape::arched, door.y1 = std::min(plan.height - 0.2f, 2.2f);
    plan.openings.push_back(door);
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
    add_windows(spec, plan, rng);
    add_door(spec, plan, rng);
    choose_ceiling(spec, plan);
    plan.neon = spec.light == "neon";
    if (!spec.light_color.empty()) plan.neon_color = color_named(spec.light_color);
    open_plan(spec, plan, rng);
    return plan;
}

}  // namespace fastscene
