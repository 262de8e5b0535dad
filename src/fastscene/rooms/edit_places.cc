// Where words say that a thing is to stand, against what there is in the room.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/tops.h"

namespace fastscene::editing {
namespace {

// "it", "them", "each of them"
bool is_pronoun(const Words& words) {
    return std::all_of(words.begin(), words.end(),
                       [](const std::string& w) {
                           return is_one_of(w, {"it", "them", "that", "those", "these", "this", "each", "both", "of"});
                       }) &&
           !words.empty() && words.front() != "of";
}

bool is_part_of_it(const std::string& word) {
    return is_one_of(word, {"foot", "side", "sides", "end", "ends", "left", "right", "head"});
}

class Reader {
  public:
    Reader(const Editor& editor, const Words& words, const std::string& kind, const std::string& mover,
           const std::vector<std::string>& spoken)
        : editor_(editor), words_(words), kind_(kind), mover_(mover), spoken_(spoken), moving_(!mover.empty()) {
        std::erase(spoken_, mover_);
        // "at its foot" is at the foot of it.
        const std::size_t its = find_word(words_, {"its", "their"});
        if (its > 0 && its + 1 < words_.size() && is_part_of_it(words_.back())) {
            if (is_one_of(words_.back(), {"left", "right"}) && is_one_of(words_[its - 1], {"on", "at", "to"}))
                words_[its - 1] = "to";
            words_[its] = "the";
            if (words_.back() == "head") words_ = {"next", "to"};
            else words_.push_back("of");
            words_.push_back("it");
        } else if (words_.size() > 2 && !spoken_.empty() && is_part_of_it(words_.back()) &&
                   is_one_of(words_[words_.size() - 2], {"each", "both", "either"})) {
            words_.push_back("of"), words_.push_back("it");  // "a chair at each end"
        }
    }

    std::optional<Place> read() {
        std::size_t at = 0;
        while (at + 1 < words_.size() && is_one_of(words_[at], {"right", "directly", "just", "straight", "somewhere"}))
            ++at;
        if (at < words_.size() && is_one_of(words_[at], {"somewhere", "elsewhere"})) return elsewhere();
        const auto relation = relation_at(words_, at);
        // "to" and the like before a part of the room, before longer terms of the lexicon: "in the far corner".
        for (std::size_t i = at; i < std::min(words_.size(), at + 3); ++i) {
            if (!relation_at(part_of(words_, i, i + 1), 0)) break;
            const auto part = room_part(words_, i + 1);
            const bool sides = relation && relation->name == "on both sides of";  // "to either side of the door"
            const bool before = relation && relation->name == "in front of";
            if (!part || ((i > at || sides || before) && relation && relation->next > i + 1)) continue;
            const auto short_one = relation_at(part_of(words_, at, i + 1), 0);
            if (short_one && short_one->next == i + 1 - at && short_one->name != "between")
                if (auto place = at_part(short_one->name, *part)) return place;
        }
        if (!relation) return {};
        if (relation->next < words_.size() && relation->name != "between")
            if (const auto part = room_part(words_, relation->next))
                if (auto place = at_part(relation->name, *part)) return place;
        return at_thing(*relation);
    }

  private:
    // The things that words mean, of any kind.
    std::vector<int> those(const Words& words) const {
        std::vector<int> out;
        if (is_one_of(text_of(words), {"one of them", "one of those", "either of them"}) && !spoken_.empty())
            return {editor_.index_of(spoken_.front())};
        if (!is_pronoun(words)) out = all_named(editor_, text_of(words));
        else if (spoken_.empty()) throw UsageError("what is \"{}\"? nothing was named before", text_of(words));
        else
            for (const std::string& id : spoken_) out.push_back(editor_.index_of(id));
        if (out.empty()) named(editor_, text_of(words));  // says so
        return out;
    }
    Place place(const std::string& relation, const std::string& to = {}) const {
        Place out;
        out.step.wish.relation = relation, out.step.wish.relation_to = to;
        return out;
    }
    std::optional<Place> elsewhere() const {
        Place out = place("");
        out.step.elsewhere = true;
        return out;
    }

    std::optional<Place> at_part(const std::string& relation, const Part& part) {
        const Words rest = part_of(words_, part.next);
        const bool of_room = rest.empty() || (rest.front() == "of" && noun_of(rest.back()) == "room");
        if (part.noun == "corner") return at_corner(part, rest);
        if (part.noun == "middle" && of_room) return place("in the middle");
        // "A chair at each end": of what?
        if (part.noun == "side" && rest.empty() && part.says({"each", "both", "either", "sides"})) return {};
        if (part.noun == "side" && of_room) {
            auto out = at_wall(part, {});
            // "The far end" of what needs no wall is before that.
            constexpr float kBefore = 1.1f;  // metres
            if (out && out->step.wall >= 0 && moving_ && !editor_.placed(mover_).piece.against_wall &&
                editor_.placed(mover_).piece.mount == Mount::floor) {
                const WallFace face = editor_.plan().wall(out->step.wall);
                out->step.position = flat(face.point(face.length / 2, 0) + face.inward * kBefore);
                out->step.wall = -1, out->step.wish.relation.clear();
            }
            return out;
        }
        // "on the other side of the sofa"
        if (const auto opening = part.noun == "side" && rest.size() > 1 && rest.front() == "of" ? room_part(rest, 1)
                                                                                                : std::nullopt;
            opening && opening->next == rest.size() && is_one_of(opening->noun, {"window", "door", "doorway"})) {
            auto beside = at_opening(part.says({"each", "both", "either", "sides"}) ? "on both sides of" : "next to",
                                     *opening);
            if (beside && moving_ && part.is_other())
                beside->step.position = beyond_opening(editor_, beside->step.wish.relation_to, mover_);
            return beside;
        }
        if (part.noun == "side" && rest.size() > 1 && rest.front() == "of" && !part.says({"left", "right"})) {
            auto beside = at_thing({"next to", part.next + 1});
            if (beside && part.is_other()) free_side(*beside);
            if (beside) at_both(*beside, part);
            return beside;
        }
        if (part.noun == "wall") return at_wall(part, rest, relation);
        // "on the floor next to the dresser"
        if (part.noun == "floor" && !rest.empty()) {
            auto out = Reader(editor_, rest, kind_, mover_, spoken_).read();
            if (out) out->step.on_floor = mount_of(editor_, kind_) == Mount::surface;
            return out;
        }
        if (!rest.empty()) return {};
        if (part.noun == "floor") return place("on", "floor");
        if (part.noun == "ceiling" || part.noun == "room") return place("");
        if (part.noun == "middle" || part.noun == "side") return {};
        return at_opening(relation, part);
    }

    std::optional<Place> at_opening(const std::string& relation, const Part& part) {
        const std::string kind = opening_there(editor_.plan(), part.noun);
        const bool small = furnishing::is_small(kind_);
        // Curtains and blinds hang at windows wherever they come.
        const bool hung = has_role(kind_, Role::blind) ||
                          (has_role(kind_, Role::soft) && mount_of(editor_, kind_) == Mount::wall);
        if (kind == "window" && hung && !moving_) return place("");
        if (kind == "window" && (part.says({"sill"}) || (small && is_one_of(relation, {"in", "on", "at", "to"}))))
            return place("on", "window");
        const bool at_it = is_one_of(relation, {"to", "at", "in", "on", "from", "against", "along"});
        Place out = place(at_it ? "next to" : relation, kind);
        // Furniture that is moved against a window stands below it, with nothing between.
        if (relation == "against" && kind == "window" && moving_ && !editor_.placed(mover_).flat &&
            editor_.placed(mover_).piece.mount == Mount::floor)
            out.step.wish.relation = "under";
        out.step.position = which_opening(editor_, part, kind);
        if (kind == "window" && is_one_of(relation, {"to", "at"}) && moving_ && !out.step.position)
            out.step.position = before_opening(editor_, kind, mover_);
        if (relation == "on both sides of") out.count = 2;
        return out;
    }

    std::optional<Place> at_corner(const Part& part, const Words& rest) {
        Place out = place("in the corner");
        out.step.elsewhere = moving_ && part.is_other();
        out.step.each = !moving_ && part.says({"each", "every", "all"});
        std::optional<Vec2f> near;
        if (const auto direction = direction_said(editor_, part)) near = flat(*direction) * 100.f;
        if (moving_ && part.says({"opposite"})) {
            near = footprint_of(editor_.placed(mover_)).center * -100.f;
            out.step.elsewhere = false;
        }
        // "The far corner" is the freer of two.
        if (near && rest.empty() && part.says({"left", "right"}) != part.says({"far", "back", "near", "front"}))
            near = freer_corner(editor_, *near, mover_);
        const bool off = is_one_of(rest.empty() ? "" : rest.front(), {"furthest", "farthest", "away", "far"});
        if (rest.size() > 2 && (off || is_one_of(rest.front(), {"closest", "nearest"}))) {
            Words at = rest;
            if (at[1] == "away") at.erase(at.begin());  // "farthest away from"
            at[0] = "next", at[1] = "to";
            near = point_of(at);
            if (near && off) near = *near * -1.f;
        } else if (!rest.empty() && rest.front() != "of") near = point_of(rest);
        if (near && !rest.empty() && rest.front() == "opposite") near = *near * -1.f;
        if (!rest.empty() && rest.front() != "of" && !near) return {};
        if (near && !rest.empty() && room_part(rest, 1).has_value())
            near = freer_of_two_corners(editor_, *near, mover_);
        if (near) {
            const auto corners = corners_of_room(editor_.plan());
            out.step.position = *std::min_element(corners.begin(), corners.end(), [&](Vec2f a, Vec2f b) {
                return length(a - *near) < length(b - *near);
            });
        }
        return out;
    }
    // Where "by the window", "next to the bed" is.
    std::optional<Vec2f> point_of(const Words& words) {
        const auto relation = relation_at(words, 0);
        if (!relation) return {};
        const Words there = part_of(words, relation->next);
        if (const auto part = room_part(there, 0)) {
            for (const Opening& o : editor_.plan().openings)
                if (is_opening_of(o, part->noun)) return flat(editor_.plan().wall(o.wall).point((o.u0 + o.u1) / 2, 0));
            return {};
        }
        const auto found = is_pronoun(there) ? those(there) : all_named(editor_, text_of(there));
        if (found.empty()) return {};
        return flat(editor_.room().furnished.placed[static_cast<std::size_t>(found.front())].position);
    }

    bool hangs() const { return mount_of(editor_, kind_) == Mount::wall || kind_ == "tv"; }

    // "the wall opposite the bed", "the wall behind the sofa"; otherwise as without the wall.
    std::optional<Place> at_wall_of(const Words& rest) {
        auto out = Reader(editor_, rest, kind_, mover_, spoken_).read();
        if (!out || !is_one_of(out->step.wish.relation, {"opposite", "behind", "facing", "in front of"})) return out;
        Words wall{"the", "wall"};
        wall.insert(wall.end(), rest.begin(), rest.end());
        out = hangs() ? place("on", "wall") : place("against");
        out->step.wall = wall_meant(editor_, wall, spoken_);
        return out;
    }

    std::optional<Place> at_wall(const Part& part, const Words& rest, const std::string& relation = {}) {
        // "on the wall above the bed"
        if (!rest.empty() && rest.front() != "of") return at_wall_of(rest);
        const bool bare = std::all_of(part.modifiers.begin(), part.modifiers.end(),
                                      [](const std::string& w) { return is_definite(w) || w == "a"; });
        if (relation == "on" && bare && !hangs() && mount_of(editor_, kind_) == Mount::floor)
            throw UsageError("{}: it stands on the floor and hangs on no wall; \"against the wall\" is at one",
                             mover_.empty() ? in_words(kind_) : mover_);
        Place out = hangs() && (relation == "on" || relation == "to") ? place("on", "wall") : place("against");
        if (const auto direction = direction_said(editor_, part))
            out.step.wall = wall_towards(editor_.plan(), *direction);
        for (const Opening& o : editor_.plan().openings)
            if ((part.says({"window"}) && o.kind == Opening::Kind::window) ||
                (part.says({"door"}) && o.kind != Opening::Kind::window))
                out.step.wall = o.wall;
        if (const auto wall = wall_that_looks(editor_.plan(), part)) out.step.wall = *wall;
        out.each_wall = !moving_ && part.says({"each", "every"});
        out.step.elsewhere = moving_ && part.is_other();
        out.step.opposite = part.says({"opposite"}) || (part.noun == "side" && part.is_other());
        return out;
    }

    std::optional<Place> at_thing(const Relation& relation) {
        Words there = part_of(words_, relation.next);
        const std::string& name = relation.name;
        if (there.empty()) {
            if (is_one_of(name, {"in the corner", "in the middle", "far wall", "against"})) return place(name);
            return name == "as usual" ? std::optional(place("")) : std::nullopt;
        }
        if (is_one_of(name, {"in a row", "each other", "as usual", "from"})) return {};
        if (name == "between") return between(there);
        if (is_one_of(name, {"in the corner", "in the middle"}) && noun_of(there.back()) == "room") return place(name);
        if (name == "in the middle") {
            auto out = at_thing({"on", relation.next});
            if (out) out->step.centered = true;
            return out;
        }
        // "on the other side of the bed" was read as opposite.
        const bool each = is_one_of(there.front(), {"each", "both", "every", "all"});
        // "On the other desk", where none was named before: that which has no such thing yet.
        if (const std::size_t other = find_word(there, {"other"}); !moving_ && other == 1 && there.front() == "the" &&
                                                                   there.size() > 2 && !there.back().ends_with("s") &&
                                                                   next_place(there) == there.size())
            there = {lacking_one(editor_, part_of(there, 2), kind_)};
        // "Candles to the tables": one for each of them.
        const std::size_t noun = std::min(next_place(there), find_word(there, {"that", "with", "without"}, 1)) - 1;
        const bool plural = !moving_ && there.front() == "the" &&
                            is_one_of(name, {"to", "at", "on", "above", "under"}) && there[noun].ends_with("s");
        const std::string looked = is_one_of(name, {"to", "at", "in"}) ? "" : name;
        const std::vector<int> all = those(there);
        const Anchor anchor = anchor_of(editor_, all, looked);
        Place out = place(name, anchor.kind);
        out.step.at = anchor.ids;
        if (moving_ && std::find(there.begin(), there.end(), "other") != there.end())
            out.step.at = all_but_nearest(editor_, anchor.kind, mover_);
        const std::vector<int> found = of_one_kind(editor_, all, looked);
        const Placed& first = editor_.room().furnished.placed[static_cast<std::size_t>(found.front())];
        if (looked.empty()) out.step.wish.relation = suited(name, kind_, first);
        if (name == "along" || name == "against") out.step.wish.relation = "next to";
        // Candles around a bathtub stand on its edge.
        if (name == "around" && furnishing::is_small(kind_)) out.step.wish.relation = carries(first) ? "on" : "next to";
        // A blanket over a sofa lies on it.
        if (name == "above" && find_word(words_, {"over", "across"}) < relation.next &&
            furnishing::lies_on_seats(kind_))
            out.step.wish.relation = "on";
        // A candle on each side of the mantel stands on it.
        const bool top = furnishing::is_small(kind_) && !first.piece.surfaces.empty() &&
                         !has_role(first.piece.kind, Role::seat) && !has_role(first.piece.kind, Role::bed);
        if (name == "on both sides of") out.count = 2;
        const bool sat_at = has_role(kind_, Role::seat) && has_role(first.piece.kind, Role::laid);
        if (name == "on both sides of" && !moving_ && sat_at) out.step.wish.relation = "around";
        if (name == "on both sides of" && top) out.step.wish.relation = kAtTheEnds;
        // "Each desk": of whatever kind.
        const auto suits = [&](int i) {
            return fits(out.step.wish.relation, editor_.room().furnished.placed[static_cast<std::size_t>(i)]);
        };
        out.if_uncounted = plural && !each;
        if (each || (plural && all.size() > 1))
            for (const int i : all)
                if (suits(i) || std::none_of(all.begin(), all.end(), suits))
                    out.each_at.push_back({editor_.document().things[static_cast<std::size_t>(i)].id});
        return out;
    }

    // Left or right of a thing: the side where what moves does not stand itself; where it stands at neither, that with
    // fewer of its kind.
    void free_side(Place& place) const {
        const auto anchors = things_at(editor_, place.step);
        if (anchors.size() != 1) return;
        const Placed& at = editor_.placed(anchors.front());
        constexpr float kNear = 1.2f;  // metres from its edge
        const auto balance_of = [&](bool own) {
            float balance = 0;
            for (const Placed& p : editor_.room().furnished.placed) {
                const bool counts = own ? p.id == mover_ : asked_kind(p) == kind_ && p.id != mover_;
                if (!counts || distance_to(footprint_of(at), footprint_of(p).center) > kNear) continue;
                balance += dot(p.position - at.position, right_of(at.yaw)) > 0 ? 1.f : -1.f;
            }
            return balance;
        };
        float balance = moving_ ? balance_of(true) : 0.f;
        if (balance == 0) balance = balance_of(false);
        if (balance != 0) place.step.wish.relation = balance > 0 ? "left of" : "right of";
    }

    // "At each end of the table", "on both sides of the bed"; "at the end of the table".
    void at_both(Place& place, const Part& part) const {
        const auto anchors = things_at(editor_, place.step);
        const bool both = part.says({"each", "both", "either", "every", "sides"});
        const bool seats = has_role(kind_, Role::seat) && !anchors.empty() &&
                           is_table(editor_.placed(anchors.front()).piece.kind);
        const bool on_top = both && furnishing::is_small(kind_) && !anchors.empty() &&
                            !editor_.placed(anchors.front()).piece.surfaces.empty();
        const bool bed = !anchors.empty() && has_role(editor_.placed(anchors.front()).piece.kind, Role::bed);
        if (part.says({"end"}) && bed && !both) place.step.wish.relation = "at the foot of";
        else if (part.says({"end"}) && (seats || on_top)) place.step.wish.relation = kAtTheEnds;
        else if (both) place.step.wish.relation = "on both sides of";
        if (both) place.count = 2;
    }

    std::optional<Place> between(const Words& words) {
        const auto joint = std::find(words.begin(), words.end(), "and");
        const auto side = [&](const Words& part) {
            if (!part.empty() && is_one_of(noun_of(part.back()), {"wall", "floor", "ceiling", "corner"}))
                throw UsageError("expected things or openings to be between, found \"{}\"", text_of(part));
            if (const auto known = room_part(part, 0); known && known->next == part.size())
                return Anchor{opening_there(editor_.plan(), known->noun), {}};
            return anchor_of(editor_, those(part), "");
        };
        // "between them"
        if (is_pronoun(words) && spoken_.size() == 2) {
            Place out = place("between", editor_.placed(spoken_[0]).piece.kind);
            out.step.wish.relation_and = editor_.placed(spoken_[1]).piece.kind;
            out.step.at = {spoken_[0]}, out.step.at_and = {spoken_[1]};
            return out;
        }
        const Anchor one = side(Words(words.begin(), joint));
        const Anchor other = joint == words.end() ? one : side(Words(joint + 1, words.end()));
        const Plan& plan = editor_.plan();
        if (one.kind == other.kind && has_opening(plan, one.kind) &&
            std::count_if(plan.openings.begin(), plan.openings.end(),
                          [&](const Opening& o) { return is_opening_of(o, one.kind); }) < 2)
            throw UsageError("there is only one {} in the room", one.kind);
        Place out = place("between", one.kind);
        out.step.wish.relation_and = other.kind;
        out.step.at = one.ids, out.step.at_and = other.ids;
        return out;
    }

    const Editor& editor_;
    Words words_;
    std::string kind_, mover_;
    std::vector<std::string> spoken_;
    bool moving_;
};

}  // namespace

std::optional<Place> place_of(const Editor& editor, const Words& words, const std::string& kind,
                              const std::string& mover, const std::vector<std::string>& spoken) {
    return words.empty() ? std::nullopt : Reader(editor, words, kind, mover, spoken).read();
}

}  // namespace fastscene::editing
