// What is said beside what is to be done, what is to stay, and what was not done as it was said.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {
namespace {

// The lexicon's word for what a wish was called, where that is not quite what stands there.
std::optional<Word> stand_in_word(const PromptObject& wish) {
    const auto word = look_up(wish.words);
    if (!word || word->kind != WordKind::object || word->exact || word->meaning != wish.kind) return {};
    return word;
}

}  // namespace

// What a remark speaks of is "them" in the clauses that follow.
void remark(Talk& talk, const Words& words) {
    // "A rug is missing, add a red one": a red rug.
    if (const std::size_t lacks = find_word(words, {"is", "are"}, 1);
        lacks + 2 == words.size() && words.back() == "missing")
        talk.last.clear(), talk.lacks = text_of(words, number_said(words.front()) || is_definite(words.front()), lacks);
    // "There is no clock here, add one"
    if (const std::size_t no = find_word(words, {"no"}); no + 1 < words.size() && no < 4)
        talk.last.clear(), talk.lacks = text_of(words, no + 1, words.size() - (words.back() == "here" ? 1 : 0));
    // "The table needs a vase, put a blue one on it"
    if (const std::size_t needs = find_word(words, {"needs", "need", "lacks"}, 1); needs + 2 < words.size()) {
        talk.lacks = text_of(words, needs + (number_said(words[needs + 1]) ? 2 : 1));
        const Words who = part_of(words, 0, needs);
        talk.last.clear();
        if (is_definite(words.front()) && !all_named(talk.editor, text_of(who)).empty()) talk.things_of_parts(who);
    }
    const std::size_t end = find_word(
        words, {"is", "isn't", "isnt", "are", "aren't", "arent", "don't", "dont", "doesn't", "doesnt", "look", "looks",
                "feel", "feels", "seem", "seems", "blocks", "clash", "clashes"});
    if (end > 0 && end < words.size() && is_definite(words.front())) try {
            talk.things_of_parts(part_of(words, 0, end));
        } catch (const UsageError& e) {  // a remark about nothing that stands there
            talk.last.clear(), talk.unclear = e.what();
        }
    // "It is too far from the sofa", "too close to the door"
    if (const std::size_t too = find_word(words, {"too"}); too + 3 < words.size()) {
        const std::size_t to = find_word(words, {"from", "to"}, too);
        talk.too_far.clear(), talk.too_near.clear();
        if (words[too + 1] == "far") talk.too_far = part_of(words, to + 1);
        if (is_one_of(words[too + 1], {"close", "near"})) talk.too_near = part_of(words, to + 1);
    }
    // "There are too many plants": all of them.
    if (const std::size_t many = find_word(words, {"many", "much"}, 1);
        many + 1 < words.size() && words[many - 1] == "too") {
        const std::size_t to = next_place(words, many + 1);
        Words all{"all"};
        for (std::size_t i = many + 1; i < to && words[i] != "here"; ++i) all.push_back(words[i]);
        try {
            if (all.size() > 1) talk.things(joined_words(all, part_of(words, to)));
        } catch (const UsageError& e) {
            talk.unclear = e.what();
        }
    }
    // "I hate that bookshelf"
    if (const std::size_t felt = find_word(words, {"hate", "love", "dislike"}); felt + 1 < words.size()) try {
            talk.things_of_parts(part_of(words, felt + 1));
        } catch (const UsageError& e) {
            talk.last.clear(), talk.unclear = e.what();
        }
    // "I never use the desk"
    for (std::size_t i = 1; i + 1 < words.size() && talk.last.empty() && talk.lacks.empty() && talk.unclear.empty();
         ++i) {
        if (!is_definite(words[i]) || is_one_of(words[i], {"it", "them"})) continue;
        std::size_t to = i + 1;
        while (to < words.size() && next_place(words, to) != to) ++to;
        if (all_named(talk.editor, text_of(words, i, to)).empty()) continue;
        try {
            talk.things(part_of(words, i, to));
        } catch (const UsageError& e) {
            talk.unclear = e.what();
        }
    }
    talk.editor.note("room", fmt::format("\"{}\" is taken as a remark: it changes nothing", text_of(words)));
}

namespace {

// "Keep only six chairs", "leave just the vase on the table": the others go; false: no such words.
bool keep_only(Talk& talk, const Words& words) {
    if (words.size() < 2 || !is_one_of(words.front(), {"only", "just"})) return false;
    const Words some = part_of(words, 1);
    const std::size_t place = next_place(some);
    const auto number = number_said(some.front());
    if (place < some.size() && is_one_of(some[place], {"on", "at"}) && !number) {
        Words all = joined_words({"everything"}, part_of(some, place));
        all.push_back("except");
        return remove(talk, joined_words(all, part_of(some, 0, place))), true;
    }
    if (!number || *number < 1 || is_one_of(some.front(), {"a", "an"})) return false;
    Words noun = part_of(some, 1);
    // "Only two", "just two of them": of those that were spoken of.
    if (noun.empty() || is_one_of(text_of(noun), {"of them", "of those", "of these"})) {
        std::vector<std::string> all = talk.things({"them"});
        const auto left = static_cast<std::size_t>(*number);
        if (left >= all.size()) throw AlreadySo(fmt::format("there are only {} of them", all.size()));
        remove_all(talk, part_of(all, left));
        return true;
    }
    if (noun.front() == "of" && noun.size() > 1) noun.erase(noun.begin());
    if (noun.size() > 1 && is_definite(noun.front())) noun.erase(noun.begin());
    if (!noun.back().ends_with("s") && place == some.size()) noun.back() += "s";
    remove(talk, joined_words(joined_words({"all"}, noun), {"except", some.front()}));
    return true;
}

}  // namespace

void keep(Talk& talk, const Words& words) {
    if (keep_only(talk, words)) return;
    Words bare = words;
    for (bool again = true; again && bare.size() > 1;) {
        again = false;
        for (const char* end :
             {"as it is", "as they are", "as is", "where it is", "where they are", "how it is", "the way it is",
              "the way they are", "the same", "unchanged", "alone", "there", "though"}) {
            const Words tail = tokens_of(end);
            if (bare.size() <= tail.size() || part_of(bare, bare.size() - tail.size()) != tail) continue;
            bare.resize(bare.size() - tail.size());
            again = true;
        }
    }
    if (is_one_of(text_of(bare), {"the rest", "everything else", "all else", "the others", "the other ones",
                                  "all others", "the other things"}))
        return;
    if (text_of(bare).starts_with("the others ") && value_of(part_of(bare, 2))) return;
    if (find_word(bare, {"only", "just"}) < bare.size() || next_place(bare) < bare.size())
        throw UsageError("expected what is to stay as it is, found \"{}\"", text_of(words));
    const std::vector<std::string> before = talk.last;
    add_new(talk.kept, talk.things_of_parts(bare));
    talk.last = before;
}

void check_kept(const Talk& talk, const RoomDocument& before) {
    const auto thing_of = [](const RoomDocument& document, const std::string& id) {
        const auto found = std::find_if(document.things.begin(), document.things.end(),
                                        [&](const DocumentThing& t) { return t.id == id; });
        return found == document.things.end() ? nullptr : &*found;
    };
    for (const std::string& id : talk.kept) {
        const DocumentThing *was = thing_of(before, id), *is = thing_of(talk.editor.document(), id);
        if (was && (!is || is->position != was->position || is->yaw != was->yaw || is->color != was->color ||
                    is->material != was->material || is->size_m != was->size_m))
            throw UsageError("{}: it was to stay as it is, and another part of the sentence changes it", id);
    }
}

void check_stand_in(const PromptObject& wish) {
    if (const auto word = stand_in_word(wish); word && word->far)
        throw UsageError("there is no \"{}\" to add; the nearest is of the kind \"{}\"", wish.words,
                         in_words(wish.kind));
}

void tell_unshown(Talk& talk, const std::vector<std::string>& ids, const PromptObject& wish, const Words& words) {
    if (ids.empty()) return;
    if (stand_in_word(wish))
        talk.editor.note(ids.front(), fmt::format("the nearest thing there is to \"{}\"", wish.words));
    std::vector<std::string> unshown;
    for (const PromptWord& word : read_in_room(talk.editor, text_of(words, 0, next_place(words))).words)
        if (word.fate == PromptWord::Fate::not_understood && is_unknown_adjective(words, word.words))
            unshown.push_back(word.words);
        else if (const auto known = look_up(word.words);
                 word.fate == PromptWord::Fate::approximated && word.words != wish.words && !number_said(word.words) &&
                 known && known->kind != WordKind::object && shape_said({word.words}).empty() &&
                 known->kind != WordKind::relation && !known->meaning.empty())
            unshown.push_back(word.words);
    if (const std::size_t with = find_word(words, {"with"}, 1); with + 1 < words.size() && is_a_part(words[with + 1]))
        unshown.push_back("with " + words[with + 1]);
    // "A space poster" with no print of space
    const Words nouns = tokens_of(wish.words);
    const std::size_t noun = nouns.empty() ? words.size() : find_word(words, {nouns.back()});
    for (std::size_t i = 0;
         has_role(wish.kind, Role::shows_motif) && wish.pattern.empty() && i < noun && noun < words.size(); ++i)
        if (const auto known = look_up(words[i]);
            !number_said(words[i]) && !is_definite(words[i]) &&
            (!known || known->kind == WordKind::filler || known->kind == WordKind::room))
            unshown.push_back(words[i]);
    if (!unshown.empty())
        talk.editor.note(ids.front(), fmt::format("nothing shows \"{}\"", fmt::join(unshown, "\", \"")));
}

// "Angle the chairs towards each other with a table between them": what comes with what was done; false: no such words.
bool done_with(Talk& talk, const Clause& clause) {
    const Words& words = clause.words;
    const bool stands = clause.verb == Verb::move || clause.verb == Verb::turn || clause.verb == Verb::face ||
                        ((clause.verb == Verb::put || clause.verb == Verb::line) && !begins_anew(words)) ||
                        (clause.verb == Verb::want && is_definite(words.front()) &&
                         next_place(words) < find_word(words, {"with"}, 2));
    if (!stands || !is_one_of(words.back(), {"it", "them", "each"})) return false;
    const std::size_t with = find_word(words, {"with"}, 2);
    if (with + 3 >= words.size()) return false;
    const bool anew = number_said(words[with + 1]) || words[with + 1] == "another";
    if (!anew && (!is_definite(words[with + 1]) || is_one_of(words[with + 1], {"it", "them"}))) return false;
    const Words rest = part_of(words, with + 1);
    if (next_place(rest) == rest.size()) return false;
    Clause first = clause;
    first.words = part_of(words, 0, with);
    talk.act(first);
    if (anew) add_there(talk, rest);
    else move(talk, rest);
    return true;
}

std::optional<Words> laid_with(const Talk& talk, const Words& words) {
    const std::size_t with = find_word(words, {"with"}, 1);
    const bool lays = is_one_of(talk.said, {"set", "lay", "decorate", "dress", "fill", "top"});
    const bool those = is_definite(words.front()) || is_one_of(words.front(), {"all", "both", "every", "each"});
    if (!lays || with + 1 >= words.size() || !those || next_place(words) < with) return {};
    Words out = part_of(words, with + 1);
    out.push_back("on");
    out.insert(out.end(), words.begin(), words.begin() + static_cast<std::ptrdiff_t>(with));
    return out;
}

void line_up(Talk& talk, const Words& words) {
    // "line the racks up along the wall"
    if (const std::size_t up = find_word(words, {"up"}, 1); up < words.size()) {
        Words bare = words;
        bare.erase(bare.begin() + static_cast<std::ptrdiff_t>(up));
        return line_up(talk, bare);
    }
    const std::size_t end = next_place(words);
    EditStep step;
    step.kind = EditStep::Kind::line;
    const std::vector<std::string> spoken = talk.last;
    step.ids = talk.things_of_parts(part_of(words, 0, end));
    Words there = part_of(words, end);
    // "The treadmills facing the mirror": in one row.
    if (!there.empty() && there.front() == "facing") {
        talk.last = spoken;
        const Words row = joined_words(joined_words(part_of(words, 0, end), {"in", "one", "row"}), there);
        if (set_in_rows(talk, row)) return;
    }
    if (!there.empty() && is_one_of(text_of(there), {"in a row", "in a line", "side by side"})) there.clear();
    if (!there.empty()) {
        const auto relation = relation_at(there, 0);
        if (relation && relation->name == "on both sides of") {
            Words all = part_of(words, 0, end);
            all.insert(all.end(), there.begin(), there.end());
            return move(talk, all);
        }
        // "Along the wall" is a word of the lexicon.
        std::size_t at = relation ? relation->next : there.size();
        if (at == there.size()) at = 1;
        const auto part = relation ? room_part(there, at) : std::nullopt;
        if (!part || !is_one_of(part->noun, {"wall", "window", "door"}))
            throw UsageError("expected a wall to line things up at, found \"{}\"", text_of(there));
        const bool any = part->noun == "wall" && part->next == there.size() &&
                         std::all_of(part->modifiers.begin(), part->modifiers.end(), [](const std::string& w) {
                             return is_definite(w) || is_one_of(w, {"a", "any", "one"});
                         });
        if (!any) step.wall = wall_meant(talk.editor, part_of(there, at), spoken);
    }
    // One alone stands at that wall.
    if (step.ids.size() == 1 && !there.empty()) step.kind = EditStep::Kind::place, step.wish.relation = "against";
    talk.editor.apply(step);
}

}  // namespace fastscene::editing
