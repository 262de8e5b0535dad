#include "fastscene/rooms/edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/base/suggest.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/document_parts.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/plan_parts.h"
#include "fastscene/rooms/room_type.h"
#include "fastscene/rooms/validate.h"

namespace fastscene {
namespace editing {
namespace {

constexpr const char* kName = "room";  // of the document, in messages

std::string in_words(std::string kind) {
    std::replace(kind.begin(), kind.end(), '_', ' ');
    return kind;
}

// What is wrong with a room, with the ids of its things.
std::set<std::string> faults_of(const RoomDocument& document, const FurnishedRoom& room) {
    std::set<std::string> out;
    for (const Fault& fault : room_faults(room.plan, room.placed, room.camera)) {
        std::string text = fault.text;
        for (std::size_t i = room.placed.size(); i-- > 0;) {
            const std::string name = room.placed[i].piece.kind + " #" + std::to_string(i);
            for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name))
                text.replace(at, name.size(), document.things[i].id);
        }
        out.insert(text);
    }
    return out;
}

}  // namespace

Editor::Editor(const RoomDocument& document, std::shared_ptr<const FurniturePack> pack, const Run& run)
    : pack_(std::move(pack)), run_(run), result_{completed(document, kName, pack_, run), {}} {
    build();
}

void Editor::build() { room_ = furnish_document(result_.document, kName, pack_, run_); }

int Editor::index_of(const std::string& id) const {
    const std::vector<DocumentThing>& things = result_.document.things;
    const auto found = std::find_if(things.begin(), things.end(), [&](const DocumentThing& t) { return t.id == id; });
    if (found != things.end()) return static_cast<int>(found - things.begin());
    std::vector<std::string> ids;
    for (const DocumentThing& t : things) ids.push_back(t.id);
    const std::string near = nearest_word(id, ids);
    throw UsageError("there is no \"{}\" in the room{}", id,
                     near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near));
}

std::vector<int> Editor::with_riders(const std::vector<int>& roots) const {
    const std::vector<Placed>& placed = room_.furnished.placed;
    std::vector<int> out = roots;
    for (std::size_t k = 0; k < out.size(); ++k)
        for (int i = 0; i < static_cast<int>(placed.size()); ++i)
            if (placed[static_cast<std::size_t>(i)].on == out[k] && std::find(out.begin(), out.end(), i) == out.end())
                out.push_back(i);
    return out;
}

void Editor::tell(const std::string& id, const std::string& what) { result_.changes.push_back({id, what}); }

void Editor::take(const std::vector<std::string>& ids) {
    std::vector<int> roots;
    for (const std::string& id : ids) roots.push_back(index_of(id));
    std::set<std::string> gone;
    for (const int i : with_riders(roots)) gone.insert(result_.document.things[static_cast<std::size_t>(i)].id);
    std::vector<DocumentThing>& things = result_.document.things;
    for (const DocumentThing& t : things)
        if (gone.contains(t.id)) tell(t.id, t.on.empty() || !gone.contains(t.on) ? "removed" : "removed with " + t.on);
    std::erase_if(things, [&](const DocumentThing& t) { return gone.contains(t.id); });
    for (DocumentThing& t : things)
        for (std::string* id : {&t.on, &t.below, &t.with})
            if (gone.contains(*id)) id->clear();
    build();
}

// Moves a thing with what stands on it, and with others `along`.
void Editor::carry(int index, Vec3f position, float yaw, const std::vector<int>& along) {
    std::vector<DocumentThing>& things = result_.document.things;
    const Placed before = room_.furnished.placed[static_cast<std::size_t>(index)];
    const float turn = yaw - before.yaw, c = std::cos(turn), s = std::sin(turn);
    std::vector<int> moving{index};
    moving.insert(moving.end(), along.begin(), along.end());
    for (const int i : with_riders(moving)) {
        DocumentThing& t = things[static_cast<std::size_t>(i)];
        const Vec3f d = t.position - before.position;
        t.position = position + Vec3f{c * d.x + s * d.z, d.y, c * d.z - s * d.x};
        t.yaw = std::remainder(t.yaw + turn, 2 * kPi);
        if (i == index) t.yaw = yaw;
    }
    const float far = length(position - before.position);
    tell(things[static_cast<std::size_t>(index)].id,
         fmt::format("moved {:.2f} m to x {:.2f}, z {:.2f}, turned to {:.0f} degrees", far, position.x, position.z,
                     yaw * 180 / kPi));
    for (const int i : along)
        tell(things[static_cast<std::size_t>(i)].id, "moved with " + things[static_cast<std::size_t>(index)].id);
}

// Nothing may be wrong that was not before.
template <class Change>
void Editor::checked(const Change& change) {
    const std::set<std::string> before = faults_of(result_.document, room_.furnished);
    const EditResult kept = result_;
    try {
        change();
        build();
        for (const std::string& fault : faults_of(result_.document, room_.furnished))
            if (!before.contains(fault)) throw Error("{}", fault);
    } catch (...) {
        result_ = kept;
        build();
        throw;
    }
}

void Editor::move(const EditStep& step) {
    for (const std::string& id : step.ids) {
        const int i = index_of(id);
        checked([&] {
            const Placed& p = room_.furnished.placed[static_cast<std::size_t>(i)];
            Vec3f to = p.position;
            if (step.position) to.x = step.position->x, to.z = step.position->y;
            const float yaw = step.kind == EditStep::Kind::turn
                                  ? std::remainder(p.yaw + step.yaw.value_or(kPi), 2 * kPi)
                                  : step.yaw.value_or(p.yaw);
            DocumentThing& t = result_.document.things[static_cast<std::size_t>(i)];
            // Off what carried it, it stands on the floor.
            if (step.position && !t.on.empty()) to.y = 0, t.on.clear();
            carry(i, to, yaw, {});
        });
    }
}

std::string Editor::new_id(const std::string& kind) const {
    const RoomDocument& document = result_.document;
    std::set<std::string> ids;
    for (const DocumentThing& t : document.things) ids.insert(t.id);
    if (document.next_room)
        for (const DocumentThing& t : document.next_room->things) ids.insert(t.id);
    int n = 1;
    while (ids.contains(fmt::format("{}-{}", kind, n))) ++n;
    return fmt::format("{}-{}", kind, n);
}

namespace {

std::string place_in_words(const PromptObject& wish) {
    if (wish.relation.empty()) return "";
    return " " + wish.relation + (wish.relation_to.empty() ? "" : " the " + in_words(wish.relation_to));
}

bool is_where_asked(const Plan& plan, const std::vector<Placed>& all, const Placed& piece, const PromptObject& wish) {
    return stands_as_asked(plan, all, piece, wish).value_or(wish.relation.empty());
}

// On a top that is almost full: every place on it is tried.
void fill_gap(Layout& layout, const PromptObject& wish) {
    if (wish.relation != "on" || !layout.why_not(wish.kind).empty()) return;
    constexpr float kStep = 0.04f;  // metres
    const PieceRequest request = layout.request(wish.kind, &wish);
    for (int i = 0; i < static_cast<int>(layout.placed().size()); ++i) {
        const Placed top = layout.placed()[static_cast<std::size_t>(i)];
        if (top.piece.surfaces.empty() || (top.piece.kind != wish.relation_to && top.wish.kind != wish.relation_to))
            continue;
        const Surface& s = top.piece.surfaces.front();
        for (float z = -s.half.y; z <= s.half.y; z += kStep)
            for (float x = -s.half.x; x <= s.half.x; x += kStep) {
                const Vec3f at = top.position + right_of(top.yaw) * (s.center.x + x) +
                                 front_of(top.yaw) * (s.center.z + z);
                if (layout.on_top_at(i, request, flat(at), top.yaw, wish)) return;
            }
    }
}

}  // namespace

// Lays out what is wished for among what stands; `moving` is made as it was.
std::vector<Placed> Editor::laid_out(const std::vector<Placed>& standing, const PromptObject& wish,
                                     const Placed* moving, const std::optional<Vec2f>& near) const {
    PromptSpec spec = room_.spec;
    spec.objects = {wish};
    spec.objects[0].id = 0;
    spec.not_placed.clear();
    // Nothing comes that was not asked for.
    spec.clutter = "empty";
    Random rng(room_.seed, "edit:" + wish.kind + wish.relation + wish.relation_to, standing.size());
    Layout layout(room_.furnished.plan, spec, rng);
    layout.begin_with(standing);
    if (moving) layout.make_as(moving->piece.made_from);
    if (near) {
        constexpr float kReach = 1.2f;  // metres
        const PieceRequest request = layout.request(wish.kind, &spec.objects[0]);
        const Layout::WallWish there{.near = near, .center_pull = 0, .at_most_from_near = kReach};
        if (layout.why_not(wish.kind).empty() && make_piece(request).mount == Mount::floor &&
            layout.against_wall(request, there, spec.objects[0]))
            return layout.placed();
    }
    const std::size_t before = layout.mark();
    place_asked(layout);
    if (layout.mark() == before ||
        !is_where_asked(room_.furnished.plan, layout.placed(), layout.placed().back(), wish)) {
        layout.undo(before);
        fill_gap(layout, spec.objects[0]);
    }
    return layout.placed();
}

// Chairs go with the table that they stand at.
std::vector<int> Editor::seats_at(int table) const {
    const std::vector<Placed>& placed = room_.furnished.placed;
    const std::string& kind = placed[static_cast<std::size_t>(table)].piece.kind;
    std::vector<int> out;
    if (!has_role(kind, Role::lamp_above) && !has_role(kind, Role::work_place)) return out;
    for (int i = 0; i < static_cast<int>(placed.size()); ++i)
        if (const Placed& p = placed[static_cast<std::size_t>(i)];
            p.with == table && has_role(p.piece.kind, Role::seat))
            out.push_back(i);
    return out;
}

void Editor::place(const EditStep& step) {
    for (const std::string& id : step.ids) {
        const int index = index_of(id);
        const std::vector<int> seats = seats_at(index);
        if (!seats.empty()) try {
                place_one(index, seats, step.wish);
                continue;
            } catch (const Error&) {  // there is no room for them: it goes alone
            }
        place_one(index, {}, step.wish);
    }
}

void Editor::place_one(int index, const std::vector<int>& along, PromptObject wish) {
    const std::vector<Placed> placed = room_.furnished.placed;
    std::vector<int> moving{index};
    moving.insert(moving.end(), along.begin(), along.end());
    moving = with_riders(moving);
    std::vector<Placed> standing;
    std::vector<int> now(placed.size(), -1), was;
    for (int i = 0; i < static_cast<int>(placed.size()); ++i)
        if (std::find(moving.begin(), moving.end(), i) == moving.end()) {
            now[static_cast<std::size_t>(i)] = static_cast<int>(standing.size());
            was.push_back(i);
            standing.push_back(placed[static_cast<std::size_t>(i)]);
        }
    for (Placed& p : standing)
        for (int* at : {&p.on, &p.below, &p.with})
            if (*at >= 0) *at = now[static_cast<std::size_t>(*at)];
    const Placed& thing = placed[static_cast<std::size_t>(index)];
    std::vector<DocumentThing>& things = result_.document.things;
    const std::string id = things[static_cast<std::size_t>(index)].id;
    wish.kind = thing.wish.kind.empty() ? thing.piece.kind : thing.wish.kind;
    wish.words = in_words(wish.kind);
    wish.count = 1;
    wish.size_m = thing.piece.size_m;
    const std::vector<Placed> all = laid_out(standing, wish, &thing, {});
    const Placed* found = all.size() == standing.size() + 1 ? &all.back() : nullptr;
    constexpr float kSame = 2e-3f;  // metres
    if (!found || length(found->piece.size_m - thing.piece.size_m) > kSame ||
        !is_where_asked(room_.furnished.plan, all, *found, wish))
        throw Error("{}: there is no free place for it{}", id, place_in_words(wish));
    checked([&] {
        DocumentThing& t = result_.document.things[static_cast<std::size_t>(index)];
        const auto id_of = [&](int i) {
            const int old = i < 0 || i >= static_cast<int>(was.size()) ? -1 : was[static_cast<std::size_t>(i)];
            return old < 0 ? std::string() : result_.document.things[static_cast<std::size_t>(old)].id;
        };
        t.on = id_of(found->on), t.below = id_of(found->below), t.with = id_of(found->with);
        t.window = found->sill;
        t.mount.reset();
        if (found->piece.mount != found->piece.made_mount) t.mount = found->piece.mount;
        if (t.asked) t.asked->relation = wish.relation, t.asked->relation_to = wish.relation_to;
        carry(index, found->position, found->yaw, along);
    });
}

// As large as it is usual; where there is no room for that, smaller.
std::vector<Placed> Editor::with_added(const PromptObject& asked, const std::optional<Vec2f>& near) const {
    const std::vector<Placed>& standing = room_.furnished.placed;
    const FurnishedRoom& room = room_.furnished;
    for (const float scale : {1.f, 0.82f, 0.66f, 0.56f}) {
        PromptObject wish = asked;
        if (scale < 1) {
            if (wish.size_m != Vec3f{} || wish.kind == "rug") break;
            PromptSpec spec = room_.spec;
            Random rng(room_.seed, "size");
            Layout layout(room.plan, spec, rng);
            if (!layout.why_not(wish.kind).empty()) break;
            wish.size_m = make_piece(layout.request(wish.kind, &wish)).size_m * scale;
        }
        std::vector<Placed> all = laid_out(standing, wish, nullptr, near);
        if (all.size() < standing.size() + static_cast<std::size_t>(std::max(1, wish.count))) continue;
        if (std::all_of(all.begin() + static_cast<std::ptrdiff_t>(standing.size()), all.end(), [&](const Placed& p) {
                return p.wish.kind != wish.kind || is_where_asked(room.plan, all, p, wish);
            }))
            return all;
    }
    throw Error("{}: there is no free place for it{}", asked.words, place_in_words(asked));
}

void Editor::add(const EditStep& step) {
    const std::vector<Placed> standing = room_.furnished.placed, all = with_added(step.wish, step.position);
    std::vector<std::string> ids;
    for (const DocumentThing& t : result_.document.things) ids.push_back(t.id);
    for (std::size_t i = standing.size(); i < all.size(); ++i) {
        ids.push_back(new_id(all[i].wish.kind.empty() ? all[i].piece.kind : all[i].wish.kind));
        DocumentThing t = thing_of(all[i], ids, i);
        const std::string place = t.on.empty() ? place_in_words(all[i].wish) : " on " + t.on;
        tell(t.id, fmt::format("added{} at x {:.2f}, z {:.2f}", place, t.position.x, t.position.z));
        result_.document.things.push_back(std::move(t));
    }
    build();
}

void Editor::recolor(const EditStep& step) {
    const PromptObject& looks = step.wish;
    std::string said;
    for (const auto& [key, value] :
         {std::pair{"color", looks.color}, {"material", looks.material}, {"pattern", looks.pattern}})
        if (!value.empty()) said += fmt::format("{}{}: {}", said.empty() ? "" : ", ", key, value);
    if (!step.surface.empty()) return recolor_surface(step, said);
    for (const std::string& id : step.ids) {
        DocumentThing& t = result_.document.things[static_cast<std::size_t>(index_of(id))];
        if (!t.asked) {
            t.asked.emplace();
            t.asked->kind = t.kind, t.asked->words = in_words(t.kind);
        }
        // Another material has its own color.
        if (!looks.material.empty()) t.color = t.asked->color = "", t.material = t.asked->material = looks.material;
        if (!looks.color.empty()) t.color = t.asked->color = looks.color;
        if (!looks.pattern.empty()) t.pattern = t.asked->pattern = looks.pattern;
        tell(id, said);
    }
    build();
}

void Editor::recolor_surface(const EditStep& step, const std::string& said) {
    const Style& style = room_.furnished.plan.style;
    DocumentSurfaces& own = result_.document.surfaces;
    const std::vector<std::pair<std::string_view, std::pair<std::optional<Material>*, const Material*>>> parts{
        {"wall", {&own.wall, &style.wall}},
        {"accent_wall", {&own.accent_wall, &style.accent_wall}},
        {"floor", {&own.floor, &style.floor}},
        {"ceiling", {&own.ceiling, &style.ceiling}},
        {"trim", {&own.trim, &style.trim}}};
    for (const auto& [name, part] : parts) {
        // "The walls" are all of them.
        if (name != step.surface && !(name == "accent_wall" && step.surface == "wall")) continue;
        Material m = *part.second;
        apply_wish(m, step.wish, true, style.palette);
        if (!step.wish.color.empty()) m.name = step.wish.color + " " + step.surface;
        *part.first = m;
    }
    tell(step.surface, said);
    build();
}

void Editor::resize(const EditStep& step) {
    for (const std::string& id : step.ids) {
        const int i = index_of(id);
        if (with_riders({i}).size() > 1)
            throw Error("{}: things stand on it; move them off it before its size is changed", id);
        checked([&] {
            DocumentThing& t = result_.document.things[static_cast<std::size_t>(i)];
            for (std::size_t a = 0; a < 3; ++a) t.size_m[a] *= step.factor;
            tell(id, fmt::format("size: {:.2f} x {:.2f} x {:.2f} m", t.size_m.x, t.size_m.y, t.size_m.z));
        });
    }
}

namespace {

// Those of the style; wet rooms keep their tiles.
DocumentSurfaces fresh_surfaces(const DocumentSurfaces& old, const std::string& type, const Style& style) {
    DocumentSurfaces out;
    out.shelves = old.shelves;
    if (room_type(type).wet) out.floor = style.wet_floor, out.accent_wall = style.wet_wall;
    return out;
}

}  // namespace

void Editor::restyle(const std::string& name) {
    const Style& style = style_named(name);
    RoomDocument& document = result_.document;
    if (document.style == style.name) return;
    document.surfaces = fresh_surfaces(document.surfaces, document.type, style);
    if (document.next_room)
        document.next_room->surfaces = fresh_surfaces(document.next_room->surfaces, document.next_room->type, style);
    document.style = style.name;
    tell("room", "style: " + style.name);
    build();
}

void Editor::light(const std::string& value) {
    DocumentLight& light = result_.document.light;
    if (is_one_of(value, {"morning", "day", "evening", "dusk", "night"})) {
        light.hour = value;
        light.lamps.reset(), light.towards_sun.reset();
        if (light.light == "neon" || light.light == "lamps on") light.light.clear();
        // A low sun is behind clouds.
        if (value == "evening" && is_one_of(light.weather, {"overcast", "rainy", "snowy"})) light.weather.clear();
    } else if (is_one_of(value, {"sunny", "overcast", "rainy", "snowy"})) {
        light.weather = value;
        light.towards_sun.reset();
    } else if (value == "lamps on" || value == "lamps off") {
        light.lamps = value == "lamps on" ? 1.f : 0.f;
    } else if (is_one_of(value, {"garden", "city", "sea", "mountains", "forest"})) {
        light.outlook = value;
    } else {
        throw UsageError(
            "expected an hour (morning, day, evening, dusk, night) or a weather (sunny, overcast, rainy, snowy), found "
            "\"{}\"",
            value);
    }
    tell("room", "light: " + value);
    build();
}

void Editor::apply(const EditStep& step) {
    switch (step.kind) {
        case EditStep::Kind::remove: return take(step.ids);
        case EditStep::Kind::move:
        case EditStep::Kind::turn: return move(step);
        case EditStep::Kind::place: return place(step);
        case EditStep::Kind::recolor: return recolor(step);
        case EditStep::Kind::resize: return resize(step);
        case EditStep::Kind::add: return add(step);
        case EditStep::Kind::restyle: return restyle(step.value);
        case EditStep::Kind::light: return light(step.value);
    }
}

}  // namespace editing

EditResult edit_document(const RoomDocument& document, const std::vector<EditStep>& steps,
                         std::shared_ptr<const FurniturePack> pack, const Run& run) {
    editing::Editor editor(document, std::move(pack), run);
    for (const EditStep& step : steps) editor.apply(step);
    return editor.result();
}

}  // namespace fastscene
