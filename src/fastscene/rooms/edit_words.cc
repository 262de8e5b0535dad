// Which things of a room words mean.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/materials.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene {
namespace editing {
namespace {

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

// "coffee_table" and "dining_table_round" are tables, "table_lamp" and "picture_ledge" are no table and no picture.
bool is_a(const std::string& kind, const std::string& word) {
    if (kind == word || kind.ends_with("_" + word) || kind.ends_with("_" + word + "s")) return true;
    const std::string all = "_" + kind;
    const auto at = all.find("_" + word + "_");
    return at != std::string::npos && is_form_of(all.substr(at + 1), word);
}

// Things of the kind that words name: of that very kind, else of one that the word is a part of ("table" of a coffee
// table), else of one whose name ends so ("chair" of an armchair).
std::vector<int> alike(const RoomDocument& document, const PromptObject& said, bool several) {
    std::vector<int> exact, near, ending;
    const std::string last = singular(said.words.substr(said.words.rfind(' ') + 1));
    for (std::size_t i = 0; i < document.things.size(); ++i) {
        const DocumentThing& t = document.things[i];
        const std::string asked = t.asked ? t.asked->kind : "";
        const bool is = t.kind == said.kind || asked == said.kind;
        if (is) exact.push_back(static_cast<int>(i));
        if (is || is_a(t.kind, last) || (!asked.empty() && is_a(asked, last))) near.push_back(static_cast<int>(i));
        if (t.kind.ends_with(last)) ending.push_back(static_cast<int>(i));
    }
    // Where chairs stand, "the chairs" are no rows of seats.
    if (!exact.empty())
        std::erase_if(near, [&](int i) {
            const std::string& kind = document.things[static_cast<std::size_t>(i)].kind;
            return kind != said.kind && kind.ends_with("_" + last + "s");
        });
    // "A table" is any, "a chair" first of all a chair; "all plants" are trees as well, "console tables" nothing else.
    const bool by_name = plain_name(said.kind) == plain_name(singular(said.words));
    const bool one_word = said.words.find(' ') == std::string::npos;
    if (!exact.empty() && (!one_word || (by_name && !several))) return exact;
    // "The rocking chair" is no office chair; a round dining table is a dining table.
    if (!one_word && by_name)
        std::erase_if(near, [&](int i) {
            const std::string& kind = document.things[static_cast<std::size_t>(i)].kind;
            return kind != last && !is_a(kind, said.kind);
        });
    if (!one_word && by_name) return near;
    if (!near.empty() || !ending.empty()) return near.empty() ? ending : near;
    // "The palms", where only trees stand.
    for (std::size_t i = 0; i < document.things.size() && !by_name; ++i)
        if (is_a(document.things[i].kind, said.kind)) near.push_back(static_cast<int>(i));
    if (!near.empty()) return near;
    // "The counter" of a shop is its checkout, "the stove" a part of the kitchen's units.
    const auto has = [&](const std::vector<std::string>& names) {
        return std::find(names.begin(), names.end(), last) != names.end();
    };
    for (std::size_t i = 0; i < document.things.size(); ++i)
        if (const Thing* row = find_thing(document.things[i].kind); row && (has(row->called) || has(row->parts)))
            near.push_back(static_cast<int>(i));
    return near;
}

// "Two of the chairs" are chairs.
std::string without_number(const std::vector<std::string>& tokens) {
    if (tokens.size() < 3 || tokens[1] != "of") return joined(tokens);
    if (!number_said(tokens[0]) && !is_one_of(tokens[0], {"all", "both", "each", "some", "any"})) return joined(tokens);
    std::vector<std::string> rest(tokens.begin() + 2, tokens.end());
    if (tokens[0] == "all" || tokens[0] == "both" || tokens[0] == "each") rest.insert(rest.begin(), tokens[0]);
    return joined(rest);
}

// What words mean, before it is known whether one or several were meant.
struct Meaning {
    PromptObject said;
    std::vector<int> found;
    bool unknown = false;  // the words name no thing at all
};

// The bed has the bedding.
std::vector<int> with_part(const Editor& editor, const std::vector<std::string>& tokens) {
    std::vector<std::string> bare = tokens;
    std::erase_if(bare, [](const std::string& w) { return is_one_of(w, {"the", "my", "of", "a"}); });
    const auto word = look_up(joined(bare));
    std::vector<int> out;
    if (!word || word->kind != WordKind::detail || word->meaning != "textile") return out;
    for (std::size_t i = 0; i < editor.document().things.size(); ++i)
        if (has_role(editor.document().things[i].kind, Role::bed)) out.push_back(static_cast<int>(i));
    return out;
}

// Whether the phrase is in the words, in the plural as well.
bool says_phrase(const Words& words, const Words& phrase) {
    for (std::size_t i = 0; i + phrase.size() <= words.size(); ++i) {
        Words there = part_of(words, i, i + phrase.size());
        if (there.back() == phrase.back() + "s") there.back().pop_back();
        if (there == phrase) return true;
    }
    return false;
}

// "the towel stack", "two dining tables": a kind of the room by its own name of several words, before any place.
void by_kind(const Editor& editor, const std::vector<std::string>& tokens, PromptObject& said,
             std::vector<int>& found) {
    const Words head = part_of(tokens, 0, next_place(tokens));
    std::string best;
    for (const DocumentThing& t : editor.document().things) {
        const std::string name = in_words(t.kind);
        const Words phrase = tokens_of(name);
        if (phrase.size() > 1 && name.size() > best.size() && says_phrase(head, phrase)) best = name;
    }
    if (best.empty() || in_words(said.kind) == best) return;
    found.clear();
    said.words = best;
    for (std::size_t i = 0; i < editor.document().things.size(); ++i)
        if (in_words(editor.document().things[i].kind) == best) {
            said.kind = editor.document().things[i].kind;
            found.push_back(static_cast<int>(i));
        }
}

// Of those found, the ones that stand where the words say.
void with_place(const Editor& editor, const PromptSpec& spec, std::vector<int>& found) {
    PromptObject where = spec.objects.front();
    where.count = static_cast<int>(found.size());
    // "at", "by", "near" a window, where the reader takes no place from it.
    if (where.relation.empty() && spec.objects.size() > 1)
        where.relation = "next to", where.relation_to = spec.objects[1].kind;
    if (where.relation.empty() || found.size() < 2) return;
    if (!is_shell(where.relation_to) && spec.objects.size() > 1)
        if (const auto at = alike(editor.document(), spec.objects[1], false); !at.empty())
            where.relation_to = editor.document().things[static_cast<std::size_t>(at.front())].kind;
    std::vector<int> there;
    const FurnishedRoom& furnished = editor.room().furnished;
    // On a rug is on the floor.
    if (where.relation == "on" && where.relation_to == "floor") {
        for (const int i : found)
            if (const Placed& p = furnished.placed[static_cast<std::size_t>(i)];
                p.on < 0 && p.sill < 0 && p.piece.mount != Mount::wall && p.piece.mount != Mount::ceiling)
                there.push_back(i);
        if (!there.empty()) found = there;
        return;
    }
    if (beside_as_seen(editor, where, found)) return;
    const bool several = where.count > 1 && spec.objects.front().count > 1;
    for (const int i : found)
        if (stands_as_asked(furnished.plan, furnished.placed, furnished.placed[static_cast<std::size_t>(i)], where)
                .value_or(false))
            there.push_back(i);
    // "The two tables by the window", where one is close to it: the two nearest.
    const PromptObject& said = spec.objects.front();
    const auto count = static_cast<std::size_t>(said.counted ? std::max(1, said.count) : 1);
    const bool close = where.relation == "next to" || (where.relation == "in front of" && said.counted);
    if (close && (there.empty() ? !several || count > 1 : several && there.size() < count))
        nearest_to(editor, where.relation_to, found, count);
    else if (!there.empty()) found = there;
    if (several && where.relation == "next to" && is_shell(where.relation_to))
        nearest_to(editor, where.relation_to, found, count);
}

// The very things of a place: "at the second table", "on the left nightstand". Nothing: it is at any such thing, at a
// part of the room, or nowhere.
struct Anchors {
    std::string relation;
    std::vector<int> things;
};
std::optional<Anchors> anchors_said(const Editor& editor, const Words& place, const std::vector<int>& found) {
    const auto relation = place.empty() || found.size() < 2 ? std::nullopt : relation_at(place, 0);
    if (!relation) return {};
    const Words there = part_of(place, relation->next);
    if (there.empty() || room_part(there, 0)) return {};
    const bool told = has_word(there, {"first", "second", "third", "fourth", "fifth", "last", "left", "right", "larger",
                                       "smaller", "bigger", "other"}) ||
                      there.back().find_first_of("0123456789") != std::string::npos;
    if (!told) return {};
    Anchors out{relation->name, all_named(editor, text_of(there))};
    if (out.things.empty() || (out.things.size() > 1 && !says_several(there, {}))) return {};
    return out;
}

// Of "the coffee table books" the books.
void of_the_last(const Editor& editor, const Words& head, const std::vector<int>& compound, PromptObject& said,
                 std::vector<int>& found) {
    const DocumentThing& t = editor.document().things[static_cast<std::size_t>(compound.front())];
    found = compound;
    said.kind = t.kind;
    said.words = text_of(head, head.empty() ? 0 : head.size() - 1);
}

// "the panels by the piano": what only the name of a kind in the room says.
std::vector<int> ending_so(const Editor& editor, const Words& head, const Words& place, PromptObject& said) {
    std::vector<int> out;
    const std::string last = head.empty() ? "" : head.back();
    const std::string one = last.ends_with("s") ? last.substr(0, last.size() - 1) : last;
    constexpr std::size_t kWord = 3;  // letters
    if (one.size() < kWord) return out;
    for (std::size_t i = 0; i < editor.document().things.size(); ++i)
        if (const std::string& kind = editor.document().things[i].kind;
            kind.ends_with("_" + one) || kind.ends_with("_" + last))
            out.push_back(static_cast<int>(i));
    if (out.empty()) return out;
    said = {};
    said.words = last, said.kind = editor.document().things[static_cast<std::size_t>(out.front())].kind;
    const auto relation = place.empty() ? std::nullopt : relation_at(place, 0);
    const auto part = relation ? room_part(place, relation->next) : std::nullopt;
    if (part && part->noun == "floor")
        std::erase_if(out, [&](int i) { return !editor.document().things[static_cast<std::size_t>(i)].on.empty(); });
    else if (relation && !part)
        at_anchors(editor, relation->name, all_named(editor, text_of(place, relation->next)), out);
    return out;
}

Meaning meaning_of(const Editor& editor, const std::string& words) {
    const std::vector<std::string> tokens = tokens_of(words);
    const std::string plain = without_number(tokens);
    const std::size_t place = next_place(tokens);
    Meaning out;
    const std::vector<int> compound = compound_named(editor, tokens);
    // The room's own meaning first: a kitchen's "cabinets" are its counter's.
    for (const bool in_room : {true, false}) {
        const PromptSpec spec = in_room ? read_in_room(editor, plain) : understand_prompt(plain, false, editor.pack());
        if (spec.objects.empty()) continue;
        out.said = spec.objects.front();
        // Of "the clutter on the desk" the desk is the place.
        const Words noun = tokens_of(out.said.words);
        if (!says_phrase(part_of(tokens, 0, place), noun) && says_phrase(part_of(tokens, place), noun)) {
            out.said = {};
            continue;
        }
        out.found = alike(editor.document(), out.said, says_several(tokens, out.said));
        // "The plant on the counter" may be a small one.
        if (auto wide = alike(editor.document(), out.said, true);
            place < tokens.size() && wide.size() > out.found.size()) {
            std::vector<int> there = wide, exact = out.found;
            with_place(editor, spec, there), with_place(editor, spec, exact);
            if (there.size() < wide.size() && exact.size() > 1 && exact.size() == out.found.size()) out.found = there;
        }
        by_kind(editor, tokens, out.said, out.found);
        if (!compound.empty()) of_the_last(editor, part_of(tokens, 0, place), compound, out.said, out.found);
        else at_support(editor, tokens, out.found);
        with_looks(out.said, editor, out.found);
        const auto anchors = anchors_said(editor, part_of(tokens, place), out.found);
        if (anchors) at_anchors(editor, anchors->relation, anchors->things, out.found);
        else if (compound.empty() || place < tokens.size()) with_place(editor, spec, out.found);
        const bool of_place = anchors || (says_several(tokens, out.said) &&
                                          find_word(tokens, {"of"}, place) < tokens.size());  // the left of a table
        pick(of_place ? part_of(tokens, 0, place) : tokens, out.said, editor, out.found);
        if (!out.found.empty()) return out;
    }
    out.unknown = out.said.kind.empty();
    out.found = with_part(editor, tokens);
    if (out.found.empty() && has_role(out.said.kind, Role::ceiling_light) && has_word(tokens, {"ceiling"}))
        for (std::size_t i = 0; i < editor.document().things.size(); ++i)
            if (const Placed& p = editor.room().furnished.placed[i];
                p.piece.mount == Mount::ceiling && has_role(p.piece.kind, Role::light))
                out.found.push_back(static_cast<int>(i));
    // "The rocking chair", where there is none, is no office chair.
    const bool known = out.said.words.find(' ') != std::string::npos && !out.said.kind.empty() &&
                       plain_name(out.said.kind) == plain_name(singular(out.said.words));
    if (out.found.empty() && !known)
        out.found = ending_so(editor, part_of(tokens, 0, place), part_of(tokens, place), out.said);
    if (!out.found.empty()) pick(part_of(tokens, 0, place), out.said, editor, out.found);
    return out;
}

// "The papers", where only something quite different stands for them, and nobody asked for it by that name.
bool is_other_thing(const Editor& editor, const PromptObject& said, const std::vector<int>& found) {
    const auto word = look_up(said.words);
    if (!word || !word->far || word->meaning != said.kind) return false;
    return std::none_of(found.begin(), found.end(), [&](int i) {
        const DocumentThing& t = editor.document().things[static_cast<std::size_t>(i)];
        return t.asked && t.asked->words == said.words;
    });
}

// "The table", and no more.
bool is_bare(const Words& tokens) {
    return static_cast<std::size_t>(std::count_if(tokens.begin(), tokens.end(), is_definite)) + 1 == tokens.size();
}

// "chair-2", also "chair 2".
std::optional<int> id_said(const RoomDocument& document, const std::string& words) {
    const std::string text = joined(tokens_of(words));
    for (std::size_t i = 0; i < document.things.size(); ++i) {
        const std::string id = joined(tokens_of(document.things[i].id));
        if (document.things[i].id == words || text == id || text == "the " + id) return static_cast<int>(i);
    }
    return {};
}

}  // namespace

bool says_several(const std::vector<std::string>& words, const PromptObject& said) {
    return has_word(words, {"all", "both", "every", "each"}) || said.count > 1 || said.words.ends_with("s");
}

PromptSpec read_in_room(const Editor& editor, const std::string& words) {
    PromptSpec spec = understand_prompt("a " + room_title(editor.document().type) + " with " + words, false,
                                        editor.pack());
    std::erase_if(spec.objects, [](const PromptObject& o) { return o.forbidden; });
    return spec;
}

std::vector<int> all_named(const Editor& editor, const std::string& words) {
    if (const auto id = id_said(editor.document(), words)) return {*id};
    if (const auto near = by_distance(editor, tokens_of(words))) return *near;
    if (const auto rows = in_rows(editor, tokens_of(words))) return *rows;
    if (const auto ends = at_ends_of_table(editor, tokens_of(words))) return *ends;
    if (const auto side = on_side_of_table(editor, tokens_of(words))) return *side;
    if (const auto those = by_what_they_carry(editor, tokens_of(words))) return *those;
    return meaning_of(editor, words).found;
}

std::vector<std::string> named(const Editor& editor, const std::string& words) {
    if (const auto id = id_said(editor.document(), words))
        return {editor.document().things[static_cast<std::size_t>(*id)].id};
    const std::vector<std::string> tokens = tokens_of(words);
    if (has_word(tokens, {"except", "unless", "not", "minus", "excluding"}))
        throw UsageError("expected the things that are meant, found \"{}\"", words);
    auto near = by_distance(editor, tokens);
    if (!near) near = in_rows(editor, tokens);
    if (!near) near = at_ends_of_table(editor, tokens);
    if (!near) near = on_side_of_table(editor, tokens);
    if (const auto those = near ? std::nullopt : by_what_they_carry(editor, tokens)) {
        const bool one = !tokens[next_place(tokens) - 1].ends_with("s") && !has_word(tokens, {"all", "every", "each"});
        if (one && those->size() > 1) refuse_many(words, editor, *those);
        near = those;
    }
    Meaning meant = near ? Meaning{{}, *near} : meaning_of(editor, words);
    std::vector<int>& found = meant.found;
    const PromptObject& said = meant.said;
    if (found.empty() && !meant.unknown && is_bare(tokens)) found = called_in_full(editor, tokens, meant.said);
    // "The chairs on that side": of what, and which?
    if (const std::size_t place = next_place(tokens); !near && found.size() > 1 && place < tokens.size())
        if (const auto relation = relation_at(tokens, place))
            if (const auto part = room_part(tokens, relation->next);
                part && part->noun == "side" && part->next == tokens.size() &&
                !part->says({"left", "right", "far", "near", "back", "front", "window", "door"}))
                throw UsageError("which side? expected \"on the left\", \"by the window\", found \"{}\"",
                                 text_of(tokens, place));
    if (found.empty() && (is_shell(said.kind) || has_role(said.kind, Role::opening))) refuse_shell();
    if (found.empty() && is_one_of(tokens.front(), {"everything", "all", "anything"}) && meant.unknown)
        throw UsageError("name the things that are meant, found \"{}\"", words);
    if (found.empty() || is_other_thing(editor, said, found)) refuse_none(words, editor, said.kind);
    // "two chairs", "two of the chairs"; the articles are numbers as well.
    const auto number = number_said(tokens.front());
    const bool all = has_word(tokens, {"all", "both", "every", "each"}) || says_several(tokens, said);
    // "Two chairs" of four, "a chair", "one of the chairs": the last ones.
    const std::size_t count = near                                         ? 0
                              : tokens.front() == "half"                   ? found.size() / 2
                              : number && *number >= 1                     ? static_cast<std::size_t>(*number)
                              : said.counted && said.count > 1             ? static_cast<std::size_t>(said.count)
                              : is_one_of(tokens.front(), {"some", "any"}) ? 1
                                                                           : 0;
    std::vector<int> exact = found;
    std::erase_if(exact,
                  [&](int i) { return editor.document().things[static_cast<std::size_t>(i)].kind != said.kind; });
    // "The two plants", where there are two, and trees: those.
    if (count > 1 && count < found.size() && tokens.front() == "the" && !has_word(tokens, {"first", "last"})) {
        if (exact.size() != count) refuse_many(said.words, editor, found);
        found = exact;
    }
    if (count > found.size())
        throw UsageError("there {} only {} of \"{}\" in the room", found.size() == 1 ? "is" : "are", found.size(),
                         words);
    // Of chairs and an office chair "two chairs" are chairs.
    if (count > 0 && exact.size() >= count) found = exact;
    if (count > 0) found.erase(found.begin(), found.end() - static_cast<std::ptrdiff_t>(count));
    else if (found.size() > 1 && !all && !near) {
        const std::vector<int> main = is_bare(tokens) ? main_of(editor, found) : std::vector<int>{};
        if (main.empty()) refuse_many(said.words, editor, found);
        found = main;
    }
    std::vector<std::string> ids;
    for (const int i : found) ids.push_back(editor.document().things[static_cast<std::size_t>(i)].id);
    return ids;
}

}  // namespace editing

std::vector<std::string> things_named(const RoomDocument& document, const std::string& words,
                                      std::shared_ptr<const FurniturePack> pack) {
    return editing::named(editing::Editor(document, std::move(pack), Run{}), words);
}

}  // namespace fastscene
