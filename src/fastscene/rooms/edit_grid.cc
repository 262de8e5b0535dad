// Things in rows, one behind the other: "arrange the chairs in two rows facing the screen".
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {
namespace {

// How far neighbors of a row and rows are from each other; tightly, where there is no more room.
struct Gaps {
    float beside, behind;  // metres
};
constexpr Gaps kGaps[] = {{0.3f, 0.7f}, {0.15f, 0.45f}, {0.06f, 0.3f}};

}  // namespace

// `count` rows that look along `step.yaw`, the first one in front; their middle is as near to the room's as may be.
void Editor::in_rows_of(const EditStep& step) {
    const auto rows = static_cast<std::size_t>(std::max(1, step.wish.count));
    if (step.ids.size() < 2 || rows > step.ids.size())
        throw UsageError("expected at least {} things for {} rows, found {}", std::max<std::size_t>(2, rows), rows,
                         step.ids.size());
    std::vector<int> moving, along;
    std::vector<std::vector<int>> seats;
    float wide = 0, ahead_of = 0, behind = 0;  // metres from a thing's middle, with who sits at it
    for (const std::string& id : step.ids) {
        moving.push_back(index_of(id));
        const Placed& p = placed(moving.back());
        if (p.piece.mount != Mount::floor) throw UsageError("{}: only what stands on the floor is set in rows", id);
        wide = std::max(wide, p.piece.size_m.x);
        seats.push_back(seats_at(moving.back()));
        along.insert(along.end(), seats.back().begin(), seats.back().end());
        std::vector<Footprint> boxes{footprint_of(p)};
        for (const int i : seats.back()) boxes.push_back(footprint_of(placed(i)));
        const Vec2f front = flat(front_of(p.yaw));
        for (const Footprint& box : boxes) {
            const float to = dot(box.center - flat(p.position), front), half = extent(box, front);
            ahead_of = std::max(ahead_of, to + half), behind = std::max(behind, half - to);
        }
    }
    const float deep = ahead_of + behind;
    std::vector<int> all = moving;
    all.insert(all.end(), along.begin(), along.end());
    // Whoever sits at a desk faces it.
    const bool sat_at = !along.empty() && std::all_of(moving.begin(), moving.end(), [&](int i) {
        return has_role(placed(i).piece.kind, Role::work_place);
    });
    const std::size_t columns = (moving.size() + rows - 1) / rows;
    const float yaw = step.yaw.value_or(0);
    const float turned = sat_at && step.centered ? std::remainder(yaw + kPi, 2 * kPi) : yaw;
    const Vec2f ahead = flat(front_of(yaw)), right = flat(right_of(yaw));
    const Vec2f wanted = step.position.value_or(Vec2f{0, 0});
    constexpr float kStep = 0.25f;  // metres
    std::vector<Vec2f> middles;
    for (float x = -plan().width / 2; x <= plan().width / 2; x += kStep)
        for (float z = -plan().depth / 2; z <= plan().depth / 2; z += kStep) middles.push_back({x, z});
    std::stable_sort(middles.begin(), middles.end(),
                     [&](Vec2f a, Vec2f b) { return length(a - wanted) < length(b - wanted); });
    for (const Gaps& gaps : kGaps) {
        int tries = 0;
        for (const Vec2f middle : middles) {
            std::vector<Pose> poses;
            bool free = true;
            for (std::size_t k = 0; k < moving.size() && free; ++k) {
                const auto row = static_cast<float>(k / columns), column = static_cast<float>(k % columns);
                const auto here = static_cast<float>(std::min(columns, moving.size() - k / columns * columns));
                const Vec2f at = middle + right * ((column - 0.5f * (here - 1)) * (wide + gaps.beside)) -
                                 ahead * ((row - 0.5f * static_cast<float>(rows - 1)) * (deep + gaps.behind));
                Placed there = placed(moving[k]);
                there.position = {at.x, there.position.y, at.y}, there.yaw = turned;
                free = stands_clear(moving[k], footprint_of(there), all) &&
                       seats_clear(moving[k], there, seats[k], all);
                poses.push_back({there.position, turned});
            }
            constexpr int kMostTries = 12;  // of places that look free: each is a room to be checked
            if (!free || ++tries > kMostTries) continue;
            try {
                return checked(
                    [&] {
                        for (std::size_t k = 0; k < moving.size(); ++k) {
                            thing(moving[k]).with.clear();
                            set_pose(moving[k], poses[k], seats[k]);
                        }
                    },
                    kNarrow);
            } catch (const Error&) {  // elsewhere, then
            }
        }
    }
    const auto n = static_cast<float>(columns), m = static_cast<float>(rows);
    throw Error("{}: there is no free floor for {} rows of {}; they take {:.1f} x {:.1f} m", step.ids.front(), rows,
                columns, n * wide + (n - 1) * kGaps[2].beside, m * deep + (m - 1) * kGaps[2].behind);
}

namespace {

// "In two rows" at `at`: how many; 0: no such words.
int rows_at(const Words& words, std::size_t at) {
    if (at + 2 < words.size() && words[at] == "in" && is_one_of(words[at + 1], {"a", "one"}) &&
        is_one_of(words[at + 2], {"row", "line"}) && has_word(words, {"facing", "towards", "toward"}))
        return 1;
    if (at + 2 >= words.size() || !is_one_of(words[at], {"in", "into"}) || words[at + 2] != "rows") return 0;
    const auto number = number_said(words[at + 1]);
    return number && *number >= 1 ? static_cast<int>(*number) : 0;
}

}  // namespace

void without_strangers(Talk& talk, std::vector<std::string>& ids) {
    constexpr std::size_t kMany = 4;  // times as many of one kind as of others
    for (const std::string& one : std::vector<std::string>(ids)) {
        const std::string& kind = talk.editor.placed(one).piece.kind;
        const auto is_other = [&](const std::string& id) { return talk.editor.placed(id).piece.kind != kind; };
        const auto others = static_cast<std::size_t>(std::count_if(ids.begin(), ids.end(), is_other));
        if (others == 0 || others * kMany > ids.size()) continue;
        for (const std::string& id : ids)
            if (is_other(id)) talk.editor.note(id, "stays: it is not of the kind of the others");
        std::erase_if(ids, is_other);
        return;
    }
}

// "The chairs in two rows facing the window", "eight mats in two rows"; false: no such words.
bool set_in_rows(Talk& talk, const Words& words) {
    std::size_t at = 1;
    while (at < words.size() && rows_at(words, at) == 0) ++at;
    if (parts_of(words).size() > 1) return false;
    Words things = part_of(words, 0, at), rest = part_of(words, at + 3);
    // "In three rows of four"
    if (rest.size() > 1 && rest.front() == "of" && number_said(rest[1])) rest = part_of(rest, 2);
    EditStep step;
    step.kind = EditStep::Kind::rows;
    step.wish.count = at < words.size() ? rows_at(words, at) : 1;
    // "A row of five mats in front of the bench"
    if (at >= words.size()) {
        // "Two rows of four desks facing the board": of those that are there.
        const auto number = number_said(words.front());
        const bool there = number && words.size() > 3 && words[1] == "rows" && words[2] == "of" && talk.said != "add";
        if (there) {
            const std::size_t end = next_place(words, 4);
            const auto each = number_said(words[3]);
            step.wish.count = static_cast<int>(*number);
            things = joined_words({"the"}, part_of(words, each ? 4 : 3, end));
            auto ids = talk.things_of_parts(joined_words({"all"}, things));
            const auto all = each ? static_cast<std::size_t>(*each * *number) : ids.size();
            if (all > ids.size()) throw UsageError("there are only {} of \"{}\"", ids.size(), text_of(things));
            ids.resize(all);
            step.ids = ids, rest = part_of(words, end);
        }
        const bool row = there || (words.size() > 4 && is_one_of(text_of(words, 0, 3), {"a row of", "one row of"}));
        const std::size_t place = next_place(words, 4);
        if (!there) things = part_of(words, 3, place), rest = part_of(words, place);
        if (!there && (!row || !number_said(things.front()) || things.size() < 2)) return false;
        const auto wishes = wishes_of(talk.editor, things);
        if (mount_of(talk.editor, wishes.front().kind) != Mount::floor) return false;
    }
    const std::size_t facing = find_word(rest, {"facing", "towards", "toward"});
    Words target = facing < rest.size() ? part_of(rest, facing + 1) : Words{};
    rest = part_of(rest, 0, facing);
    const auto act = [&] {
        if (!step.ids.empty()) {
            // said already
        } else if (begins_anew(things) && number_said(things.front()) && talk.said != "move") {
            add(talk, things);
            step.ids = talk.last;
        } else step.ids = talk.things_of_parts(things);
        const std::string kind = asked_kind(talk.editor.placed(step.ids.front()));
        if (!rest.empty()) {
            const auto place = place_of(talk.editor, rest, kind, step.ids.front());
            if (!place) throw UsageError("expected a place in the room, found \"{}\"", text_of(rest));
            const auto anchors = things_at(talk.editor, place->step);
            if (target.empty() && anchors.size() == 1) target = {anchors.front()};
            if (anchors.size() == 1) step.position = flat(talk.editor.placed(anchors.front()).position);
        }
        // The way they look: to what was said, else as the first of them does.
        step.yaw = talk.editor.placed(step.ids.front()).yaw;
        if (!target.empty()) step.yaw = talk.editor.way_to_face(step.ids, target), step.centered = true;
        without_strangers(talk, step.ids);
        talk.editor.apply(step);
        talk.last = step.ids;
    };
    talk.editor.together(act);
    return true;
}

// Square to the room, towards what words mean from where the things stand.
float Editor::way_to_face(const std::vector<std::string>& ids, const Words& target) const {
    Words at{"opposite"};
    const auto place = place_of(*this, joined_words(at, target), asked_kind(placed(ids.front())), ids.front());
    if (!place) throw UsageError("expected a thing or an opening to face, found \"{}\"", text_of(target));
    EditStep step = place->step;
    step.at = things_at(*this, place->step);
    const auto there = target_of(step, index_of(ids.front()));
    if (!there) throw UsageError("there is no {} in the room", in_words(step.wish.relation_to));
    Vec2f middle{};
    for (const std::string& id : ids)
        middle = middle + flat(placed(id).position) * (1 / static_cast<float>(ids.size()));
    const Vec2f way = *there - middle;
    constexpr float kQuarter = kPi / 2;
    return std::remainder(kQuarter * std::round(std::atan2(way.x, way.y) / kQuarter), 2 * kPi);
}

}  // namespace fastscene::editing
