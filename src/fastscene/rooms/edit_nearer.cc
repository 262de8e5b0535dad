// Places as people mean them: close by, in a row, in the very place that was said.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene::editing {
namespace {

// A table or a cabinet, and nothing that one sits or lies on.
bool is_free_top(const Placed& p) {
    return p.on < 0 && !p.piece.surfaces.empty() && !has_role(p.piece.kind, Role::seat) &&
           !has_role(p.piece.kind, Role::bed) && !has_role(p.piece.kind, Role::no_top);
}

// How far a box is from the things of a kind, or from the middle between two of them.
float off_place(const std::vector<Placed>& all, const Footprint& box, const Placed* own, const PromptObject& wish) {
    if (wish.relation == "between") return off_middle(all, wish, box.center, own);
    float least = std::numeric_limits<float>::infinity();
    for (const Placed& a : all) {
        if (&a == own || (a.piece.kind != wish.relation_to && a.wish.kind != wish.relation_to)) continue;
        const Footprint there = footprint_of(a);
        const Vec2f to = there.center - box.center;
        const Vec2f way = length(to) > 1e-3f ? to * (1 / length(to)) : Vec2f{0, 1};
        least = std::min(least, distance_to(there, box.center) - extent(box, way));
    }
    return least;
}

}  // namespace

// The one small thing that is wished on another; nothing: the wish is a different one.
std::optional<PieceRequest> small_wished_on(Layout& layout) {
    const PromptObject& wish = layout.spec().objects[0];
    if (wish.relation != "on" || wish.count > 1 || !layout.why_not(wish.kind).empty()) return {};
    const PieceRequest request = layout.request(wish.kind, &wish);
    if (make_piece(request).mount != Mount::surface) return {};
    return request;
}

// On a rug: what is set on tops, and what stands.
bool Editor::on_flat(Layout& layout) const {
    const PromptObject& wish = layout.spec().objects[0];
    const auto request = small_wished_on(layout);
    if (!request) return false;
    for (int i = 0; i < static_cast<int>(layout.placed().size()); ++i) {
        const Placed rug = layout.placed()[static_cast<std::size_t>(i)];
        if (!rug.flat || (rug.piece.kind != wish.relation_to && rug.wish.kind != wish.relation_to)) continue;
        constexpr int kTries = 6;
        for (int k = 0; k < kTries; ++k) {
            const std::size_t before = layout.mark();
            if (!layout.on_floor_near(flat(rug.position), *request, wish)) continue;
            if (stands_as_asked(plan(), layout.placed(), layout.placed().back(), wish).value_or(false)) return true;
            layout.undo(before);
        }
    }
    return false;
}

// "A lamp next to the bed" stands on what is closest by, at the bed's head first.
bool Editor::on_top_beside(Layout& layout) const {
    constexpr float kBy = 0.35f, kHigh = 1.3f;  // metres
    const PromptObject& wish = layout.spec().objects[0];
    if (wish.relation != "next to" || wish.count > 1 || !layout.why_not(wish.kind).empty()) return false;
    const PieceRequest request = layout.request(wish.kind, &wish);
    if (make_piece(request).mount != Mount::surface) return false;
    std::vector<std::pair<float, int>> tops;
    const std::vector<Placed> all = layout.placed();
    for (const Placed& at : all) {
        if (at.on >= 0 || (at.piece.kind != wish.relation_to && at.wish.kind != wish.relation_to)) continue;
        for (int i = 0; i < static_cast<int>(all.size()); ++i) {
            const Placed& top = all[static_cast<std::size_t>(i)];
            if (&top == &at || !is_free_top(top) || top.piece.size_m.y > kHigh) continue;
            const Footprint box = footprint_of(top);
            const Vec2f to = flat(at.position) - box.center;
            const float off = distance_to(footprint_of(at), box.center) -
                              extent(box, to * (1 / std::max(1e-3f, length(to))));
            const bool bed = has_role(at.piece.kind, Role::bed);
            const float head = bed ? std::max(0.f, dot(box.center - flat(at.position), flat(front_of(at.yaw)))) : 0.f;
            if (off < kBy) tops.emplace_back(off + head, i);
        }
    }
    std::stable_sort(tops.begin(), tops.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return std::any_of(tops.begin(), tops.end(), [&](const auto& top) {
        return layout.on_top(top.second, request, wish).has_value() &&
               stands_as_asked(plan(), layout.placed(), layout.placed().back(), wish).value_or(false);
    });
}

// What needs a top, on one that stands at a wall.
bool Editor::on_top_at_wall(Layout& layout, int wall) const {
    const PromptObject& wish = layout.spec().objects[0];
    const PieceRequest request = layout.request(wish.kind, &wish);
    const auto count = static_cast<int>(layout.placed().size());
    for (int i = 0; i < count; ++i) {
        const Placed top = layout.placed()[static_cast<std::size_t>(i)];
        if (!is_free_top(top) || wall_behind(plan(), top) != wall) continue;
        if (layout.on_top(i, request, wish)) return true;
    }
    return false;
}

void Editor::tell_missing_corners(const EditStep& step, std::size_t added) {
    constexpr std::size_t kCorners = 4;
    if (added < kCorners)
        note(kNotDone, fmt::format("{} of {} corners have no room for a {}", kCorners - added, kCorners,
                                   in_words(step.wish.kind)));
}

// Seats before a table, a counter, an island: side by side, drawn up to it.
bool Editor::seats_in_row(Layout& layout) const {
    const PromptObject& wish = layout.spec().objects[0];
    const bool there = is_one_of(wish.relation, {"in front of", "next to", "behind"});
    if (!there || wish.count < 2 || !has_role(wish.kind, Role::sits_before)) return false;
    if (has_role(wish.kind, Role::easy_chair) || !layout.why_not(wish.kind).empty()) return false;
    const Piece piece = make_piece(layout.request(wish.kind, &wish));
    const std::size_t before = layout.mark();
    for (int i = 0; i < static_cast<int>(before); ++i) {
        const Placed table = layout.placed()[static_cast<std::size_t>(i)];
        if (table.piece.kind != wish.relation_to && table.wish.kind != wish.relation_to) continue;
        constexpr float kLow = 0.6f;  // metres: nobody sits at what is lower
        if (table.piece.surfaces.empty() || table.piece.size_m.y < kLow) continue;
        if (!has_role(table.piece.kind, Role::lamp_above) && !has_role(table.piece.kind, Role::work_place)) continue;
        std::vector<float> sides{1, -1};
        if (wish.relation == "behind") sides = {-1};
        if (wish.relation == "in front of") sides = {1, -1};
        const auto count = static_cast<float>(wish.count);
        for (const float side : sides)
            for (const float gap : {0.02f, 0.1f, 0.18f})
                for (const float share : {1.f, 0.8f, 0.6f}) {
                    const float step = std::max(table.piece.size_m.x * share / count, piece.size_m.x + 0.04f);
                    if (step * (count - 1) + piece.size_m.x > table.piece.size_m.x + 0.3f) continue;
                    const Vec3f out = front_of(table.yaw) *
                                      (side * (table.piece.size_m.z / 2 + gap + piece.size_m.z / 2));
                    for (int n = 0; n < wish.count; ++n) {
                        const float at = (static_cast<float>(n) - 0.5f * (count - 1)) * step;
                        const Vec3f to = table.position + out + right_of(table.yaw) * at;
                        const auto k = layout.stand_at(piece, flat(to), yaw_of(out * -1.f), wish, {});
                        if (!k) break;
                        layout.join(*k, i);
                    }
                    if (layout.mark() == before + static_cast<std::size_t>(wish.count)) return true;
                    layout.undo(before);
                }
    }
    return false;
}

// A pair that stands there already needs no other.
void Editor::check_no_pair(const EditStep& step) const {
    constexpr float kBy = 0.5f;  // metres
    const std::vector<Placed>& all = room_.furnished.placed;
    for (const Placed& at : all) {
        if (asked_kind(at) != step.wish.relation_to && at.piece.kind != step.wish.relation_to) continue;
        if (!step.at.empty() && std::find(step.at.begin(), step.at.end(), at.id) == step.at.end()) continue;
        std::string left, right;
        for (const Placed& p : all) {
            if (p.piece.kind != step.wish.kind && asked_kind(p) != step.wish.kind) continue;
            const Vec3f d = p.position - at.position;
            const Footprint box = footprint_of(p);
            if (distance_to(footprint_of(at), box.center) - std::max(box.half.x, box.half.y) > kBy) continue;
            (dot(d, right_of(at.yaw)) > 0 ? right : left) = p.id;
        }
        if (!left.empty() && !right.empty())
            throw AlreadySo(
                fmt::format("{}: {} and {} stand on both sides of {} already", step.wish.words, left, right, at.id));
    }
}

// What needs no wall, about the point where it was asked: "put a beanbag there".
bool Editor::stand_near(Layout& layout, const EditStep& step) const {
    constexpr int kRings = 8, kWaysAround = 12;
    constexpr float kFarthest = 0.9f;  // metres: further off it is not there
    const PromptObject& wish = layout.spec().objects[0];
    if (!step.position || wish.count > 1 || !layout.why_not(wish.kind).empty()) return false;
    const Piece piece = make_piece(layout.request(wish.kind, &wish));
    if (piece.mount != Mount::floor || piece.against_wall) return false;
    const Vec2f to_middle = *step.position * -1.f;
    const float yaw = step.yaw.value_or(std::atan2(to_middle.x, to_middle.y));
    for (int ring = 0; ring <= kRings; ++ring)
        for (int way = 0; way < (ring == 0 ? 1 : kWaysAround); ++way) {
            const float angle = 2 * kPi * static_cast<float>(way) / kWaysAround;
            const Vec2f at = *step.position +
                             Vec2f{std::sin(angle), std::cos(angle)} * (kFarthest * static_cast<float>(ring) / kRings);
            if (layout.stand_at(piece, at, yaw, wish, {})) return true;
        }
    return false;
}

// Where a fine grid has a place closer to what was said than the layout's own, there. False: it stands nowhere now.
bool Editor::bring_nearer(Layout& layout, const EditStep& step, std::size_t before) const {
    constexpr float kClose = 0.3f, kGain = 0.15f;  // metres
    const PromptObject wish = layout.spec().objects[0];
    if (wish.count > 1 || layout.mark() != before + 1 ||
        !is_one_of(wish.relation, {"next to", "behind", "in front of", "left of", "right of", "between"}))
        return true;
    const Placed found = layout.placed().back();
    if (found.piece.mount != Mount::floor || found.flat) return true;
    if (found.with >= 0 && has_role(found.piece.kind, Role::seat)) return true;  // drawn up
    const auto off = [&] {
        return off_place(layout.placed(), footprint_of(layout.placed().back()), &layout.placed().back(), wish);
    };
    const float now = off();
    // Off a seat's front is less beside it than at an arm.
    const bool ahead = is_ahead_of_seat(layout.placed(), wish, layout.placed().back());
    if (std::isinf(now) || (now < kClose && !ahead)) return true;
    layout.undo(before);
    if (search_finely(layout, step)) {
        if (off() < now - kGain) return true;
        if (ahead && !is_ahead_of_seat(layout.placed(), wish, layout.placed().back())) return true;
        layout.undo(before);
    }
    const auto again = layout.stand_at(found.piece, flat(found.position), found.yaw, wish, {});
    if (again && found.with >= 0) layout.join(*again, found.with);
    return again.has_value();
}

// Side by side, backs to one wall; the middle of the wall first.
void Editor::line_up(const EditStep& step) {
    if (step.ids.size() < 2) throw UsageError("expected several things to line up, found {}", step.ids.size());
    std::vector<int> moving;
    for (const std::string& id : step.ids) {
        moving.push_back(index_of(id));
        if (placed(moving.back()).piece.mount != Mount::floor || placed(moving.back()).flat)
            throw UsageError("{}: only what stands on the floor is lined up at a wall", id);
    }
    const Standing standing = without(with_riders(moving));
    PromptSpec spec = room_.spec;
    spec.objects = {};
    Random rng(room_.seed, "line");
    Vec2f middle{};
    for (const int i : moving) middle = middle + flat(placed(i).position) * (1.f / static_cast<float>(moving.size()));
    std::vector<int> walls{0, 1, 2, 3};
    if (step.wall >= 0) walls = {step.wall};
    std::stable_sort(walls.begin(), walls.end(), [&](int a, int b) {
        const auto off = [&](int w) { return dot(middle - flat(plan().wall(w).origin), flat(plan().wall(w).inward)); };
        return off(a) < off(b);
    });
    std::string fault;
    for (const int w : walls)
        for (const float gap : {0.15f, 0.08f, 0.03f}) {
            const WallFace face = plan().wall(w);
            float total = -gap;
            for (const int i : moving) total += placed(i).piece.size_m.x + gap;
            std::vector<float> starts;
            for (float u = 0; u + total <= face.length; u += 0.1f) starts.push_back(u);
            std::stable_sort(starts.begin(), starts.end(), [&](float a, float b) {
                const float half = (face.length - total) / 2;
                return std::abs(a - half) < std::abs(b - half);
            });
            for (const float start : starts) {
                Layout layout = begin_layout(spec, rng, standing.placed, nullptr);
                std::vector<Pose> poses;
                float u = start;
                for (const int i : moving) {
                    const Piece& piece = placed(i).piece;
                    const Vec3f at = face.point(u + piece.size_m.x / 2, 0) + face.inward * (piece.size_m.z / 2 + 0.03f);
                    const float yaw = std::atan2(face.inward.x, face.inward.z);
                    if (!layout.stand_at(piece, flat(at), yaw, {}, {})) break;
                    poses.push_back({{at.x, placed(i).position.y, at.z}, yaw});
                    u += piece.size_m.x + gap;
                }
                if (poses.size() != moving.size()) continue;
                try {
                    checked([&] {
                        for (std::size_t k = 0; k < moving.size(); ++k) {
                            thing(moving[k]).with.clear();
                            set_pose(moving[k], poses[k], {});
                        }
                    });
                    return;
                } catch (const Error& e) {
                    if (fault.empty()) fault = e.what();
                }
            }
        }
    throw Error("{}: there is no free wall along which all {} of them could stand{}{}", step.ids.front(),
                step.ids.size(), fault.empty() ? "" : ": ", fault);
}

}  // namespace fastscene::editing
