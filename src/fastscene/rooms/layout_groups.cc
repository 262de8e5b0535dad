// Groups of pieces that several types of rooms share.
#include "fastscene/rooms/layout_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/recipe.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene::furnishing {
namespace {

// Metres from a desk below a bed to who sits at it: clear of the ladder.
constexpr float kBeforeLoft = kInsideBed + 0.03f;

// A long side at the wall, the floor before it free; a desk or a seat below one that is high enough.
void sleeping_place_along(Placement& p, const std::string& kind) {
    const auto found = p.main_at_wall(kind, {.center_pull = 0.1f, .window_pull = -0.8f});
    if (!found) return;
    const int bed = *found;
    p.rug(bed, 0.85f, 1.9f, 1.4f, p.size(bed).z / 2 + 0.8f);
    if (kind == "daybed") {
        p.above(bed, "picture", 0.75f);
        p.beside(bed, "side_table", 0.6f, p.chance(0.5f) ? 1 : -1, 0.06f,
                 [&p](int table) { p.top(table, "table_lamp", 0.9f); });
    }
}

void sleeping_place(Placement& p, const std::string& kind) {
    if (has_role(kind, Role::along_wall)) return sleeping_place_along(p, kind);
    // Where there is a wall with room for a nightstand on both sides, clear of the door, that one.
    constexpr float kForNightstand = 0.56f;
    const auto found = p.main_at_wall(
        kind, {.center_pull = 1.2f, .window_pull = -0.8f, .spare = {.left = kForNightstand, .right = kForNightstand}});
    if (!found) return;
    const int bed = *found;
    for (const int side : {-1, 1})
        p.beside(bed, "nightstand", side < 0 ? 1.f : 0.75f, side, 0.08f, [=, &p](int stand) {
            p.top(stand, "table_lamp", 0.9f);
            p.later([=, &p] {
                std::string_view thing = p.chance(0.5f) ? "book_stack" : "vase";
                if (room_type(p.layout().spec().room).for_children) thing = for_a_child(thing);
                if (p.chance(p.clutter())) p.top(stand, std::string(thing), 1);
            });
        });
    p.above(bed, "picture", 0.75f);
    p.rug(bed, 0.75f, p.size(bed).x + 1.1f, 1.9f, 0.75f);
    p.before(bed, "bench", 0.35f, 0.06f, false);
    p.before(bed, "ottoman", 0, 0.1f, false);
}

std::string easy_chair(Placement& p) {
    for (const std::string& kind : kinds_with(Role::easy_chair))
        if (p.wishes().has(kind)) return kind;
    return "armchair";
}

void reading_corner(Placement& p, float probability) {
    const Layout::WallWish at_wall{.window_pull = 1.2f};
    p.put(
        easy_chair(p), probability,
        [=, &p](const PieceRequest& r, const PromptObject& o) {
            if (o.relation.empty() || o.relation == "in the corner")
                if (const auto i = p.layout().angled_towards({0, 0}, r, o)) return i;
            return p.layout().against_wall(r, at_wall, o);
        },
        [&p](int chair) {
            const int side = p.chance(0.5f) ? 1 : -1;
            p.beside(chair, "side_table", 0.6f, side, 0.05f,
                     [&p](int table) { p.top(table, p.chance(0.5f) ? "book_stack" : "vase", 0.9f); });
            p.beside(chair, "floor_lamp", 0.5f, -side, 0.05f);
        });
}

// A desk with its chair and lamp; without a wish, with this probability.
void working_place(Placement& p, float probability) {
    const auto furnish_desk = [&p](int desk) {
        const bool plain = p.wishes().has("chair") && !p.wishes().has("office_chair");
        for (int left = p.wishes().count("monitor"); left > 0; --left)
            p.put("monitor", 0, [=, &p](const PieceRequest& r, const PromptObject& o) {
                return next_screen(p.layout(), desk, r, o);
            });
        const bool sheltered = p.at(desk).below >= 0;  // by a bed: one sits before that
        p.before(desk, plain ? "chair" : "office_chair", 1, sheltered ? kBeforeLoft : plain ? 0.05f : -0.2f, true);
        p.top(desk, "table_lamp", 0.85f);
    };
    const auto place = [&p](const PieceRequest& r, const PromptObject& o) -> std::optional<int> {
        if (const auto bed = p.layout().find("loft_bed"); bed && o.relation.empty())
            if (const auto desk = p.layout().below(*bed, r, o)) return desk;
        return p.at_wall(r, {.center_pull = 0.5f, .window_pull = 0.8f}, o);
    };
    if (probability >= 1 || p.wishes().asked("desk") || p.wishes().asked("monitor")) {
        if (const auto desk = p.main("desk", place)) furnish_desk(*desk);
        return;
    }
    p.later([=, &p] {
        // Who sleeps above a free space works there.
        if (!p.layout().find("desk") && p.chance(p.layout().find("loft_bed") ? 1.f : probability))
            p.put("desk", 1, place, furnish_desk);
    });
}

// What the sofa looks at: a fire or a screen.
void focus_of(Placement& p, int sofa) {
    const int opposite = p.wall_opposite(sofa);
    const Layout::WallWish for_fire{.wall = opposite, .center_pull = 1.5f, .clear_of_windows = true};
    const Layout::WallWish for_screen{
        .wall = opposite, .center_pull = 1.5f, .window_pull = -2, .clear_of_windows = true};
    const auto above_fire = [&p](int fire) { p.above(fire, p.chance(0.5f) ? "mirror" : "picture", 0.7f); };
    if (p.wishes().asked("fireplace")) {
        if (const auto fire = p.main_at_wall("fireplace", for_fire)) above_fire(*fire);
        return;
    }
    const auto screen = [=, &p](int stand) {
        p.put("tv", 0.9f, [=, &p](const PieceRequest& r, const PromptObject& o) {
            if (is_hung_screen(o))
                if (const auto i = screen_above(p.layout(), stand, r, o)) return i;
            if (const auto i = p.layout().on_top(stand, r, o)) return i;
            return p.layout().on_wall(r, stand, o);
        });
        p.later([=, &p] {
            if (p.chance(p.clutter())) p.top(stand, "book_stack", 0.6f);
        });
    };
    if (p.wishes().has("tv")) {
        if (const auto stand = p.main_at_wall("tv_stand", for_screen)) screen(*stand);
        return;
    }
    p.later([=, &p] {
        if (p.wishes().asked("tv")) return;
        if (p.chance(0.18f)) p.wall("fireplace", 1, for_fire, above_fire);
        else if (!p.wishes().forbids("tv")) p.wall("tv_stand", 0.9f, for_screen, screen);
        // No seat looks at a bare wall.
        if (!p.layout().find("tv_stand") && !p.layout().find("fireplace"))
            p.wall("sideboard", 0.9f, {.wall = opposite, .center_pull = 1.2f, .window_pull = -0.5f},
                   [&p](int side) { p.above(side, "picture", 0.9f); });
    });
}

void seating_group(Placement& p) {
    const bool small = !p.wishes().asked("sofa") && p.wishes().asked("loveseat");
    const auto found = p.main_at_wall(small ? "loveseat" : "sofa", {.center_pull = 1.f, .window_pull = -0.3f});
    if (!found) return;
    const int sofa = *found;
    p.rug(sofa, 0.9f, p.size(sofa).x + 0.5f, 1.9f, p.size(sofa).z / 2 + 0.55f);
    p.before(sofa, "coffee_table", 0.95f, 0.42f, false, [&p](int table) {
        p.top(table, "book_stack", 0.7f);
        p.top(table, p.chance(0.5f) ? "vase" : "bowl", 0.7f);
        p.top(table, "candle", p.clutter() * 0.6f);
        p.put("ottoman", 0.3f, [=, &p](const PieceRequest& r, const PromptObject& o) {
            return p.layout().beside(table, r, p.chance(0.5f) ? 1 : -1, 0.2f, o);
        });
    });
    p.above(sofa, "picture", 0.85f);
    const int side = p.chance(0.5f) ? 1 : -1;
    p.beside(sofa, "side_table", 0.6f, side, 0.06f, [&p](int end) { p.top(end, "table_lamp", 0.8f); });
    p.beside(sofa, "floor_lamp", 0.65f, -side, 0.06f);
    focus_of(p, sofa);
    const Vec2f focus = p.front_point(sofa, 0.6f);
    const auto chair = [=, &p](const PieceRequest& r, const PromptObject& o) {
        // High and closed behind, it would hide what is behind it.
        if (r.kind == "hanging_chair")
            if (const auto index = p.layout().against_wall(r, {.center_pull = 0, .window_pull = -0.3f, .corner = true},
                                                           o))
                return index;
        if (const auto index = p.layout().angled_towards(focus, r, o)) return index;
        return p.layout().against_wall(r, {}, o);
    };
    const int chairs = p.wishes().count("armchair");
    for (const std::string& kind : kinds_with(Role::easy_chair))
        for (int i = p.wishes().count(kind); i > 0; --i) p.put(kind, 0, chair);
    for (int i = 0; i < (chairs > 0 ? chairs : 2); ++i) p.put("armchair", i == 0 ? 0.8f : 0.5f, chair);
    if (!small && p.wishes().has("loveseat")) p.wall("loveseat", 1);
}

// A mat, a plate and cutlery before every chair, where the table is laid: at the ends there is not always room, but
// nobody lays for one where five may sit.
void lay_table(Placement& p, const std::string& what, int table) {
    constexpr float kAtTable = 0.45f, kFromEdge = 0.2f;  // metres: of a chair from the top, of a plate inside its edge
    Layout& l = p.layout();
    const PieceRequest setting = l.request(what);
    const std::size_t count = l.placed().size(), before = l.mark();
    const Footprint top = footprint_of(p.at(table));
    int chairs = 0, laid = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Placed chair = l.placed()[i];
        const float far = distance_to(top, flat(chair.position));
        if (!is_seat(chair.piece.kind) || far > kAtTable) continue;
        ++chairs;
        const Vec2f at = flat(chair.position + front_of(chair.yaw) * (far + kFromEdge));
        laid += l.on_top_at(table, setting, at, chair.yaw + kPi).has_value();
    }
    if (2 * laid < chairs) l.undo(before);
}

void eating_place(Placement& p, int seats) {
    const char* kind = !p.wishes().asked("dining_table") && p.wishes().asked("dining_table_round")
                           ? "dining_table_round"
                           : "dining_table";
    const auto found = p.main(kind, [&p](const PieceRequest& r, const PromptObject& o) {
        auto i = p.layout().free_standing(r, o, p.spare_for(r.kind));
        // One that was asked for and finds no room is smaller.
        for (float size = 0.85f; !i && !o.kind.empty() && size > 0.6f; size -= 0.15f) {
            PieceRequest smaller = r;
            const Vec3f usual = make_piece(r).size_m;
            smaller.size_factor = 1.f, smaller.size_m = {usual.x * size, 0, usual.z * size};
            i = p.layout().free_standing(smaller, o, p.spare_for(r.kind));
        }
        return i;
    });
    if (!found) return;
    const int table = *found;
    const bool has_chairs = std::any_of(
        p.layout().placed().begin(), p.layout().placed().end(),
        [&](const Placed& other) { return other.with == table && other.piece.kind == "chair"; });
    p.seats_around(table, "chair", has_chairs ? 0 : seats, 1);
    p.later([=, &p] {
        constexpr float kLaid = 0.6f;
        for (const std::string& what : kinds_with(Role::before_seats))
            if (!is_settled(p.layout().spec(), what) && p.chance(kLaid * (0.35f + 1.3f * p.clutter())))
                lay_table(p, what, table);
    });
    const bool flowers = p.wishes().asked("bouquet");  // they stand there
    p.top(table, !flowers && p.chance(0.6f) ? "vase" : "bowl", 0.9f);
    p.later([=, &p] {
        if (p.chance(p.clutter())) p.top(table, "candle", 0.7f);
    });
    const auto over_it = [=, &p](const PieceRequest& r, const PromptObject& o) {
        const auto i = p.layout().hanging(r, flat(p.at(table).position), o);
        if (i) p.layout().join(*i, table);
        return i;
    };
    const char* over = "pendant_lamp";
    for (const char* lamp : {"chandelier", "bulb_pendant", "paper_lantern", "track_light", "ceiling_fan"})
        if (p.wishes().asked(lamp)) over = lamp;
    p.put(over, std::string_view(over) == "pendant_lamp" ? 0.8f : 0.f, over_it);
    p.rug(table, 0.5f, p.size(table).x + 1.3f, p.size(table).z + 1.3f, 0);
}

// Units, with room at an end for the first of what follows.
void units_along_wall(Placement& p, const RecipeStep& step) {
    constexpr float kJoint = 0.02f;
    float beside = 0;
    if (!step.then.empty() && !p.wishes().forbids(step.then[0].thing))
        beside = make_piece(p.layout().request(step.then[0].thing)).size_m.x + kJoint;
    const auto units = p.main("kitchen_counter", [&](const PieceRequest& r, const PromptObject& o) {
        return kitchen_units(p.layout(), r, o, beside);
    });
    if (units) follow_steps(step.then, p, *units);
}

}  // namespace

std::span<const StepKind> group_kinds() {
    static const std::array<StepKind, 6> all{{
        {"sleeping_place",
         {"thing", "first_asked"},
         false,
         {},
         [](Placement& p, const RecipeStep& step, int) { sleeping_place(p, thing_of(step, p)); }},
        {"seating_group",
         {},
         false,
         {"sofa", "loveseat", "coffee_table"},
         [](Placement& p, const RecipeStep&, int) { seating_group(p); }},
        {"eating_place",
         {"seats"},
         false,
         {"dining_table", "dining_table_round"},
         [](Placement& p, const RecipeStep& step, int) { eating_place(p, step.seats); }},
        {"working_place",
         {"probability"},
         false,
         {"desk", "monitor"},
         [](Placement& p, const RecipeStep& step, int) { working_place(p, step.probability); }},
        {"reading_corner",
         {"probability"},
         false,
         {"armchair"},
         [](Placement& p, const RecipeStep& step, int) { reading_corner(p, step.probability); }},
        {"kitchen_units",
         {"then"},
         false,
         {"kitchen_counter"},
         [](Placement& p, const RecipeStep& step, int) { units_along_wall(p, step); }},
    }};
    return all;
}

}  // namespace fastscene::furnishing
