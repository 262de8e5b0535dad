// Two seats before a fireplace or another thing: a pair, one on each side of its middle.
#include <algorithm>
#include <set>
#include <cmath>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {
namespace {

// Where the first of a pair stands, its like across the middle: metres before the thing and off its middle.
struct PairSpot {
    float ahead, aside;
};
std::vector<PairSpot> pair_spots(const Piece& piece, bool close) {
    const float half = std::max(piece.size_m.x, piece.size_m.z) / 2;
    std::vector<PairSpot> out;
    for (const float ahead :
         close ? std::vector<float>{0.6f, 0.5f} : std::vector<float>{0.95f, 0.8f, 1.1f, 1.3f, 0.65f})
        for (const float aside : {0.4f, 0.55f, 0.3f, 0.7f, 0.2f, 0.9f}) out.push_back({ahead + half, aside + half});
    return out;
}

}  // namespace

// Turned to it, both alike. False: there is no room for that, or the wish is another one.
bool Editor::pair_before(Layout& layout) const {
    const PromptObject& wish = layout.spec().objects[0];
    if (wish.count != 2 || !has_role(wish.kind, Role::seat) || !layout.why_not(wish.kind).empty()) return false;
    const bool close = wish.relation == "next to";
    if (!close && !is_one_of(wish.relation, {"in front of", "opposite", "facing"})) return false;
    const Piece piece = make_piece(layout.request(wish.kind, &wish));
    if (piece.mount != Mount::floor) return false;
    const std::size_t before = layout.mark();
    const std::set<std::string> faults = fault_texts(layout.placed());
    for (int i = 0; i < static_cast<int>(before); ++i) {
        const Placed at = layout.placed()[static_cast<std::size_t>(i)];
        if (at.piece.kind != wish.relation_to && at.wish.kind != wish.relation_to) continue;
        const bool table = is_sat_at(at.piece.kind);
        if (table || at.flat || at.on >= 0 || (close && !has_role(at.piece.kind, Role::focus))) continue;
        // Off the middle, where it stands close to a corner.
        for (const float off : {0.f, 0.3f, -0.3f, 0.6f, -0.6f})
            for (const PairSpot& spot : pair_spots(piece, close)) {
                for (const float side : {1.f, -1.f}) {
                    const Vec3f to = at.position + front_of(at.yaw) * (at.piece.size_m.z / 2 + spot.ahead) +
                                     right_of(at.yaw) * (side * spot.aside + off);
                    // Sofas face each other, chairs the middle of what they stand before.
                    const Vec3f ahead = has_role(wish.kind, Role::sofa) ? right_of(at.yaw) * -side : at.position - to;
                    if (!layout.stand_at(piece, flat(to), yaw_of(Vec3f{ahead.x, 0, ahead.z}), wish, {})) break;
                }
                if (layout.mark() == before + 2) {
                    const auto now = fault_texts(layout.placed());
                    if (std::includes(faults.begin(), faults.end(), now.begin(), now.end())) return true;
                }
                layout.undo(before);
            }
    }
    return false;
}

// What was asked for before a thing as a pair, and stands there one by one.
void Editor::tell_uneven_pair(const std::vector<std::string>& ids, const EditStep& step) {
    if (ids.size() != 2 || !has_role(step.wish.kind, Role::seat)) return;
    if (!is_one_of(step.wish.relation, {"in front of", "opposite", "facing"}) ||
        !noun_of(step.wish.relation_to).empty())
        return;
    constexpr float kEvenly = 0.3f;  // metres
    const Vec3f middle = (placed(ids[0]).position + placed(ids[1]).position) * 0.5f;
    for (const std::string& id : things_at(*this, step)) {
        const Placed& at = placed(id);
        const Vec3f along = right_of(at.yaw), ahead = front_of(at.yaw);
        const auto row = dot(placed(ids[0]).position - placed(ids[1]).position, ahead);
        if (std::abs(dot(middle - at.position, along)) < kEvenly && std::abs(row) < kEvenly) return;
        if (is_sat_at(at.piece.kind)) return;
    }
    tell(ids[1], "not side by side with " + ids[0] + ": there was no room for a pair before its middle");
}

// The second next to the first, or as near as they come from where they stand.
bool put_together(Talk& talk, const std::vector<std::string>& ids) {
    constexpr float kTogether = 0.35f;  // metres
    const auto off = [&] { return gap_between_edges(talk.editor.placed(ids[0]), talk.editor.placed(ids[1])); };
    if (off() < 0.02f) throw AlreadySo(ids[1] + ": it stands there already");
    // Straight up to it, where nothing stands between them; else beside it.
    const Vec3f to = talk.editor.placed(ids[0]).position - talk.editor.placed(ids[1]).position;
    EditStep step;
    step.kind = EditStep::Kind::shift;
    step.ids = {ids[1]};
    step.by = Vec3f{to.x, 0, to.z} * ((off() - 0.01f) / std::max(0.01f, length(Vec3f{to.x, 0, to.z})));
    step.exactly = true;
    try {
        talk.editor.apply(step);
        return true;
    } catch (const Error&) {
    }
    step = {};
    step.kind = EditStep::Kind::place;
    step.wish.relation = "next to", step.wish.relation_to = talk.editor.placed(ids[0]).piece.kind;
    step.ids = {ids[1]}, step.at = {ids[0]};
    talk.editor.together([&] {
        try {
            talk.editor.apply(step);
        } catch (const AlreadySo&) {
            throw Error("{}: something stands between it and {}", ids[1], ids[0]);
        }
        if (off() > kTogether) throw Error("{}: there is no free place for it close to {}", ids[1], ids[0]);
    });
    return true;
}

std::vector<std::string> without_companions(const Editor& editor, const std::vector<std::string>& ids) {
    std::vector<std::string> out;
    for (const std::string& id : ids) {
        const Placed& p = editor.placed(id);
        const bool along = p.with >= 0 && has_role(p.piece.kind, Role::seat) &&
                           is_among(editor.document().things[static_cast<std::size_t>(p.with)].id, ids);
        if (!along) out.push_back(id);
    }
    return out;
}

}  // namespace fastscene::editing
