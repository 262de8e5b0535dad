// The windows and the door of a room.
#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {
namespace {

constexpr float kSmallSill = 1.25f;                   // metres, of small windows: nobody looks in
constexpr float kThreshold = 0.05f, kLintel = 0.14f;  // below and above a window from floor to ceiling

float free_margin(float length, float wanted) { return std::max(0.25f, (length - wanted) / 2); }

constexpr float kDoorMargin = 0.28f;  // from a door to the corner of the room: its casing and a hand of wall
// Where a window may begin beside a door that stands at the left of its wall.
float clear_of_door(const Plan& plan) { return kDoorMargin + plan.door.width_m + 0.3f; }

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
            window.y1 = std::min(plan.wall_top() - 0.25f, 2.2f);
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
    const auto add = [&](int wall, float from, float to) {
        const float length = to - from;
        const int count = std::max(1, static_cast<int>((length + like.every_m - like.width_m) / like.every_m));
        const float wide = std::min(like.width_m, length / static_cast<float>(count) - 0.1f);
        if (wide < kNarrowestPane) return;
        for (int i = 0; i < count; ++i) {
            Opening window;
            window.wall = wall;
            if (plan.cabin) window.shape = Opening::Shape::rounded;
            const float middle = from + length * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
            window.u0 = middle - wide / 2, window.u1 = middle + wide / 2;
            window.y1 = std::min(plan.wall_top() - kLintelAbove, like.head_m);
            window.y0 = std::min(like.sill_m, window.y1 - 0.4f);
            if (like.arched) window.shape = Opening::Shape::arched;
            if (like.round) {  // hung from its head
                window.shape = Opening::Shape::round;
                window.y0 = window.y1 - wide;
            }
            plan.openings.push_back(window);
        }
    };
    for (const int wall : like.walls) {
        const auto [low, high] = plan.free_span(wall, 2.1f);
        if (!plan.cabin) {
            add(wall, wall == 2 ? low + clear_of_door(plan) : low + kCorner, high - kCorner);
            continue;
        }
        // Between what is glazed already, with posts beside it.
        constexpr float kPost = 0.14f;
        std::vector<std::pair<float, float>> taken{{high, high}};
        for (const Opening& o : plan.openings)
            if (o.wall == wall) taken.push_back({o.u0, o.u1});
        std::sort(taken.begin(), taken.end());
        float from = low;
        for (const auto& [u0, u1] : taken) {
            if (u0 - from > kPost) add(wall, from + kPost, u0 - kPost);
            from = u1;
        }
    }
}

// The screen and the doors of a vehicle.
void add_glazed_parts(const RoomWindows& like, Plan& plan) {
    constexpr float kBeside = 0.1f, kAbove = 0.1f;
    for (const GlazedPart& part : like.glazed_parts) {
        const float length = plan.wall(part.wall).length,
                    wide = std::min(part.width_m > 0 ? part.width_m : length, length - 2 * kBeside);
        for (const float place : part.places) {
            // u runs from the right end as seen from inside: on wall 1 that is the far one.
            const float middle = std::clamp(length * (part.wall == 1 ? place : 1 - place), wide / 2 + kBeside,
                                            length - wide / 2 - kBeside);
            Opening o;
            o.wall = part.wall;
            o.glazing = part.glazing;
            if (!is_doors(part.glazing)) o.shape = Opening::Shape::rounded;
            o.u0 = middle - wide / 2, o.u1 = middle + wide / 2;
            o.y0 = part.sill_m, o.y1 = std::min(part.head_m, plan.wall_top() - kAbove);
            plan.openings.push_back(o);
        }
    }
}

// Regular windows in the form that was asked for.
RoomWindows as_asked(RoomWindows like, const PromptObject& wish, const Plan& plan) {
    constexpr float kLarger = 1.3f, kSmaller = 0.7f, kLeastWall = 0.5f;  // metres of wall between two of them
    const Opening::Shape shape = shape_of(&wish);
    if (shape != Opening::Shape::square) like.arched = like.round = false;
    if (shape == Opening::Shape::arched) like.arched = true;
    if (shape == Opening::Shape::round) like.round = true;
    if (wish.size == "large") like.width_m *= kLarger, like.head_m += 0.3f, like.sill_m *= kSmaller;
    if (wish.size == "small") like.width_m *= kSmaller;
    if (wish.pattern == kFullHeight) like.sill_m = kThreshold, like.head_m = plan.wall_top() - kLintel;
    like.width_m = std::min(like.width_m, like.every_m - kLeastWall);
    return like;
}

// So many of the windows at most: the last ones go.
void keep_windows(Plan& plan, int count) {
    auto& all = plan.openings;
    const auto is_window = [](const Opening& o) { return o.kind == Opening::Kind::window; };
    while (std::count_if(all.begin(), all.end(), is_window) > count) {
        const auto last = std::find_if(all.rbegin(), all.rend(), is_window);
        all.erase(std::next(last).base());
    }
}

}  // namespace

void add_windows(PromptSpec& spec, Plan& plan, Random& rng) {
    const PromptObject* wish = wish_for(spec, "window");
    if (wish_for(spec, "window", true)) return;
    const bool anywhere = !wish || plan.cabin || wish->relation.empty();  // no wall was said
    if (RoomWindows like = room_type(spec.room).windows; like.regular && anywhere && !(plan.knee > 0)) {
        if (wish && !plan.cabin) like = as_asked(like, *wish, plan);
        if (!like.walls.empty() || !wish) {
            add_glazed_parts(like, plan);
            add_regular_windows(like, plan);
            if (wish && wish->counted && !plan.cabin) keep_windows(plan, wish->count);
            for (Opening& o : plan.openings) o.requested = wish != nullptr;
            return;
        }
    }
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
        window.y1 = std::min(plan.wall_top() - (asked.above ? 0.7f : 0.25f), large ? 2.45f : 2.2f);
        if (wish && wish->pattern == kFullHeight && !bay) window.y0 = kThreshold, window.y1 = plan.wall_top() - kLintel;
        window.shape = bay || blinds ? Opening::Shape::square : shape_of(wish);
        float width = usual;
        if (asked.beside > 0 && !bay) width = std::clamp(length - 2 * asked.beside, 0.7f, usual);
        if (window.shape == Opening::Shape::arched) {  // upright, up to the ceiling
            width = std::min(usual, large ? 1.5f : small ? 0.7f : 1.2f);
            window.y1 = std::min(plan.wall_top() - (asked.above ? 0.7f : 0.22f), large ? 2.7f : 2.4f);
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
            window.u0 = std::max(std::max(low, 0.f) + clear_of_door(plan), window.u1 - width);
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
    const RoomDoor& like = plan.door;
    if (wish_for(spec, "door", true) || like.form == DoorForm::none) return;
    Opening door;
    door.kind = Opening::Kind::door;
    door.wall = 2;
    const PromptObject* wish = wish_for(spec, "door");
    door.requested = wish != nullptr;
    const auto [low, high] = plan.free_span(2, 2.1f);
    for (int i = 1; wish && i < wish->count; ++i) spec.not_placed.push_back(wish->words + ": a room has one");
    const bool shared = std::any_of(plan.openings.begin(), plan.openings.end(),
                                    [](const Opening& o) { return o.wall == 2; });
    const float wide = like.width_m < high - low - 2 * kDoorMargin ? like.width_m : RoomDoor{}.width_m;
    const float margin = wants_corners(spec) && !shared
                             ? std::clamp((high - low - wide) / 2, kDoorMargin, kCornerMargin)
                             : kDoorMargin;
    door.u0 = rng.chance(0.5f) || shared ? low + margin : high - margin - wide;
    const bool cut = has_cut_corners(plan);
    if ((like.middle || cut) && !shared) door.u0 = (low + high - wide) / 2;
    door.u1 = door.u0 + wide;
    constexpr float kWallAbove = 0.2f, kArchedHeight = 2.2f;
    const bool asked = shape_of(wish) != Opening::Shape::square;
    door.y1 = like.height_m > RoomDoor{}.height_m ? std::min(plan.wall_top() - kWallAbove, like.height_m)
                                                  : like.height_m;
    if (like.arched || asked) door.shape = Opening::Shape::arched;
    if (asked) door.y1 = std::min(plan.wall_top() - kWallAbove, std::max(kArchedHeight, like.height_m));
    move_door(plan, door);
    plan.openings.push_back(door);
}

}  // namespace fastscene
