// New things that take the places of old ones.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "fastscene/base/error.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/document_parts.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"

namespace fastscene::editing {
namespace {

// Fewer new ones than old ones: each in the middle of some of these that look one way, where they can be shared out
// so.
std::vector<Placed> shared_out(std::vector<Placed> olds, int count) {
    const auto total = static_cast<int>(olds.size());
    if (count < 1 || total <= count || olds.front().on >= 0) return olds;
    constexpr float kTurn = 10;  // degrees: so near to each other they look one way
    const auto way = [&](const Placed& p) { return std::lround(p.yaw * 180 / kPi / kTurn); };
    // Where they look several ways, as around a table: each in the middle of those of one side, the longest first.
    std::map<long, std::vector<Placed>> sides;
    for (const Placed& p : olds) sides[way(p)].push_back(p);
    const bool one_table = olds.front().with >= 0 && std::all_of(olds.begin(), olds.end(), [&](const Placed& p) {
                               return p.with == olds.front().with;
                           });
    if (one_table && static_cast<int>(sides.size()) >= count && sides.size() > 1) {
        std::vector<std::vector<Placed>> longest;
        for (auto& [yaw, side] : sides) longest.push_back(side);
        std::stable_sort(longest.begin(), longest.end(),
                         [](const auto& a, const auto& b) { return a.size() > b.size(); });
        std::vector<Placed> out;
        for (int n = 0; n < count; ++n) {
            const std::vector<Placed>& side = longest[static_cast<std::size_t>(n)];
            Vec3f middle{};
            for (const Placed& p : side) middle += p.position * (1 / static_cast<float>(side.size()));
            out.push_back(side.front());
            out.back().position = middle;
        }
        return out;
    }
    if (total % count != 0) return olds;
    std::stable_sort(olds.begin(), olds.end(), [&](const Placed& a, const Placed& b) { return way(a) < way(b); });
    std::vector<Placed> out;
    for (int n = 0; n < count; ++n) {
        const auto first = static_cast<std::size_t>(n * (total / count));
        const auto last = first + static_cast<std::size_t>(total / count);
        Placed middle = olds[first];
        for (std::size_t k = first + 1; k < last; ++k) {
            if (way(olds[k]) != way(middle)) return olds;
            middle.position += olds[k].position;
        }
        middle.position = middle.position * (static_cast<float>(count) / static_cast<float>(total));
        out.push_back(middle);
    }
    return out;
}

}  // namespace

// As many new ones as were asked for, shared out to the places of the old ones; without a place there, near it.
void Editor::replace(const EditStep& step) {
    std::vector<int> roots;
    std::vector<Placed> olds;
    for (const std::string& id : step.ids) {
        roots.push_back(index_of(id));
        olds.push_back(placed(roots.back()));
    }
    std::vector<std::pair<std::string, int>> riders;  // what stood on the old ones, and on which
    std::vector<std::string> seats;
    for (std::size_t k = 0; k < roots.size(); ++k) {
        for (const int i : with_riders({roots[k]}))
            if (placed(i).on == roots[k]) riders.emplace_back(thing(i).id, static_cast<int>(k));
        for (const int i : seats_at(roots[k])) seats.push_back(thing(i).id);
    }
    const Standing standing = without(with_riders(roots));
    std::vector<Placed> all = standing.placed;
    int count = std::max(1, step.wish.count);
    // Of "benches for the chairs", nobody said how many: fewer, where they are much wider.
    constexpr float kWider = 1.6f, kForTwo_m = 1;
    if (!step.wish.counted && count == static_cast<int>(olds.size()) && count % 2 == 0) {
        PromptSpec spec = room_.spec;
        Random rng(room_.seed, "wide");
        Layout layout(plan(), spec, rng);
        const bool known = layout.why_not(step.wish.kind).empty() && olds.front().piece.mount == Mount::floor;
        const float wide = known ? make_piece(layout.request(step.wish.kind, &step.wish)).size_m.x : 0.f;
        if (wide > std::max(kForTwo_m, kWider * olds.front().piece.size_m.x))
            count = static_cast<int>(shared_out(olds, count / 2).size()) == count / 2 && count > 2 ? count / 2 : count;
    }
    if (riders.empty()) olds = shared_out(std::move(olds), count);
    const int places = static_cast<int>(olds.size());
    std::vector<int> place_of_new;
    if (places == 1 && count > 1 && olds.front().piece.mount == Mount::floor && olds.front().on < 0)
        if (auto there = side_by_side(standing, step, olds.front(), count); !there.empty())
            all = std::move(there), place_of_new.assign(static_cast<std::size_t>(count), 0);
    for (int n = static_cast<int>(place_of_new.size()); n < count; ++n) {
        const int k = n % places, here = (count - k + places - 1) / places, nth = n / places;
        const auto more = in_place_of(all, standing, step, olds[static_cast<std::size_t>(k)], nth, here);
        if (more.size() == all.size() && count == 1 && riders.empty() && replaced_nearby(step)) return;
        if (more.size() == all.size() && count == 1) {
            EditStep there = step;
            there.position = flat(olds.front().position);
            std::string why = olds.front().on < 0 ? what_is_missing(there, nullptr, with_riders(roots)) : "";
            throw Error("{}: there is no place for it where {} stood{}", step.wish.words, olds.front().id, why);
        }
        if (more.size() == all.size())
            throw Error("{}: there is a place for {} of {} where {} stood", step.wish.words, n, count,
                        olds[static_cast<std::size_t>(k)].id);
        all = more;
        place_of_new.push_back(k);
    }
    std::vector<std::string> stood;
    for (const int k : place_of_new) stood.push_back(" in place of " + olds[static_cast<std::size_t>(k)].id);
    const std::vector<std::string> fresh = admit(all, standing, stood);
    for (std::size_t n = 0; n < fresh.size(); ++n)
        if (const Placed& p = all[standing.placed.size() + n];
            step.wish.size == "large" && p.on >= 0 && p.piece.kind != step.wish.kind)
            tell(fresh[n], "a small one: it stands where that stood");
    std::vector<std::string> onto(olds.size());
    for (std::size_t n = 0; n < fresh.size(); ++n)
        if (const auto k = static_cast<std::size_t>(place_of_new[std::min(n, place_of_new.size() - 1)]);
            onto[k].empty())
            onto[k] = fresh[n];
    for (std::size_t n = 0; n < fresh.size(); ++n) {
        constexpr float kThere_m = 1;
        const Placed& p = all[standing.placed.size() + n];
        const Placed& old = olds[static_cast<std::size_t>(place_of_new[std::min(n, place_of_new.size() - 1)])];
        const float off = length(footprint_of(p).center - footprint_of(old).center);
        if (off > kThere_m && p.piece.mount == Mount::floor && p.on < 0)
            tell(fresh[n], fmt::format("{:.1f} m from where that stood: there was no room for it there", off));
    }
    for (const std::string& id : step.ids) tell(id, "removed");
    for (const std::string& id : step.ids)
        for (DocumentThing& t : result_.document.things) {
            if (t.with == id) t.with = std::find(seats.begin(), seats.end(), t.id) != seats.end() ? onto[0] : "";
            if (t.below == id) t.below.clear();
        }
    std::erase_if(result_.document.things, [&](const DocumentThing& t) {
        return std::find(step.ids.begin(), step.ids.end(), t.id) != step.ids.end();
    });
    set_down(riders, onto);
    // Nobody sits at what came for a desk or a table, unless it is one.
    const bool sat_at = std::all_of(olds.begin(), olds.end(),
                                    [](const Placed& old) { return is_sat_at(old.piece.kind); });
    if (sat_at && !is_sat_at(step.wish.kind) && !seats.empty()) take(seats);
}

std::vector<Placed> Editor::side_by_side(const Standing& standing, const EditStep& step, const Placed& old,
                                         int count) const {
    for (const float scale : {1.f, 0.85f})
        for (const float shift : {0.f, 0.2f, -0.2f, 0.4f, -0.4f, 0.6f, -0.6f, 0.8f, -0.8f}) {
            std::vector<Placed> all = standing.placed;
            for (int n = 0; n < count; ++n) {
                std::vector<Placed> more = in_place_of(all, standing, step, old, n, count, Aside{shift, scale});
                if (more.size() == all.size()) break;
                all = std::move(more);
            }
            if (all.size() == standing.placed.size() + static_cast<std::size_t>(count)) return all;
        }
    return {};
}

// One more in the place of an old one: the `nth` of `here` that share it.
std::vector<Placed> Editor::in_place_of(const std::vector<Placed>& all, const Standing& standing, const EditStep& step,
                                        const Placed& old, int nth, int here, const std::optional<Aside>& only) const {
    PromptSpec spec = room_.spec;
    PromptObject wish = step.wish;
    wish.count = 1;
    wish.id = 0;
    spec.objects = {wish};
    Random rng(room_.seed, "replace:" + wish.kind + old.id, all.size());
    const auto now = [&](int i) { return i < 0 ? -1 : standing.now[static_cast<std::size_t>(i)]; };
    constexpr float kLeastBed = 0.8f;
    for (const float scale : {1.f, 0.85f, 0.7f}) {
        if (only && only->scale != scale) continue;
        if (scale < kLeastBed && (has_role(wish.kind, Role::bed) || has_role(wish.kind, Role::seat))) break;
        Layout layout = begin_layout(spec, rng, all, nullptr);
        // Twins are alike, and as large as the first.
        const bool alike = all.size() > standing.placed.size();
        if (alike) layout.make_as(all.back().piece.made_from);
        if (const std::string why = layout.why_not(wish.kind); !why.empty()) throw Error("{}: {}", wish.words, why);
        PieceRequest request = layout.request(wish.kind, &wish);
        // On a table or a sill a plant is a small one.
        if ((old.on >= 0 || old.sill >= 0) && !request.model) request.kind = small_form_of(request.kind);
        if (!only || !alike) request = shrunk_to(request, scale);
        Placed place = old;
        float wide = std::max(make_piece(request).size_m.x + 0.06f, old.piece.size_m.x / static_cast<float>(here));
        // Several lamps over a table hang along it.
        if (old.piece.mount == Mount::ceiling && old.with >= 0) {
            constexpr float kOfTable = 0.75f;
            place.yaw = placed(old.with).yaw;
            wide = std::max(wide, kOfTable * placed(old.with).piece.size_m.x / static_cast<float>(here));
        }
        const float aside = (static_cast<float>(nth) - 0.5f * static_cast<float>(here - 1)) * wide +
                            (only ? only->by : 0.f);
        auto i = take_place(layout, request, wish, place, now(old.on), aside);
        if (only && !i) continue;
        const Piece piece = make_piece(request);
        for (const float reach : {0.8f, 1.6f})
            if (!i && piece.mount == Mount::floor && old.on < 0)
                i = layout.against_wall(
                    request, {.near = flat(old.position), .center_pull = 0, .at_most_from_near = reach}, wish);
        // As large as usual elsewhere nearby, before it is smaller there; a small one is rather smaller.
        constexpr float kNearby_m = 3;
        const bool elsewhere = scale == (wish.size == "small" && !only ? 0.7f : 1.f);
        for (const bool corner : {true, false})
            if (!i && elsewhere && piece.mount == Mount::floor && piece.against_wall && old.on < 0)
                i = layout.against_wall(
                    request,
                    {.near = flat(old.position), .center_pull = 0, .corner = corner, .at_most_from_near = kNearby_m},
                    wish);
        if (!i && elsewhere && piece.mount == Mount::floor && old.on < 0 && !old.flat) {
            EditStep there = step;
            there.wish = wish, there.position = flat(old.position);
            Standing among = standing;
            among.placed = all;
            among.was.resize(all.size(), 0);
            if (const auto found = squeezed_in(among, there, nullptr, {.narrow = true},
                                               [](const Squeezed&) { return true; }))
                return found->all;
        }
        if (!i && wish.size_m != Vec3f{} && scale < 1) break;
        if (!i || blocks_fronts(plan(), layout.placed(), all.size())) continue;
        if (old.with >= 0 && now(old.with) >= 0) layout.join(*i, now(old.with));
        return layout.placed();
    }
    if (only) return all;
    EditStep anywhere = step;
    anywhere.wish = wish;
    Standing among = standing;
    among.placed = all;
    among.was.resize(all.size(), 0);
    const std::vector<Placed> out = laid_out(among, anywhere, nullptr);
    constexpr float kStillThere = 1.5f;  // metres: further off, it is in nobody's place
    const bool far = !out.empty() && length(flat(out.back().position) - flat(old.position)) > kStillThere;
    return out.empty() || far ? all : out;
}

namespace {

// Where on a carrier's top a thing stands, as near as may be to where it is; nothing: it is too large for it.
std::optional<Vec3f> nearest_on_top(const Placed& carrier, const Placed& thing) {
    if (carrier.piece.surfaces.empty()) return {};
    const Surface& top = carrier.piece.surfaces.front();
    const Vec3f right = right_of(carrier.yaw), front = front_of(carrier.yaw), d = thing.position - carrier.position;
    const Footprint box = footprint_of(thing);
    const float spare_x = top.half.x - extent(box, flat(right)), spare_z = top.half.y - extent(box, flat(front));
    constexpr float kBeyond = 0.02f;  // metres that it may reach beyond the free part
    if (spare_x < -kBeyond || spare_z < -kBeyond) return {};
    const auto within = [](float at, float middle, float spare) {
        return middle + std::clamp(at - middle, -std::max(0.f, spare), std::max(0.f, spare));
    };
    Vec3f out = carrier.position + right * within(dot(d, right), top.center.x, spare_x) +
                front * within(dot(d, front), top.center.z, spare_z);
    out.y = carrier.position.y + top.center.y;
    return out;
}

}  // namespace

namespace {

struct StoodOn {
    std::vector<std::pair<std::string, Vec3f>> there;  // what stands on it, and where
    std::vector<std::string> left;                     // what has no room
};

// Places of a thing on a top, the nearest to where it is first; or the farthest from the top's middle.
std::vector<Vec3f> places_on_top(const Placed& carrier, const Placed& thing, bool at_edge) {
    const auto near = nearest_on_top(carrier, thing);
    if (!near) return {};
    std::vector<Vec3f> out{*near};
    const Surface& top = carrier.piece.surfaces.front();
    const Vec3f right = right_of(carrier.yaw), front = front_of(carrier.yaw);
    const Footprint box = footprint_of(thing);
    const float wide = std::max(0.f, top.half.x - extent(box, flat(right)));
    const float deep = std::max(0.f, top.half.y - extent(box, flat(front)));
    constexpr int kSteps = 6;
    const Vec3f middle = carrier.position + right * top.center.x + front * top.center.z;
    // A round top is free up to its edge, not only within a square.
    if (shape_of(carrier.piece) == "round") {
        constexpr int kWays = 24;
        const float reach = carrier.piece.size_m.x / 2 - std::max(box.half.x, box.half.y) - 0.01f;
        for (int ring = 1; ring <= kSteps && reach > 0; ++ring)
            for (int k = 0; k < kWays; ++k) {
                const float way = 2 * kPi * static_cast<float>(k) / kWays;
                Vec3f at = carrier.position + (right * std::sin(way) + front * std::cos(way)) *
                                                  (reach * static_cast<float>(ring) / kSteps);
                at.y = near->y;
                out.push_back(at);
            }
    }
    for (int i = -kSteps; i <= kSteps; ++i)
        for (int k = -kSteps; k <= kSteps; ++k) {
            Vec3f at = middle + right * (wide * static_cast<float>(i) / kSteps) +
                       front * (deep * static_cast<float>(k) / kSteps);
            at.y = near->y;
            out.push_back(at);
        }
    std::stable_sort(out.begin(), out.end(), [&](Vec3f a, Vec3f b) {
        return at_edge ? length(flat(a - middle)) > length(flat(b - middle)) : length(a - *near) < length(b - *near);
    });
    return out;
}

StoodOn stood_on(const Placed& carrier, std::vector<Placed> things) {
    std::stable_sort(things.begin(), things.end(), [](const Placed& a, const Placed& b) {
        return a.piece.size_m.x * a.piece.size_m.z > b.piece.size_m.x * b.piece.size_m.z;
    });
    std::optional<StoodOn> best;
    for (const bool first_at_edge : {false, true}) {
        StoodOn out;
        std::vector<Footprint> taken;
        for (const Placed& p : things) {
            Placed there = p;
            bool done = false;
            for (const Vec3f at : places_on_top(carrier, p, first_at_edge && taken.empty())) {
                there.position = at;
                const Footprint box = footprint_of(there);
                if (std::any_of(taken.begin(), taken.end(), [&](const Footprint& f) { return overlap(f, box); }))
                    continue;
                taken.push_back(box), out.there.emplace_back(p.id, at);
                done = true;
                break;
            }
            if (!done) out.left.push_back(p.id);
        }
        if (!best || out.left.size() < best->left.size()) best = out;
        if (best->left.empty()) break;
    }
    return *best;
}

// A bench, a stool: others stand on it as well.
bool is_low_seat(const Placed& p) {
    constexpr float kNoBack_m = 0.55f;
    return p.piece.size_m.y < kNoBack_m;
}

}  // namespace

// What stood on what was replaced stands on what came, where that has room for it: each as near to its place as may be;
// where not all of them have room so, the largest at the edge.
void Editor::set_down(const std::vector<std::pair<std::string, int>>& riders, const std::vector<std::string>& onto) {
    for (const auto& [id, place] : riders) thing(index_of(id)).on = onto[static_cast<std::size_t>(place)];
    build();
    std::map<std::string, std::vector<Placed>> by_top;
    std::vector<std::string> gone;
    for (const auto& [id, place] : riders) {
        const std::string& top = onto[static_cast<std::size_t>(place)];
        const int i = index_of(id);
        // Nothing is set down on what one sits on.
        const bool seat = !top.empty() && has_role(placed(top).piece.kind, Role::seat) &&
                          !furnishing::lies_on_seats(placed(i).piece.kind) &&
                          !has_role(placed(top).piece.kind, Role::no_top) && !is_low_seat(placed(top));
        if (!top.empty() && !seat) {
            by_top[top].push_back(placed(i));
            continue;
        }
        gone.push_back(id);
        if (!top.empty()) tell(id, "there is no room for it on " + top);
    }
    for (const auto& [top, things] : by_top) {
        const StoodOn best = stood_on(placed(top), things);
        for (const auto& [id, to] : best.there) {
            const int i = index_of(id);
            const Vec3f by = to - placed(i).position;
            for (const int k : with_riders({i})) thing(k).position += by;
        }
        for (const std::string& id : best.left) {
            gone.push_back(id);
            tell(id, "there is no room for it on " + top);
        }
    }
    if (!gone.empty()) take(gone);
    else build();
}

}  // namespace fastscene::editing
