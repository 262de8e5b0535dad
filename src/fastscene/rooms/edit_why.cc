// Why a thing has no place: what is in the way, or how much floor it takes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/validate.h"

namespace fastscene::editing {
namespace {

bool is_meant(const EditStep& step, const Placed& p) {
    const auto is = [&](const std::string& kind) {
        return !kind.empty() && (p.piece.kind == kind || p.wish.kind == kind);
    };
    return is(step.wish.relation_to) || is(step.wish.relation_and);
}

}  // namespace

std::string Editor::why_none_added(EditStep step) const {
    const std::string place = place_in_words(step);
    PromptSpec spec = room_.spec;
    Random rng(room_.seed, "why");
    if (const std::string why = Layout(plan(), spec, rng).why_not(step.wish.kind); !why.empty())
        return fmt::format("{}: {}", step.wish.words, why);
    const auto hangs = [&](const Placed& p) { return asked_kind(p) == step.wish.kind && p.piece.mount == Mount::wall; };
    if (has_role(step.wish.kind, Role::soft) &&
        std::any_of(room_.furnished.placed.begin(), room_.furnished.placed.end(), hangs))
        return fmt::format("{}: they hang at the windows already; \"make the {} …\" changes them", step.wish.words,
                           step.wish.words);
    const int asked = step.wish.count;
    while (--step.wish.count > 0)
        if (!laid_out(without({}), step, nullptr).empty())
            return fmt::format("{}: there is a free place for {} of {}{}", step.wish.words, step.wish.count, asked,
                               place);
    step.wish.count = 1;
    return fmt::format("{}: there is no free place for it{}{}", step.wish.words, place,
                       what_is_missing(step, nullptr, {}));
}

// Calls `each` for every place that is meant, with the thing standing there, until it returns false. Not at all for
// what hangs or lies flat, or cannot be had: no thing is in its way.
void Editor::try_places(const EditStep& step, const Placed* moving, const std::vector<int>& gone,
                        const std::function<bool(const Standing&, const Asked&, const Placed&)>& each) const {
    const Standing standing = without(gone);
    Asked asked = asked_among(standing, step);
    Random rng(room_.seed, "why", asked.among.size());
    Layout layout = begin_layout(asked.spec, rng, asked.among, moving);
    const PromptObject& wish = asked.spec.objects[0];
    if (!layout.why_not(wish.kind).empty()) return;
    Placed p;
    p.piece = make_piece(layout.request(wish.kind, &wish));
    if (p.piece.mount != Mount::floor || is_rug(p.piece)) return;
    for (const Candidate& c : candidates_for(layout, step, p.piece, 0)) {
        p.position = {c.at.x, 0, c.at.y}, p.yaw = c.yaw;
        if (!each(standing, asked, p)) return;
    }
}

// Of all places that are meant the one at which the fewest things stand; none: it is no thing that is in the way.
std::vector<std::string> Editor::fewest_in_the_way(const EditStep& step, const Placed* moving,
                                                   const std::vector<int>& gone) const {
    constexpr std::size_t kMostNamed = 3;
    std::vector<int> fewest;
    bool found = false;
    try_places(step, moving, gone, [&](const Standing& standing, const Asked& asked, const Placed& p) {
        const Footprint box = footprint_of(p);
        if (blocks_opening(plan(), box)) return true;
        std::vector<int> here;
        bool meant = false;
        for (int i = 0; i < static_cast<int>(asked.among.size()); ++i) {
            const Placed& other = asked.among[static_cast<std::size_t>(i)];
            if (other.flat || other.on >= 0 || other.piece.mount != Mount::floor || !overlap(box, footprint_of(other)))
                continue;
            here.push_back(standing.was[static_cast<std::size_t>(i)]);
            meant = meant || is_meant(step, placed(here.back()));
        }
        if (!meant && (!found || here.size() < fewest.size())) fewest = here, found = true;
        return true;
    });
    std::vector<std::string> out;
    for (const int i : fewest)
        if (out.size() < kMostNamed) out.push_back(placed(i).id);
    return fewest.size() > kMostNamed ? std::vector<std::string>{} : out;
}

std::string Editor::fault_at_best(const EditStep& step, const Placed* moving, const std::vector<int>& gone) const {
    const auto kinds = [&](const std::vector<Placed>& all) {
        std::set<std::string> out;
        for (const Fault& f : room_faults(plan(), all, room_.furnished.camera, kNarrow, round_ones(all)))
            out.insert(f.kind);
        return out;
    };
    const std::set<std::string> before = kinds(without(gone).placed);
    constexpr int kMostLooks = 12;
    int looks = 0;
    std::string why;
    bool at_opening = false;
    try_places(step, moving, gone, [&](const Standing& standing, const Asked&, const Placed& p) {
        const Footprint box = footprint_of(p);
        std::vector<Placed> all = standing.placed;
        if (std::any_of(all.begin(), all.end(), [&](const Placed& other) {
                return !other.flat && overlap(shrunk(box, 0.01f), footprint_of(other));
            }))
            return true;
        if (blocks_opening(plan(), box)) return at_opening = true;
        if (++looks > kMostLooks) return false;
        all.push_back(p);
        const std::set<std::string> now = kinds(all);
        for (const auto& [kind, says] : {std::pair{"way", "no way of 0.45 m would be left past it"},
                                         {"window", "it would stand before a window"},
                                         {"door", "it would stand before a door"}})
            if (why.empty() && now.contains(kind) && !before.contains(kind)) why = says;
        return why.empty();
    });
    return why.empty() && at_opening ? "it would stand before a door or a window" : why;
}

std::string Editor::what_hangs_above(const EditStep& step) const {
    PromptObject above;
    above.id = -2;  // none of those that stand there
    above.relation = "above", above.relation_to = step.wish.relation_to;
    std::vector<std::string> there;
    for (const Placed& p : room_.furnished.placed)
        if (p.piece.mount == Mount::wall && !has_role(p.piece.kind, Role::soft) &&
            stands_as_asked(plan(), room_.furnished.placed, p, above).value_or(false))
            there.push_back(p.id);
    if (!there.empty())
        return fmt::format(", and {} {} there", fmt::join(there, " and "), there.size() > 1 ? "hang" : "hangs");
    constexpr float kAtWindow = 0.5f;  // metres
    const std::vector<Footprint> windows = anchors_of(plan(), {}, "window");
    for (const Footprint& a : anchors_of(plan(), room_.furnished.placed, step.wish.relation_to))
        for (const Footprint& window : windows)
            if (gap_between(a, window) < kAtWindow) return ", and a window is there";
    return {};
}

// Whether it would have a place without one of the things that stand about it, or were it smaller.
std::string Editor::what_is_missing(const EditStep& step, const Placed* moving, const std::vector<int>& gone) const {
    EditStep one = step;
    one.wish.count = 1;
    const Vec3f size = moving ? moving->piece.size_m : usual_size(one.wish);
    const Mount mount = moving ? moving->piece.mount : mount_of(*this, one.wish.kind);
    if (size == Vec3f{} || mount == Mount::ceiling) return {};
    const bool hangs = mount == Mount::wall;
    const std::string takes = hangs ? fmt::format(": it takes {:.2f} x {:.2f} m of wall", size.x, size.y)
                                    : fmt::format(": it takes {:.2f} x {:.2f} m", size.x, size.z);
    if (mount == Mount::surface) return takes;
    if (hangs && step.wish.relation == "above") return takes + what_hangs_above(step);
    const Squeeze tightly{.narrow = true};
    const std::vector<std::string> blocking = hangs ? std::vector<std::string>{} : fewest_in_the_way(one, moving, gone);
    if (!blocking.empty())
        return fmt::format("{}, and {} {} in the way", takes, fmt::join(blocking, " and "),
                           blocking.size() > 1 ? "are" : "is");
    if (const std::string fault = hangs ? "" : fault_at_best(one, moving, gone); !fault.empty())
        return fmt::format("{}, and {}", takes, fault);
    if (moving || !(one.wish.size_m == Vec3f{})) return takes;
    for (const float scale : {0.6f, 0.5f, 0.4f}) {
        one.wish.size_m = size * scale;
        if (squeezed_in(without(gone), one, moving, tightly, [](const Squeezed&) { return true; }))
            return fmt::format("{}, and there is room for {:.2f} x {:.2f} m at most", takes, size.x * scale,
                               (hangs ? size.y : size.z) * scale);
    }
    return takes;
}

}  // namespace fastscene::editing
