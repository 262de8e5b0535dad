// Words with more than one meaning, settled by the words and the room around them: "the table" of a dining room, "fern"
// the color, "a light".
#include <algorithm>
#include <string>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

// What "round" is called.
bool is_round(const std::string& words) {
    return is_one_of(words, {"round",    "circular", "rund",    "runde",   "runder",  "rundes",  "runden",
                             "rond",     "ronde",    "ronds",   "rondes",  "redondo", "redonda", "redondos",
                             "redondas", "rotondo",  "rotonda", "rotondi", "rotonde", "tondo",   "tonda"});
}

// "round topped", "arched": of doors, doorways and windows.
bool is_arched(const std::string& words) {
    return is_one_of(words, {"arched", "rounded", "round topped", "arch topped", "round headed", "curved", "vaulted"});
}

// "A round marble table", "une table ronde": whether an adjective of noun i says that it is round (or arched); told as
// understood then.
bool take_round(Matches& m, std::size_t i, bool (*is_shape)(const std::string&) = is_round) {
    const auto describes = [](const Match& x) {
        return is_adjective(x) || x.is(WordKind::nuance) || x.is(WordKind::style);
    };
    const auto take = [&](std::size_t k) {
        if (!is_shape(m[k].words)) return false;
        m[k].word = Word{WordKind::nuance, is_shape == is_round ? "round" : "arched"};
        return true;
    };
    for (std::size_t k = i; k-- > 0 && describes(m[k]);)
        if (take(k)) return true;
    for (std::size_t k = i + 1; k < m.size() && describes(m[k]); ++k)
        if (!is_one_of(m[k].words, {"round", "circular"}) && take(k)) return true;
    return false;
}

Matches::const_iterator first_room(const Matches& m) {
    return std::find_if(m.begin(), m.end(),
                        [](const Match& x) { return x.is(WordKind::room) && !x.word->meaning.empty(); });
}

// "A table" is the table one expects in that room.
void name_tables(Matches& m) {
    std::string meaning;
    if (const auto room = first_room(m); room != m.end()) {
        const RoomType& type = room_type(room->word->meaning);
        const bool near = !room->word->exact && !type.table_when_near.empty();
        meaning = near ? type.table_when_near : type.table;
    }
    for (std::size_t i = 0; i < m.size(); ++i) {
        if (!m[i].word || (m[i].words != "table" && m[i].words != "tables" && m[i].words != "tisch" &&
                           m[i].words != "mesa" && m[i].words != "tavolo"))
            continue;
        const bool round = take_round(m, i);
        bool chairs = false;  // who names chairs with it means to eat at it
        for (std::size_t k = i + 1; k < m.size() && k < i + 7; ++k)
            chairs = chairs ||
                     (m[k].is(WordKind::object) && (m[k].word->meaning == "chair" || m[k].word->meaning == "bench"));
        const bool sat_at = has_role(meaning, Role::work_place);
        const std::string here = round ? "dining_table_round" : chairs && !sat_at ? "dining_table" : meaning;
        if (here.empty()) continue;
        m[i].word = Word{WordKind::object, here};
        m[i].plural = m[i].words == "tables";  // the plural is of another table
    }
}

// "an art deco bar with five stools": no room is named but this. Who names a counter or an island with stools means
// high ones.
void name_bars(Matches& m) {
    const bool named = std::any_of(m.begin(), m.end(),
                                   [](const Match& x) { return x.is(WordKind::room) && !x.negated; });
    std::size_t first = 0;
    while (first < m.size() &&
           (modifies(m[first]) || m[first].is(WordKind::mood) || m[first].is(WordKind::light) ||
            m[first].is(WordKind::time) || m[first].is_function("the") || m[first].is_function("in")))
        ++first;
    bool bar = std::any_of(m.begin(), m.end(), [](const Match& x) {
        return x.is(WordKind::room) && is_one_of(x.words, {"cocktail bar", "bar room", "bar lounge", "wine bar"});
    });
    if (!named && first < m.size() && m[first].words == "bar" && m[first].is(WordKind::object))
        if (const Thing* thing = find_thing(m[first].word->meaning); thing && find_room_type(thing->room))
            m[first].word = Word{WordKind::room, thing->room}, bar = true;
    for (Match& x : m)
        if (bar && x.is(WordKind::object) && is_one_of(x.words, {"counter", "bar counter", "bar"}))
            x.word = Word{WordKind::object, "bar_counter"};
    const bool high =
        bar || std::any_of(m.begin(), m.end(), [](const Match& x) {
            return x.is(WordKind::object) && is_one_of(x.word->meaning, {"kitchen_island", "bar_counter"});
        });
    for (Match& x : m)
        if (high && x.is(WordKind::object) && is_one_of(x.words, {"stool", "stools"}))
            x.plural = x.words == "stools", x.word = Word{WordKind::object, "bar_stool"};
}

// The first thing of a recipe that is called one of these; null: none.
const Thing* called_in(const std::vector<RecipeStep>& recipe, const std::vector<std::string>& names) {
    const auto called = [&](const std::string& kind) -> const Thing* {
        const Thing* thing = kind.empty() ? nullptr : find_thing(kind);
        const auto is_named = [&](const std::string& name) {
            return std::find(names.begin(), names.end(), name) != names.end();
        };
        return thing && std::any_of(thing->called.begin(), thing->called.end(), is_named) ? thing : nullptr;
    };
    for (const RecipeStep& step : recipe) {
        for (const std::string* kind : {&step.thing, &step.seat, &step.back, &step.other})
            if (const Thing* thing = called(*kind)) return thing;
        for (const std::string& kind : step.first_asked)
            if (const Thing* thing = called(kind)) return thing;
        if (const Thing* thing = called_in(step.then, names)) return thing;
    }
    return nullptr;
}

// Whether a word of this kind may be the name of a thing in some room: "seats" is a verb elsewhere.
bool may_name_a_thing(WordKind kind) {
    switch (kind) {
        case WordKind::object:
        case WordKind::structure:
        case WordKind::detail:
        case WordKind::nuance:
        case WordKind::function:
        case WordKind::other: return true;
        default: return false;
    }
}

// Some words mean another thing in another room.
void heed_the_room(Matches& m) {
    const auto room = first_room(m);
    const RoomType* type = room == m.end() ? nullptr : find_room_type(room->word->meaning);
    for (std::size_t i = 0; i < m.size(); ++i) {
        const std::string& w = m[i].words;
        const bool noun = !m[i].word || may_name_a_thing(m[i].word->kind);
        if (type && noun) {
            std::vector<std::string> names = base_forms(w);
            const bool many = called_in(recipe_of(type->name), names) != nullptr;
            names.push_back(w);
            if (const Thing* thing = called_in(recipe_of(type->name), names)) {
                if (!m[i].is(WordKind::object)) m[i].plural = many;
                m[i].word = Word{WordKind::object, thing->kind};
            }
        }
        if (!m[i].word) continue;
        if (type)
            for (const LocalMeaning& local : type->meanings)
                if (std::find(local.words.begin(), local.words.end(), w) != local.words.end())
                    m[i].word = Word{has_role(local.thing, Role::shell) ? WordKind::structure : WordKind::object,
                                     local.thing, !local.near};
        const bool washes = (type && is_own_thing("washbasin", *type)) ||
                            (!type && std::any_of(m.begin(), m.end(), [](const Match& x) {
                                return x.is(WordKind::object) &&
                                       (x.word->meaning == "toilet" || x.word->meaning == "bathtub" ||
                                        x.word->meaning == "shower");
                            }));
        if ((w == "vanity" || w == "vanities") && !washes) m[i].word = Word{WordKind::object, "dressing_table"};
        // "a fluffy white carpet" is a rug; "carpet" alone covers the floor.
        if (w == "carpet" || w == "carpets") {
            std::size_t k = i;
            while (k > 0 && (is_adjective(m[k - 1]) || m[k - 1].is(WordKind::nuance) || m[k - 1].is(WordKind::style)))
                --k;
            m[i].plural = w == "carpets";  // the plural is of a rug
            if (w == "carpets" || (k > 0 && m[k - 1].is(WordKind::count))) m[i].word = Word{WordKind::object, "rug"};
        }
        if (m[i].is(WordKind::object) && has_role(m[i].word->meaning, Role::may_be_round) && m[i].word->adds.empty() &&
            take_round(m, i))
            m[i].word->adds = "pattern=round";
        // Painters bring steps of their own; a library's ladder leans.
        if (w == "ladder" && std::any_of(m.begin(), m.end(), [](const Match& x) {
                return x.word && is_one_of(x.word->meaning, {"renovation", "paint_buckets", "drop_cloth"});
            }))
            m[i].word = Word{WordKind::object, "step_ladder"};
        // A bunk's ladder or stairs are parts of it.
        if (has_role(m[i].word->meaning, Role::climbed) && m[i].is(WordKind::object)) {
            const auto bunk = std::find_if(m.begin(), m.end(), [](const Match& x) {
                return x.is(WordKind::object) && has_role(x.word->meaning, Role::framed_bed);
            });
            if (bunk != m.end()) {
                if (m[i].word->meaning == "staircase" && !m[i].negated && bunk->word->meaning == "bunk_bed" &&
                    added_by(*bunk->word, "pattern").empty())
                    bunk->word->adds += std::string(bunk->word->adds.empty() ? "" : ";") + "pattern=stairs";
                m[i].word = m[i].word->meaning == "staircase" && bunk->word->meaning == "bunk_bed" && !m[i].negated
                                ? Word{WordKind::nuance, "bunk stairs"}
                                : Word{WordKind::detail, "part"};
            }
        }
        // "a round window", "arched wooden doors"
        if (m[i].is(WordKind::structure) && is_one_of(m[i].word->meaning, {"window", "door", "doorway"}) &&
            added_by(*m[i].word, "pattern").empty()) {
            const bool arched = take_round(m, i, is_arched), round = !arched && take_round(m, i);
            if (arched || (round && m[i].word->meaning != "window"))
                m[i].word->adds += std::string(m[i].word->adds.empty() ? "" : ";") + "pattern=arched";
            else if (round) m[i].word->adds += std::string(m[i].word->adds.empty() ? "" : ";") + "pattern=round";
        }
        if (w == "bamboo" && !(i + 1 < m.size() && (is_noun(m[i + 1]) || is_adjective(m[i + 1]))))
            m[i].word = Word{WordKind::object, "plant", false};
        // "an L-shaped gray sofa", "two single white beds", "butcher block counters", "a wall mounted TV": told by a
        // word before.
        for (std::size_t k = i; m[i].is(WordKind::object) && k-- > 0 && (modifies(m[k]) || m[k].is(WordKind::mood));) {
            if (is_one_of(m[k].words, {"l shaped", "corner"}) && m[i].word->meaning == "sofa") {
                m[i].word->adds += std::string(m[i].word->adds.empty() ? "" : ";") + "pattern=corner";
                m[k].word = Word{WordKind::nuance, "corner shape"};
            } else if (m[i].word->meaning == "bed" && is_one_of(m[k].words, {"single", "twin"}) &&
                       is_one_of(w, {"bed", "beds"})) {
                m[i].plural = w == "beds";
                m[i].word->meaning = "bed_single";
                m[k].word = Word{WordKind::nuance, "kind"};
            } else if (m[i].word->meaning == "tv" && is_one_of(m[k].words, {"wall mounted", "mounted", "wall hung"})) {
                m[k].word = Word{WordKind::nuance, "on the wall"};
            }
        }
        if (w == "butcher block" && i + 1 < m.size() && m[i + 1].is(WordKind::object))
            m[i].word = Word{WordKind::material, "oak"};
        // "a bed with a soft mattress" is one thing; alone it lies on the floor.
        if (m[i].is(WordKind::object) && is_one_of(w, {"mattress", "matratze", "matelas", "colchon", "materasso"}) &&
            std::any_of(m.begin(), m.end(), [&](const Match& x) {
                return &x != &m[i] && x.is(WordKind::object) && x.words != w && has_role(x.word->meaning, Role::bed);
            }))
            m[i].word = Word{WordKind::detail, "part"};
        // Bedding without a bed speaks of the bed.
        if (m[i].is(WordKind::detail) && (w.starts_with("bed") || w == "duvet" || w == "sheets" || w == "comforter")) {
            const bool bed = std::any_of(m.begin(), m.end(), [](const Match& x) {
                return x.is(WordKind::object) && has_role(x.word->meaning, Role::bed);
            });
            if (!bed) m[i].word = Word{WordKind::object, "bed", false};
        }
    }
}

// What is a thing in a room and can be drawn as well: "a painting of a ship".
std::string motif_of(const std::string& words) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kDrawn{{{"ship", "ship"},
                                                                                          {"boat", "ship"},
                                                                                          {"car", "car"},
                                                                                          {"skull", "skull"},
                                                                                          {"map", "map"},
                                                                                          {"plant", "leaf"},
                                                                                          {"robot", "robot"}}};
    for (const auto& [noun, motif] : kDrawn)
        if (words == noun || (words.size() == noun.size() + 1 && words.starts_with(noun) && words.back() == 's'))
            return "motif=" + std::string(motif);
    return {};
}

// "a clock shaped like a rooster", "a portrait of a lady", "the family kitchen": no rooster, no lady, no family stands
// there.
void name_likenesses(Matches& m) {
    const auto shows = [](const Match& x) {
        return x.is(WordKind::object) && has_role(x.word->meaning, Role::shows_motif);
    };
    const auto is_person = [](const Match& x) {
        return x.is(WordKind::object) && has_role(x.word->meaning, Role::person);
    };
    for (std::size_t i = 0; i + 1 < m.size(); ++i) {
        if (is_person(m[i]) && (m[i + 1].is(WordKind::room) || is_noun(m[i + 1])))
            m[i].word = Word{WordKind::nuance, "owner"};
        const bool likeness = m[i].is(WordKind::nuance) && m[i].word->meaning == "likeness";
        if (!likeness && !(shows(m[i]) && m[i + 1].is_function("of"))) continue;
        for (std::size_t k = i + (likeness ? 1 : 2); k < m.size() && (modifies(m[k]) || is_noun(m[k])); ++k) {
            if (!is_noun(m[k])) continue;
            m[k].word = Word{WordKind::nuance, "motif", true, motif_of(m[k].words)};
            break;
        }
    }
}

// "monstera plant", "antler chandelier": a noun right before a noun says its kind.
void name_kinds(Matches& m) {
    name_likenesses(m);
    for (std::size_t i = 0; i + 1 < m.size(); ++i) {
        // "a fan shaped mirror": no fan is there.
        if (m[i].is(WordKind::object) && m[i + 1].words == "shaped") m[i].word = Word{WordKind::nuance, "shape"};
        // "a violin maker's workshop": what is made there says who works there.
        if (m[i].is(WordKind::object) && m[i + 1].is(WordKind::nuance) && m[i + 1].word->meaning == "owner" &&
            (m[i + 1].words.ends_with("ers") || m[i + 1].words.ends_with("ors") || m[i + 1].words.ends_with("ists")))
            m[i].word = Word{WordKind::nuance, "owner"};
        // "a sleeping cat", "a dog asleep on the rug": told by the words next to it.
        for (const std::size_t k : {i, i + 1}) {
            const std::size_t animal = k == i ? i + 1 : i;
            if (!m[animal].is(WordKind::object) || !has_role(m[animal].word->meaning, Role::pet)) continue;
            const std::string verb = m[k].words.substr(0, m[k].words.find(' '));
            if (!is_one_of(verb, {"sleeping", "asleep", "sleeps", "napping", "naps", "snoozing", "dozing", "curled",
                                  "sleepy", "lying", "lies"}))
                continue;
            if (m[animal].word->meaning == "cat" && !verb.starts_with("l"))
                m[animal].word->adds = std::string("pattern=") + kAsleep;
            if (!m[k].is(WordKind::relation))
                m[k].word = Word{WordKind::nuance, "asleep"};  // "sleeping on" says where as well
        }
        // "Barcelona chairs" look out on nothing.
        if (m[i].is(WordKind::nuance) && m[i].word->meaning == "outside" && m[i + 1].is(WordKind::object))
            m[i].word = Word{WordKind::nuance, "kind", false};
        if (!m[i].is(WordKind::object) || !m[i + 1].is(WordKind::object)) continue;
        const std::vector<std::string> single = base_forms(m[i].words);
        const bool plural = std::any_of(single.begin(), single.end(), [&](const std::string& s) {
            const auto w = look_up(s);
            return w && w->meaning == m[i].word->meaning;
        });
        if (!plural)
            m[i].word = Word{WordKind::nuance, m[i].word->meaning == m[i + 1].word->meaning ? "kind" : "motif"};
    }
}

// Words that are colors too ("fern", "midnight", "coffee") are colors right before an adjective or a noun they are no
// part of, and where a color is said: "in coffee and cream".
void name_colors(Matches& m) {
    const auto colored = [](const Match& x) {
        return is_noun(x) || x.is(WordKind::material) || x.is(WordKind::pattern) || x.is(WordKind::color) ||
               x.words == "colored";
    };
    for (std::size_t i = 0; i < m.size(); ++i) {
        if (!m[i].word || !m[i].word->also_color || m[i].is(WordKind::material) || m[i].is(WordKind::color)) continue;
        const bool before = i + 1 < m.size() && colored(m[i + 1]);
        const bool thing = m[i].is(WordKind::nuance) && m[i].word->meaning == "thing";
        const bool joined = i + 2 < m.size() && m[i + 1].is_function("and") && m[i + 2].is(WordKind::color);
        const bool led = i > 0 && (m[i - 1].is_function("in") ||
                                   (i > 1 && m[i - 1].is_function("and") && m[i - 2].is(WordKind::color)));
        if (before || (thing && (joined || led))) m[i].word = Word{WordKind::color, m[i].words};
    }
}

// "light" is a lamp with an article before and no noun behind, a shade of color before a noun, else a feeling of the
// room.
void name_lights(Matches& m) {
    for (std::size_t i = 1; i < m.size(); ++i)  // "the only light comes from a lamp"
        if (m[i].words == "light" && m[i].is(WordKind::mood) && m[i - 1].is(WordKind::scope))
            m[i].word = Word{WordKind::nuance, "feel"};
    for (std::size_t i = 1; i < m.size(); ++i)  // "red light"
        if (m[i].words == "light" && m[i].is(WordKind::mood) && m[i - 1].is(WordKind::color) &&
            (i + 1 == m.size() || m[i + 1].comma || m[i + 1].is(WordKind::function)))
            m[i].word = Word{WordKind::nuance, "feel"};
    for (std::size_t i = 0; i < m.size(); ++i)
        if (m[i].words == "light" && m[i].is(WordKind::mood) && i > 0 &&
            (m[i - 1].is(WordKind::count) || m[i - 1].words == "hanging") &&
            (i + 1 >= m.size() || !(is_noun(m[i + 1]) || is_adjective(m[i + 1]))))
            m[i].word = Word{WordKind::object, "ceiling_lamp", false};
}

}  // namespace

void settle_double_meanings(Reading& r) {
    mark_negated(r.m);
    name_bars(r.m);
    settle_rooms(r);
    heed_the_room(r.m);
    name_tables(r.m);
    name_colors(r.m);
    name_lights(r.m);
    name_kinds(r.m);
}

}  // namespace fastscene::reading
