// The shape of rooms beyond a box: chimney breasts, the corner of an L, alcoves and bays, columns, slopes with
// skylights, coffers, panelling, and a doorway to a next room. Cut corners and vaults are in plan_vaults.cc.
#include <algorithm>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/room_type.h"

namespace fastscene {
namespace {

// Asked for: yes; asked not to: no; else by the rng. Drawn in any case, so that a wish changes nothing else.
bool decide(const PromptSpec& spec, std::string_view kind, float probability, Random& rng) {
    const bool drawn = rng.chance(probability);
    return !wish_for(spec, kind, true) && (wish_for(spec, kind) || drawn);
}

void add_breast(Plan& plan, Random& rng) {
    // Before the far wall, or at a side of long rooms.
    const float wide = rng.uniform(1.5f, 1.75f), deep = rng.uniform(0.32f, 0.42f), w = plan.width / 2,
                d = plan.depth / 2;
    const int side = rng.index(3);
    if (side == 0 || plan.depth < 4.4f)
        plan.blocks.push_back({Block::Kind::breast, {-wide / 2, d - deep}, {wide / 2, d}});
    else if (side == 1) plan.blocks.push_back({Block::Kind::breast, {w - deep, 0.2f - wide / 2}, {w, 0.2f + wide / 2}});
    else plan.blocks.push_back({Block::Kind::breast, {-w, 0.2f - wide / 2}, {-w + deep, 0.2f + wide / 2}});
}
void add_corner(Plan& plan, Random& rng) {
    if (!plan.measured) plan.width += 0.3f, plan.depth += 0.3f;
    const float x = plan.width * rng.uniform(0.24f, 0.33f), z = plan.depth * rng.uniform(0.2f, 0.3f),
                w = plan.width / 2, d = plan.depth / 2;
    if (rng.chance(0.5f)) plan.blocks.push_back({Block::Kind::corner, {w - x, d - z}, {w, d}});
    else plan.blocks.push_back({Block::Kind::corner, {-w, d - z}, {-w + x, d}});
}
// What is left of the far wall between two corners: a bay for a window, or a place for a bed, a desk, shelves.
void add_recess(Plan& plan, float wide, float deep) {
    if (!plan.measured) plan.depth += deep;
    const float w = plan.width / 2, d = plan.depth / 2;
    plan.blocks.push_back({Block::Kind::corner, {-w, d - deep}, {-wide / 2, d}});
    plan.blocks.push_back({Block::Kind::corner, {wide / 2, d - deep}, {w, d}});
}
void add_columns(Plan& plan, int count, Random& rng) {
    const float side = rng.uniform(0.22f, 0.3f),
                x = (rng.chance(0.5f) ? 1.f : -1.f) * (plan.width / 2 - rng.uniform(1.3f, 1.5f));
    for (int i = 0; i < count; ++i) {
        const float z = plan.depth * ((static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f) * 0.9f;
        plan.blocks.push_back({Block::Kind::column, {x - side / 2, z - side / 2}, {x + side / 2, z + side / 2}});
    }
}

// Who names a skylight wants a roof above: where nothing speaks against it, the ceiling slopes.
bool slopes_for_skylight(const PromptSpec& spec) {
    if (!wish_for(spec, "skylight") || wish_for(spec, "sloped_ceiling", true) || !spec.next_room.empty()) return false;
    return std::none_of(spec.objects.begin(), spec.objects.end(), [](const PromptObject& o) {
        return !o.forbidden && is_one_of(o.kind, {"bay_window", "alcove", "doorway", "column", "beams", "vault"});
    });
}

// Skylights in pairs over both slopes, or over the one that is not asked to stay closed.
void add_skylights(PromptSpec& spec, Plan& plan, Random& rng) {
    const PromptObject* wish = wish_for(spec, "skylight");
    if (wish_for(spec, "skylight", true)) return;
    const int wanted = wish ? std::min(wish->count, 4) : plan.knee > 0 ? 1 + rng.index(3) : 0;
    if (plan.oculus > 0) return wish ? report(spec, *wish, wish->count - 1, "a dome has one") : void();
    if (wish && !(plan.knee > 0)) return report(spec, *wish, wish->count, "only rooms with a sloped ceiling have them");
    if (wish) report(spec, *wish, std::max(0, wish->count - 4), "a roof has at most four");
    const float slope = std::hypot(plan.slope_run, plan.height - plan.knee), high = std::min(1.2f, slope - 0.7f),
                wide = 0.85f;
    const int first = rng.chance(0.5f) ? 1 : 3;
    for (int i = 0; i < wanted; ++i) {
        const int on_side = (wanted + 1 - i % 2) / 2, place = i / 2;  // how many this slope gets, and which this is
        const float z = plan.depth *
                        ((static_cast<float>(place) + 0.5f) / static_cast<float>(std::max(1, on_side)) - 0.5f) * 0.8f;
        const float s0 = 0.5f * (slope - high);
        plan.skylights.push_back({i % 2 == 0 ? first : 4 - first, z - wide / 2, z + wide / 2, s0, s0 + high});
    }
}

// What became of the words that ask for a second room.
void tell_next_room(PromptSpec& spec, const std::string& what) {
    for (PromptWord& word : spec.words)
        if (word.object < 0 && word.meaning.ends_with(" behind a doorway"))
            word.fate = PromptWord::Fate::approximated, word.meaning = what;
}

std::string next_type(const std::string& room, Random& rng) {
    return room_type(room).next_rooms[rng.chance(0.5f) ? 0 : 1];
}

// A wall without openings takes a doorway; behind it lies a whole room of the same house.
void add_doorway(PromptSpec& spec, Plan& plan, Random& rng) {
    const PromptObject* wish = wish_for(spec, "doorway");
    // Who speaks of windows means those of this room, and who wants no door wants none.
    const bool windows = wants_corners(spec) || wish_for(spec, "window") || wish_for(spec, "window", true) ||
                         wish_for(spec, "door", true);
    const float probability = windows ? 0.f : room_type(spec.room).doorway_probability;
    const bool beyond = !spec.next_room.empty();
    if (!decide(spec, "doorway", probability, rng) && !beyond) return;
    if (wish) report(spec, *wish, wish->count - 1, "a room has one");
    const int first = rng.index(2);
    const int order[3] = {first == 0 ? 1 : 3, first == 0 ? 3 : 1, 0};
    for (const int w : order) {
        if (std::any_of(plan.openings.begin(), plan.openings.end(), [&](const Opening& o) { return o.wall == w; }))
            continue;
        const auto [low, high] = plan.free_span(w, 2.3f, true);
        if (high - low < 2.2f) continue;
        Opening o;
        o.kind = Opening::Kind::doorway;
        o.wall = w;
        o.requested = wish != nullptr;
        const float wide = std::min(
            high - low - 1.2f, rng.uniform(0.95f, 1.5f) + (beyond ? 0.3f : 0.f));  // who asks for it wants to see it
        // Near an end, so that the wall keeps a place for furniture.
        const bool at_end = rng.chance(0.5f);
        o.u0 = at_end ? high - wide - rng.uniform(0.35f, 0.6f) : low + rng.uniform(0.35f, 0.6f);
        o.u1 = o.u0 + wide;
        o.y1 = std::min(plan.wall_top() - 0.3f, rng.uniform(2.1f, 2.3f));
        if (shape_of(wish) != Opening::Shape::square)
            o.shape = Opening::Shape::arched, o.y1 = std::min(plan.wall_top() - 0.2f, o.y1 + 0.25f);
        const WallFace face = plan.wall(w);

        auto next = std::make_shared<NextRoom>();
        next->type = next_type(spec.room, rng);
        if (beyond) next->type = spec.next_room;
        const bool wet = room_type(next->type).wet;
        Plan& p = next->plan;
        p.style = plan.style;
        p.joined = true;
        p.height = plan.wall_top();
        p.beams = plan.beams;
        if (const PromptObject* beams = plan.asked("beams")) p.asked_parts = {*beams};
        p.width = std::min(face.length, rng.uniform(3.6f, 4.4f) - (wet ? 1.f : 0.f));
        p.depth = rng.uniform(3.4f, 4.2f) - (wet ? 0.6f : 0.f);
        p.accent = rng.chance(0.5f);
        p.recessed_lights = plan.recessed_lights;
        p.neon = plan.neon;
        p.neon_color = plan.neon_color;
        p.style.shelves = room_type(next->type).shelves;
        if (wet) tile_wet_room(p, rng);
        // Its place along our wall: the doorway inside it, itself within the wall's length.
        const float middle = (o.u0 + o.u1) / 2, reach = p.width / 2 - wide / 2 - 0.3f;
        const float center = std::clamp(middle + rng.uniform(-reach, reach), p.width / 2, face.length - p.width / 2);
        const Vec3f out = -face.inward, up{0, 1, 0};
        next->room_from_next = {Mat3f::from_columns(cross(up, out), up, out),
                                face.point(center, 0) + out * (kWallThickness + p.depth / 2)};
        // The same hole, seen from there: our `along` is its +x or -x.
        const float x = dot(cross(up, out), face.along) * (middle - center);
        Opening back = o;
        back.wall = 2;
        back.requested = false;
        back.u0 = p.width / 2 - x - wide / 2;
        back.u1 = back.u0 + wide;
        p.openings.push_back(back);
        for (const int side : {0, rng.chance(0.5f) ? 1 : 3}) {
            const float length = p.wall(side).length,
                        window = std::min(length - 1.f, wet ? 0.9f : rng.uniform(1.3f, 1.9f));
            p.openings.push_back({Opening::Kind::window, side, (length - window) / 2, (length + window) / 2,
                                  room_type(next->type).windows.sill_beyond_doorway_m,
                                  std::min(p.height - 0.25f, 2.25f), false});
        }
        plan.openings.push_back(o);
        plan.next = std::move(next);
        return;
    }
    if (beyond) tell_next_room(spec, "no wall is left for a doorway to a " + room_title(spec.next_room));
    if (wish) report(spec, *wish, 1, "no wall is left for it");
}

}  // namespace

void shape_plan(PromptSpec& spec, Plan& plan, Random& rng) {
    for (const PromptObject& wish : spec.objects)
        if (!wish.forbidden && is_shell(wish.kind)) plan.asked_parts.push_back(wish);
    const RoomType& type = room_type(spec.room);
    const bool rich = plan.style.mouldings == Mouldings::rich, old = rich || plan.style.mouldings == Mouldings::plain;
    const bool lit_from_above = slopes_for_skylight(spec);
    const bool sloped = decide(spec, "sloped_ceiling", is_below_roof(spec) ? 1.f : 0.f, rng) &&
                        (is_below_roof(spec) || wish_for(spec, "sloped_ceiling"));
    const Outline outline = outline_asked(spec);
    if (lit_from_above && !sloped)
        spec.assumed.push_back("ceiling: sloped, for the " + wish_for(spec, "skylight")->words);
    if (sloped || lit_from_above) {
        constexpr float kNarrowest = 3.4f, kAttic = 4.9f;  // between two slopes; a hallway below a skylight stays one
        plan.width = plan.measured ? std::max(plan.width, kNarrowest)
                                   : std::max(plan.width + 0.7f, sloped ? kAttic : kNarrowest);
        if (!(spec.size_m.y > 0)) plan.height = std::max(plan.height, 2.7f);
        plan.knee = std::min(rng.uniform(1.05f, 1.3f), plan.height - 0.9f);
        plan.slope_run = std::min(rng.uniform(1.35f, 1.7f), plan.width / 2 - 0.8f);
        if (const PromptObject* wish = wish_for(spec, "alcove"))
            report(spec, *wish, wish->count, "not below a sloped ceiling");
        if (const PromptObject* wish = wish_for(spec, "bay_window"))
            report(spec, *wish, wish->count, "not below a sloped ceiling");
    } else {
        // One of these: a room with all of them has no walls left.
        const bool asked_bay = wish_for(spec, "bay_window"), asked_alcove = wish_for(spec, "alcove");
        float roll = rng.uniform();
        constexpr float kTight = 10.f;  // square metres: no corner to leave out
        if (outline != Outline::box || asked_bay || asked_alcove || wants_corners(spec) ||
            (plan.measured && plan.width * plan.depth < kTight))
            roll = 2.f;
        // A bay's panes are square: who asks for arches or portholes has none by chance.
        if (wish_for(spec, "bay_window", true) || shape_of(wish_for(spec, "window")) != Opening::Shape::square)
            roll = std::max(roll, type.breast_probability + type.corner_probability + type.bay_probability);
        const float recess = rng.uniform(0.6f, 0.8f), wide = std::min(plan.width - 0.9f, rng.uniform(2.3f, 2.8f)),
                    niche = rng.uniform(0.45f, 0.55f);
        if (outline != Outline::box) cut_corners(outline, plan);
        else if (roll < type.breast_probability) add_breast(plan, rng);
        else if ((roll -= type.breast_probability) < type.corner_probability) add_corner(plan, rng);
        else if ((roll -= type.corner_probability) < type.bay_probability || asked_bay)
            add_recess(plan, wide, recess), plan.bay = true;
        else if ((roll -= type.bay_probability) < type.alcove_probability || asked_alcove)
            add_recess(plan, std::min(wide, plan.width - 0.9f), niche);
        for (const char* kind : {"bay_window", "alcove"})
            if (const PromptObject* wish = wish_for(spec, kind); wish && outline != Outline::box)
                report(spec, *wish, wish->count, "not in a room of this outline");
        if (asked_bay && asked_alcove && outline == Outline::box)
            report(spec, *wish_for(spec, "alcove"), wish_for(spec, "alcove")->count, "the bay takes its place");
        for (const char* kind : {"bay_window", "alcove"})
            if (const PromptObject* wish = wish_for(spec, kind); wish && outline == Outline::box)
                report(spec, *wish, wish->count - 1, "a room has one");
        const PromptObject* columns = wish_for(spec, "column");
        if (decide(spec, "column", is_hall(spec) ? 0.65f : 0.f, rng))
            add_columns(plan, columns ? std::clamp(columns->count, 1, 3) : 2, rng);
        if (columns) report(spec, *columns, std::max(0, columns->count - 3), "a room has at most three");
    }
    if (!plan.beams && rich && !(plan.knee > 0)) plan.coffers = type.coffers && rng.chance(0.6f);
    const bool level = !plan.beams && !(plan.knee > 0) && outline == Outline::box;
    if (outline != Outline::box) plan.coffers = false;
    if (const PromptObject* wish = wish_for(spec, "coffers")) {
        plan.coffers = level;
        if (!level) report(spec, *wish, wish->count, "only a level ceiling over a rectangular room has them");
    }
    plan.relief = type.wall_relief;
    plan.cabin = type.cabin, plan.tunnel = type.windows.tunnel;
    raise_vault(spec, plan);
    add_mezzanine(spec, plan, rng);
    plan.cove = plan.knee > 0 ? 0.f : type.cove_m;
    plan.glazed = type.windows.glazed;
    plan.door = type.door;
    plan.panelling = decide(spec, "wainscoting", old && type.panelling ? 0.6f : 0.f, rng);
}

void open_plan(PromptSpec& spec, Plan& plan, Random& rng) {
    add_skylights(spec, plan, rng);
    if (plan.mezzanine.depth > 0) {
        if (const PromptObject* wish = wish_for(spec, "doorway"))
            report(spec, *wish, wish->count, "not beside a mezzanine");
        if (!spec.next_room.empty()) tell_next_room(spec, "no second room opens beside a mezzanine");
        return open_mezzanine(spec, plan);
    }
    if (plan.knee > 0) {
        if (const PromptObject* wish = wish_for(spec, "doorway")) report(spec, *wish, wish->count, "not in an attic");
        if (!spec.next_room.empty()) tell_next_room(spec, "no second room opens from an attic");
        return;
    }
    add_doorway(spec, plan, rng);
}

}  // namespace fastscene
