// What hangs above a thing: over its middle, several in a row, on the wall behind it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene::editing {

bool hang_above(Layout& layout, const PromptObject& wish) {
    if (wish.relation != "above" || wish.count > 1 || !layout.why_not(wish.kind).empty()) return false;
    const PieceRequest request = layout.request(wish.kind, &wish);
    if (make_piece(request).mount != Mount::ceiling) return false;
    for (int i = 0; i < static_cast<int>(layout.placed().size()); ++i) {
        const Placed below = layout.placed()[static_cast<std::size_t>(i)];
        if (below.piece.kind != wish.relation_to && below.wish.kind != wish.relation_to) continue;
        const Vec3f half = below.piece.size_m * 0.5f;
        // The nearest to its middle that is free.
        constexpr float kOfHalf = 0.7f;
        constexpr int kSteps = 10;
        std::vector<Vec3f> offs;
        for (int x = -kSteps; x <= kSteps; ++x)
            for (int z = -kSteps; z <= kSteps; ++z)
                offs.push_back(right_of(below.yaw) * (kOfHalf * half.x * static_cast<float>(x) / kSteps) +
                               front_of(below.yaw) * (kOfHalf * half.z * static_cast<float>(z) / kSteps));
        // Along it rather than across.
        const Vec3f across = half.z > half.x ? right_of(below.yaw) : front_of(below.yaw);
        const auto off_middle_of = [&](Vec3f off) { return length(off) + std::abs(dot(off, across)); };
        std::stable_sort(offs.begin(), offs.end(),
                         [&](Vec3f a, Vec3f b) { return off_middle_of(a) < off_middle_of(b); });
        for (const Vec3f off : offs)
            if (const auto k = layout.hanging(request, flat(below.position + off), wish))
                return layout.join(*k, i), true;
    }
    return false;
}

// From the ceiling above a thing, side by side along it.
bool Editor::hang_in_row(Layout& layout) const {
    const PromptObject& wish = layout.spec().objects[0];
    if (wish.relation != "above" || wish.count < 2 || !layout.why_not(wish.kind).empty()) return false;
    const PieceRequest request = layout.request(wish.kind, &wish);
    const Piece piece = make_piece(request);
    if (piece.mount != Mount::ceiling) return false;
    const std::size_t before = layout.mark();
    for (int i = 0; i < static_cast<int>(before); ++i) {
        const Placed below = layout.placed()[static_cast<std::size_t>(i)];
        if (below.piece.kind != wish.relation_to && below.wish.kind != wish.relation_to) continue;
        const Vec3f size = below.piece.size_m;
        const Vec3f along = size.z > size.x ? front_of(below.yaw) : right_of(below.yaw);
        const float reach = std::max(size.x, size.z), wide = std::max(piece.size_m.x, piece.size_m.z);
        const auto count = static_cast<float>(wish.count);
        const Vec3f across = size.z > size.x ? right_of(below.yaw) : front_of(below.yaw);
        // Beams take lamps to them: first where all of them hang evenly, at one height.
        const auto hang = [&](float drop, float step, Vec3f aside, bool evenly) {
            constexpr float kEvenly = 0.02f, kTaken = 0.2f;  // metres
            Vec2f taken{};
            for (int n = 0; n < wish.count; ++n) {
                const Vec3f middle = below.position + along * ((static_cast<float>(n) - 0.5f * (count - 1)) * step);
                PieceRequest one = request;
                if (drop < 1) one.size_m = {piece.size_m.x, piece.size_m.y * drop, piece.size_m.z};
                const std::size_t mark = layout.mark();
                auto k = layout.hanging(one, flat(middle + aside), wish);
                // From a beam on a shorter cord: they end at one height.
                const float lower = k ? plan().ceiling_at(flat(middle + aside)) - layout.placed().back().position.y
                                      : 0.f;
                if (lower > kEvenly && request.size_m == Vec3f{}) {
                    layout.undo(mark);
                    one.size_m = {piece.size_m.x, piece.size_m.y * drop - lower, piece.size_m.z};
                    k = layout.hanging(one, flat(middle + aside), wish);
                }
                if (!k) break;
                layout.join(*k, i);
                const Placed &p = layout.placed().back(), &first = layout.placed()[before];
                const Vec2f by = flat(p.position) - flat(middle + aside);
                if (n == 0) taken = by;
                const float below_first = footprint_of(p).y0 - footprint_of(first).y0;
                if (evenly &&
                    (length(by - taken) > kEvenly || length(taken) > kTaken || std::abs(below_first) > kEvenly))
                    break;
                if (n + 1 == wish.count) return true;
            }
            layout.undo(before);
            return false;
        };
        std::vector<float> steps;
        for (const float part : {0.7f, 0.85f, 1.f, 0.55f})
            if (const float step = std::max(reach * part / count, wide + 0.05f);
                step * (count - 1) + wide <= reach + 0.4f)
                steps.push_back(step);
        // Higher, where something tall stands below them.
        for (const bool evenly : {true, false})
            for (const float off : {0.f, 0.08f, -0.08f, 0.15f, -0.15f, 0.22f, -0.22f})
                for (const float aside : {0.f, 0.05f, -0.05f, 0.1f, -0.1f, 0.2f, -0.2f})
                    for (const float drop : {1.f, 0.8f, 0.65f})
                        for (const float step : steps)
                            if ((drop == 1 || request.size_m == Vec3f{}) &&
                                hang(drop, step, along * aside + across * off, evenly))
                                return true;
        // Around what hangs there already.
        int done = 0;
        for (float at = -reach / 2 - 0.1f, last = -1e9f; at <= reach / 2 + 0.1f && done < wish.count; at += 0.05f) {
            if (at - last < wide + 0.08f) continue;
            const auto k = layout.hanging(request, flat(below.position + along * at), wish);
            if (!k) continue;
            layout.join(*k, i);
            last = at, ++done;
        }
        if (done == wish.count) return true;
        layout.undo(before);
    }
    return false;
}

// Lamps above a table where some hang: all of them in one row, for which those move a little. False: there is no room
// for that, or none hangs there.
bool Editor::add_into_row(const EditStep& step) {
    if (step.wish.relation != "above" || step.wish.count < 2) return false;
    std::vector<int> hanging;
    PromptObject above;
    above.id = -2;  // none of those that stand there
    above.relation = "above", above.relation_to = step.wish.relation_to;
    for (int i = 0; i < static_cast<int>(room_.furnished.placed.size()); ++i)
        if (placed(i).piece.mount == Mount::ceiling && asked_kind(placed(i)) == step.wish.kind &&
            stands_as_asked(plan(), room_.furnished.placed, placed(i), above).value_or(false))
            hanging.push_back(i);
    if (hanging.empty()) return false;
    const Standing standing = without(hanging);
    EditStep row = step;
    row.wish.count += static_cast<int>(hanging.size());
    std::vector<Placed> all = laid_out(standing, row, nullptr);
    if (all.size() != standing.placed.size() + static_cast<std::size_t>(row.wish.count)) return false;
    // Each of those that hang has the place nearest to it.
    for (const int i : hanging) {
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(standing.placed.size());
        const auto nearest = std::min_element(first, all.end(), [&](const Placed& a, const Placed& b) {
            return length(a.position - placed(i).position) < length(b.position - placed(i).position);
        });
        const float by = length(flat(nearest->position) - flat(placed(i).position));
        thing(i).position.x = nearest->position.x, thing(i).position.z = nearest->position.z;
        if (by > 0.01f) tell(thing(i).id, fmt::format("moved {:.2f} m into the row", by));
        all.erase(nearest);
    }
    const Standing rest = without({});
    std::vector<Placed> now = rest.placed;
    now.insert(now.end(), all.begin() + static_cast<std::ptrdiff_t>(standing.placed.size()), all.end());
    admit(now, rest, {place_in_words(step)});
    build();
    return true;
}

// Above what stands a way off its wall, as a bar does: on the wall behind it, in sight above it.
bool Editor::hang_behind(Layout& layout) const {
    const PromptObject& wish = layout.spec().objects[0];
    if (wish.relation != "above" || wish.count > 1 || !layout.why_not(wish.kind).empty()) return false;
    PieceRequest request = layout.request(wish.kind, &wish);
    if (make_piece(request).mount != Mount::wall) return false;
    constexpr float kFarthest = 2.5f, kAbove = 0.3f;  // metres
    for (int i = 0; i < static_cast<int>(layout.placed().size()); ++i) {
        const Placed below = layout.placed()[static_cast<std::size_t>(i)];
        if (below.piece.kind != wish.relation_to && below.wish.kind != wish.relation_to) continue;
        for (int w = 0; w < 4; ++w) {
            const WallFace face = plan().wall(w);
            const Vec3f to = below.position - face.origin;
            if (dot(face.inward, front_of(below.yaw)) < 0.9f || dot(to, face.inward) > kFarthest) continue;
            for (const float scale : {1.f, 0.8f, 0.6f})
                for (const float further : {0.f, 0.2f, -0.2f, 0.4f, -0.4f, 0.7f, -0.7f}) {
                    PieceRequest r = request;
                    r.size_factor *= scale;
                    Piece piece = make_piece(r);
                    if (std::abs(further) > below.piece.size_m.x / 2) continue;
                    // Higher than what stands at that wall.
                    const float least = std::max(piece.hang_height_m, footprint_of(below).y1 + kAbove);
                    for (const float up : {0.f, 0.15f, 0.3f, 0.45f, 0.6f}) {
                        piece.hang_height_m = least + up;
                        if (layout.hang_at(piece, w, dot(to, face.along) + further, wish)) return true;
                    }
                }
        }
    }
    return false;
}

}  // namespace fastscene::editing
