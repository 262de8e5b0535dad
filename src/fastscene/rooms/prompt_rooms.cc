// Which rooms a prompt speaks of: the room itself, the house around it, parts of it that serve another end, and the
// room next to it.
#include <algorithm>
#include <array>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

// "an attic study", "a bedroom in a converted loft": the other room serves, and this shapes it.
bool shapes_another(const Matches& m, std::size_t at) {
    const std::string& structure = m[at].word->meaning;
    const RoomType* type = find_room_type(structure);
    if (!type || !(type->sloped_ceiling || type->high_ceiling)) return false;
    const auto serves = [&](const Match& x) {
        return x.is(WordKind::room) && x.word->meaning != structure && !x.negated;
    };
    // "an attic study", "an attic turned into a study"; not "an attic with a study corner".
    const auto leads_on = [&](const Match& x) {
        return modifies(x) || x.is(WordKind::mood) || x.is(WordKind::light) || x.is_function("to") ||
               x.is_function("into") || x.is_function("as") || x.is_function("used as");
    };
    for (std::size_t k = at + 1; k < m.size() && (serves(m[k]) || leads_on(m[k])); ++k)
        if (serves(m[k])) return true;
    bool in = false;
    for (std::size_t k = at; k-- > 0;) {
        if (serves(m[k])) return in;
        if (m[k].is_function("in") || m[k].is_function("of") || m[k].is_function("under") || m[k].words == "under")
            in = true;
        else if (!modifies(m[k]) && !m[k].is_function("the") && !m[k].is(WordKind::mood)) return false;
    }
    return false;
}

// "a 2-bed flat", "three bedroom house": of the house, not of this room.
void count_other_rooms(Matches& m) {
    const auto is_house = [](const Match& x) {
        return x.is(WordKind::room) && !x.word->exact && x.word->meaning == default_room_type().name;
    };
    for (std::size_t i = 1; i + 1 < m.size(); ++i) {
        const bool bedroom = is_one_of(m[i].words.substr(0, m[i].words.find("room")), {"bed", "bath"});
        if (!bedroom || !m[i - 1].is(WordKind::count) || m[i - 1].words == "a" || !is_house(m[i + 1])) continue;
        m[i - 1].word = m[i].word = Word{WordKind::nuance, "house"};
    }
}

// "a hotel suite with a walk-in closet": the approximated word is the room, the exact one lies next to it. Words for
// whole houses ("an apartment with a kitchen") are approximated by the default type, and are not meant here.
bool comes_with_another(const Matches& m) {
    const auto is_named = [](const Match& x) { return x.is(WordKind::room) && !x.negated; };
    const auto first = std::find_if(m.begin(), m.end(), is_named);
    if (first == m.end() || first->word->exact || first->word->meaning == default_room_type().name) return false;
    const auto with = std::find_if(first, m.end(), [](const Match& x) { return x.is_function("with"); });
    const auto exact = [&](const Match& x) { return is_named(x) && x.word->exact; };
    return std::none_of(first, with, exact) && std::any_of(with, m.end(), exact);
}

// What a room that is in such a house has of it, or is like it: its style, unless one is named.
Word style_of_house(const Matches& m, const RoomType& house) {
    const bool named = std::any_of(m.begin(), m.end(), [](const Match& x) { return x.is(WordKind::style); });
    if (named || house.styles.empty()) return Word{WordKind::nuance, "house", false};
    return Word{WordKind::style, house.styles.front(), false};
}

// "a bedroom in a log cabin", "the kitchen of a houseboat": the house around the room.
void leave_houses(Matches& m) {
    const auto is_named = [](const Match& x) { return x.is(WordKind::room) && !x.negated && x.word->exact; };
    for (auto x = m.begin(); x != m.end(); ++x) {
        const RoomType* type = is_named(*x) ? find_room_type(x->word->meaning) : nullptr;
        if (!type || !type->house || std::none_of(m.begin(), x, is_named)) continue;
        // "a kids room with a spaceship poster": what a thing of the room is like.
        if (x + 1 != m.end() && (x + 1)->is(WordKind::object)) {
            x->word = Word{WordKind::nuance, "feel", false};
            continue;
        }
        for (auto before = x; before-- > m.begin();) {
            if (before->is_function("the") || before->words == "a" || before->words == "an" || modifies(*before) ||
                before->is(WordKind::mood))
                continue;
            if (is_one_of(before->words, {"in", "inside", "of", "on", "aboard", "within", "on board"}))
                x->word = style_of_house(m, *type);
            break;
        }
    }
}

// "a spa bathroom", "a gallery-like living room": the last of them is the room, the one before says what it is like.
void qualify_rooms(Matches& m) {
    for (std::size_t i = 0; i + 1 < m.size(); ++i) {
        const RoomType* type = m[i].is(WordKind::room) && !m[i].negated ? find_room_type(m[i].word->meaning) : nullptr;
        if (!type || type->next_door || type->sloped_ceiling || type->high_ceiling) continue;
        const bool likened = is_one_of(m[i + 1].words, {"like", "style", "styled", "inspired", "themed"});
        const std::size_t next = likened ? i + 2 : i + 1;
        if (next >= m.size() || !m[next].is(WordKind::room) || m[next].negated || m[next].comma) continue;
        if (m[next].word->meaning == type->name || !m[next].word->exact) continue;
        if (!likened && m[next].words == "hall") {  // "a history museum hall" is the museum
            m[next].word = Word{WordKind::filler, ""};
            continue;
        }
        m[i].word = type->house ? style_of_house(m, *type) : Word{WordKind::nuance, "feel", false};
    }
}

// "a flat above a cinema", "a bedroom with a view of the church": what lies outside, where another room is named.
void leave_outside(Matches& m) {
    const auto first = std::find_if(m.begin(), m.end(),
                                    [](const Match& x) { return x.is(WordKind::room) && !x.negated; });
    if (first == m.end()) return;
    for (auto x = first + 1; x < m.end(); ++x) {
        const RoomType* type = x->is(WordKind::room) && x->word->exact ? find_room_type(x->word->meaning) : nullptr;
        if (!type || type->next_door || type->name == first->word->meaning) continue;
        for (auto before = x; before-- > first && !before->is(WordKind::room);) {
            if (before->is_function("the") || before->words == "a" || before->words == "an" || modifies(*before))
                continue;
            if (is_one_of(before->words, {"above", "over", "opposite", "behind", "near", "beside", "next to", "of",
                                          "across from", "overlooking", "facing"}))
                x->word = Word{WordKind::nuance, "outside"};
            break;
        }
    }
}

// "a hallway with a staircase": what may be a room by itself is a thing of the room that is named otherwise; and of the
// room that nobody names, where other things come first ("a bed and a closet").
void take_as_things(Matches& m) {
    const auto is_named = [](const Match& x) { return x.is(WordKind::room) && !x.negated; };
    for (std::size_t i = m.size(); i-- > 0;) {
        const RoomType* type = is_named(m[i]) ? find_room_type(m[i].word->meaning) : nullptr;
        if (!type || type->as_thing.empty()) continue;
        if (!type->thing_words.empty() &&
            std::find(type->thing_words.begin(), type->thing_words.end(), m[i].words) == type->thing_words.end())
            continue;
        const bool another = std::any_of(m.begin(), m.end(),
                                         [&](const Match& x) { return is_named(x) && x.word->meaning != type->name; });
        const bool follows = std::any_of(m.begin(), m.begin() + static_cast<std::ptrdiff_t>(i),
                                         [](const Match& x) { return x.is(WordKind::object); });
        if (another || follows) m[i].word = Word{WordKind::object, type->as_thing};
    }
}

// A word for the whole house ("apartment", "castle") only names the room when no other word does.
void choose_room(Matches& m, PromptSpec& spec) {
    for (std::size_t i = 0; i < m.size(); ++i)
        if (m[i].is(WordKind::room) && !m[i].negated && spec.structure.empty() && shapes_another(m, i)) {
            spec.structure = m[i].word->meaning;
            m[i].word = Word{WordKind::nuance, "structure", m[i].word->exact};
        }
    // "a garage turned into a gym": what it was.
    for (std::size_t i = 0; i < m.size(); ++i) {
        if (!m[i].is(WordKind::room)) continue;
        bool turned = false;
        for (std::size_t k = i + 1; k < m.size() && k < i + 6 && !m[k].comma && !has_object(m[k]); ++k) {
            for (const char* verb : {"turned", "converted", "transformed", "remodeled", "made into", "now", "used as"})
                turned = turned || m[k].words.starts_with(verb);
            if (!m[k].is(WordKind::room)) continue;
            if (turned && m[k].word->meaning != m[i].word->meaning) m[i].word = Word{WordKind::nuance, "house"};
            break;
        }
    }
    const bool named = std::any_of(m.begin(), m.end(),
                                   [](const Match& x) { return x.is(WordKind::room) && x.word->exact && !x.negated; });
    if (!named || comes_with_another(m)) return;
    for (Match& x : m)
        if (x.is(WordKind::room) && !x.word->exact) x.word = Word{WordKind::nuance, "house"};
}

bool is_room(const Match& m) { return m.is(WordKind::room) && !m.negated; }

// "en suite" is said of the room next to the one that has it.
bool is_en_suite(const Match& m) { return is_room(m) && (m.words == "en suite" || m.words == "ensuite"); }

// "a dining area", "an office corner": a part of the room.
bool is_part(const Matches& m, std::size_t at) {
    const auto ends = [](const std::string& words) {
        for (const char* part : {"area", "nook", "corner", "zone", "kitchenette"})
            if (words.ends_with(part)) return true;
        return false;
    };
    return ends(m[at].words) || (at + 1 < m.size() && ends(m[at + 1].words) && !m[at + 1].words.starts_with("in "));
}

// What stands where a part of the room serves such an end.
std::string piece_of(const std::string& room, const std::string& words) {
    if (words.starts_with("reading")) return "armchair";
    const RoomType* type = find_room_type(room);
    return type ? type->main_thing : "";
}

// "a bedroom with a desk in its office corner": parts of the room that was named otherwise become their main piece.
void furnish_parts(Matches& m) {
    const bool named = [&] {
        for (std::size_t i = 0; i < m.size(); ++i)
            if (is_room(m[i]) && !is_part(m, i)) return true;
        return false;
    }();
    if (!named) return;
    for (std::size_t i = 0; i < m.size(); ++i) {
        if (!is_room(m[i]) || !is_part(m, i)) continue;
        const std::string piece = piece_of(m[i].word->meaning, m[i].words);
        const bool there = std::any_of(
            m.begin(), m.end(), [&](const Match& x) { return x.is(WordKind::object) && x.word->meaning == piece; });
        const bool of_two_words = !m[i].words.ends_with("area") && !m[i].words.ends_with("nook") &&
                                  !m[i].words.ends_with("kitchenette");
        if (of_two_words && i + 1 < m.size()) m[i + 1].word = Word{WordKind::nuance, "feel"};
        m[i].word = piece.empty() || there ? Word{WordKind::nuance, "feel"} : Word{WordKind::object, piece, false};
    }
}

// Words between two rooms that say how one gets from one to the other.
bool joins_rooms(const Match& m) {
    static constexpr std::array<std::string_view, 14> kJoins{
        "opening to",  "opening onto", "leading to", "leading into", "attached", "connected", "adjoining",
        "adjacent to", "next to",      "through",    "open",         "open to",  "off",       "into"};
    return std::find(kJoins.begin(), kJoins.end(), m.words) != kJoins.end() ||
           (m.is(WordKind::structure) && (m.word->meaning == "doorway" || m.word->meaning == "door"));
}

constexpr const char* kAnyKind = "any";  // of the second room nothing was said but what stands in it

// "a bedroom with an en-suite bathroom", "a living room opening to a kitchen": the second room lies behind a doorway.
void find_next_room(Reading& r) {
    Matches& m = r.m;
    const auto first = std::find_if(m.begin(), m.end(), [](const Match& x) { return is_room(x) && !is_en_suite(x); });
    if (first == m.end()) return;
    const std::string room = first->word->meaning;
    const auto said_en_suite = std::find_if(m.begin(), m.end(), is_en_suite);
    const std::string en_suite = said_en_suite == m.end() ? "" : said_en_suite->word->meaning;
    // "a second room with a piano": of no kind that was said.
    for (Match& x : m)
        if (x.is(WordKind::nuance) && x.word->meaning == "another room" && !x.negated && r.spec.next_room.empty()) {
            const std::string& second = room_type(room).second_room;
            r.spec.next_room = second.empty() ? default_room_type().name : second;
            x.word = Word{WordKind::nuance, "next room", true, kAnyKind};
            return;
        }
    for (auto x = m.begin(); x != m.end(); ++x) {
        if (!is_room(*x) || x == first || is_same_room(room, x->word->meaning) || !x->word->exact) continue;
        const std::string& type = x->word->meaning;
        if (!room_type(type).next_door || (!r.spec.next_room.empty() && r.spec.next_room != type)) continue;
        r.spec.next_room = type;
        const bool said = type == en_suite || std::any_of(first, x, joins_rooms);
        x->word = Word{WordKind::nuance, "next room", said};
    }
}

// What belongs into a room of a type and hardly anywhere else.
bool belongs_to(const std::string& kind, const std::string& room) {
    const RoomType* type = find_room_type(room);
    return type && is_own_thing(kind, *type);
}

}  // namespace

void fill_next_room(Reading& r) {
    if (r.spec.next_room.empty()) return;
    const auto next = std::find_if(r.m.begin(), r.m.end(), [](const Match& x) {
        return x.is(WordKind::nuance) && x.word->meaning == "next room";
    });
    const bool any = next != r.m.end() && next->word->adds == kAnyKind;
    for (auto x = next; x != r.m.end(); ++x) {
        if (any && x->comma) return;
        if (any && x->is(WordKind::relation) && !x->relation) {
            // "a second room with a piano behind the living room"
            const auto room = std::find_if(x, r.m.end(),
                                           [](const Match& y) { return y.is(WordKind::room) || y.comma; });
            if (room != r.m.end() && !room->comma)
                r.tell(static_cast<std::size_t>(x - r.m.begin()), "where the other room lies");
            return;
        }
        if (!has_object(*x) || x->negated) continue;
        if (PromptObject& there = r.spec.objects[static_cast<std::size_t>(x->object)];
            any && there.relation.empty() && x->is(WordKind::object)) {
            there.relation = kInNextRoom;
            continue;
        }
        if (any) continue;
        PromptObject& o = r.spec.objects[static_cast<std::size_t>(x->object)];
        if (o.relation.empty() && belongs_to(o.kind, r.spec.next_room) && !belongs_to(o.kind, r.spec.room))
            o.relation = kInNextRoom;
    }
}

void settle_rooms(Reading& r) {
    count_other_rooms(r.m);
    qualify_rooms(r.m);
    leave_houses(r.m);
    leave_outside(r.m);
    take_as_things(r.m);
    choose_room(r.m, r.spec);
    furnish_parts(r.m);
    if (r.spec.structure.empty()) find_next_room(r);
}

}  // namespace fastscene::reading
