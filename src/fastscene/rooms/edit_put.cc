// "a plant in the corner", "the table for six", "a lamp where the pouf is": things put somewhere, old and new.
#include <algorithm>

#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {
namespace {

// "the armchair by the window and a side table beside it": one stands there, the other comes new. False: all of them
// stand there, or all come new.
bool put_one_by_one(Talk& talk, const Words& words) {
    std::vector<Words> each;  // with all before it that have no place of their own
    bool open = false;
    for (const Words& part : parts_of(words)) {
        if (part.front() == "facing") return false;
        if (!open) each.emplace_back();
        else each.back().push_back("and");
        each.back().insert(each.back().end(), part.begin(), part.end());
        open = next_place(part) == part.size();
    }
    if (open && each.size() > 1) return false;
    if (std::none_of(each.begin(), each.end(), [&](const Words& w) { return begins_anew(w) != begins_anew(each[0]); }))
        return false;
    do_each(
        talk.editor, each.size(), [&](std::size_t k) { put(talk, each[k]); },
        [&](std::size_t k) { return text_of(each[k]); });
    return true;
}

}  // namespace

void put(Talk& talk, const Words& words) {
    // "They need a second bed, put it next to the first one"
    if (!talk.lacks.empty() && is_one_of(words.front(), {"it", "them"})) {
        Words all = tokens_of(std::exchange(talk.lacks, {}));
        all.insert(all.begin(), "a");
        return add(talk, joined_words(all, part_of(words, 1)));
    }
    if (const std::string lamps = lamps_said(words); !lamps.empty()) return make(talk, words);
    if (is_one_of(words.front(), {"the", "a"}) && words.size() > 1 &&
        is_one_of(words[1], {"time", "style", "weather", "hour", "light", "lighting", "color"}))
        return make(talk, words);
    // "the walls to white"
    const std::size_t to = find_word(words, {"to"}, 1);
    if (to < words.size() && value_of(part_of(words, to + 1))) return make(talk, words);
    if (const auto laid = laid_with(talk, words)) return add(talk, *laid);
    if (set_for_guests(talk, words) || put_one_by_one(talk, words)) return;
    const std::size_t end = next_place(words);
    if (is_one_of(text_of(words, end), {"on top of each other", "on each other", "on top of one another"}))
        throw UsageError("things that stand on the floor stay there: \"{}\" cannot be stacked", text_of(words, 0, end));
    const std::string thing = text_of(words, 0, end);
    const bool id = end > 1 && words[end - 1].find_first_not_of("0123456789") == std::string::npos;
    // "sofa at the window": that which is there.
    const bool bare = begins_anew(words) && !number_said(words.front()) && !thing.ends_with("s") && end < words.size();
    if (!begins_anew(words) || id || (bare && all_named(talk.editor, thing).size() == 1)) return move(talk, words);
    add(talk, words);
}

// "three lamps over the table instead of the one": of those.
Words instead_of(const Words& old, const Words& by) {
    if (!is_one_of(old.back(), {"one", "ones", "it"}) || old.size() > 3) return old;
    Words out{"the"};
    for (std::size_t i = 0; i < next_place(by) && by[i] != "instead"; ++i)
        if (!number_said(by[i]) && !is_definite(by[i])) out.push_back(by[i]);
    if (old.back() != "ones" && out.back().size() > 2 && out.back().ends_with("s")) out.back().pop_back();
    return out;
}

std::vector<std::string> those_instead(Talk& talk, const Words& old, const Words& by) {
    const std::size_t place = next_place(by);
    if (next_place(old) < old.size() || is_one_of(old.front(), {"it", "them"})) return talk.things_of_parts(old);
    const std::vector<int> all = all_named(talk.editor, text_of(old));
    const std::vector<int> there = place < by.size() && all.size() > 1
                                       ? all_named(talk.editor, text_of(joined_words(old, part_of(by, place))))
                                       : std::vector<int>{};
    if (there.empty() || there.size() >= all.size()) return talk.things_of_parts(old);
    std::vector<std::string> ids;
    for (const int i : there) ids.push_back(talk.editor.document().things[static_cast<std::size_t>(i)].id);
    return talk.last = ids;
}

namespace {

// "The fridge to the counter and the plant where it was": where this sentence took it from; false: it took nothing.
bool put_where_it_was(Talk& talk, const Words& other, const Words& thing) {
    std::optional<Vec2f> at;
    try {
        at = left_by(talk, talk.things(other).front());
    } catch (const UsageError&) {  // it is gone
        at = talk.last_gone;
    }
    if (!at) return false;
    if (!begins_anew(thing)) return stand_at(talk, talk.things_of_parts(thing), *at), true;
    talk.there = true, talk.last_gone = at, talk.last_gone_from.clear();
    return add(talk, thing), true;
}

}  // namespace

// "a plant where the pouf is": in its place; "the lamp to where the plant stands": they change places.
bool put_where(Talk& talk, const Clause& clause) {
    const Words& words = clause.words;
    const std::size_t where = find_word(words, {"where"}, 1);
    // "The bed to the other side and the toy box where the bed was": one after the other.
    if (const std::vector<Words> parts = parts_of(words);
        parts.size() > 1 && find_word(parts.back(), {"where"}, 1) < parts.back().size() &&
        std::all_of(parts.begin(), parts.end() - 1, [](const Words& w) { return next_place(w) < w.size(); })) {
        do_each(
            talk.editor, parts.size(),
            [&](std::size_t k) {
                Clause one = clause;
                one.words = parts[k];
                talk.act(one);
            },
            [&](std::size_t k) { return text_of(parts[k]); });
        return true;
    }
    if (where + 2 >= words.size() || (clause.verb != Verb::put && clause.verb != Verb::add &&
                                      clause.verb != Verb::want && clause.verb != Verb::move))
        return false;
    Words there = part_of(words, where + 1), thing = part_of(words, 0, where);
    if (there.size() > 3 && text_of(there, there.size() - 3, there.size() - 1) == "used to") {
        there.resize(there.size() - 3);
        there.push_back("was");
    }
    if (!is_one_of(there.back(),
                   {"is", "are", "stands", "stand", "hangs", "hang", "sits", "lies", "was", "were", "stood"}))
        return false;
    const bool was = is_one_of(there.back(), {"was", "were", "stood"});
    there.pop_back();
    if (thing.size() > 1 && is_one_of(thing.back(), {"to", "at"})) thing.pop_back();
    if (was && put_where_it_was(talk, there, thing)) return true;
    if (was && !begins_anew(thing)) throw Error("{}: it is where it was", talk.things(there).front());
    if (begins_anew(thing)) return replace(talk, there, thing), true;
    thing.push_back("and");
    thing.insert(thing.end(), there.begin(), there.end());
    return swap(talk, thing), true;
}

// "the desk so that it faces the window": a turn, where no place was said.
bool says_so_that(const Words& words) {
    const std::size_t so = find_word(words, {"so"}, 1);
    return so < words.size() && find_word(words, {"faces", "looks", "face", "look", "point"}, so) < words.size() &&
           next_place(part_of(words, 0, so)) == so;
}

}  // namespace fastscene::editing
