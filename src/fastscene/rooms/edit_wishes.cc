// What words ask for that is new: which things, how many, in which shape, at which place.
#include <algorithm>
#include <utility>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene::editing {
namespace {

// "Two plants either side of the fireplace": the fireplace is there, and no thing to add.
void check_new(const Words& words, const PromptObject& wish) {
    const Words noun = tokens_of(wish.words);
    for (std::size_t i = 1; i + noun.size() <= words.size(); ++i) {
        if (part_of(words, i, i + noun.size()) != noun) continue;
        for (std::size_t k = i; k-- > 0 && !is_joint(words[k]) && !is_one_of(words[k], {"a", "an", "with", "of"});)
            if (is_one_of(words[k], {"the", "my", "our", "your", "its", "their"}))
                throw UsageError("expected a place, found \"{}\"", text_of(words, k));
    }
}

// "Some toys for the kids" are some toys, "a desk for homework" is a desk.
Words without_whom(const Editor& editor, Words words) {
    // What it is for is nothing that there is or could be: no thing, no place.
    const std::size_t at = find_word(words, {"for"}, 1);
    std::size_t end = at + 1;
    while (end < words.size() && !is_joint(words[end]) && words[end] != "with" && words[end] != "next") ++end;
    const Words what = part_of(words, at + 1, end);
    const auto is_thing = [](const std::string& w) {
        const auto known = look_up(w);
        return known && (known->kind == WordKind::object || known->kind == WordKind::structure);
    };
    if (!what.empty() && what.size() < 4 && next_place(what) == what.size() && !number_said(what.front()) &&
        std::none_of(what.begin(), what.end(), is_thing) && all_named(editor, text_of(what)).empty()) {
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(at), words.begin() + static_cast<std::ptrdiff_t>(end));
        return words;
    }
    for (std::size_t i = 1; i < words.size(); ++i) {
        if (words[i] != "for") continue;
        const std::size_t next = i + 1 < words.size() && is_definite(words[i + 1]) ? i + 2 : i + 1;
        if (next >= words.size()) continue;
        const std::string& who = words[next];
        if (is_one_of(who.ends_with("s") && who.size() > 2 ? who.substr(0, who.size() - 1) : who,
                      {"kid", "children", "guest", "visitor", "customer", "us", "me", "everyone", "people", "patient",
                       "student"}))
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                        words.begin() + static_cast<std::ptrdiff_t>(next) + 1);
    }
    return words;
}

// "Hang two ferns", "two ferns from the ceiling" are hanging ferns, where there are such. Throws UsageError for what
// does not hang.
Words hung_up(const Talk& talk, Words words) {
    const Editor& editor = talk.editor;
    const std::size_t from = find_word(words, {"from", "off"}, 1);
    const bool from_ceiling = from + 2 < words.size() && words[from + 2] == "ceiling";
    if (from_ceiling)
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(from),
                    words.begin() + static_cast<std::ptrdiff_t>(from) + 3);
    else if (!talk.said.starts_with("hang") || find_word(words, {"wall", "walls"}) < words.size() ||
             (find_word(words, {"on"}) < words.size() && find_word(words, {"side", "sides"}) == words.size()))
        return words;
    const auto hangs = [&](const Words& all) {
        const PromptSpec spec = read_in_room(editor, text_of(all, 0, next_place(all)));
        if (spec.objects.empty()) return true;  // said elsewhere
        const Mount mount = mount_of(editor, spec.objects.front().kind);
        return mount == Mount::ceiling || (!from_ceiling && mount == Mount::wall);
    };
    if (hangs(words)) return words;
    // "A hanging plant", "a simple hanging lamp"
    for (const std::size_t at : {number_said(words.front()) ? std::size_t{1} : 0, next_place(words) - 1}) {
        Words hanging = words;
        hanging.insert(hanging.begin() + static_cast<std::ptrdiff_t>(at), "hanging");
        if (hangs(hanging)) return hanging;
    }
    // "Hang a reading lamp" is a wall lamp.
    const std::size_t end = next_place(words);
    Words at_wall = part_of(words, 0, 1);
    at_wall.insert(at_wall.end(), {"wall", words[end - 1]});
    at_wall.insert(at_wall.end(), words.begin() + static_cast<std::ptrdiff_t>(end), words.end());
    const auto known = look_up("wall " + words[end - 1]);
    if (end > 1 && !from_ceiling && known && known->kind == WordKind::object && hangs(at_wall)) return at_wall;
    throw UsageError("nothing of that kind hangs, found \"{}\"", text_of(words, 0, next_place(words)));
}

}  // namespace

namespace {

// "Tablecloth": something that things have, and no thing.
bool is_known_detail(const std::string& word) {
    const auto known = look_up(word);
    return known && known->kind == WordKind::detail;
}

}  // namespace

Words counted_anew(Words words) {
    // "Two pictures side by side" are two pictures.
    for (const char* row : {"side by side", "next to each other", "in a row", "in a line"}) {
        const Words phrase = tokens_of(row);
        for (std::size_t i = 1; i + phrase.size() <= words.size(); ++i)
            if (part_of(words, i, i + phrase.size()) == phrase) {
                words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                            words.begin() + static_cast<std::ptrdiff_t>(i + phrase.size()));
                break;
            }
    }
    if (!words.empty() && words.front() == "another") words.front() = "a";
    if (words.size() > 1 && words[0] == "a" &&
        is_one_of(words[1], {"second", "third", "fourth", "fifth", "sixth", "new", "extra", "further"}))
        words.erase(words.begin() + 1);
    if (words.size() > 2 && words[0] == "a" && words[1] == "few") words.erase(words.begin() + 1), words[0] = "three";
    if (words.size() > 3 && words[0] == "a" && words[1] == "couple" && words[2] == "of")
        words.erase(words.begin() + 1, words.begin() + 3), words[0] = "two";
    // "A bigger mirror" is a big one.
    for (std::string& w : words) {
        if (is_one_of(w, {"bigger", "larger", "longer", "wider"})) w = "large";
        if (is_one_of(w, {"smaller", "shorter", "narrower"})) w = "small";
        if (is_one_of(w, {"taller", "higher"})) w = "tall";
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(2, words.size()); ++i)
        if (is_one_of(words[i], {"more", "some", "additional", "extra", "new", "also"}) && words.size() > 1)
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(i--));
    return words;
}

namespace {

// What stands on the floor with neither a back nor a top.
bool is_slender(const Editor& editor, const PromptObject& wish) {
    PromptSpec spec = editor.room().spec;
    Random rng(0, "slender");
    Layout layout(editor.plan(), spec, rng);
    if (!layout.why_not(wish.kind).empty()) return true;
    const Piece piece = make_piece(layout.request(wish.kind, &wish));
    return piece.mount != Mount::wall && !piece.against_wall && piece.surfaces.empty();
}

// "A tall cabinet", "a low, narrow shelf": as the usual one, but for that. Plants and lamps are taller as a whole.
void size_as_said(const Editor& editor, const Words& words, PromptObject& wish) {
    const Words noun = tokens_of(wish.words);
    const std::size_t at = noun.empty() ? words.size() : find_word(words, {noun.front(), noun.front() + "s"});
    Vec3f factor = usual_factor(part_of(words, 0, at));
    // "A long mirror" is a tall one.
    if (has_word(part_of(words, 0, at), {"long", "longer"}) && mount_of(editor, wish.kind) == Mount::wall)
        std::swap(factor.x, factor.y);
    if (at >= words.size() || factor == Vec3f{1, 1, 1} || !(wish.size_m == Vec3f{})) return;
    PromptObject usual = wish;
    usual.size.clear();
    if (is_slender(editor, usual)) return;
    const Vec3f size = editor.usual_size(usual);
    if (size == Vec3f{}) return;
    constexpr float kBelowCeiling = 0.1f;  // metres
    wish.size.clear();
    for (std::size_t a = 0; a < 3; ++a) wish.size_m[a] = size[a] * factor[a];
    wish.size_m.y = std::min(wish.size_m.y, editor.plan().height - kBelowCeiling);
}

}  // namespace

// What things have, and no thing beside them: "an island with drawers".
bool is_a_part(const std::string& word) {
    return is_one_of(word,
                     {"drawers", "doors", "shelves", "wheels", "handles", "legs", "armrests", "storage", "casters"});
}

bool is_unknown_adjective(const Words& words, const std::string& said) {
    const Words phrase = tokens_of(said);
    if (phrase.size() != 1) return false;
    const std::size_t at = find_word(words, {phrase.front()});
    if (at == 0 || at + 1 >= words.size()) return false;
    // Between an article, a number or an adjective and the noun.
    const auto known = look_up(words[at + 1]);
    const auto two = at + 2 < words.size() ? look_up(words[at + 1] + " " + words[at + 2]) : std::nullopt;
    const bool noun = (known && known->kind == WordKind::object) || (two && two->kind == WordKind::object);
    const auto before = look_up(words[at - 1]);
    const bool opens = number_said(words[at - 1]) || is_one_of(words[at - 1], {"some", "more", "another", "with"}) ||
                       (before && (before->kind == WordKind::size || before->kind == WordKind::color ||
                                   before->kind == WordKind::material));
    return noun && opens;
}

std::vector<PromptObject> wishes_of(const Editor& editor, const Words& words) {
    std::string text = text_of(counted_anew(words));
    PromptSpec spec = read_in_room(editor, text);
    auto unknown = spec.words_with(PromptWord::Fate::not_understood);
    // "A jug of water" is a jug.
    if (const std::size_t of = find_word(words, {"of"}, 1);
        of + 2 == words.size() && !unknown.empty() && unknown.front().words == words.back()) {
        text = text_of(counted_anew(part_of(words, 0, of)));
        spec = read_in_room(editor, text);
        unknown = spec.words_with(PromptWord::Fate::not_understood);
    }
    // "A rolled towel" is a towel, and that nothing shows it is told.
    std::erase_if(unknown, [&](const PromptWord& word) { return is_unknown_adjective(words, word.words); });
    if (!unknown.empty()) throw UsageError("expected a thing to add, found \"{}\"", unknown.front().words);
    if (spec.objects.empty() && std::any_of(words.begin(), words.end(), is_known_detail))
        throw UsageError("there is no \"{}\" to add: no thing of a room is one", text);
    if (spec.objects.empty()) throw UsageError("expected a thing to add, found \"{}\"", text);
    // "Three simple lamps" are three.
    if (const auto number = number_said(words.front());
        number && *number >= 1 && !is_one_of(words.front(), {"a", "an"}) && !spec.objects.front().counted)
        spec.objects.front().count = static_cast<int>(*number), spec.objects.front().counted = true;
    // "a bowl of lemons" is a bowl.
    for (std::size_t i = 1; i + 1 < words.size() && spec.objects.size() > 1; ++i)
        if (words[i] == "of" && text_of(words, i + 1).starts_with(spec.objects[1].words) &&
            furnishing::is_small(spec.objects[1].kind))
            spec.objects.erase(spec.objects.begin() + 1);
    for (std::size_t k = is_definite(words.front()) ? 1 : 0; k < spec.objects.size(); ++k)
        check_new(words, spec.objects[k]);
    for (PromptObject& o : spec.objects) {
        check_stand_in(o);
        size_as_said(editor, words, o);
        if (is_shell(o.kind) || has_role(o.kind, Role::opening)) refuse_shell();
        o.relation = o.relation_to = o.relation_and = "";
        // "Books" are a stack of them.
        if (!o.counted && has_role(o.kind, Role::heap)) o.count = 1;
        const Thing* thing = find_thing(o.kind);
        const bool heap = has_role(o.kind, Role::heap) || (thing && has_role(thing->small_form, Role::heap));
        if (heap && find_word(words, {"stack", "pile"}) < words.size()) o.count = 1;
    }
    if (const std::size_t with = find_word(words, {"with"}, 1); with + 1 < words.size() && is_a_part(words[with + 1]))
        std::erase_if(spec.objects, [&](const PromptObject& o) { return o.words == words[with + 1]; });
    PromptObject& first = spec.objects.front();
    for (std::size_t k = 1; k < spec.objects.size(); ++k) {
        PromptObject& o = spec.objects[k];
        o.relation_to = first.kind;
        // Chairs stand around tables, one before a desk.
        const bool table = has_role(first.kind, Role::lamp_above), desk = has_role(first.kind, Role::work_place);
        o.relation = furnishing::is_small(o.kind)                        ? "on"
                     : !has_role(o.kind, Role::seat) || !(table || desk) ? "next to"
                     : desk && !has_role(first.kind, Role::laid)         ? "in front of"
                                                                         : "around";
    }
    return spec.objects;
}

std::string shape_asked(const Words& words) {
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (const std::string one = shape_said({words[i]}); !one.empty() && out.empty()) out = one;
        const bool shaped = i > 0 && is_one_of(words[i], {"shaped", "shape"});
        const std::string of = shaped ? words[i - 1] : words[i].ends_with("-shaped") ? words[i] : "";
        if (of.empty() || !shape_said({of}).empty() || is_one_of(of, {"a", "the", "in", "good"})) continue;
        // "an l shaped sofa" is a word of the lexicon.
        const auto word = look_up(text_of(words, i - (shaped ? 1 : 0), i + 2));
        if (word && word->kind == WordKind::object) continue;
        throw UsageError("nothing can be made {}; shapes are round, oval, square and rectangular",
                         shaped ? of + " " + words[i] : of);
    }
    return out;
}

void shape_as_asked(Talk& talk, const std::vector<std::string>& ids, const std::string& shape) {
    if (shape.empty()) return;
    for (const std::string& id : ids) {
        if (shape_of(talk.editor.placed(id).piece) == shape) continue;
        EditStep step;
        step.kind = EditStep::Kind::reshape;
        step.ids = {id};
        step.value = shape;
        talk.editor.apply(step);
    }
}

namespace {

Place at_step(const EditStep& step) {
    Place out;
    out.step = step;
    return out;
}

// "A chair at the desk and a plant on it", "a rug under the table and a lamp above it": what one cannot put that on, or
// hang it over, is not "it", but what that came at.
std::vector<std::string> it_of(const Talk& talk, const Words& there, const std::string& kind,
                               const std::vector<std::string>& spoken) {
    const auto relation = relation_at(there, 0);
    if (!relation || there.back() != "it" || relation->next + 1 != there.size() || spoken.size() != 1) return spoken;
    const Placed& p = talk.editor.placed(spoken.front());
    const bool small = furnishing::is_small(kind) || small_form_of(kind) != kind;
    const bool on_seat = relation->name == "on" && has_role(p.piece.kind, Role::seat) && small &&
                         !furnishing::lies_on_seats(kind);
    if (!on_seat && !(relation->name == "above" && (p.flat || is_rug(p.piece)))) return spoken;
    const std::vector<std::string> at = talk.last_place.wish.relation_to.empty()
                                            ? std::vector<std::string>{}
                                            : things_at(talk.editor, talk.last_place);
    return at.size() == 1 ? at : spoken;
}

Addition read_addition(const Talk& talk, const Words& said, const std::vector<std::string>& spoken) {
    const Editor& editor = talk.editor;
    const Words words = hung_up(talk, counted_anew(without_whom(editor, said)));
    // "Chairs around the big round table": the table is round.
    const std::string shape = shape_asked(part_of(words, 0, next_place(words)));
    for (std::size_t end = next_place(words); end < words.size(); end = next_place(words, end + 1)) {
        const Words there = part_of(words, end);
        // "a table in oak"
        if (value_of(part_of(there, 1))) continue;
        // "a rug in beige under the table"
        const std::size_t after = next_place(there);
        if (there.front() == "in" && after < there.size() && value_of(part_of(there, 1, after))) continue;
        // "a side table next to the sofa with a lamp on it"
        if (const std::size_t with = find_word(there, {"with"}, 1);
            with + 1 < there.size() && begins_anew(part_of(there, with + 1))) {
            Words all = part_of(words, 0, end);
            Words rest = part_of(there, with);
            if (rest.size() > 2 && rest.back() == "it") rest.resize(rest.size() - 2);
            all.insert(all.end(), rest.begin(), rest.end());
            const auto both = wishes_of(editor, all);
            if (auto place = place_of(editor, part_of(there, 0, with), both.front().kind, "", spoken))
                return {both, place, shape};
        }
        const auto wishes = wishes_of(editor, part_of(words, 0, end));
        const auto it = it_of(talk, there, wishes.front().kind, spoken);
        if (auto place = place_of(editor, there, wishes.front().kind, "", it)) return {wishes, place, shape};
    }
    // "An office chair for the desk"
    if (const std::size_t whose = find_word(words, {"for"}, 1);
        whose + 1 < words.size() &&
        (is_definite(words[whose + 1]) || is_one_of(words[whose + 1], {"each", "both", "every", "all"}))) {
        const auto wishes = wishes_of(editor, part_of(words, 0, whose));
        if (auto place = place_of(editor, part_of(words, whose), wishes.front().kind, "", spoken))
            return {wishes, place, shape};
    }
    const auto wishes = wishes_of(editor, words);
    if (furnishing::is_small(wishes.front().kind))
        if (const auto step = on_support(editor, words)) return {wishes, at_step(*step), shape};
    return {wishes, {}, shape};
}

}  // namespace

Addition addition_of(const Talk& talk, const Words& said, const std::vector<std::string>& spoken) {
    Words words = said;
    const std::size_t with = find_word(words, {"with"}, 1);
    // "… with two chairs each by the window"
    const std::size_t every = find_word(words, {"each"}, std::min(words.size(), with + 2));
    const bool each = every < words.size() && !relation_at(words, every - 1) &&
                      (every + 1 == words.size() || next_place(words, every + 1) == every + 1);
    if (each) words.erase(words.begin() + static_cast<std::ptrdiff_t>(every));
    // "… with six plants on it"
    const std::size_t n = words.size();
    const bool on_it = with + 3 < n && is_one_of(words[n - 1], {"it", "them", "top", "each"}) && words[n - 2] == "on";
    const std::string text = text_of(words);
    // "A desk with a lamp on it": on the desk.
    const std::size_t begins = next_place(words);
    if (on_it && begins > with && begins + 2 == n) words.resize(n - 2);
    Addition out = read_addition(talk, words, spoken);
    // Stools at an island as those that stand there.
    as_those_at(talk.editor, out);
    // "A ladder to the bookshelves" is one, "a candle to the tables without one" are as many as those.
    const bool of_some = find_word(said, {"without", "that", "with"}, next_place(said)) < said.size();
    if (out.place && out.place->if_uncounted && !of_some && is_one_of(said.front(), {"a", "an", "another"}))
        out.place->each_at.clear();
    for (const char* row : {"in a row", "in a line", "side by side", "next to each other"})
        out.in_row = out.in_row || text.find(row) != std::string::npos;
    as_those_there(talk.editor, said, out.wishes.front());
    // "A lamp above the table" hangs.
    PromptObject& first = out.wishes.front();
    if (out.place && out.place->step.wish.relation == "above" && furnishing::is_small(first.kind) &&
        has_role(first.kind, Role::light) && first.words.find(' ') == std::string::npos)
        for (const std::string& kind : kinds_with(Role::overhead))
            if (has_role(kind, Role::hung) && has_role(kind, Role::light)) {
                first.kind = kind;
                break;
            }
    out.each = each, out.on_it = on_it && out.wishes.size() > 1;
    return out;
}

}  // namespace fastscene::editing
