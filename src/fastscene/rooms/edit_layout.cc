// Where things that are added or moved come to stand: searched for as for a prompt, among what stands.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/document_parts.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/tops.h"

namespace fastscene::editing {
namespace {

constexpr float kElsewhere = 0.7f;  // metres: nearer than that is the same place

}  // namespace

std::string place_in_words(const EditStep& step) {
    const PromptObject& wish = step.wish;
    if (step.wall >= 0) return " at that wall";
    if (step.elsewhere) return wish.relation == "in the corner" ? " in another corner" : " elsewhere";
    if (wish.relation.empty()) return "";
    if (wish.relation == "against" && wish.relation_to.empty()) return " at a wall";
    std::string out = " " + wish.relation;
    if (step.at.size() == 1) out += " " + step.at.front();
    else if (!wish.relation_to.empty()) out += " the " + in_words(wish.relation_to);
    if (step.at_and.size() == 1) out += " and " + step.at_and.front();
    else if (!wish.relation_and.empty()) out += " and the " + in_words(wish.relation_and);
    return out;
}

namespace {

// Places all over a top are tried.
bool set_down_on(Layout& layout, int top, const PieceRequest& request, const PromptObject& wish) {
    constexpr float kLevel = 0.01f, kFinest = 0.02f;  // metres
    constexpr float kMostPlaces = 300;
    const Placed t = layout.placed()[static_cast<std::size_t>(top)];
    // Made once: what stands in the way on the top is seen before it is made to stand there.
    Placed there;
    there.piece = make_piece(request), there.on = top;
    const Vec3f size = there.piece.size_m;
    const auto is_taken = [&](const Vec3f at, float yaw) {
        there.position = {at.x, t.position.y + t.piece.surfaces.front().center.y, at.z}, there.yaw = yaw;
        const Footprint box = footprint_of(there);
        for (int i = 0; i < static_cast<int>(layout.placed().size()); ++i)
            if (const Placed& p = layout.placed()[static_cast<std::size_t>(i)];
                i != top && !p.flat && !shelters(layout.placed(), i, there) && overlap(box, footprint_of(p)))
                return true;
        return false;
    };
    for (const bool across : {false, true})
        for (const Surface& s : t.piece.surfaces) {
            if (std::abs(s.center.y - t.piece.surfaces.front().center.y) > kLevel) continue;
            const float wide = s.half.x - (across ? size.z : size.x) / 2;
            const float deep = s.half.y - (across ? size.x : size.z) / 2;
            const float step = std::max(kFinest, std::sqrt(std::max(0.f, 4 * wide * deep) / kMostPlaces));
            for (float z = -deep; z <= deep + 1e-4f; z += step)
                for (float x = -wide; x <= wide + 1e-4f; x += step) {
                    const Vec3f at = t.position + right_of(t.yaw) * (s.center.x + x) +
                                     front_of(t.yaw) * (s.center.z + z);
                    const float yaw = t.yaw + (across ? kPi / 2 : 0);
                    if (!is_taken(at, yaw) && layout.on_top_at(top, request, flat(at), yaw, wish)) return true;
                }
        }
    return false;
}

// On a top that is almost full: smaller ones of its kind, and smaller than usual at last.
void fill_gap(Layout& layout, const PromptObject& wish, bool moving, bool full_size) {
    if (wish.relation != "on" || !layout.why_not(wish.kind).empty()) return;
    constexpr int kDraws = 6;
    const bool fixed = moving || wish.size_m != Vec3f{};
    for (const float scale : {1.f, 0.8f, 0.65f, 0.5f})
        for (int draw = 0; draw < (fixed ? 1 : kDraws); ++draw) {
            if ((fixed || full_size) && scale < 1) return;
            PieceRequest request = layout.request(fixed ? wish.kind : small_form_of(wish.kind), &wish);
            // On a small top a vase is a small one.
            const auto& classes = piece_classes();
            if (const std::string small = request.kind + "_small";
                !fixed && scale < 1 && !request.model && std::binary_search(classes.begin(), classes.end(), small))
                request.kind = small;
            request.size_factor *= scale;
            // No bench is made so small that it would stand on a table.
            if (scale < 1 && make_piece(request).mount == Mount::floor) return;
            for (int i = 0; i < static_cast<int>(layout.placed().size()); ++i) {
                const Placed& top = layout.placed()[static_cast<std::size_t>(i)];
                if ((top.piece.kind == wish.relation_to || top.wish.kind == wish.relation_to) &&
                    set_down_on(layout, i, request, wish))
                    return;
            }
        }
}

// Nothing comes along to carry it: no small table, no stand.
std::vector<PromptObject> wish_alone(const PromptObject& wish) {
    std::vector<PromptObject> out{wish};
    for (const char* kind : {"side_table", "nightstand", "tv_stand"}) {
        if (wish.kind == kind) continue;
        PromptObject none;
        none.kind = none.words = kind;
        none.forbidden = true;
        none.id = static_cast<int>(out.size());
        out.push_back(none);
    }
    return out;
}

// Whether it is among them.
template <class T>
bool has(const std::vector<T>& all, const T& one) {
    return std::find(all.begin(), all.end(), one) != all.end();
}

}  // namespace

Editor::Standing Editor::without(const std::vector<int>& gone) const {
    const std::vector<Placed>& all = room_.furnished.placed;
    Standing out;
    out.now.assign(all.size(), -1);
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        if (has(gone, i)) continue;
        out.now[static_cast<std::size_t>(i)] = static_cast<int>(out.placed.size());
        out.was.push_back(i);
        out.placed.push_back(placed(i));
    }
    for (Placed& p : out.placed)
        for (int* at : {&p.on, &p.below, &p.with})
            if (*at >= 0) *at = out.now[static_cast<std::size_t>(*at)];
    return out;
}

// A layout in which nothing comes that was not asked for.
Layout Editor::begin_layout(PromptSpec& spec, Random& rng, const std::vector<Placed>& standing,
                            const Placed* moving) const {
    spec.not_placed.clear();
    spec.clutter = "empty";
    Layout layout(plan(), spec, rng);
    layout.begin_with(standing);
    if (moving) layout.make_as(moving->piece.made_from);
    return layout;
}

std::optional<PieceRequest> Editor::request_of_one(const EditStep& step, const std::string& stream,
                                                   const std::vector<int>& like) const {
    EditStep one = step;
    one.wish.count = 1;
    const Standing standing = without({});
    Asked asked = asked_among(standing, one);
    Random rng(room_.seed, stream + ":" + step.wish.kind, standing.placed.size());
    Layout layout = begin_layout(asked.spec, rng, standing.placed, nullptr);
    const PromptObject& wish = asked.spec.objects[0];
    // As those that stand there, unless it was said how they look.
    const bool plain = wish.color.empty() && wish.material.empty() && wish.pattern.empty() && wish.size.empty();
    for (const int i : like)
        if (plain && asked_kind(placed(i)) == wish.kind) layout.make_as(placed(i).piece.made_from);
    if (!layout.why_not(wish.kind).empty()) return {};
    return layout.request(wish.kind, &wish);
}

// At one wall, or at the others than the present one, that opposite first; in a corner of them, where it was asked.
bool Editor::at_a_wall(Layout& layout, const EditStep& step, const Placed* moving) const {
    const PromptObject& wish = layout.spec().objects[0];
    if (!layout.why_not(wish.kind).empty()) return false;
    const PieceRequest request = layout.request(wish.kind, &wish);
    const Mount mount = make_piece(request).mount;
    if (mount == Mount::ceiling) return false;
    const bool corner = wish.relation == "in the corner";
    const int own = moving ? wall_behind(plan(), *moving) : -1;
    std::vector<int> walls{step.wall};
    if (step.wall < 0)
        walls = own < 0 ? std::vector<int>{0, 1, 3, 2}
                        : std::vector<int>{(own + 2) % 4, (own + 1) % 4, (own + 3) % 4, own};
    if (step.wall < 0 && step.elsewhere && !corner && own >= 0) walls.pop_back();
    if (step.opposite && own >= 0 && !corner) walls.resize(1);
    for (const int wall : walls) {
        if (mount == Mount::surface) {
            if (!corner && wish.relation_to != "wall" && on_top_at_wall(layout, wall)) return true;
            continue;
        }
        Layout::WallWish there{.wall = wall, .center_pull = 0.4f, .corner = corner};
        if (step.position) there.near = step.position, there.at_most_from_near = 1.3f;
        const std::size_t before = layout.mark();
        PromptObject as_said = wish;
        layout.insist(corner ? &as_said : nullptr);
        if (wish.count > 1 && !corner) {
            layout.insist(nullptr);
            if (several_at_wall(layout, wall)) return true;
            continue;
        }
        const auto found = layout.against_wall(request, there, wish);
        layout.insist(nullptr);
        if (!found) continue;
        const Vec2f to = footprint_of(layout.placed().back()).center;
        if (corner && !is_where_asked(plan(), layout.placed(), layout.placed().back(), wish)) {
            layout.undo(before);
            continue;
        }
        const Vec2f from = moving ? footprint_of(*moving).center : Vec2f{};
        const bool same_corner = corner && moving && from.x * to.x > 0 && from.y * to.y > 0;
        if (!step.elsewhere || !moving || (length(to - from) > kElsewhere && !same_corner)) return true;
        layout.undo(before);
    }
    return false;
}

// Side by side on one wall, about its middle; else each where there is room at it.
bool Editor::several_at_wall(Layout& layout, int wall) const {
    const PromptObject& wish = layout.spec().objects[0];
    std::vector<PieceRequest> requests;
    std::vector<Piece> pieces;
    for (int n = 0; n < wish.count; ++n) {
        requests.push_back(layout.request(wish.kind, &wish));
        pieces.push_back(make_piece(requests.back()));
    }
    const std::size_t before = layout.mark();
    const float length = plan().wall(wall).length;
    constexpr float kStep = 0.1f;  // metres
    for (const float gap : {0.3f, 0.15f, 0.08f}) {
        float total = -gap;
        for (const Piece& piece : pieces) total += piece.size_m.x + gap;
        for (int k = 0; pieces.front().mount == Mount::wall && kStep * static_cast<float>(k) < length - total; ++k) {
            const float off = kStep * static_cast<float>((k + 1) / 2) * (k % 2 == 0 ? 1.f : -1.f);
            float u = (length - total) / 2 + off;
            for (const Piece& piece : pieces) {
                if (!layout.hang_at(piece, wall, u + piece.size_m.x / 2, wish)) break;
                u += piece.size_m.x + gap;
            }
            if (layout.mark() == before + pieces.size()) return true;
            layout.undo(before);
        }
    }
    for (const PieceRequest& request : requests)
        if (!layout.against_wall(request, {.wall = wall, .center_pull = 0.4f}, wish)) return layout.undo(before), false;
    return true;
}

// Near a point, for what stands on the floor or hangs on a wall.
bool Editor::near_a_point(Layout& layout, const EditStep& step) const {
    constexpr float kReach = 1.2f;  // metres
    const PromptObject& wish = layout.spec().objects[0];
    const Layout::WallWish there{.near = step.position, .center_pull = 0, .at_most_from_near = kReach};
    if (!layout.why_not(wish.kind).empty()) return false;
    const PieceRequest request = layout.request(wish.kind, &wish);
    const Mount mount = make_piece(request).mount;
    return (mount == Mount::floor || mount == Mount::wall) && layout.against_wall(request, there, wish).has_value();
}

// By those names the layout finds them.
Editor::Asked Editor::asked_among(const Standing& standing, const EditStep& step) const {
    Asked out{room_.spec, standing.placed};
    out.spec.objects = wish_alone(step.wish);
    PromptObject& wish = out.spec.objects[0];
    wish.id = 0;
    if (is_one_of(wish.relation, {"on", "at the foot of"}))
        for (Placed& p : out.among)
            if (p.piece.kind == wish.relation_to || p.wish.kind == wish.relation_to) add_flat_top(p.piece);
    for (const auto& [ids, to, tag] :
         {std::tuple{&step.at, &wish.relation_to, "@at"}, {&step.at_and, &wish.relation_and, "@and"}}) {
        if (ids->empty()) continue;
        for (std::size_t i = 0; i < out.among.size(); ++i)
            if (has(*ids, result_.document.things[static_cast<std::size_t>(standing.was[i])].id))
                out.among[i].wish.kind = tag;
        *to = tag;
    }
    return out;
}

// Lays out what is wished for among what stands; `moving` is made as it was. Nothing: there is no place for all of it.
std::vector<Placed> Editor::laid_out(const Standing& standing, const EditStep& step, const Placed* moving,
                                     bool finely) const {
    auto [spec, among] = asked_among(standing, step);
    const PromptObject& wish = spec.objects[0];
    Random rng(room_.seed, "edit:" + wish.kind + wish.relation + step.wish.relation_to, among.size());
    Layout layout = begin_layout(spec, rng, among, moving);
    const std::size_t before = layout.mark();
    bool done = false;
    if (finely) {
        // the layout's own place was no good
    } else if (step.wall >= 0 || step.elsewhere || (step.position && wish.relation == "in the corner"))
        done = at_a_wall(layout, step, moving);
    else {
        if (step.position) done = stand_near(layout, step) || near_a_point(layout, step);
        if (!done)
            done = hang_above(layout, wish) || hang_in_row(layout) || pair_before(layout) || seats_in_row(layout) ||
                   on_flat(layout) || on_top_beside(layout) || at_the_ends(layout) ||
                   in_the_middle(layout, step, moving) || on_the_floor(layout, step) || screen_on_desk(layout);
        if (!done && wish.relation != kAtTheEnds && !step.on_floor && !sits_before_table(step.wish))
            place_asked(layout);
        if (layout.mark() == before || !is_where_asked(plan(), layout.placed(), layout.placed().back(), wish)) {
            layout.undo(before);
            fill_gap(layout, wish, moving != nullptr, full_size_);
        }
        done = layout.mark() >= before + static_cast<std::size_t>(std::max(1, wish.count)) &&
               std::all_of(layout.placed().begin() + static_cast<std::ptrdiff_t>(before), layout.placed().end(),
                           [&](const Placed& p) {
                               return p.wish.kind != wish.kind || is_where_asked(plan(), layout.placed(), p, wish);
                           });
    }
    constexpr float kThereabouts = 1.5f;  // metres
    if (done && step.position && wish.relation.empty() &&
        length(footprint_of(layout.placed().back()).center - *step.position) > kThereabouts)
        done = false;
    done = done && bring_nearer(layout, step, before) && !blocks_fronts(plan(), layout.placed(), before);
    constexpr float kSame = 2e-3f;  // metres
    if (done && moving && length(layout.placed().back().piece.size_m - moving->piece.size_m) > kSame) done = false;
    if (!done) {
        layout.undo(before);
        if (step.wall < 0 && !search_finely(layout, step) && !hang_behind(layout)) return {};
    }
    if (layout.mark() == before) return {};
    std::vector<Placed> out = layout.placed();
    for (std::size_t i = 0; i < before; ++i) out[i].wish = standing.placed[i].wish;
    for (std::size_t i = before; i < out.size(); ++i) {
        PromptObject& own = out[i].wish;
        if (own.kind != wish.kind) continue;
        own.relation_to = step.wish.relation_to, own.relation_and = step.wish.relation_and;
        own.count = 1;
    }
    return out;
}

}  // namespace fastscene::editing
