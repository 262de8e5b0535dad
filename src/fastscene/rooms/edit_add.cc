// "a floor lamp beside the bed", "the sofa with two armchairs": what comes new, and what changes places.
#include <algorithm>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {
namespace {

Words joined_parts(const std::vector<Words>& parts) {
    Words out;
    for (const Words& part : parts) {
        if (!out.empty()) out.push_back(",");
        out.insert(out.end(), part.begin(), part.end());
    }
    return out;
}

// "A desk with a chair beside it", of what was spoken of before: both come there.
bool both_come_there(const Talk& talk, const Words& words, std::size_t with) {
    const bool spoken = words.back() == "it" ? talk.last.size() == 1 : talk.last.size() > 1;
    return spoken && next_place(part_of(words, 0, with)) == with && parts_of(words).size() == 1 &&
           find_word(words, {"beside", "next", "behind", "front", "between", "opposite"}, with) < words.size();
}

// "curtains in the same color as the rug"; false: no such words.
bool add_like_another(Talk& talk, const Words& words) {
    const std::size_t same = find_word(words, {"same"}, 1), as = find_word(words, {"as"}, same);
    if (as + 1 >= words.size() || find_word(words, {"color", "shade"}, same) > as) return false;
    Words bare = part_of(words, 0, same);
    while (bare.size() > 1 && is_one_of(bare.back(), {"in", "of", "with", "the"})) bare.pop_back();
    while (bare.size() > 1 && is_joint(bare.back())) bare.pop_back();
    EditStep step;
    step.kind = EditStep::Kind::recolor;
    const Words model = part_of(words, as + 1);
    const bool others = is_one_of(model.back(), {"others", "ones", "rest", "those"});
    if (!others) step.wish.color = talk.editor.color_seen(talk.things(model).front());
    add(talk, bare);
    step.ids = talk.last;
    // "The same color as the others": those of its kind that were there.
    const std::string kind = step.ids.empty() ? "" : asked_kind(talk.editor.placed(step.ids.front()));
    for (const Placed& p : talk.editor.room().furnished.placed)
        if (others && step.wish.color.empty() && asked_kind(p) == kind && !is_among(p.id, step.ids))
            step.wish.color = talk.editor.color_seen(p.id);
    if (step.wish.color.empty()) throw UsageError("there are no others whose color could be meant");
    talk.editor.apply(step);
    return true;
}

}  // namespace

// "a teapot and two cups on it": all of them on what was last spoken of.
void add_there(Talk& talk, const Words& words) {
    const std::vector<std::string> carriers = talk.last;
    const std::vector<Words> riders = parts_of(words);
    // "Between them" is between what came and what that came at.
    std::vector<std::string> both = carriers;
    if (const std::size_t n = words.size(); n > 2 && words[n - 2] == "between" && carriers.size() == 1)
        if (const auto other = things_at(talk.editor, talk.last_place); other.size() < 3)
            for (const std::string& id : other)
                if (both.size() < 2) add_new(both, {id});
    const Words there = part_of(riders.back(), next_place(riders.back()));
    do_each(
        talk.editor, riders.size(),
        [&](std::size_t k) {
            Words rider = riders[k];
            // "With a chair and a lamp on it": the chair stands at it.
            const PromptSpec said = read_in_room(talk.editor, text_of(rider));
            const bool sits = !said.objects.empty() && has_role(said.objects.front().kind, Role::seat);
            if (next_place(rider) == rider.size() && sits && there.front() == "on")
                rider = joined_words(joined_words(rider, {"at"}), part_of(there, 1));
            else if (next_place(rider) == rider.size()) rider.insert(rider.end(), there.begin(), there.end());
            talk.last = both;
            add(talk, rider);
        },
        [&](std::size_t k) { return text_of(riders[k]); });
    talk.last = carriers;
}

// "a floor lamp beside the bed and two plants in the corner"; a place holds for those before it that name none.
void add(Talk& talk, const Words& words) {
    // "two armchairs before the fire facing each other"
    if (const std::size_t facing = find_word(words, {"facing"}, 1);
        facing + 3 == words.size() && is_one_of(text_of(words, facing + 1), {"each other", "one another"})) {
        add(talk, part_of(words, 0, facing));
        return face(talk, {"them", "facing", "each", "other"});
    }
    // "A sofa there facing the window"
    if (const std::size_t facing = find_word(words, {"facing"}, 2);
        facing + 1 < words.size() && words[facing - 1] == "there" && next_place(words) == facing) {
        talk.there = true;
        add(talk, part_of(words, 0, facing - 1));
        return face(talk, joined_words({"them"}, part_of(words, facing)));
    }
    // "A coffee machine on a small table in the corner": first the table, where there is none.
    if (const std::size_t on = find_word(words, {"on"}, 2);
        parts_of(words).size() == 1 && on + 2 < words.size() && is_one_of(words[on + 1], {"a", "an"}) &&
        !is_one_of(words.back(), {"it", "them"}) && noun_of(words.back()) != "wall" &&
        all_named(talk.editor, text_of(words, on + 1, next_place(words, on + 1))).empty() &&
        !room_part(words, on + 1)) {
        add(talk, part_of(words, on + 1));
        Words all = part_of(words, 0, on);
        all.insert(all.end(), {"on", "it"});
        return add(talk, all);
    }
    // "Two chairs around a small round table": with its size or shape it is a new one.
    if (const std::size_t at = find_word(words, {"around"}, 2);
        parts_of(words).size() == 1 && at + 3 < words.size() && is_one_of(words[at + 1], {"a", "an"}) &&
        (is_one_of(words[at + 2], {"small", "little", "large", "big"}) || !shape_said({words[at + 2]}).empty())) {
        add(talk, part_of(words, at + 1));
        return add(talk, joined_words(part_of(words, 0, at), {"around", "it"}));
    }
    // "A vase is missing, put a blue one on the table"
    if (const std::size_t one = find_word(words, {"one", "ones"});
        !talk.lacks.empty() && one < words.size() && one + 1 == next_place(words)) {
        Words all = one > 0 ? part_of(words, 0, one) : Words{"a"};
        for (const std::string& w : tokens_of(std::exchange(talk.lacks, {}))) all.push_back(w);
        return add(talk, joined_words(all, part_of(words, one + 1)));
    }
    // "Take the lamp away and hang two smaller ones over the table"
    if (const std::size_t place = next_place(words);
        place > 1 && is_one_of(words[place - 1], {"one", "ones"}) && talk.last.empty() && !talk.noun.empty()) {
        Words all = part_of(words, 0, place - 1);
        for (const std::string& w : tokens_of(talk.noun)) all.push_back(w);
        return add(talk, joined_words(all, part_of(words, place)));
    }
    // "Add a third one", "another one"
    if (const std::size_t n = words.size();
        n > 1 && n < 4 && words.back() == "one" && !talk.noun.empty() &&
        is_one_of(words[n - 2], {"another", "second", "third", "fourth", "fifth", "more", "extra"})) {
        Words all{"another"};
        const Words noun = tokens_of(talk.noun);
        return add(talk, joined_words(all, noun));
    }
    // "The tv is too small, get a bigger one": in place of that.
    if (words.size() > 2 && words.back() == "one" && !talk.last.empty() &&
        value_of(part_of(words, 1, words.size() - 1)))
        return replace(talk, {"it"}, words);
    std::vector<Words> parts = parts_of(words);
    // "an armchair by the sofa, facing the tv"
    if (parts.size() > 1 && parts.back().front() == "facing") {
        Words all{"them"};
        all.insert(all.end(), parts.back().begin(), parts.back().end());
        parts.pop_back();
        add(talk, joined_parts(parts));
        return face(talk, all);
    }
    // "a bed with a nightstand on each side"
    if (const std::size_t n = words.size(), with = find_word(words, {"with"}, 1);
        with + 3 < n && is_one_of(words[n - 2], {"each", "both", "either"}) &&
        is_one_of(words[n - 1], {"side", "sides", "end", "ends"}) && begins_anew(part_of(words, with + 1)))
        return add(talk, joined_words(words, {"of", "it"}));
    // "a shelf over the desk with a plant and a candle on it"
    if (const std::size_t with = find_word(words, {"with"}, 1);
        with + 1 < words.size() && is_one_of(words.back(), {"it", "them"}) &&
        (find_word(words, {"and", ","}, with) < words.size() ||
         find_word(words,
                   {"between", "next", "beside", "behind", "above", "front", "over", "under", "opposite", "around",
                    "side", "sides", "end", "ends"},
                   with) < words.size()) &&
        begins_anew(part_of(words, with + 1)) && next_place(part_of(words, with + 1)) < words.size() - with - 1 &&
        !both_come_there(talk, words, with)) {
        add(talk, part_of(words, 0, with));
        return add_there(talk, part_of(words, with + 1));
    }
    // "a rug before the bed, light yellow"
    if (parts.size() > 1 && parts.back().size() > 1 && is_one_of(parts.back().back(), {"one", "ones"}) &&
        value_of(part_of(parts.back(), 0, parts.back().size() - 1)))
        parts.back().pop_back();
    if (parts.size() > 1 && !number_said(parts.back().front()))
        if (const auto value = value_of(parts.back()); value && !value->resizes() && value->brighter == 1) {
            const Words look = parts.back();
            parts.pop_back();
            add(talk, joined_parts(parts));
            Words all{"them"};
            all.insert(all.end(), look.begin(), look.end());
            return make(talk, all);
        }
    // "brick walls and a concrete floor"
    if (parts.size() > 1 && std::all_of(parts.begin(), parts.end(), [&](const Words& w) {
            return is_one_of(noun_of(w.back()), {"wall", "floor", "ceiling"});
        })) {
        for (const Words& part : parts)
            if (!paint_wanted(talk, part)) throw UsageError("expected how to make it, found \"{}\"", text_of(part));
        return;
    }
    if (brightness_said(talk, words) || paint_wanted(talk, words) || add_like_another(talk, words)) return;
    // "a desk, and a lamp on it": first what that is.
    for (std::size_t k = 1; k < parts.size(); ++k) {
        if (!is_one_of(parts[k].back(), {"it", "them"}) || next_place(parts[k]) == parts[k].size()) continue;
        // "Clear the sideboard and put two candles and a bowl on it": nothing stands on candles.
        const auto first_kind = read_in_room(talk.editor, text_of(parts[k - 1], 0, next_place(parts[k - 1])));
        const bool carries_it = first_kind.objects.empty() || !furnishing::is_small(first_kind.objects.front().kind);
        if (!carries_it && !talk.last.empty() && is_one_of(parts[k][parts[k].size() - 2], {"on", "under"})) {
            const std::vector<std::string> there = talk.last;
            const Words place = part_of(parts[k], next_place(parts[k]));
            do_each(
                talk.editor, parts.size(),
                [&](std::size_t i) {
                    talk.last = there;
                    add(talk, next_place(parts[i]) == parts[i].size() ? joined_words(parts[i], place) : parts[i]);
                },
                [&](std::size_t i) { return text_of(parts[i]); });
            return;
        }
        do_each(
            talk.editor, 2,
            [&](std::size_t n) {
                const bool first = n == 0;
                Words some;
                for (std::size_t i = first ? 0 : k; i < (first ? k : parts.size()); ++i) {
                    if (!some.empty()) some.push_back("and");
                    some.insert(some.end(), parts[i].begin(), parts[i].end());
                }
                // Of a rug and a chair "it" is the chair.
                if (!first && parts[k].back() == "it" && talk.last.size() > 1 && k > 1) talk.last = {talk.last.back()};
                add(talk, some);
            },
            [&](std::size_t n) { return n == 0 ? text_of(parts.front()) : text_of(parts[k]); });
        return;
    }
    if (parts.empty()) throw UsageError("expected a thing to add, found the end of the sentence");
    // "a desk under the window, with a lamp on it"
    for (std::size_t k = parts.size(); k-- > 1;)
        if (parts[k].front() == "with" && parts[k].size() > 1) {
            parts[k - 1].insert(parts[k - 1].end(), parts[k].begin(), parts[k].end());
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
        }
    // "Flowers on the desk and on both tables", "on the desk and the shelf": at each of those places.
    for (std::size_t k = 1; k < parts.size(); ++k) {
        const std::size_t place = next_place(parts[k - 1]);
        if (place >= parts[k - 1].size() || !begins_anew(parts[k - 1])) continue;
        const Words noun = part_of(parts[k - 1], 0, place), there = part_of(parts[k - 1], place);
        const auto before = relation_at(there, 0), now = relation_at(parts[k], 0);
        if (now && now->next < parts[k].size() && parts[k].front() != "with") parts[k] = joined_words(noun, parts[k]);
        else if (before && before->name == "on" && is_definite(parts[k].front()) &&
                 next_place(parts[k]) == parts[k].size() && !all_named(talk.editor, text_of(parts[k])).empty())
            parts[k] = joined_words(joined_words(noun, part_of(there, 0, before->next)), parts[k]);
    }
    // "A lamp over the table and two chairs at the ends": of the table.
    for (std::size_t k = 1; k < parts.size(); ++k) {
        const Words there = part_of(parts[k - 1], next_place(parts[k - 1]));
        const auto relation = there.empty() ? std::nullopt : relation_at(there, 0);
        const std::size_t n = parts[k].size();
        const bool both = n > 1 && is_one_of(parts[k][n - 2], {"each", "both", "either", "other"}) &&
                          is_one_of(parts[k].back(), {"end", "side"});
        if (!relation || (!both && !is_one_of(parts[k].back(), {"ends", "sides"})) || room_part(there, relation->next))
            continue;
        parts[k].push_back("of");
        parts[k].insert(parts[k].end(), there.begin() + static_cast<std::ptrdiff_t>(relation->next), there.end());
    }
    // "Two armchairs and the sofa around the fireplace": what comes as well as what stands there already.
    for (std::size_t k = parts.size(); k-- > 1;) {
        const std::size_t place = next_place(parts[k]), before = next_place(parts[k - 1]);
        const bool joined = text_of(words).find(text_of(parts[k - 1]) + " and " + text_of(parts[k])) !=
                            std::string::npos;
        if (joined && place < parts[k].size() && before == parts[k - 1].size() && stands_already(talk, parts[k]))
            parts[k - 1] = joined_words(parts[k - 1], part_of(parts[k], place));
    }
    add_parts(talk, parts, words);
}

}  // namespace fastscene::editing
