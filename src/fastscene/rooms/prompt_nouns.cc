// The nouns of a prompt: which pieces it speaks of, which of them again, which it does not want.
#include <algorithm>
#include <array>

#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

// Whether "the" or its like stands before it, with nothing but adjectives between.
bool is_definite(const Matches& m, std::size_t i) {
    for (std::size_t k = i; k-- > 0;) {
        if (m[k].is_function("the") || m[k].is_function("its") || m[k].is_function("their") || m[k].is_function("this") || m[k].is_function("that"))
            return true;
        if (!is_adjective(m[k]) && !m[k].is(WordKind::nuance)) return false;
    }
    return false;
}

std::string last_word(const std::string& words) {
    const auto space = words.rfind(' ');
    return space == std::string::npos ? words : words.substr(space + 1);
}

// "the chair" after "two armchairs", "the lamp" after "a floor lamp".
int spoken_of_before(const Reading& r, std::size_t i) {
    const std::string& klass = r.m[i].word->meaning;
    for (std::size_t k = i; k-- > 0;)
        if (has_object(r.m[k]) && r.m[k].word->meaning == klass && r.m[k].is(WordKind::object)) return r.m[k].object;
    const std::string noun = r.m[i].words;
    for (std::size_t k = i; k-- > 0;)
        if (has_object(r.m[k]) && r.m[k].is(WordKind::object) && last_word(r.m[k].words).ends_with(noun)) return r.m[k].object;
    return -1;
}

// A bare plural means more than one ("plants", "chairs"); some words are plural by nature.
bool is_plural(const Match& m, Language language) {
    static constexpr std::array<std::string_view, 12> kNeverMore{"kitchen_counter", "curtain", "towel_rail",  "toy_box", "beams",       "wall",
                                                                 "floor",           "ceiling", "cushion_set", "shower",  "wainscoting", "moulding"};
    const std::string& klass = m.word->meaning;
    if (std::find(kNeverMore.begin(), kNeverMore.end(), klass) != kNeverMore.end() || m.is(WordKind::detail)) return false;
    if (!language.empty()) {
        const auto forms = base_forms(m.words, language);
        return !forms.empty() && (m.words.back() == 's' || m.words.back() == 'n' || m.words.back() == 'i' || m.words.back() == 'e') &&
               std::any_of(forms.begin(), forms.end(), [&](const std::string& f) {
                   const auto w = look_up(f, language);
                   return w && w->meaning == klass;
               });
    }
    if (m.words.ends_with("drawers") || klass == "glass_cup" || m.words.ends_with("stairs")) return false;
    for (const std::string& single : base_forms(m.words))
        if (const auto word = look_up(single); word && word->meaning == klass) return true;
    return false;
}

// Commas do not end "without curtains, rugs or plants".
bool negation_goes_on(const Matches& m, std::size_t comma) {
    for (std::size_t k = comma + 1; k < m.size() && k < comma + 12; ++k) {
        if (m[k].is_function("or") || m[k].is_function("nor")) return true;
        if (m[k].is(WordKind::function) || m[k].is(WordKind::negation) || m[k].is(WordKind::relation) || m[k].is(WordKind::count)) return false;
    }
    return false;
}

void mark_negated(Matches& m) {
    bool negated = false;
    for (std::size_t i = 0; i < m.size(); ++i) {
        if (m[i].comma && negated) negated = negation_goes_on(m, i);
        if (m[i].is(WordKind::negation)) {
            negated = true;
            continue;
        }
        if (m[i].is_function("with") || m[i].is_function("but") || m[i].is_function("mit") || m[i].is_function("avec") || m[i].is_function("con"))
            negated = false;
        // "no tv and a piano": what has its own article is wanted.
        if (negated && m[i].is_function("and") && i + 1 < m.size() && m[i + 1].is(WordKind::count)) negated = false;
        m[i].negated = negated;
    }
}

// "A table" is the table one expects in that room.
void name_tables(Matches& m) {
    std::string room, meaning;
    for (const Match& x : m)
        if (x.is(WordKind::room) && room.empty()) room = x.word->meaning;
    if (room == "dining" || room == "kitchen") meaning = "dining_table";
    if (room == "living" || room == "sunroom" || room == "loft") meaning = "coffee_table";
    for (std::size_t i = 0; i < m.size(); ++i) {
        if (!m[i].word ||
            (m[i].words != "table" && m[i].words != "tables" && m[i].words != "tisch" && m[i].words != "mesa" && m[i].words != "tavolo"))
            continue;
        const bool round = i > 0 && m[i - 1].words == "round";
        bool chairs = false;  // who names chairs with it means to eat at it
        for (std::size_t k = i + 1; k < m.size() && k < i + 7; ++k)
            chairs = chairs || (m[k].is(WordKind::object) && (m[k].word->meaning == "chair" || m[k].word->meaning == "bench"));
        const std::string here = round ? "dining_table_round" : chairs ? "dining_table" : meaning;
        if (!here.empty()) m[i].word = Word{WordKind::object, here};
    }
}

// Some words mean another thing in another room.
void heed_the_room(Matches& m) {
    std::string room;
    for (const Match& x : m)
        if (x.is(WordKind::room) && room.empty()) room = x.word->meaning;
    for (std::size_t i = 0; i < m.size(); ++i) {
        if (!m[i].word) continue;
        const std::string& w = m[i].words;
        if (room == "bathroom" && (w == "sink" || w == "sinks" || w == "faucet" || w == "tap" || w == "counter" || w == "countertop"))
            m[i].word = Word{WordKind::object, "washbasin", w.starts_with("sink")};
        if ((w == "vanity" || w == "vanities") && !room.empty() && room != "bathroom") m[i].word = Word{WordKind::object, "dresser", false};
        // "a fluffy white carpet" is a rug; "carpet" alone covers the floor.
        if (w == "carpet" || w == "carpets") {
            std::size_t k = i;
            while (k > 0 && (is_adjective(m[k - 1]) || m[k - 1].is(WordKind::nuance) || m[k - 1].is(WordKind::style))) --k;
            if (w == "carpets" || (k > 0 && m[k - 1].is(WordKind::count))) m[i].word = Word{WordKind::object, "rug"};
        }
        if (w == "bamboo" && !(i + 1 < m.size() && (is_noun(m[i + 1]) || is_adjective(m[i + 1])))) m[i].word = Word{WordKind::object, "plant", false};
        // Bedding without a bed speaks of the bed.
        if (m[i].is(WordKind::detail) && (w.starts_with("bed") || w == "duvet" || w == "sheets" || w == "comforter")) {
            const bool bed =
                std::any_of(m.begin(), m.end(), [](const Match& x) { return x.is(WordKind::object) && x.word->meaning.starts_with("bed"); });
            if (!bed) m[i].word = Word{WordKind::object, "bed", false};
        }
    }
}

// "monstera plant", "antler chandelier": a noun right before a noun says its kind.
void name_kinds(Matches& m) {
    for (std::size_t i = 0; i + 1 < m.size(); ++i) {
        if (!m[i].is(WordKind::object) || !m[i + 1].is(WordKind::object)) continue;
        const std::vector<std::string> single = base_forms(m[i].words);
        const bool plural = std::any_of(single.begin(), single.end(), [&](const std::string& s) {
            const auto w = look_up(s);
            return w && w->meaning == m[i].word->meaning;
        });
        if (!plural) m[i].word = Word{WordKind::nuance, m[i].word->meaning == m[i + 1].word->meaning ? "kind" : "motif"};
    }
}

// Words that are colors too ("fern", "midnight", "wine") are colors right before an adjective or a noun they are no part of.
void name_colors(Matches& m) {
    for (std::size_t i = 0; i + 1 < m.size(); ++i) {
        if (!m[i].word || !m[i].word->also_color || m[i].is(WordKind::material) || m[i].is(WordKind::color)) continue;
        if (is_noun(m[i + 1]) || m[i + 1].is(WordKind::material) || m[i + 1].is(WordKind::pattern)) m[i].word = Word{WordKind::color, m[i].words};
    }
}

// "light" is a lamp with an article before and no noun behind, a shade of color before a noun, else a feeling of the room.
void name_lights(Matches& m) {
    for (std::size_t i = 0; i < m.size(); ++i)
        if (m[i].words == "light" && m[i].is(WordKind::mood) && i > 0 && (m[i - 1].is(WordKind::count) || m[i - 1].words == "hanging") &&
            (i + 1 >= m.size() || !(is_noun(m[i + 1]) || is_adjective(m[i + 1]))))
            m[i].word = Word{WordKind::object, "ceiling_lamp", false};
}

// A word for the whole house ("apartment", "castle") only names the room when no other word does.
void choose_room(Matches& m) {
    const bool named = std::any_of(m.begin(), m.end(), [](const Match& x) { return x.is(WordKind::room) && x.word->exact && !x.negated; });
    if (!named) return;
    for (Match& x : m)
        if (x.is(WordKind::room) && !x.word->exact) x.word = Word{WordKind::nuance, "house"};
}

void take_added(const Word& word, PromptObject& object) {
    const auto equals = word.adds.find('=');
    if (equals == std::string::npos) return;
    const std::string key = word.adds.substr(0, equals), value = word.adds.substr(equals + 1);
    if (key == "material") object.material = value;
    if (key == "color") object.color = value;
    if (key == "size") object.size = value;
}

}  // namespace

void settle_double_meanings(Reading& r) {
    choose_room(r.m);
    heed_the_room(r.m);
    name_tables(r.m);
    name_colors(r.m);
    name_lights(r.m);
    name_kinds(r.m);
}

void find_nouns(Reading& r) {
    mark_negated(r.m);
    for (std::size_t i = 0; i < r.m.size(); ++i) {
        Match& m = r.m[i];
        if (!m.is(WordKind::object) && !m.is(WordKind::structure)) continue;
        if (is_definite(r.m, i) && m.is(WordKind::object) && !m.negated)
            if (const int before = spoken_of_before(r, i); before >= 0) {
                m.object = before;
                continue;
            }
        // A kitchen has one run of units: stove, sink and worktop are parts of it.
        if (m.word->meaning == "kitchen_counter") {
            const auto same = std::find_if(r.spec.objects.begin(), r.spec.objects.end(),
                                           [&](const PromptObject& o) { return o.klass == m.word->meaning && o.forbidden == m.negated; });
            if (same != r.spec.objects.end()) {
                m.object = same->id;
                continue;
            }
        }
        // "walls … on the wall", "a window … by the window": a part of the shell that was spoken of.
        if (m.is(WordKind::structure) && (is_definite(r.m, i) || (i > 0 && r.m[i - 1].is(WordKind::relation)))) {
            const auto same = std::find_if(r.spec.objects.begin(), r.spec.objects.end(),
                                           [&](const PromptObject& o) { return o.klass == m.word->meaning && o.forbidden == m.negated; });
            if (same != r.spec.objects.end()) {
                m.object = same->id;
                continue;
            }
        }
        PromptObject object;
        object.klass = m.word->meaning;
        object.words = m.words;
        object.forbidden = m.negated;
        object.id = static_cast<int>(r.spec.objects.size());
        if (is_plural(m, r.language)) object.count = 2;
        take_added(*m.word, object);
        m.object = object.id;
        r.spec.objects.push_back(object);
    }
    // "a lamp on the desk, a desk under the window": the desk is one desk.
    for (std::size_t i = 0; i < r.m.size(); ++i) {
        if (!has_object(r.m[i]) || !r.m[i].is(WordKind::object) || r.m[i].negated || !is_definite(r.m, i)) continue;
        for (std::size_t k = i + 1; k < r.m.size(); ++k)
            if (has_object(r.m[k]) && r.m[k].object > r.m[i].object && r.m[k].word->meaning == r.m[i].word->meaning && !r.m[k].negated) {
                const int gone = r.m[k].object;
                r.spec.objects.erase(r.spec.objects.begin() + gone);
                for (Match& x : r.m) x.object = x.object == gone ? r.m[i].object : x.object - (x.object > gone);
                for (PromptObject& o : r.spec.objects) o.id -= o.id > gone;
                break;
            }
    }
}

}  // namespace fastscene::reading
