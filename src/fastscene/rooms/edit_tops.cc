// Tops that are full: what stands on them moves a little, and what comes is small.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/validate.h"

namespace fastscene::editing {
namespace {

// Points of a top at which a thing with this box lies on it altogether, the middle first; at most so many of them.
std::vector<Vec2f> spots_on(const Placed& top, const Surface& s, const Footprint& box, float step) {
    constexpr float kMostSpots = 250;
    const auto axes = axes_of(footprint_of(top));
    const float wide = s.half.x - extent(box, axes[0]), deep = s.half.y - extent(box, axes[1]);
    step = std::max(step, std::sqrt(std::max(0.f, 4 * wide * deep) / kMostSpots));
    std::vector<Vec2f> out;
    const Vec2f middle = flat(top.position) + axes[0] * s.center.x + axes[1] * s.center.z;
    for (float z = -deep; z <= deep + 1e-4f; z += step)
        for (float x = -wide; x <= wide + 1e-4f; x += step) out.push_back(middle + axes[0] * x + axes[1] * z);
    std::stable_sort(out.begin(), out.end(), [&](Vec2f a, Vec2f b) { return length(a - middle) < length(b - middle); });
    return out;
}

Footprint moved_to(Footprint box, Vec2f at) {
    box.center = at;
    return box;
}

// As high as things on this level may be: up to the next one.
float height_above(const Placed& top, const Surface& s) {
    constexpr float kThick = 0.03f, kUnlimited = 10;  // metres
    float out = kUnlimited;
    for (const Surface& other : top.piece.surfaces)
        if (other.center.y > s.center.y + kThick) out = std::min(out, other.center.y - s.center.y - kThick);
    return out;
}

// Where a screen stands on a desk: at the back, before its middle, towards whoever sits there.
struct TopPlace {
    Vec2f at;
    float yaw = 0;
};
bool has_screen(const Piece& piece) {
    return std::any_of(piece.materials.begin(), piece.materials.end(),
                       [](const Material& m) { return m.pattern == Pattern::screen; });
}
std::optional<TopPlace> screen_place(const std::vector<Placed>& all, int desk, const Surface& s, const Piece& screen) {
    const Placed& top = all[static_cast<std::size_t>(desk)];
    if (!has_role(top.piece.kind, Role::work_place) || !has_screen(screen)) return {};
    const Vec3f front = front_of(top.yaw);
    float side = 1;
    for (const Placed& seat : all)
        if (seat.with == desk && has_role(seat.piece.kind, Role::seat))
            side = dot(seat.position - top.position, front) < 0 ? -1.f : 1.f;
    constexpr float kFromBack_m = 0.03f;
    const float back = std::max(0.f, s.half.y - screen.size_m.z / 2 - kFromBack_m);
    const Vec3f at = top.position + right_of(top.yaw) * s.center.x + front * (s.center.z - side * back);
    return TopPlace{flat(at), yaw_of(front * side)};
}

class Top {
  public:
    Top(const std::vector<Placed>& all, int top, const Surface& s) : all_(all), top_(top), s_(s) {
        const float level = at().position.y + s.center.y;
        for (int i = 0; i < static_cast<int>(all.size()); ++i) {
            const Placed& p = all[static_cast<std::size_t>(i)];
            if (p.flat || i == top) continue;
            const bool rides = p.on == top && std::abs(p.position.y - level) < 0.01f;
            const bool carries = std::any_of(all.begin(), all.end(), [&](const Placed& q) { return q.on == i; });
            const bool stays = carries || has_role(p.piece.kind, Role::before_seats);
            (rides && !stays ? riders_ : others_).push_back(i);
        }
    }

    // With `p` on it, and what is in its way moved by as little as may be; nothing: it has no room. `aside`: metres off
    // the place, further off which it is not before whoever sits there.
    std::optional<Squeezed> with(Placed p, const std::optional<TopPlace>& rather = {}, float aside = 0.3f) const {
        constexpr std::size_t kMostMoved = 3;
        p.on = top_;
        p.position.y = at().position.y + s_.center.y;
        std::optional<Squeezed> best;
        float least = 1e9f;
        constexpr int kMostTries = 200;
        int tries = 0;
        std::vector<Vec2f> spots = spots_on(at(), s_, footprint_of(p), 0.04f);
        if (rather) {
            spots.insert(spots.begin(), rather->at);
            const auto off = [&](Vec2f spot) { return length(spot - rather->at); };
            std::erase_if(spots, [&](Vec2f spot) { return off(spot) > aside; });
            std::stable_sort(spots.begin(), spots.end(), [&](Vec2f a, Vec2f b) { return off(a) < off(b); });
        }
        for (const Vec2f spot : spots) {
            p.position.x = spot.x, p.position.z = spot.y;
            const Footprint box = footprint_of(p);
            if (reaches_into(others_, box)) continue;
            std::vector<int> blocked;
            for (const int i : riders_)
                if (overlap(box, footprint_of(thing(i)))) blocked.push_back(i);
            if (blocked.size() > kMostMoved) continue;
            Squeezed out{all_, blocked};
            out.all.push_back(p);
            float moved = 0;
            bool fine = true;
            for (std::size_t k = 0; k < blocked.size() && fine && moved < least; ++k) {
                if (++tries > kMostTries) return best;
                const auto by = make_room(out.all, blocked, k);
                fine = by.has_value();
                if (by) moved += *by;
            }
            if (fine && moved < least) least = moved, best = out;
            if (least == 0 || (rather && best)) break;
        }
        return best;
    }

  private:
    const Placed& at() const { return all_[static_cast<std::size_t>(top_)]; }
    const Placed& thing(int i) const { return all_[static_cast<std::size_t>(i)]; }
    bool reaches_into(const std::vector<int>& those, const Footprint& box) const {
        return std::any_of(those.begin(), those.end(), [&](int i) { return overlap(box, footprint_of(thing(i))); });
    }

    // To the nearest free spot; by how much.
    std::optional<float> make_room(std::vector<Placed>& all, const std::vector<int>& blocked, std::size_t k) const {
        constexpr float kFarthest = 0.6f;  // metres
        Placed& p = all[static_cast<std::size_t>(blocked[k])];
        const Vec2f from = footprint_of(p).center;
        std::vector<Vec2f> spots = spots_on(at(), s_, footprint_of(p), 0.03f);
        std::stable_sort(spots.begin(), spots.end(),
                         [&](Vec2f a, Vec2f b) { return length(a - from) < length(b - from); });
        for (const Vec2f spot : spots) {
            const float by = length(spot - from);
            if (by > kFarthest) return {};
            const Footprint box = moved_to(footprint_of(p), spot);
            if (reaches_into(others_, box) || overlap(box, footprint_of(all.back()))) continue;
            const bool free = std::none_of(riders_.begin(), riders_.end(), [&](int i) {
                // Those that are yet to be moved are in nobody's way.
                const auto turn = std::find(blocked.begin(), blocked.end(), i);
                if (turn != blocked.end() && turn - blocked.begin() >= static_cast<std::ptrdiff_t>(k)) return false;
                return overlap(box, footprint_of(all[static_cast<std::size_t>(i)]));
            });
            if (!free) continue;
            p.position.x += spot.x - from.x, p.position.z += spot.y - from.y;
            return by;
        }
        return {};
    }

    const std::vector<Placed>& all_;
    int top_;
    const Surface& s_;
    std::vector<int> riders_, others_;
};

// A screen on a desk at which one sits, and yet turned away or at its end.
bool is_screen_astray(const std::vector<Placed>& all) {
    const Placed& p = all.back();
    if (p.on < 0 || !has_screen(p.piece)) return false;
    const Placed& desk = all[static_cast<std::size_t>(p.on)];
    if (desk.piece.surfaces.empty()) return false;
    const auto place = screen_place(all, p.on, desk.piece.surfaces.front(), p.piece);
    constexpr float kAside_m = 0.35f, kTurned = 0.2f;  // radians
    return place && (length(flat(p.position) - place->at) > kAside_m ||
                     std::abs(std::remainder(p.yaw - place->yaw, 2 * kPi)) > kTurned);
}

}  // namespace

std::optional<Squeezed> Editor::squeezed_on_top(Layout& layout, const Placed* moving) const {
    const PromptObject& wish = layout.spec().objects[0];
    const bool fixed = moving || wish.size_m != Vec3f{};
    const std::set<std::string> before = fault_texts(layout.placed());
    for (const float scale : {1.f, 0.8f, 0.65f}) {
        if ((fixed || full_size_) && scale < 1) break;
        PieceRequest request = layout.request(moving ? wish.kind : small_form_of(wish.kind), &wish);
        request.size_factor *= scale;
        Placed p;
        p.piece = make_piece(request);
        p.wish = wish;
        if (p.piece.mount != Mount::surface) return {};
        for (int i = 0; i < static_cast<int>(layout.placed().size()); ++i) {
            const Placed& top = layout.placed()[static_cast<std::size_t>(i)];
            if (top.piece.kind != wish.relation_to && top.wish.kind != wish.relation_to) continue;
            for (const Surface& s : top.piece.surfaces) {
                if (p.piece.size_m.y > height_above(top, s)) continue;
                const auto rather = screen_place(layout.placed(), i, s, p.piece);
                for (const float turn : {0.f, kPi / 2}) {
                    if (rather && turn > 0) break;
                    p.yaw = rather ? rather->yaw : top.yaw + turn;
                    auto found = Top(layout.placed(), i, s).with(p, rather);
                    if (!found) continue;
                    const auto now = fault_texts(found->all);
                    if (std::includes(before.begin(), before.end(), now.begin(), now.end())) return found;
                }
            }
        }
    }
    return {};
}

bool Editor::add_on_top(const EditStep& step) {
    // A desk that was made for no screens has a form for as many: with a free back.
    for (int i = 0; i < static_cast<int>(room_.furnished.placed.size()) && step.wish.relation == "on"; ++i) {
        const Placed& desk = placed(i);
        const bool meant = step.at.empty()
                               ? asked_kind(desk) == step.wish.relation_to || desk.piece.kind == step.wish.relation_to
                               : is_among(desk.id, step.at);
        if (!meant || !has_role(desk.piece.kind, Role::work_place) || !desk.piece.made_from ||
            desk.piece.made_from->screens > 0 || desk.piece.surfaces.empty())
            continue;
        PromptSpec spec = room_.spec;
        Random rng(room_.seed, "screen");
        Layout layout(plan(), spec, rng);
        if (!layout.why_not(step.wish.kind).empty()) break;
        const Piece screen = make_piece(layout.request(step.wish.kind, &step.wish));
        if (screen.mount != Mount::surface || !has_screen(screen)) break;
        PieceRequest request = *desk.piece.made_from;
        if (!request.style) request.style = &plan().style;
        request.screens = std::clamp(step.wish.count, 1, kMostScreens);
        request.size_m = {desk.piece.size_m.x, 0, desk.piece.size_m.z}, request.size_factor = 1;
        const Piece made = make_piece(request);
        constexpr float kSame_m = 0.01f;
        const Vec3f more = made.size_m - desk.piece.size_m;
        if (made.surfaces.empty() || std::max(std::abs(more.x), std::abs(more.z)) > kSame_m ||
            std::abs(made.surfaces.front().half.x - desk.piece.surfaces.front().half.x) < kSame_m ||
            std::abs(made.surfaces.front().center.y - desk.piece.surfaces.front().center.y) > kSame_m)
            continue;  // its builder knows no screens
        const std::string id = desk.id;
        DocumentThing& t = thing(i);
        t.screens = request.screens, t.asked_size_m = request.size_m, t.size_m = made.size_m, t.size_factor = 1;
        build();
        tell(id, fmt::format("what lay in the middle of its top makes room for the {}", step.wish.words));
        break;
    }
    if (step.wish.relation != "on" || step.wish.count > 1 || step.on_floor || !noun_of(step.wish.relation_to).empty())
        return false;
    const auto fits_as_it_is = [&] {
        try {
            bool smaller = false;
            return !is_screen_astray(with_added(step, smaller));
        } catch (const Error&) {
            return false;
        }
    };
    struct FullSize {  // until the search is over, however it ends
        bool& on;
        explicit FullSize(bool& flag) : on(flag) { on = true; }
        ~FullSize() { on = false; }
    };
    std::optional<Squeezed> found;
    {
        const FullSize only(full_size_);
        if (fits_as_it_is()) return false;
        EditStep one = step;
        one.wish.count = 1;
        found = squeezed_in(without({}), one, nullptr, {.narrow = true, .pushes = true},
                            [](const Squeezed&) { return true; });
    }
    if (!found) return false;
    admit_squeezed(step, *found);
    return true;
}

std::vector<int> laid_before(const std::vector<Placed>& all, int table, int seat) {
    constexpr float kAside_m = 0.12f, kAhead_m = 0.45f, kTurned = 0.05f;  // radians: square to the seat
    std::vector<int> out;
    const Placed& s = all[static_cast<std::size_t>(seat)];
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        const Placed& p = all[static_cast<std::size_t>(i)];
        const Vec3f d = p.position - s.position;
        const bool square = std::abs(std::remainder(p.yaw - s.yaw, kPi)) < kTurned;
        if (p.on == table && has_role(p.piece.kind, Role::before_seats) && square &&
            std::abs(dot(d, right_of(s.yaw))) < kAside_m && dot(d, front_of(s.yaw)) < s.piece.size_m.z / 2 + kAhead_m &&
            dot(d, front_of(s.yaw)) > 0)
            out.push_back(i);
    }
    return out;
}

bool Editor::lay_before_seats(const EditStep& step) {
    if (step.wish.relation != "on" || !has_role(step.wish.kind, Role::before_seats)) return false;
    std::vector<std::pair<int, int>> bare;  // a table, and a seat at it
    bool seats = false;
    for (int i = 0; i < static_cast<int>(room_.furnished.placed.size()); ++i) {
        const Placed& table = placed(i);
        const bool meant = step.at.empty()
                               ? asked_kind(table) == step.wish.relation_to || table.piece.kind == step.wish.relation_to
                               : is_among(table.id, step.at);
        if (!meant || table.piece.surfaces.empty()) continue;
        for (const int seat : drawn_up_to(i)) {
            seats = true;
            if (laid_before(room_.furnished.placed, i, seat).empty()) bare.emplace_back(i, seat);
        }
    }
    if (!seats) return false;
    const int count = std::max(1, step.wish.count);
    int done = 0;
    for (const auto& [table, seat] : bare) {
        if (done == count) break;
        EditStep one = step;
        one.wish.count = 1;
        const Standing standing = without({});
        const auto usual = request_of_one(one, "laid", {});
        if (!usual) return false;
        const Placed& s = placed(seat);
        const Placed& top = placed(table);
        Placed fresh;
        fresh.wish = step.wish, fresh.wish.count = 1;
        std::optional<Squeezed> found;
        for (const float scale : {1.f, 0.8f, 0.65f}) {
            if (found) break;
            PieceRequest request = *usual;
            request.size_factor *= scale;
            fresh.piece = make_piece(request);
            constexpr float kInside_m = 0.02f, kAside_m = 0.1f;  // of the table's edge; off the middle of the seat
            const float reach = distance_to(footprint_of(top), flat(s.position)) + kInside_m + fresh.piece.size_m.z / 2;
            const TopPlace place{flat(s.position) + flat(front_of(s.yaw)) * reach,
                                 std::remainder(s.yaw + kPi, 2 * kPi)};
            fresh.yaw = place.yaw;
            found = Top(standing.placed, table, top.piece.surfaces.front()).with(fresh, place, kAside_m);
        }
        if (!found) continue;
        admit_squeezed(one, *found);
        ++done;
    }
    if (bare.empty()) throw Error("{}: before each seat there is one already", step.wish.words);
    if (done == 0) throw Error("{}: there is no room for it before a seat", step.wish.words);
    if (done < count)
        note(kNotDone, fmt::format("{}: there is room for {} of {} before the seats that have none", step.wish.words,
                                   done, count));
    return true;
}

bool Editor::screen_on_desk(Layout& layout) const {
    const PromptObject& wish = layout.spec().objects[0];
    const auto request = small_wished_on(layout);
    if (!request) return false;
    const Piece piece = make_piece(*request);
    for (int i = 0; i < static_cast<int>(layout.placed().size()); ++i) {
        const Placed desk = layout.placed()[static_cast<std::size_t>(i)];
        if ((desk.piece.kind != wish.relation_to && desk.wish.kind != wish.relation_to) || desk.piece.surfaces.empty())
            continue;
        const auto place = screen_place(layout.placed(), i, desk.piece.surfaces.front(), piece);
        if (!place) continue;
        const Vec2f along = flat(right_of(desk.yaw));
        for (const float aside : {0.f, 0.05f, -0.05f, 0.1f, -0.1f, 0.15f, -0.15f, 0.2f, -0.2f, 0.3f, -0.3f})
            if (layout.on_top_at(i, *request, place->at + along * aside, place->yaw, wish)) return true;
    }
    return false;
}

}  // namespace fastscene::editing
