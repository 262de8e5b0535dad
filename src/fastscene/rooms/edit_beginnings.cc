// What clauses begin with.
#include <algorithm>
#include <array>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {
namespace {

// How clauses begin, by what is to be done. The longest that fits counts; what is politely said before it is passed
// over.
struct Row {
    Verb verb;
    std::string_view beginnings;  // with "|" between them
};
constexpr std::array<Row, 24> kBeginnings{{
    {Verb::remove,
     "remove|delete|erase|take away|take out|take|drop|get rid of|throw out|throw away|throw|"
     "lose|discard|ditch|hide|clear away|clear out|without|no more|no|i dont like|chuck out|chuck|bin|scrap|"
     "toss out|take down|eliminate|"
     "i do not like|i dont want|i do not want|i dont need|we dont need|there should be no"},
    {Verb::clear, "clear|empty"},
    {Verb::move,
     "move|shift|bring|push|pull|slide|drag|relocate|lower|raise|lift|carry|nudge|scoot|shove|swing|"
     "reposition|transfer|tuck|combine|join|merge"},
    {Verb::put,
     "put|place|set|lay out|set up|stand|hang|lay|position|mount|lean|put down|put up|lay down|set down|hang up|stack|"
     "pile|pile up|scatter|spread|drape|toss|stick|pop|prop|prop up|rest|squeeze|slot|plop|pin|string|sit|roll "
     "out|unroll|"
     "decorate|dress|arrange|fill|top|group|gather|cluster|collect|bunch|bunch up"},
    {Verb::make, "make|change|switch|give"},
    {Verb::refuse,
     "open|close|shut|rearrange|reorganize|redecorate|improve|fix|undo|redo|divide|separate|partition|straighten|sweep|"
     "mop|dust"},
    {Verb::tidy, "tidy|tidy up|clean|clean up|declutter|straighten up"},
    {Verb::center, "center|centre"},
    {Verb::brighter, "brighten|brighten up|lighten|lighten up|light up|turn up|illuminate"},
    {Verb::darker, "darken|dim|turn down"},
    {Verb::add,
     "add|insert|include|get|create|bring in|have|give me|give us|can i have|can we have|"
     "could i have|could we have|can i get|there should be|there must be|there needs to be|"
     "let there be|it needs|the room needs|install|how about|what about"},
    {Verb::want,
     "i need|we need|i want|we want|i wish|i would like|we would like|id like|id love|"
     "i would love|i prefer|id prefer|let"},
    {Verb::replace, "replace|exchange|substitute|swap out|switch out|change out|trade|trade in"},
    {Verb::swap, "swap|interchange"},
    {Verb::keep, "keep|leave"},
    {Verb::line, "line up|line|align|space|space out|spread out|distribute|even out"},
    {Verb::turn, "turn|rotate|spin|flip"},
    {Verb::face, "face|point|orient|aim|angle"},
    {Verb::color, "paint|color|recolor|dye|tint|repaint|reupholster|cover|tile|carpet|plaster"},
    {Verb::larger, "enlarge|scale up|widen|lengthen|extend|heighten"},
    {Verb::smaller, "shrink|scale down|reduce|shorten|narrow"},
    {Verb::copy, "duplicate|copy|clone"},
    {Verb::kindle, "light|ignite|kindle"},
    {Verb::quench, "put out|blow out|extinguish|snuff out|snuff"},
}};

const std::vector<Beginning>& beginnings() {
    static const std::vector<Beginning> all = [] {
        std::vector<Beginning> out;
        for (const Row& row : kBeginnings) {
            std::string_view left = row.beginnings;
            while (!left.empty()) {
                const std::string_view one = left.substr(0, left.find('|'));
                left.remove_prefix(std::min(left.size(), one.size() + 1));
                out.push_back({tokens_of(one), row.verb});
            }
        }
        return out;
    }();
    return all;
}

// Said before what is to be done, and nothing by itself.
constexpr std::array<std::string_view, 47> kPolite{"please",
                                                   "pls",
                                                   "plz",
                                                   "can you",
                                                   "could you",
                                                   "would you",
                                                   "will you",
                                                   "can we",
                                                   "could we",
                                                   "you should",
                                                   "we should",
                                                   "you can",
                                                   "i want to",
                                                   "i want you to",
                                                   "i would like to",
                                                   "i would like you to",
                                                   "id like to",
                                                   "id like you to",
                                                   "we want to",
                                                   "let's",
                                                   "lets",
                                                   "let us",
                                                   "let me",
                                                   "try to",
                                                   "go ahead and",
                                                   "just",
                                                   "now",
                                                   "then",
                                                   "also",
                                                   "maybe",
                                                   "perhaps",
                                                   "next",
                                                   "ok",
                                                   "okay",
                                                   "hey",
                                                   "hi",
                                                   "actually",
                                                   "first",
                                                   "finally",
                                                   "kindly",
                                                   "afterwards",
                                                   "would you mind",
                                                   "how about",
                                                   "what about",
                                                   "try",
                                                   "consider",
                                                   "i need you to"};

std::size_t count_of(std::string_view phrase) {
    return static_cast<std::size_t>(std::count(phrase.begin(), phrase.end(), ' ')) + 1;
}

}  // namespace

bool stands_at(const Words& words, std::size_t at, std::string_view phrase) {
    const std::size_t count = count_of(phrase);
    return at + count <= words.size() && text_of(words, at, at + count) == phrase;
}

std::size_t past_polite(const Words& words, std::size_t at) {
    const auto anew = [&](std::size_t next) {  // "how about a plant" is a wish
        return next < words.size() && !beginning_at(words, next);
    };
    for (bool again = true; again;) {
        again = false;
        std::size_t longest = 0;
        for (const std::string_view phrase : kPolite)
            if (stands_at(words, at, phrase) && !(phrase.ends_with("about") && anew(at + count_of(phrase))))
                longest = std::max(longest, count_of(phrase));
        if (longest == 0) continue;
        at += longest, again = true;
        while (at < words.size() && words[at] == ",") ++at;  // "now, remove it"
    }
    return at;
}

const Beginning* beginning_at(const Words& words, std::size_t at) {
    const Beginning* best = nullptr;
    // "Light the candles", but "light blue walls"; "tile the floor", but "tile on the floor".
    const auto is_of_those = [&](std::size_t next) {
        return next < words.size() &&
               (is_definite(words[next]) || is_one_of(words[next], {"all", "both", "every", "each"}));
    };
    for (const Beginning& b : beginnings()) {
        if (part_of(words, at, at + b.words.size()) != b.words || (best && b.words.size() <= best->words.size()))
            continue;
        // "No, the bench" takes nothing away.
        if (b.words.back() == "no" && at + 1 < words.size() && is_joint(words[at + 1])) continue;
        // "String lights" are no verb.
        if (const std::size_t next = at + 1; at > 0 && b.words.size() == 1 && next < words.size())
            if (const auto thing = look_up(words[at] + " " + words[next]); thing && thing->kind == WordKind::object)
                continue;
        const bool of_those = b.verb == Verb::kindle || b.verb == Verb::quench ||
                              is_one_of(b.words.front(), {"tile", "carpet", "plaster"});
        if (!of_those || is_of_those(at + b.words.size())) best = &b;
    }
    return best;
}

bool begins_clause(const Words& words) { return beginning_at(words, 0) != nullptr; }

}  // namespace fastscene::editing
