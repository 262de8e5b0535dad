// The things at which a place is, of all that its words may mean.
#include <algorithm>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/tops.h"

namespace fastscene::editing {

std::string kind_of(const DocumentThing& t) { return t.asked && !t.asked->kind.empty() ? t.asked->kind : t.kind; }

bool is_table(const std::string& kind) {
    return has_role(kind, Role::lamp_above) || has_role(kind, Role::work_place) || kind.ends_with("table");
}

bool is_sat_at(const std::string& kind) {
    return has_role(kind, Role::work_place) || has_role(kind, Role::laid) ||
           (has_role(kind, Role::lamp_above) && !has_role(kind, Role::seat) && !has_role(kind, Role::bed) &&
            !has_role(kind, Role::small));
}

bool carries(const Placed& p) { return !p.piece.surfaces.empty() || flat_top(p.piece).has_value(); }

std::string suited(const std::string& relation, const std::string& kind, const Placed& there) {
    const bool small = furnishing::is_small(kind) || furnishing::lies_on_seats(kind);
    if (relation == "in") return "on";
    if (relation == "to" && small && carries(there)) return "on";
    // A lamp at a desk stands on it.
    if (relation == "at" && has_role(kind, Role::light) && furnishing::is_small(kind) && is_sat_at(there.piece.kind) &&
        carries(there))
        return "on";
    if (has_role(kind, Role::seat) && !has_role(kind, Role::sofa) && !has_role(kind, Role::easy_chair)) {
        if (has_role(there.piece.kind, Role::laid)) return "around";
        if (has_role(there.piece.kind, Role::work_place)) return "in front of";
        if (has_role(there.piece.kind, Role::lamp_above)) return "around";
    }
    return "next to";
}

bool fits(const std::string& relation, const Placed& there) {
    if (relation == "on") return carries(there) || there.flat;
    if (relation == "around") return is_table(there.piece.kind);
    if (relation == "under") return there.piece.mount != Mount::ceiling && !there.flat;
    return true;
}

namespace {

float floor_of(const Placed& p) { return p.piece.size_m.x * p.piece.size_m.z; }

}  // namespace

std::vector<int> of_one_kind(const Editor& editor, std::vector<int> found, const std::string& relation) {
    const std::vector<Placed>& all = editor.room().furnished.placed;
    const auto at = [&](int i) -> const Placed& { return all[static_cast<std::size_t>(i)]; };
    if (std::any_of(found.begin(), found.end(), [&](int i) { return fits(relation, at(i)); }))
        std::erase_if(found, [&](int i) { return !fits(relation, at(i)); });
    const int largest = *std::max_element(found.begin(), found.end(),
                                          [&](int a, int b) { return floor_of(at(a)) < floor_of(at(b)); });
    const std::string kind = at(largest).piece.kind;
    std::erase_if(found, [&](int i) { return at(i).piece.kind != kind; });
    return found;
}

Anchor anchor_of(const Editor& editor, std::vector<int> found, const std::string& relation) {
    found = of_one_kind(editor, found, relation);
    const std::vector<DocumentThing>& things = editor.document().things;
    Anchor out{kind_of(things[static_cast<std::size_t>(found.front())]), {}};
    const auto alike = std::count_if(things.begin(), things.end(), [&](const DocumentThing& t) {
        return t.kind == out.kind || kind_of(t) == out.kind;
    });
    if (alike != static_cast<std::ptrdiff_t>(found.size()))
        for (const int i : found) out.ids.push_back(things[static_cast<std::size_t>(i)].id);
    return out;
}

Mount mount_of(const Editor& editor, const std::string& kind) {
    PromptSpec spec = editor.room().spec;
    Random rng(0, "mount");
    Layout layout(editor.plan(), spec, rng);
    PromptObject wish;
    wish.kind = kind;
    return layout.why_not(kind).empty() ? make_piece(layout.request(kind, &wish)).mount : Mount::floor;
}

std::vector<std::string> all_but_nearest(const Editor& editor, const std::string& kind, const std::string& mover) {
    const Vec2f here = footprint_of(editor.placed(mover)).center;
    std::vector<std::string> out;
    for (const DocumentThing& t : editor.document().things)
        if (t.kind == kind || kind_of(t) == kind) out.push_back(t.id);
    const auto far = [&](const std::string& id) { return distance_to(footprint_of(editor.placed(id)), here); };
    if (out.size() > 1)
        out.erase(std::min_element(out.begin(), out.end(),
                                   [&](const std::string& a, const std::string& b) { return far(a) < far(b); }));
    return out;
}

std::string lacking_one(const Editor& editor, const Words& noun, const std::string& kind) {
    const std::vector<int> all = all_named(editor, "all " + text_of(noun));
    const std::vector<Placed>& things = editor.room().furnished.placed;
    std::vector<int> lacking;
    for (const int i : all)
        if (std::none_of(things.begin(), things.end(), [&](const Placed& p) {
                const bool seats = has_role(kind, Role::seat) && has_role(p.piece.kind, Role::seat);
                return (p.on == i || p.with == i) && (asked_kind(p) == kind || seats);
            }))
            lacking.push_back(i);
    if (all.size() < 2 || lacking.size() != 1) throw UsageError("which other {}? none was named before", text_of(noun));
    return things[static_cast<std::size_t>(lacking.front())].id;
}

}  // namespace fastscene::editing
