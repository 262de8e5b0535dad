#include "fastscene/rooms/layout_place.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"

namespace fastscene::furnishing {

Placement::Placement(Layout& layout) : l_(layout), wishes_(layout.spec()), clutter_(layout.plan().style.clutter) {
    const PromptSpec& spec = l_.spec();
    if (spec.clutter == "cluttered" || spec.mood == "cozy") clutter_ = std::min(1.f, clutter_ + 0.3f);
    if (spec.clutter == "messy") clutter_ = 1.f;
    if (spec.clutter == "bare") clutter_ = 0.1f;
    if (is_left() || !is_furnished() || spec.clutter == "minimal") clutter_ = 0.f;
}

// An empty bus is one without people.
bool Placement::is_furnished() const {
    return l_.plan().cabin || !is_one_of(l_.spec().clutter, {"empty", "renovation"});
}
bool Placement::is_left() const { return is_one_of(l_.spec().clutter, {"abandoned", "moving"}); }

void Placement::place_the_rest() {
    adding_ = true;
    for (const auto& add : later_) add();
}

void Placement::later(std::function<void()> what) {
    if (adding_) what();
    else later_.push_back(std::move(what));
}

void Placement::put(const std::string& kind, float probability, const How& how, const Then& then) {
    if (wishes_.forbids(kind)) return;
    const PromptObject* wish = wishes_.next(kind);
    if (!wish && (!is_furnished() || is_settled(l_.spec(), kind))) return;
    // Who left took the pictures, and the plants have died; who likes few things has half of what others have.
    if (!wish && is_left() && has_role(kind, Role::moves_out)) return;
    if (!wish && l_.spec().clutter == "minimal") probability *= 0.5f;
    if (!wish && !adding_) {
        if (probability > 0) later_.push_back([=, this] { put(kind, probability, how, then); });
        return;
    }
    if (!wish && !chance(probability)) return;
    const auto index = how(l_.request(kind, wish), wish ? *wish : PromptObject{});
    if (!index) return wishes_.give_back(wish);
    attend(*index);
    if (then) then(*index);
}

std::optional<int> Placement::main(const std::string& kind, const How& how) {
    if (wishes_.forbids(kind)) return {};
    // Asked for at another piece ("a sofa opposite the fireplace"): that one first.
    for (const Ask& ask : wishes_.asks())
        if (ask.left > 0 && ask.wish->kind == kind && ask.at_piece() && ask.at != kind) {
            summon(std::string(ask.at));
            break;
        }
    for (std::size_t i = 0; i < l_.placed().size(); ++i)
        if (l_.placed()[i].wish.kind == kind) return static_cast<int>(i);
    const PromptObject* wish = wishes_.next(kind);
    if (!wish && !is_furnished()) return {};
    const auto index = how(l_.request(kind, wish), wish ? *wish : PromptObject{});
    if (index) attend(*index);
    else wishes_.give_back(wish);
    return index;
}

std::optional<int> Placement::main_at_wall(const std::string& kind, Layout::WallWish wish) {
    return main(kind, [&](const PieceRequest& r, const PromptObject& o) { return at_wall(r, wish, o); });
}

std::optional<int> Placement::at_wall(const PieceRequest& r, Layout::WallWish w, const PromptObject& o) {
    const Spare asked = spare_for(o.kind.empty() ? r.kind : o.kind);
    w.spare = {std::max(w.spare.left, asked.left), std::max(w.spare.right, asked.right),
               std::max(w.spare.front, asked.front), std::max(w.spare.behind, asked.behind),
               w.spare.above || asked.above};
    if (const auto i = l_.against_wall(r, w, o)) return i;
    if (r.pattern == "corner") {
        PieceRequest straight = r;
        straight.pattern.clear();
        if (const auto i = l_.against_wall(straight, w, o)) {
            l_.spec().assumed.push_back("shape of the " + o.words + ": straight, there is no room for its corner");
            return i;
        }
    }
    // Better below a window than not at all, when it was asked for.
    if (o.kind.empty() || !w.clear_of_windows) return {};
    w.clear_of_windows = false;
    return l_.against_wall(r, w, o);
}

void Placement::wall(const std::string& kind, float probability, Layout::WallWish w, const Then& then) {
    put(
        kind, probability, [=, this](const PieceRequest& r, const PromptObject& o) { return at_wall(r, w, o); }, then);
}

void Placement::beside(int anchor, const std::string& kind, float probability, int side, float gap, const Then& then) {
    put(
        kind, probability,
        [=, this](const PieceRequest& r, const PromptObject& o) { return l_.beside(anchor, r, side, gap, o); }, then);
}

void Placement::before(int anchor, const std::string& kind, float probability, float gap, bool facing,
                       const Then& then) {
    put(
        kind, probability,
        [=, this](const PieceRequest& r, const PromptObject& o) { return l_.in_front_of(anchor, r, gap, facing, o); },
        then);
}

void Placement::top(int anchor, const std::string& kind, float probability) {
    put(kind, probability, [=, this](const PieceRequest& r, const PromptObject& o) { return l_.on_top(anchor, r, o); });
}

void Placement::above(int anchor, const std::string& kind, float probability) {
    put(kind, probability,
        [=, this](const PieceRequest& r, const PromptObject& o) { return l_.on_wall(r, anchor, o); });
}

void Placement::on_wall(const std::string& kind, float probability) {
    put(kind, probability, [=, this](const PieceRequest& r, const PromptObject& o) { return l_.on_wall(r, {}, o); });
}

std::optional<int> Placement::laid_under(int anchor, PieceRequest r, Vec2f wanted, float shift, const PromptObject& o) {
    const float k = o.size == "large" ? 1.2f : o.size == "small" ? 0.75f : 1.f;
    for (const float shrink : {1.f, 0.8f, 0.6f}) {
        if (!(o.size_m.x > 0)) r.size_m = {wanted.x * k * shrink, 0, wanted.y * k * shrink};
        if (const auto i = l_.under(anchor, r, shift, o)) return i;
    }
    return {};
}

void Placement::rug(int anchor, float probability, float width, float depth, float shift) {
    put("rug", probability, [=, this](const PieceRequest& r, const PromptObject& o) {
        return laid_under(anchor, r, {width, depth}, shift, o);
    });
}

Vec2f Placement::front_point(int anchor, float far) const {
    return flat(at(anchor).position + front_of(at(anchor).yaw) * (size(anchor).z / 2 + far));
}

// The wall that a piece with this back faces: 0..3.
int Placement::wall_opposite(int anchor) const {
    const Vec3f front = front_of(at(anchor).yaw);
    int best = 0;
    for (int w = 1; w < 4; ++w)
        if (dot(l_.plan().wall(w).inward, front) < dot(l_.plan().wall(best).inward, front)) best = w;
    return best;
}

const PromptObject* Placement::seats_of_pattern(int table, const std::string& kind, int usual,
                                                const PromptObject* like) {
    if (wishes_.forbids(kind)) return nullptr;
    const PromptObject* wish = wishes_.count(kind) > 0 ? wishes_.next(kind) : nullptr;
    if (wish) wishes_.give_back(wish);
    if (!wish && !like && wishes_.asked(kind)) return nullptr;  // all that were asked for stand
    if (wish && wish->counted) {
        seats_around(table, kind, usual, 1);
        return nullptr;
    }
    if (!wish) {
        if (usual > 0) l_.around(table, l_.request(kind, like), usual);
        return like;
    }
    const int placed = l_.around(table, l_.request(kind, wish), std::max(usual, wishes_.count(kind)), *wish);
    for (int i = 0; i < placed && wishes_.count(kind) > 0; ++i) wishes_.next(kind);
    return placed > 0 ? wish : like;
}

void Placement::seats_around(int table, const std::string& kind, int usual, float probability) {
    const int wished = wishes_.count(kind);
    if (const PromptObject* wish = wished > 0 ? wishes_.next(kind) : nullptr) {
        const int placed = l_.around(table, l_.request(kind, wish), wished, *wish);
        for (int i = 1; i < std::min(placed, wished); ++i) wishes_.next(kind);
        if (placed == 0) wishes_.give_back(wish);
    } else if (usual > 0 && is_furnished() && !wishes_.asked(kind) && !wishes_.forbids(kind)) {
        const auto set = [=, this] { l_.around(table, l_.request(kind), usual); };
        if (probability >= 1) return set();
        later([=, this] {
            if (chance(probability)) set();
        });
    }
}

}  // namespace fastscene::furnishing
