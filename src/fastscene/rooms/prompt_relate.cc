// Where things stand to each other: "a desk under the window", "on the table, a vase", "a bed between two nightstands".
#include <algorithm>
#include <array>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

constexpr std::size_t kReach = 8;  // matches between a relation and its noun

bool ends_clause(const Match& m) { return m.comma; }

std::optional<std::size_t> noun_before(const Reading& r, std::size_t at) {
    for (std::size_t k = at; k-- > 0;) {
        if (ends_clause(r.m[k])) return {};
        if (has_object(r.m[k]) && !r.m[k].is(WordKind::material)) return k;
    }
    return {};
}

std::optional<std::size_t> noun_after(const Reading& r, std::size_t at) {
    for (std::size_t k = at + 1; k < r.m.size() && k <= at + kReach; ++k) {
        if (has_object(r.m[k]) && !r.m[k].is(WordKind::material)) return k;
        if (r.m[k].is(WordKind::relation) || r.m[k].is(WordKind::room) ||
            (ends_clause(r.m[k]) && !(k > at + 1 && k + 1 < r.m.size() && is_adjective(r.m[k + 1]))))
            return {};
    }
    return {};
}

bool takes_no_target(const std::string& relation) {
    return relation == "in the corner" || relation == "in the middle" || relation == "far wall";
}

// "flanked by two chairs", "surrounded by plants": the chairs stand where the words say, not what is flanked.
bool is_passive(const Match& m) { return m.words.ends_with(" by") && m.words != "close by" && m.words != "right by"; }

// "In the corner a piano", "on the table, a vase": the relation opens its clause, the subject comes after it.
bool opens_clause(const Reading& r, std::size_t at) {
    std::size_t k = at;
    while (k > 0 &&
           (r.m[k - 1].is_function("and") || r.m[k - 1].is_function("the") || r.m[k - 1].is_function("there is")))
        --k;
    return k == 0 || r.m[k - 1].comma;
}

// Whether a thing may be asked to stand so at another: a painting hangs above no stool, a rug lies before no lamp,
// nothing stands on a picture.
bool is_likely(const PromptObject& thing, std::string_view relation, const PromptObject& place) {
    const bool hangs = has_role(thing.kind, Role::likely_above), low = has_role(place.kind, Role::too_low_below),
               flat_or_hung = has_role(place.kind, Role::no_top), tall = has_role(place.kind, Role::too_tall_below);
    if (relation == "above") return hangs ? !low && !tall : !has_role(place.kind, Role::nothing_above);
    if (relation == "on") return !flat_or_hung && !(place.kind == "sofa" && !furnishing::lies_on_seats(thing.kind));
    if (relation == "in front of" || relation == "at the foot of")
        return thing.kind == "rug"
                   ? !low && !flat_or_hung && !place.kind.ends_with("table") && place.kind != "dining_table_round"
                   : place.kind != "rug";
    if (relation == "behind") return place.kind != "rug" && (!flat_or_hung || place.kind == "plant");
    return true;
}

// "a stool in front of it and a painting above it": where the words before were at a thing, too, it is the same one.
std::optional<std::size_t> meant_before(const Reading& r, std::size_t subject, std::string_view relation) {
    std::size_t k = subject;
    while (k > 0 && modifies(r.m[k - 1])) --k;
    const std::size_t joint = k;
    while (k > 0 && (r.m[k - 1].comma || r.m[k - 1].is_function("and"))) --k;
    if (k == joint || k < 2 || !r.m[k - 1].is_function("it") || !r.m[k - 2].relation || r.m[k - 2].target < 0)
        return {};
    const auto target = static_cast<std::size_t>(r.m[k - 2].target);
    if (relation == "on" || r.m[target].object == r.m[subject].object) return {};
    return is_likely(r.spec.objects[static_cast<std::size_t>(r.m[subject].object)], relation,
                     r.spec.objects[static_cast<std::size_t>(r.m[target].object)])
               ? std::optional(target)
               : std::nullopt;
}

// What "it" or "them" stands for before `subject`: the last piece that is not itself the place of another and may have
// such a thing there; "it" is no plural.
std::optional<std::size_t> meant_by(const Reading& r, std::size_t subject, bool several,
                                    std::string_view relation = {}) {
    if (!several && !relation.empty())
        if (const auto same = meant_before(r, subject, relation)) return same;
    std::optional<std::size_t> last, place_of_another;
    for (std::size_t k = subject; k-- > 0;) {
        if (!has_object(r.m[k]) || r.m[k].object == r.m[subject].object) continue;
        if (!relation.empty() && !is_likely(r.spec.objects[static_cast<std::size_t>(r.m[subject].object)], relation,
                                            r.spec.objects[static_cast<std::size_t>(r.m[k].object)])) {
            // "a tall clock next to the fireplace and a portrait above": not above the clock, so above what the clock
            // stands at.
            const PromptObject& thing = r.spec.objects[static_cast<std::size_t>(r.m[k].object)];
            if (place_of_another &&
                thing.relation_to == r.spec.objects[static_cast<std::size_t>(r.m[*place_of_another].object)].kind)
                return place_of_another;
            continue;
        }
        if (!several && r.spec.objects[static_cast<std::size_t>(r.m[k].object)].count > 1) continue;
        const bool place = std::any_of(r.m.begin(), r.m.begin() + static_cast<std::ptrdiff_t>(k),
                                       [&](const Match& m) { return m.relation && m.target == static_cast<int>(k); });
        if (place && !several) {
            if (!place_of_another) place_of_another = k;
            continue;
        }
        if (several && r.spec.objects[static_cast<std::size_t>(r.m[k].object)].count > 1) return k;
        if (!last) last = k;
        if (!several) break;
    }
    return last ? last : place_of_another;
}

bool says_each(const Reading& r, std::size_t noun) {
    return noun > 0 && (r.m[noun - 1].is_function("each") || r.m[noun - 1].is_function("every"));
}

// "in each corner", "in all four corners": one, or as many as were said, for each.
bool says_every_corner(const Match& m) {
    return m.is(WordKind::relation) &&
           (m.words.find("each corner") != std::string::npos || m.words.find("every corner") != std::string::npos ||
            m.words.find("all corners") != std::string::npos || m.words.find("four corners") != std::string::npos);
}

void attach(Reading& r, std::size_t at, std::size_t subject, std::optional<std::size_t> where, std::string relation) {
    PromptObject& object = r.object_of(subject);
    const bool placed = where.has_value() && r.m[*where].object != r.m[subject].object;
    const std::size_t target = placed ? *where : subject;
    if (!placed && !takes_no_target(relation) && relation != "against" && relation != "left of" &&
        relation != "right of")
        return r.tell_near(at, "where: stands at no piece that was named");
    // "cushions and herringbone tiles on the floor": the tiles are, and they are the floor.
    if (placed && relation == "on")
        for (std::size_t k = subject + 1; k < at; ++k)
            if (has_object(r.m[k]) && r.object_of(k).kind == r.object_of(target).kind)
                return r.tell(at, "the " + r.m[k].words + " of the " + r.object_of(target).kind, r.object_of(k).id);
    // Stockings and leaves on a mantel hang at the wall above it.
    if (placed && relation == "on" && has_role(object.kind, Role::on_mantels) && r.m[target].is(WordKind::object))
        relation = "above";
    // "clothes on the floor" were dropped there, "papers" slid apart.
    if (placed && relation == "on" && r.object_of(target).kind == "floor") {
        if (object.kind == "folded_clothes") object.kind = "clothes_heap";
        if (object.kind == "book_stack" && is_one_of(object.words, {"papers", "paper", "sheets of paper"}))
            object.kind = "paper_litter";
    }
    if (placed && furnishing::lies_about(object.kind) && r.object_of(target).kind == "floor")
        return r.tell(at, object.kind + " lies on the floor", object.id);
    if (!object.relation.empty())
        return r.tell_near(at, "where: the " + object.words + " already has its place", object.id);
    // Who sits at a desk that faces the window looks out of it: there the desk stands.
    if (placed && relation == "facing" && has_role(object.kind, Role::under_windows) &&
        is_one_of(r.object_of(target).kind, {"window", "bay_window"}))
        relation = "under";
    object.relation = relation;
    // "a lamp above the table" hangs, "a lamp in the corner" stands on the floor.
    const bool any_lamp = object.kind == "table_lamp" && is_one_of(object.words, {"lamp", "lamps"}),
               at_piece = placed && r.m[target].is(WordKind::object);
    if (any_lamp && relation == "above" && at_piece && furnishing::hangs_over(r.object_of(target).kind))
        object.kind = "pendant_lamp";
    if (any_lamp && (relation == "in the corner" || (relation == "behind" && at_piece))) object.kind = "floor_lamp";
    // Pans above an island hang from the ceiling.
    if (object.kind == "hung_pans" && relation == "above" && at_piece &&
        furnishing::hangs_over(r.object_of(target).kind))
        object.kind = "pot_rack";
    // "A paper lantern on the nightstand" is a lamp with such a shade.
    if (object.kind == "paper_lantern" && relation == "on" && at_piece)
        object.kind = "table_lamp", object.style = style_with_lamp(LampFamily::paper);
    std::string to;
    constexpr int kCorners = 4;
    if (says_every_corner(r.m[at]))
        object.count = object.counted && object.count % kCorners == 0 ? object.count
                                                                      : kCorners * (object.counted ? object.count : 1),
        object.counted = true;
    if ((r.m[at].words.find("both corners") != std::string::npos ||
         r.m[at].words.find("two corners") != std::string::npos ||
         r.m[at].words.find("opposite corners") != std::string::npos) &&
        !object.counted)
        object.count = 2, object.counted = true;
    // "a picture above each bed": as many pictures as beds.
    if (placed && says_each(r, target) && r.object_of(target).kind == "nightstand" && !r.object_of(target).counted)
        r.object_of(target).count = 2;
    if (placed && says_each(r, target) && r.object_of(target).count > 1 && !object.counted)
        object.count = r.object_of(target).count, object.counted = true;
    if (placed && !takes_no_target(relation)) {
        object.relation_to = r.object_of(target).kind;
        to = " the " + r.m[target].words;
        r.m[at].target = static_cast<int>(target);
        if (relation == "between") {
            // "between the bed and the door"; "between two windows" has one class twice.
            const auto second = noun_after(r, target);
            std::optional<std::size_t> pronoun;
            if (at + 1 < r.m.size() && r.m[at + 1].is_function("them")) pronoun = meant_by(r, target, false);
            const bool joined = second && *second <= target + 5 &&
                                std::any_of(r.m.begin() + static_cast<std::ptrdiff_t>(target),
                                            r.m.begin() + static_cast<std::ptrdiff_t>(*second),
                                            [](const Match& m) { return m.is_function("and"); });
            // "a sofa, two armchairs opposite it and a table between them": between those and these.
            const PromptObject& those = r.object_of(target);
            const bool face_to_face = pronoun && those.relation == "opposite" &&
                                      those.relation_to == r.object_of(*pronoun).kind;
            object.relation_and = pronoun && (those.count == 1 || face_to_face) ? r.object_of(*pronoun).kind
                                  : joined && *second != subject                ? r.object_of(*second).kind
                                                                                : object.relation_to;
        }
    }
    r.tell(at, object.kind + " " + relation + to, object.id);
    r.m[at].relation = true;
}

// "a bed with a nightstand on each side", "bookshelves on either side of the fireplace": two of them, next to it.
void relate_both_sides(Reading& r, std::size_t at) {
    const auto subject = noun_before(r, at);
    if (!subject) return r.tell_near(at, "where: of nothing that was named");
    std::optional<std::size_t> target;
    if (r.m[at].words.ends_with(" of") || r.m[at].words.ends_with("flanking")) target = noun_after(r, at);
    // "… on either side of it"
    if (at + 1 < r.m.size() && r.m[at + 1].is_function("it")) target = meant_by(r, *subject, false, "on both sides of");
    for (std::size_t k = *subject; k > 0 && !target.has_value(); --k)
        if (has_object(r.m[k - 1]) && r.m[k - 1].is(WordKind::object) && r.m[k - 1].object != r.m[*subject].object)
            target = k - 1;
    if (PromptObject& object = r.object_of(*subject); !object.counted || object.count == 1)
        object.count = 2, object.counted = true;
    // "twin beds flanking a nightstand": what is small stands between the large.
    if (target && has_role(r.object_of(*subject).kind, Role::bed) && r.object_of(*subject).relation.empty() &&
        has_role(r.object_of(*target).kind, Role::between_beds) && r.object_of(*target).count == 1 &&
        r.object_of(*target).relation.empty()) {
        PromptObject &beds = r.object_of(*subject), &small = r.object_of(*target);
        small.relation = "between", small.relation_to = small.relation_and = beds.kind;
        r.tell(at, small.kind + " between the " + beds.words, small.id);
        r.m[at].relation = true;
        return;
    }
    attach(r, at, *subject, target, "on both sides of");
}

// "three chairs in a row", "in a row, three chairs".
void relate_row(Reading& r, std::size_t at) {
    std::optional<std::size_t> subject = noun_before(r, at);
    if (!subject) subject = noun_after(r, at);
    if (!subject) return r.tell_near(at, "where: of nothing that was named");
    PromptObject& object = r.object_of(*subject);
    object.in_row = true;
    r.tell(at, object.kind + " side by side", object.id);
}

// "a stacked washer and dryer": the second on the first.
void stack_pairs(Reading& r) {
    for (std::size_t i = 0; i + 3 < r.m.size(); ++i) {
        if (r.m[i].words != "stacked" || !has_object(r.m[i + 1]) || !r.m[i + 2].is_function("and") ||
            !has_object(r.m[i + 3]))
            continue;
        PromptObject &below = r.object_of(i + 1), &above = r.object_of(i + 3);
        if (below.id == above.id || below.kind != above.kind || !above.relation.empty()) continue;
        above.relation = "on";
        above.relation_to = below.kind;
        r.tell(i, "the " + above.words + " on the " + below.words, above.id);
        r.m[i].relation = true;
    }
}

// "a wall mounted TV": on the wall, where no other place was said.
void hang_screens(Reading& r) {
    for (std::size_t i = 0; i < r.m.size(); ++i) {
        if (!r.m[i].is(WordKind::nuance) || r.m[i].word->meaning != "on the wall") continue;
        std::size_t screen = i + 1;
        while (screen < r.m.size() && !has_object(r.m[screen])) ++screen;
        if (screen == r.m.size()) continue;
        PromptObject& object = r.object_of(screen);
        // Opposite the sofa it hangs anyway.
        const bool usual = is_one_of(object.relation, {"", "opposite", "facing", "in front of"});
        if (object.kind == "tv" && usual) object.relation = "on", object.relation_to = "wall";
    }
}

// "a bed between two nightstands, opposite a wardrobe": the bed.
std::optional<std::size_t> head_of_last_clause(const Reading& r, std::size_t at) {
    std::size_t k = at;
    while (k > 0 && r.m[k - 1].comma) --k;
    std::optional<std::size_t> head;
    for (; k-- > 0 && !ends_clause(r.m[k]);)
        if (has_object(r.m[k])) head = k;
    return head;
}

// "coffee steaming on the counter, …": who stands there was named, and is nothing that rooms have.
bool names_other_things(const Reading& r, std::size_t at) {
    for (std::size_t k = at; k-- > 0 && !ends_clause(r.m[k]);)
        if (!r.m[k].word || r.m[k].is(WordKind::color) || r.m[k].is(WordKind::material) ||
            r.m[k].is(WordKind::weather) || r.m[k].is(WordKind::time) || r.m[k].is(WordKind::light) ||
            (r.m[k].is(WordKind::nuance) && (r.m[k].word->meaning == "thing" || r.m[k].word->meaning == "motif")))
            return true;
    return false;
}

// Whether between this noun and the words of place something else has an article or a joint of its own, and is no word
// of ours.
bool names_a_stranger(const Reading& r, std::size_t subject, std::size_t at) {
    bool begins = false;
    for (std::size_t k = subject + 1; k < at; ++k) {
        begins = begins || r.m[k].is(WordKind::count) || r.m[k].is_function("and") || r.m[k].is_function("the");
        if (begins && !r.m[k].word && !r.m[k].comma) return true;
    }
    return false;
}

// What stands on tops, and is said to.
bool stands_on_tops(const PromptObject& o) {
    return furnishing::is_small(o.kind) && !furnishing::lies_on_seats(o.kind) && o.kind != "rug" && !o.forbidden;
}

// "herbs and a vase on the sill", "books, a lamp and a clock on the desk": all of them stand there. Not the lamp of "a
// desk with a lamp and …".
void attach_joined(Reading& r, std::size_t subject, std::size_t target) {
    const PromptObject place = r.object_of(subject);
    if (place.relation != "on" || !stands_on_tops(place)) return;
    std::size_t noun = subject;
    for (bool listed = false;; listed = true) {
        std::size_t k = noun;
        while (k > 0 && modifies(r.m[k - 1])) --k;
        if (k == 0) return;
        const bool joined = r.m[k - 1].is_function("and");
        if (!joined && !(listed && r.m[k - 1].comma)) return;
        --k;
        if (joined && k > 0 && r.m[k - 1].comma) --k;
        if (k == 0 || !has_object(r.m[k - 1]) || k - 1 == target) return;
        noun = k - 1;
        PromptObject& other = r.object_of(noun);
        if (!stands_on_tops(other) || !other.relation.empty() || other.id == place.id) return;
        while (k > 0 && modifies(r.m[k - 1])) --k;
        std::size_t before = noun;
        while (before > 0 && modifies(r.m[before - 1])) --before;
        if (before > 1 && r.m[before - 1].is_function("with") && has_object(r.m[before - 2])) return;
        other.relation = place.relation;
        other.relation_to = place.relation_to;
    }
}

// "candles on the rim", "a lamp on the edge": where a part is said and not whose, it is that of what was named before.
std::optional<std::size_t> part_behind(const Reading& r, std::size_t at) {
    std::size_t k = at + 1;
    while (k < r.m.size() && (modifies(r.m[k]) || r.m[k].is_function("the") || r.m[k].is_function("its"))) ++k;
    if (k >= r.m.size() || !r.m[k].is(WordKind::detail) || r.m[k].word->meaning != "part") return {};
    const bool whose = k + 1 < r.m.size() &&
                       (has_object(r.m[k + 1]) || modifies(r.m[k + 1]) || r.m[k + 1].is_function("of"));
    return whose ? std::nullopt : std::optional(k);
}

// "a loft bed with a desk underneath and a bean bag": nothing follows that it could be under.
bool ends_its_phrase(const Reading& r, std::size_t at) {
    static constexpr std::array<std::string_view, 6> kAlone{"underneath", "beneath", "below",
                                                            "above",      "behind",  "on top"};
    if (std::find(kAlone.begin(), kAlone.end(), r.m[at].words) == kAlone.end()) return false;
    return at + 1 == r.m.size() || r.m[at + 1].comma || r.m[at + 1].is_function("and") ||
           r.m[at + 1].is_function("with");
}

// "on a foggy morning", "on a rainy night": when, not where.
bool says_when(const Reading& r, std::size_t at) {
    if (r.m[at].words != "on") return false;
    bool when = false;
    std::size_t k = at + 1;
    for (; k < r.m.size(); ++k) {
        const Match& m = r.m[k];
        if (m.is(WordKind::time) || m.is(WordKind::weather)) when = true;
        else if (!modifies(m) && !m.is(WordKind::light) && !m.is(WordKind::mood) && !m.is_function("the")) break;
    }
    return when && (k == r.m.size() || !is_noun(r.m[k]));
}

// A main piece chooses its wall first, what is said with it follows: "a bed between two nightstands" is flanked by
// them, and "a bed opposite a wardrobe" has the wardrobe opposite it. Not so "a bed between a nightstand and a
// dresser", nor "a side table between two sofas".
bool says_it_of_the_other(Reading& r, const std::string& relation, std::size_t subject, std::size_t target) {
    const PromptObject &one = r.object_of(subject), &two = r.object_of(target);
    const auto is_main = [](const PromptObject& o) {
        return has_role(o.kind, Role::main_piece) || has_role(o.kind, Role::opening);
    };
    if (!is_main(one) || one.count > 1 || is_main(two) || !two.relation.empty()) return false;
    return (relation == "between" && two.counted && two.count == 2) || (relation == "opposite" && two.count == 1);
}

void relate_one(Reading& r, std::size_t at) {
    std::string relation = r.m[at].word->meaning;
    if (says_when(r, at)) return;
    if (relation == "both sides") return relate_both_sides(r, at);
    if (relation == "in a row") return relate_row(r, at);
    // "a flat above a shop", "a room next to the park": where the house stands.
    std::size_t next = at + 1;
    while (next < r.m.size() && (modifies(r.m[next]) || r.m[next].is_function("the")) &&
           !(r.m[next].is(WordKind::nuance) && r.m[next].word->meaning == "outside"))
        ++next;
    if (next < r.m.size() && r.m[next].is(WordKind::nuance) && r.m[next].word->meaning == "outside" &&
        (next + 1 == r.m.size() || !has_object(r.m[next + 1])))
        return r.tell_near(at, "where the room lies, not what stands in it");
    if (relation == "each other") return r.tell_near(at, "where: these pieces stand as there is room for them");
    if (relation == "as usual") return r.tell_near(at, "where: such pieces hang or stand as they always do");
    std::optional<std::size_t> subject = noun_before(r, at), target = noun_after(r, at);
    if (relation == "against" && r.m[at].words.ends_with(" wall")) target.reset();  // it has said what
    // "blue tiles behind the sink": a surface that is named by its material.
    if (relation == "behind" && at > 0 && r.m[at - 1].is(WordKind::material) && has_object(r.m[at - 1]) &&
        r.object_of(at - 1).kind == "wall")
        subject = at - 1;
    // "curtains and a minibar under the tv": who stands there has a name nobody knows, and is not what was named
    // before.
    if (subject && names_a_stranger(r, *subject, at))
        return r.tell_near(at, "where: of a thing that is not understood");
    // "… books and rain on the window", "… a sofa and snow on the roof": the weather is there, not the books.
    if (subject && at > 0 && (r.m[at - 1].is(WordKind::weather) || r.m[at - 1].is(WordKind::light)) &&
        *subject + 1 < at &&
        std::any_of(r.m.begin() + static_cast<std::ptrdiff_t>(*subject), r.m.begin() + static_cast<std::ptrdiff_t>(at),
                    [](const Match& m) { return m.is_function("and"); }))
        return r.tell_near(at, "where: of nothing that can be placed");
    // "a vase in the middle of the table", "… in the center of it"
    if (relation == "in the middle" && subject && r.m[at].words.ends_with(" of")) {
        const bool it = at + 1 < r.m.size() && r.m[at + 1].is_function("it");
        const auto place = it ? meant_by(r, *subject, false) : target;
        if (place && r.m[*place].is(WordKind::object)) return attach(r, at, *subject, place, "on");
    }
    // "a throw over the armchair", "a blanket across the bed": it lies there.
    if (subject && target && is_one_of(r.m[at].words, {"over", "across"}) &&
        furnishing::lies_on_seats(r.object_of(*subject).kind))
        relation = "on";
    // "a washing machine under the dryer": of two alike the other stands on top.
    if (subject && target && relation == "under" && r.m[*subject].object != r.m[*target].object &&
        r.object_of(*subject).kind == r.object_of(*target).kind)
        return attach(r, at, *target, subject, "on");
    if (takes_no_target(relation)) {
        const bool inverted = opens_clause(r, at) || !subject;
        if (inverted) subject = noun_after(r, at);
        if (!subject) return r.tell_near(at, "where: of nothing that was named");
        return attach(r, at, *subject, {}, relation);
    }
    // "a wardrobe on the opposite wall": opposite what was named before.
    if (subject && r.m[at].words.ends_with("opposite wall"))
        return attach(r, at, *subject, meant_by(r, *subject, false), relation);
    // "a lamp on it": the piece named before the lamp.
    std::size_t pronoun = at + 1;  // "on each of them"
    while (pronoun < r.m.size() &&
           (r.m[pronoun].is_function("each") || r.m[pronoun].is_function("of") || r.m[pronoun].is_function("both") ||
            r.m[pronoun].is_function("each of") || r.m[pronoun].is_function("both of")))
        ++pronoun;
    const bool it = at + 1 < r.m.size() && r.m[at + 1].is_function("it"),
               them = pronoun < r.m.size() && r.m[pronoun].is_function("them");
    if (them && pronoun > at + 1 && subject) {
        const auto those = meant_by(r, *subject, true, relation);
        if (PromptObject& object = r.object_of(*subject); those && !object.counted && r.object_of(*those).count > 1)
            object.count = r.object_of(*those).count, object.counted = true;
    }
    if (it || them || (!target && r.m[at].words == "on top") ||
        (ends_its_phrase(r, at) && subject && *subject + 1 == at)) {
        // "… a cabinet, above it hangs a clock"
        if (!subject && opens_clause(r, at)) subject = noun_after(r, at);
        if (!subject) return r.tell_near(at, "where: of nothing that was named");
        return attach(r, at, *subject, meant_by(r, *subject, them, relation), relation);
    }
    if (const auto part = part_behind(r, at); part && relation == "on") {
        if (!subject) return r.tell_near(at, "where: of nothing that was named");
        target = meant_by(r, *subject, false);
        if (target) r.tell(*part, "of the " + r.m[*target].words, r.m[*target].object);
        return attach(r, at, *subject, target, relation);
    }
    if ((opens_clause(r, at) || (!subject && !names_other_things(r, at))) && target) {
        subject = noun_after(r, *target);
        if (!subject && *target + 1 < r.m.size() && r.m[*target + 1].comma) subject = noun_after(r, *target + 1);
        if (!subject) subject = head_of_last_clause(r, at);
    }
    if (!subject && at > 0 && r.m[at - 1].is(WordKind::detail) && target && r.m[at - 1].about == r.m[*target].object)
        return r.tell(at, "where the " + r.m[at - 1].words + " lies", r.m[*target].object);
    if (!subject) return r.tell_near(at, "where: of nothing that was named");
    if (target && (is_passive(r.m[at]) || says_it_of_the_other(r, relation, *subject, *target))) {
        const std::string turned = relation == "between" ? "on both sides of" : relation;
        return attach(r, at, *target, subject, turned);
    }
    attach(r, at, *subject, target, relation);
    if (target) attach_joined(r, *subject, *target);
}

}  // namespace

void relate(Reading& r) {
    for (std::size_t i = 0; i < r.m.size(); ++i)
        if (r.m[i].is(WordKind::relation)) relate_one(r, i);
    stack_pairs(r);
    hang_screens(r);
    fill_next_room(r);
}

}  // namespace fastscene::reading
