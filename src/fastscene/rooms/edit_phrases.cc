// What people say otherwise, in the words that the rest reads: "apart from the vase", "a tad", "how about moving it".
#include <algorithm>
#include <array>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {
namespace {

struct Phrase {
    std::string_view said, means;
};
// Longer ones before those that they begin with.
constexpr std::array<Phrase, 125> kPhrases{{
    {"with the fire burning", ", light the fire"},
    {"with the fire lit", ", light the fire"},
    {"with the fire on", ", light the fire"},
    {"on its edge", "on it"},
    {"on its rim", "on it"},
    {"on top of it", "on it"},
    {"the existing ones", "the others"},
    {"the ones there", "the others"},
    {"a darker shade", "darker"},
    {"a lighter shade", "lighter"},
    {"a shade darker", "darker"},
    {"a shade lighter", "lighter"},
    {"in two colors", "in two different colors"},
    {"facing outside", "facing the window"},
    {"looking outside", "facing the window"},
    {"faces outside", "faces the window"},
    {"facing outwards", "facing the window"},
    {"that has none", "without one"},
    {"that have none", "without one"},
    {"that has no", "without"},
    {"that have no", "without"},
    {"who have none", "without one"},
    {"with none", "without one"},
    {"so they face each other", "facing each other"},
    {"so that they face each other", "facing each other"},
    {"so they are facing each other", "facing each other"},
    {"so that they are facing each other", "facing each other"},
    {"to face each other", "facing each other"},
    {"face to face", "facing each other"},
    {"vase with flowers", "vase of flowers"},
    {"vase with fresh flowers", "vase of flowers"},
    {"vase of fresh flowers", "vase of flowers"},
    {"king size", "larger"},
    {"king sized", "larger"},
    {"queen size", "larger"},
    {"queen sized", "larger"},
    {"twin beds", "single beds"},
    {"twin bed", "single bed"},
    {"a lower", "a low"},
    {"a higher", "a tall"},
    {"angled towards", "facing"},
    {"angled toward", "facing"},
    {"turned towards", "facing"},
    {"turned toward", "facing"},
    {"window sill", "windowsill"},
    {"window sills", "windowsills"},
    {"window ledge", "windowsill"},
    {"the one that is there", "the existing one"},
    {"the one that's there", "the existing one"},
    {"the ones that are there", "the others"},
    {"next to each other facing", "in a row facing"},
    {"side by side facing", "in a row facing"},
    {"in a ring", "in a circle"},
    {"u shape", "semicircle"},
    {"horseshoe", "semicircle"},
    {"infront", "in front"},
    {"ontop", "on top"},
    {"inbetween", "in between"},
    {"nextto", "next to"},
    {"abit", "a bit"},
    {"aswell", "as well"},
    {"alot", "a lot"},
    {"a little bit", "a bit"},
    {"a wee bit", "a bit"},
    {"a tiny bit", "a bit"},
    {"a tad bit", "a bit"},
    {"a tad", "a bit"},
    {"a touch", "a bit"},
    {"a smidge", "a bit"},
    {"a hair", "a bit"},
    {"ever so slightly", "a bit"},
    {"with the exception of", "except"},
    {"apart from", "except"},
    {"aside from", "except"},
    {"other than", "except"},
    {"save for", "except"},
    {"rather than", "instead of"},
    {"looks out of the window", "faces the window"},
    {"looks out the window", "faces the window"},
    {"look out of the window", "face the window"},
    {"look out the window", "face the window"},
    {"looking out of the window", "facing the window"},
    {"looking out the window", "facing the window"},
    {"looking at", "facing"},
    {"looking towards", "facing"},
    {"looking toward", "facing"},
    {"on the left and right of", "on both sides of"},
    {"to the left and right of", "on both sides of"},
    {"left and right of", "on both sides of"},
    {"on the left and the right of", "on both sides of"},
    {"on the left and right side of", "on both sides of"},
    {"to the left and to the right of", "on both sides of"},
    {"on either end of", "on both ends of"},
    {"at either end of", "on both ends of"},
    {"left hand side", "left side"},
    {"right hand side", "right side"},
    {"left hand", "left"},
    {"right hand", "right"},
    {"smack in the middle", "in the middle"},
    {"right in the middle", "in the middle"},
    {"dead center", "in the middle"},
    {"in the dead center", "in the middle"},
    {"bang in the middle", "in the middle"},
    {"that is standing on", "on"},
    {"that are standing on", "on"},
    {"that stand on", "on"},
    {"that's standing on", "on"},
    {"standing on", "on"},
    {"sitting on", "on"},
    {"lying on", "on"},
    {"located", ""},
    {"end chairs", "chairs at the ends"},
    {"wall with the window", "window wall"},
    {"wall with the windows", "window wall"},
    {"wall with the door", "door wall"},
    {"so it runs the other way", "by 90 degrees"},
    {"so that it runs the other way", "by 90 degrees"},
    {"long side of", "side of"},
    {"long sides of", "sides of"},
    {"the whole lot", "them all"},
    {"kind of", ""},
    {"sort of", ""},
    {"a bunch of", "some"},
    {"a pair of", "two"},
}};

// Said of what comes: "a lava lamp here would be cool".
bool is_praise(const std::string& word) {
    return is_one_of(word, {"nice", "great", "cool", "good", "lovely", "perfect", "awesome", "fantastic", "amazing",
                            "ideal", "better", "wonderful", "sweet"});
}

void say(Words& words, std::string_view said, std::string_view means) {
    const Words phrase = tokens_of(said), by = tokens_of(means);
    for (std::size_t i = 0; i + phrase.size() <= words.size(); ++i) {
        if (part_of(words, i, i + phrase.size()) != phrase) continue;
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                    words.begin() + static_cast<std::ptrdiff_t>(i + phrase.size()));
        words.insert(words.begin() + static_cast<std::ptrdiff_t>(i), by.begin(), by.end());
    }
}

// "A plant by the window would be nice": add it.
Words as_wishes(const Words& words) {
    Words out;
    for (std::size_t from = 0; from < words.size();) {
        std::size_t end = from;
        while (end < words.size() && !is_one_of(words[end], {",", ".", ";"})) ++end;
        Words part = part_of(words, from, end);
        if (const std::size_t would = find_word(part, {"would"}, 1);
            would + 2 < part.size() && part[would + 1] == "be" && is_praise(part.back())) {
            // Behind the last "and": "…, and a lamp here would be nice".
            std::size_t begins = would;
            while (begins > 0 && part[begins - 1] != "and") --begins;
            Words wish = part_of(part, begins, would);
            if (!wish.empty() && begins_anew(wish)) wish.insert(wish.begin(), "add");
            part = joined_words(part_of(part, 0, begins), wish);
        }
        out = joined_words(out, part);
        if (end < words.size()) out.push_back(words[end]);
        from = end + 1;
    }
    return out;
}

// "Could the sofa and the armchair swap places": swap them.
Words as_swap(const Words& words) {
    const std::size_t swap = find_word(words, {"swap", "switch", "trade", "exchange", "change"}, 3);
    if (!is_one_of(words.front(), {"can", "could", "may", "let", "have"}) || swap + 1 >= words.size() ||
        !is_definite(words[1]) || !is_one_of(words[swap + 1], {"places", "sides", "positions", "spots", "seats"}))
        return words;
    Words out{"swap"};
    out = joined_words(out, part_of(words, 1, swap));
    return joined_words(out, part_of(words, swap + 2));
}

}  // namespace

std::string stem_of_gerund(const std::string& word) {
    constexpr std::size_t kLeast = 5;  // letters
    if (word.size() < kLeast || !word.ends_with("ing")) return {};
    std::string stem = word.substr(0, word.size() - 3);
    const auto begins = [](const std::string& verb) { return begins_clause({verb}); };
    if (begins(stem)) return stem;                                                 // "hanging"
    if (begins(stem + "e")) return stem + "e";                                     // "moving"
    if (stem.size() > 2 && stem.back() == stem[stem.size() - 2]) stem.pop_back();  // "putting"
    return begins(stem) ? stem : "";
}

namespace {

// "The table to the right of the armchair and a lamp to the left": of the armchair.
Words with_sides(Words words) {
    Words anchor;
    for (std::size_t i = 2; i < words.size(); ++i) {
        if (!is_one_of(words[i], {"left", "right", "side"})) continue;
        const bool ends = i + 1 == words.size() || is_joint(words[i + 1]);
        if (!ends && words[i + 1] == "of") {
            anchor.clear();
            for (std::size_t k = i + 2; k < words.size() && !is_joint(words[k]); ++k) anchor.push_back(words[k]);
            continue;
        }
        const bool other = words[i] != "side" || words[i - 1] == "other";
        if (!ends || anchor.empty() || !other ||
            find_word(part_of(words, i - std::min<std::size_t>(3, i), i), {"to", "on", "at"}) ==
                std::min<std::size_t>(3, i))
            continue;
        words.insert(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, "of");
        words.insert(words.begin() + static_cast<std::ptrdiff_t>(i) + 2, anchor.begin(), anchor.end());
        i += anchor.size() + 1;
    }
    return words;
}

}  // namespace

namespace {

// "A reading corner with an armchair and a lamp": those in the corner.
void as_corner(Words& words) {
    for (std::size_t i = 1; i + 2 < words.size(); ++i) {
        if (!is_one_of(words[i], {"corner", "nook"}) || words[i + 1] != "with") continue;
        std::size_t from = i;
        while (from > 0 && !is_one_of(words[from], {"a", "an"}) && i - from < 3) --from;
        if (!is_one_of(words[from], {"a", "an"})) continue;
        std::size_t end = i + 2;
        while (end < words.size() && !(is_joint(words[end]) && end + 1 < words.size() && beginning_at(words, end + 1)))
            ++end;
        Words all = joined_words(part_of(words, 0, from), part_of(words, i + 2, end));
        if (next_place(part_of(words, i + 2, end)) + i + 2 == end) all = joined_words(all, {"in", "the", "corner"});
        words = joined_words(all, part_of(words, end));
    }
}

// "We only need six chairs": keep only six.
void as_keeping(Words& words) {
    for (std::size_t i = 0; i + 3 < words.size(); ++i) {
        if (!is_one_of(words[i], {"we", "i"}) || words[i + 1] != "only" || !is_one_of(words[i + 2], {"need", "want"}))
            continue;
        const auto number = number_said(words[i + 3]);
        if (!number || is_one_of(words[i + 3], {"a", "an"})) continue;
        words[i] = "keep";
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(i) + 2);
    }
}

// "Two lamps, one on each nightstand": one lamp on each nightstand.
void as_one_each(Words& words) {
    for (std::size_t i = 2; i + 3 < words.size(); ++i) {
        if (words[i] != "one" || !is_one_of(words[i - 1], {",", "and"}) || !relation_at(words, i + 1)) continue;
        std::size_t end = i + 1;
        while (end < words.size() && !is_joint(words[end])) ++end;
        if (!has_word(part_of(words, i, end), {"each", "either", "both", "every"})) continue;
        std::size_t from = i - 1;
        while (from > 0 && is_joint(words[from])) --from;
        while (from > 0 && !is_joint(words[from]) && !(number_said(words[from]) && *number_said(words[from]) >= 2))
            --from;
        const auto number = number_said(words[from]);
        if (!number || *number < 2) continue;
        std::size_t stop = i;
        while (is_joint(words[stop - 1])) --stop;
        const Words first = part_of(words, from, stop);
        if (const std::size_t place = next_place(first); place < first.size()) {
            // "Two lamps on it, one on each side": on each side of it.
            const auto relation = relation_at(first, place);
            if (!relation || !is_one_of(words[end - 1], {"side", "end"})) continue;
            Words all = part_of(words, 0, from + place);
            all = joined_words(joined_words(all, part_of(words, i + 1, end)), {"of"});
            all = joined_words(all, part_of(first, relation->next));
            words = joined_words(all, part_of(words, end));
            continue;
        }
        words[from] = "one";
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(stop),
                    words.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
}

// "A lamp next to that": next to it.
void as_it(Words& words) {
    for (std::size_t i = 1; i < words.size(); ++i)
        if (words[i] == "that" && (i + 1 == words.size() || is_joint(words[i + 1])) &&
            is_one_of(words[i - 1], {"to", "by", "beside", "on", "above", "over", "behind", "under", "below", "near",
                                     "of", "against"}))
            words[i] = "it";
}

// "The beds side by side with a nightstand in between": and that between them.
void as_between_them(Words& words) {
    const std::size_t n = words.size(), with = find_word(words, {"with"}, 2);
    if (n < 6 || with + 3 >= n || words[n - 2] != "in" || words[n - 1] != "between") return;
    if (!is_one_of(words[with + 1], {"a", "an"}) || is_joint(words[with - 1])) return;
    words.resize(n - 2);
    words.insert(words.end(), {"between", "them"});
    words[with] = "and";
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(with) + 1, "put");
}

}  // namespace

Words in_plain_words(Words words) {
    for (const Phrase& p : kPhrases) say(words, p.said, p.means);
    if (words.empty()) return words;
    as_keeping(words), as_corner(words), as_one_each(words), as_it(words), as_between_them(words);
    words = with_sides(words);
    words = as_swap(as_wishes(words));
    // "How about moving the sofa and adding a lamp"
    const std::size_t asked = find_word(words, {"about", "mind", "try", "consider", "start", "begin"});
    for (std::size_t i = asked + 1; i < words.size(); ++i)
        if ((i == asked + 1 || is_one_of(words[i - 1], {"by", "and", ","})) && words[i] != "facing")
            if (const std::string stem = stem_of_gerund(words[i]); !stem.empty()) words[i] = stem;
    return words;
}

}  // namespace fastscene::editing
