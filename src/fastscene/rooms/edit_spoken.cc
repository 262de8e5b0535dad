// The things that a sentence speaks of: "it", "its chairs", "the rest", "all but the first one".
#include <fmt/format.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {

std::string asked_kind(const Placed& p) { return p.wish.kind.empty() ? p.piece.kind : p.wish.kind; }

std::size_t find_word(const Words& words, std::initializer_list<std::string_view> any, std::size_t from) {
    for (std::size_t i = from; i < words.size(); ++i)
        if (std::find(any.begin(), any.end(), words[i]) != any.end()) return i;
    return words.size();
}

bool has_word(const Words& words, std::initializer_list<std::string_view> any) {
    return find_word(words, any) < words.size();
}

void add_new(std::vector<std::string>& to, const std::vector<std::string>& more) {
    for (const std::string& id : more)
        if (std::find(to.begin(), to.end(), id) == to.end()) to.push_back(id);
}

std::vector<std::string> Talk::things(const Words& words) {
    std::vector<std::string> out = meant(words);
    mention(out);
    return out;
}

std::vector<std::string> Talk::meant(const Words& said_words) {
    Words words = said_words;
    // "them all", "both of them", "all of those"
    if (words.size() > 1 && words.size() < 4 && find_word(words, {"them", "it", "those", "these"}) < words.size() &&
        std::all_of(words.begin(), words.end(), [](const std::string& w) {
            return is_one_of(w, {"them", "it", "those", "these", "all", "both", "of", "each"});
        })) {
        // "Two more stools … make them all black": those that stood there as well.
        const bool all = has_word(words, {"all"}) && more_came && !noun.empty();
        words = all ? Words{"all", noun + "s"} : Words{"them"};
    }
    if (words.size() == 1 && is_one_of(words.front(), {"it", "them", "they", "that", "those", "these"})) {
        if (last.empty() && !unclear.empty()) throw UsageError("{}", unclear);
        if (last.empty()) throw UsageError("what is \"{}\"? nothing was named before", words.front());
        return last;
    }
    // "the shelf next to it"
    if (words.size() > 2 && is_one_of(words.back(), {"it", "them"}) && next_place(words) + 1 < words.size() &&
        last.size() == 1) {
        words.back() = last.front();
        return things(words);
    }
    // "its chairs": those that stand at it or on it.
    if (words.size() > 1 && is_one_of(words.front(), {"its", "their"})) {
        if (last.empty()) throw UsageError("whose is \"{}\"? nothing was named before", text_of(words));
        std::vector<std::string> ids;
        for (const int i : all_named(editor, "all " + text_of(words, 1))) {
            const DocumentThing& t = editor.document().things[static_cast<std::size_t>(i)];
            const bool carries = std::any_of(last.begin(), last.end(),
                                             [&](const std::string& id) { return editor.placed(id).on == i; });
            if (is_among(t.on, last) || is_among(t.with, last) || carries) ids.push_back(t.id);
        }
        if (ids.empty()) throw UsageError("nothing at {} is \"{}\"", last.front(), text_of(words, 1));
        return last = ids;
    }
    // "the first one"
    const bool but_one = words.size() > 1 && is_one_of(words[words.size() - 2], {"except", "but"});
    if (words.size() > 1 && is_one_of(words.back(), {"one", "ones"}) && !noun.empty() && !but_one) {
        Words all = words;
        all.back() = noun;
        return things(all);
    }
    // "The one near the door", "the other"
    if (words.size() > 2 && words[0] == "the" && is_one_of(words[1], {"one", "ones"}) && !noun.empty()) {
        Words all = joined_words({"the"}, tokens_of(words[1] == "one" ? noun : noun + "s"));
        return things(joined_words(all, part_of(words, 2)));
    }
    if (words == Words{"the", "other"} && !noun.empty()) return things(joined_words(words, tokens_of(noun)));
    if (says_all_but_some(words)) {
        Words all{"all"};
        all.insert(all.end(), words.begin() + 3, words.end());
        return last = all_but(all, {words[2]});
    }
    if (const auto riders = all_that_stands_on(*this, words)) return last = *riders;
    if (const auto rest = the_rest(words)) return last = *rest;
    const std::size_t except = find_word(words, {"except", "but", "excluding", "besides"}, 1);
    if (except + 1 < words.size()) return last = all_but(part_of(words, 0, except), part_of(words, except + 1));
    // "the other lights": all that shine, but those that were spoken of.
    if (find_word(words, {"other"}) < words.size() && is_one_of(words.back(), {"lights", "lamps"})) {
        std::vector<std::string> ids;
        for (const Placed& p : editor.room().furnished.placed)
            if (has_role(p.piece.kind, Role::light) && can_shine(p) && !is_among(p.id, last)) ids.push_back(p.id);
        if (!ids.empty()) return last = ids;
    }
    // "the other armchair": not the one last spoken of, else none of those named before.
    if (const std::size_t other = find_word(words, {"other"}); other < words.size())
        for (const std::vector<std::string>* those : {&last, &mentioned}) {
            std::vector<std::string> ids;
            for (const int i : all_named(editor, text_of(words)))
                ids.push_back(editor.document().things[static_cast<std::size_t>(i)].id);
            const std::size_t all = ids.size();
            std::erase_if(ids, [&](const std::string& id) { return is_among(id, *those); });
            if (ids.size() == all) continue;
            if (ids.size() == 1 || (!ids.empty() && words.back().ends_with("s"))) return last = ids;
        }
    last = named(editor, text_of(words));
    if (const Words all = joined_words({"all"}, part_of(words, words.size() > 1 && words[1] == "of" ? 2 : 1));
        words.front() == "half" && all.size() > 1)
        if (const std::size_t count = all_named(editor, text_of(all)).size(); count % 2 != 0)
            editor.note("room", fmt::format("half of {} is taken as {}", count, last.size()));
    noun = in_words(asked_kind(editor.placed(last.front())));
    return last;
}

void Talk::mention(const std::vector<std::string>& ids) {
    for (const std::string& id : ids) std::erase(mentioned, id);
    add_new(mentioned, ids);
    std::erase_if(mentioned, [&](const std::string& id) {  // what is gone
        const auto& all = editor.document().things;
        return std::none_of(all.begin(), all.end(), [&](const DocumentThing& t) { return t.id == id; });
    });
}

void Talk::mention_place(const EditStep& place, const std::vector<std::string>& fresh) {
    const std::vector<std::string> at = place.wish.relation_to.empty() ? std::vector<std::string>{}
                                                                       : things_at(editor, place);
    if (fresh.empty() || at.size() < 2) return mention(at);
    for (const std::string& id : fresh) {
        const Placed& p = editor.placed(id);
        const auto off = [&](const std::string& a) {
            return distance_to(footprint_of(editor.placed(a)), flat(p.position));
        };
        mention({*std::min_element(at.begin(), at.end(),
                                   [&](const std::string& a, const std::string& b) { return off(a) < off(b); })});
    }
}

std::vector<Words> Talk::each_of_the_others(const Words& words) const {
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i] != "the" || words[i + 1] != "other") continue;
        std::size_t end = i + 2;
        while (end < words.size() && !is_joint(words[end]) && words[end] != "with" && next_place(words, end) != end)
            ++end;
        if (end > i + 2 && !noun_of(words[end - 1]).empty()) continue;
        // "The other", "the other one", "the other two": of the kind that was named last.
        const std::string& last_word = words[end - 1];
        const bool counted = end == i + 3 && number_said(last_word) && last_word != "one";
        const bool bare = end == i + 2 || counted || is_one_of(last_word, {"one", "ones"});
        const bool several = counted || (end > i + 2 && last_word.ends_with("s"));
        for (auto named = mentioned.rbegin(); named != mentioned.rend(); ++named) {
            const auto& all = editor.document().things;
            if (std::none_of(all.begin(), all.end(), [&](const DocumentThing& t) { return t.id == *named; })) continue;
            const Words called = bare ? tokens_of(in_words(asked_kind(editor.placed(*named))))
                                      : part_of(words, i + 2, end);
            std::vector<std::string> ids;
            for (const int k : all_named(editor, text_of(called)))
                ids.push_back(editor.document().things[static_cast<std::size_t>(k)].id);
            if (!is_among(*named, ids)) continue;
            std::erase_if(ids, [&](const std::string& id) { return is_among(id, mentioned); });
            if (ids.empty() || (!several && ids.size() != 1) ||
                (counted && static_cast<float>(ids.size()) != *number_said(last_word)))
                break;
            std::vector<Words> out;
            for (const std::string& id : ids) {
                Words one = part_of(words, 0, i);
                one.push_back(id);
                out.push_back(joined_words(one, part_of(words, end)));
            }
            return out;
        }
    }
    return {words};
}

Words Talk::with_others(const Words& words) const {
    const std::vector<Words> each = each_of_the_others(words);
    Words out = each.size() == 1 ? each.front() : words;
    // "On the left nightstand, and books on the right one": nightstand.
    for (std::size_t i = 2; i < out.size() && !mentioned.empty(); ++i) {
        if (out[i] != "one" || out[i - 2] != "the" ||
            !is_one_of(out[i - 1], {"left", "right", "first", "second", "third", "last", "larger", "smaller"}))
            continue;
        const Words called = tokens_of(in_words(asked_kind(editor.placed(mentioned.back()))));
        out = joined_words(joined_words(part_of(out, 0, i), called), part_of(out, i + 1));
    }
    return out;
}

bool says_the_rest(const Words& words) {
    return is_one_of(text_of(words),
                     {"the rest", "the others", "all others", "all the others", "the rest of them", "the other ones",
                      "the remaining ones", "the remaining", "the ones left", "the ones that are left"});
}

// "The rest", "the other ones", "the remaining chairs": of what was last spoken of by name, those that were not meant.
std::optional<std::vector<std::string>> Talk::the_rest(const Words& words) const {
    const bool bare = says_the_rest(words) || is_one_of(text_of(words), {"the other half", "the remaining half"});
    const bool named_so = words.size() > 2 && words.front() == "the" && words[1] == "remaining";
    const bool rest_of = words.size() > 3 && text_of(words, 0, 3) == "the rest of" && words.back() != "them";
    if (!named_so && !rest_of && (!bare || noun.empty())) return {};
    if (rest_of && last.empty())
        throw UsageError("the rest of what? nothing was named before, in \"{}\"", text_of(words));
    Words of = tokens_of(noun);
    if (named_so) of = part_of(words, number_said(words[2]) ? 3 : 2);
    if (rest_of) of = part_of(words, is_definite(words[3]) ? 4 : 3);
    std::vector<std::string> ids;
    for (const int i : all_named(editor, "all " + text_of(of)))
        if (const std::string& id = editor.document().things[static_cast<std::size_t>(i)].id; !is_among(id, last))
            ids.push_back(id);
    if (ids.empty()) throw UsageError("nothing is left that \"{}\" could be", text_of(words));
    return ids;
}

// "all pictures except the largest one"
std::vector<std::string> Talk::all_but(const Words& words, Words others) {
    std::vector<std::string> ids = things(words);
    if (!others.empty() && is_one_of(others.front(), {"for", "not"})) others.erase(others.begin());
    // "all chairs but one", "… but two of them": "a chair" is the last one, and the first ones stay.
    if (const auto some = others.empty() ? std::nullopt : number_said(others.front());
        some && *some >= 1 && (others.size() == 1 || text_of(others, 1) == "of them")) {
        const auto left = static_cast<std::size_t>(*some);
        if (left >= ids.size()) throw AlreadySo(fmt::format("there are only {} of \"{}\"", ids.size(), text_of(words)));
        return {ids.begin() + static_cast<std::ptrdiff_t>(left), ids.end()};
    }
    // "Except those on the desk": things of that kind.
    if (others.size() > 1 && is_one_of(others.front(), {"those", "these"}))
        others = joined_words({"all", words.back()}, part_of(others, 1));
    // "the largest one", "the one above the bed"
    if (const std::size_t one = find_word(others, {"one", "ones"}, others.size() > 1 ? 1 : 0);
        one < others.size() && !(one + 1 < others.size() && others[one + 1] == "of"))
        others[one] = others[one] == "one" ? singular(words.back()) : words.back();
    const std::vector<std::string> left = things_of_parts(others);
    std::erase_if(ids, [&](const std::string& id) { return std::find(left.begin(), left.end(), id) != left.end(); });
    if (ids.empty()) throw UsageError("nothing but {} is meant by \"{}\"", left.front(), text_of(words));
    return ids;
}

std::vector<std::string> Talk::things_of_parts(const Words& words) {
    std::vector<std::string> ids;
    for (const Words& part : parts_of(with_its(words))) add_new(ids, things(part));
    if (ids.empty()) throw UsageError("expected a thing of the room, found the end of the sentence");
    return last = ids;
}

}  // namespace fastscene::editing
