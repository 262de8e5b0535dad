// Adjectives to nouns: "a brown leather sofa and two green armchairs", "sofa in dark blue", "walls painted sage green".
#include <algorithm>
#include <array>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/rooms/furniture.h"
#include "fastscene/rooms/prints.h"
#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

// Words for brightness that are shades of color before a noun ("dark wooden floor", "light curtains").
bool is_shade(const Match& m) {
    return (m.is(WordKind::light) || m.is(WordKind::mood)) &&
           (m.words == "dark" || m.words == "bright" || m.words == "light" || m.words == "dim" || m.words == "dunkel" ||
            m.words == "hell" || m.words == "sombre" || m.words == "clair" || m.words == "claire" ||
            m.words == "oscuro" || m.words == "scuro");
}
bool is_and(const Match& m) {
    return m.is(WordKind::function) && (m.words == "and" || m.words == "und" || m.words == "et" || m.words == "y" ||
                                        m.words == "e" || m.words == "or");
}
bool is_article(const Match& m) { return m.is(WordKind::count) && m.word->meaning == "1"; }

// "in", "of", "painted in" … lead an adjective that follows its noun.
bool leads_back(const Match& m) {
    static constexpr std::array<std::string_view, 41> kLeads{"in",
                                                             "of",
                                                             "with",
                                                             "painted",
                                                             "painted in",
                                                             "made of",
                                                             "made from",
                                                             "made out of",
                                                             "upholstered in",
                                                             "covered with",
                                                             "covered in",
                                                             "finished in",
                                                             "clad in",
                                                             "done in",
                                                             "is",
                                                             "are",
                                                             "built from",
                                                             "crafted from",
                                                             "carved from",
                                                             "decorated in",
                                                             "from",
                                                             "wrapped in",
                                                             "lined with",
                                                             "dressed in",
                                                             "aus",
                                                             "mit",
                                                             "en",
                                                             "de",
                                                             "di",
                                                             "con",
                                                             "in the",
                                                             "decorated with",
                                                             "as",
                                                             "was",
                                                             "that is",
                                                             "which is",
                                                             "that are",
                                                             "which are",
                                                             "should be",
                                                             "must be",
                                                             "be"};
    return m.is(WordKind::function) && std::find(kLeads.begin(), kLeads.end(), m.words) != kLeads.end();
}

bool is_brown(std::string_view material) {
    static constexpr std::array<std::string_view, 12> kBrown{"wood",    "oak",      "walnut",  "pine",
                                                             "leather", "planks",   "parquet", "rattan",
                                                             "teak",    "mahogany", "maple",   "birch"};
    return std::find(kBrown.begin(), kBrown.end(), material) != kBrown.end();
}

// Lamps of the furniture pack have no row.
bool is_lamp(std::string_view kind) { return has_role(kind, Role::light) || kind.ends_with("_lamp"); }

// What "dark" and "light" mean for a thing of this material.
std::string shade_of(std::string_view word, const PromptObject& object) {
    const bool light = word == "bright" || word == "light" || word == "hell" || word == "clair" || word == "claire";
    if (is_brown(object.material)) return light ? "light brown" : "dark brown";
    return light ? (object.kind == "wall" || object.kind == "ceiling" ? "white" : "cream") : "charcoal";
}

bool can_be_counted(const Match& noun) {
    if (noun.word->meaning == "kitchen_counter") return false;  // a kitchen has one run of units
    return noun.is(WordKind::object) || has_role(noun.word->meaning, Role::countable);
}

// "rows of", "many": no number that a pattern of the room would have to keep.
bool is_vague(const std::string& words) {
    constexpr std::array<std::string_view, 24> kVague{
        "row",   "rows",   "line",   "few",     "several",  "some",      "many",      "lots",
        "lot",   "bunch",  "number", "dozens",  "hundreds", "thousands", "countless", "endless",
        "loads", "plenty", "tons",   "various", "multiple", "numerous",  "abundant",  "abundance"};
    const std::string said = " " + words + " ";
    return std::any_of(kVague.begin(), kVague.end(), [&](std::string_view word) {
        return said.find(" " + std::string(word) + " ") != std::string::npos;
    });
}

// Whether the room that the prompt names has a pattern of this kind: seats in rows, tables on a grid.
bool has_pattern_of(const Reading& r, const std::string& kind) {
    const auto room = std::find_if(r.m.begin(), r.m.end(), [](const Match& x) {
        return x.is(WordKind::room) && !x.negated && !x.word->meaning.empty();
    });
    return room != r.m.end() && sets_many(recipe_of(room->word->meaning), kind);
}

// "a stack of books", "a row of boots": where one piece is many such things.
bool is_heap(const std::string& words) {
    const auto ends = [&](std::string_view tail) { return words.ends_with(tail); };
    return ends("stack of") || ends("pile of") || ends("heap of") || ends("row of");
}

// What of a kitchen's units a word names: "marble countertops", "green cabinets", "a tiled backsplash", "a steel sink".
enum class UnitPart { fronts, top, back, other };
UnitPart part_of_units(const PromptObject& object, const Match& noun, const Match& adjective) {
    if (!is_one_of(object.kind, {"kitchen_counter", "kitchen_island"})) return UnitPart::fronts;
    const std::string& w = noun.words;
    if (is_one_of(w, {"backsplash", "splashback"})) return UnitPart::back;
    const bool counter = w.find("counter") != std::string::npos && w.find("bar") == std::string::npos,
               top = w.find("top") != std::string::npos || w.ends_with("counters");
    const bool material = adjective.is(WordKind::material);
    // Nobody's doors are of marble.
    if (material && is_one_of(adjective.word->meaning, {"marble", "granite", "stone", "slate", "concrete", "terrazzo"}))
        return UnitPart::top;
    if ((counter || w.starts_with("work")) && (top || material)) return UnitPart::top;
    static constexpr std::array<std::string_view, 13> kFronts{
        "cabinet", "cupboard", "unit",  "kitchenette", "island", "breakfast bar", "bar",
        "counter", "worktop",  "kuche", "cuisine",     "cocina", "cucina"};
    const bool fronts = noun.word->exact || std::any_of(kFronts.begin(), kFronts.end(), [&](std::string_view part) {
                            return w.find(part) != std::string::npos;
                        });
    return fronts ? UnitPart::fronts : UnitPart::other;
}

// "white marble countertops": the top's, not the doors'.
void give_part(Reading& r, std::size_t at, const Match& noun, UnitPart part, PromptObject& object) {
    const Match& a = r.m[at];
    std::string& color = part == UnitPart::top ? object.holder_color : object.back_color;
    std::string& material = part == UnitPart::top ? object.holder_material : object.back_material;
    const std::string whose = part == UnitPart::top ? " of the worktop" : " of the wall behind it";
    if (part == UnitPart::other || a.is(WordKind::pattern))
        return r.tell_near(at, "of the " + noun.words + ", as the units have it", object.id);
    PromptObject alike = object;
    alike.material = material;
    const std::string what = is_shade(a) ? shade_of(a.words, alike) : a.word->meaning;
    std::string& field = a.is(WordKind::material) ? material : color;
    if (field.empty()) field = what;
    const std::string title = (a.is(WordKind::material) ? "material " : "color ") + field + whose;
    if (field == what && a.word->exact) r.tell(at, title, object.id);
    else r.tell_near(at, title, object.id);
    if (a.is(WordKind::material) && color.empty()) color = added_by(*a.word, "color");
}

}  // namespace

void bind_adjective(Reading& r, std::size_t at, std::size_t noun) {
    Match& a = r.m[at];
    const Match& n = r.m[noun];
    if (a.noun >= 0 || !a.word || a.settled || a.word->adds == "seats") return;
    a.noun = static_cast<int>(noun);
    if (n.is(WordKind::detail)) {
        if (!a.is(WordKind::count) && !is_article(a))
            r.tell_near(at, "of the " + n.words + ", which are as the piece has them");
        return;
    }
    PromptObject& object = r.object_of(noun);
    const std::string whose = " of " + object.kind;
    if (a.negated && !n.negated) {
        if (!a.is(WordKind::color))
            return r.tell_near(at, "not " + a.word->meaning + ": the " + object.words + " is as the style has it",
                               object.id);
        object.not_color = a.word->meaning;
        return r.tell(at, "not " + a.word->meaning + whose, object.id);
    }
    const auto take = [&](std::string PromptObject::*field, const char* name) {
        if ((object.*field).empty() || object.*field == a.word->meaning) {
            object.*field = a.word->meaning;
            r.tell(at, std::string(name) + " " + a.word->meaning + whose, object.id);
        } else {
            r.tell_near(at, std::string(name) + whose + " stays " + object.*field, object.id);
        }
        if (!a.word->exact) r.tell_near(at, std::string(name) + " " + object.*field + whose, object.id);
    };
    if (a.is(WordKind::color) || a.is(WordKind::material) || a.is(WordKind::pattern) || is_shade(a))
        if (const UnitPart part = part_of_units(object, n, a); part != UnitPart::fronts)
            return give_part(r, at, n, part, object);
    // Flowers and their vase are one piece, whose own color is the flowers'.
    const bool of_holder = object.kind == "bouquet" && has_role(n.word->meaning, Role::vase);
    if (of_holder && a.is(WordKind::color)) {
        take(&PromptObject::holder_color, "vase in color");
    } else if (of_holder && a.is(WordKind::material)) {
        take(&PromptObject::holder_material, "vase of");
    } else if (a.is(WordKind::color)) {
        if (!object.color.empty() && object.color2.empty() && object.color != a.word->meaning) {
            object.color2 = a.word->meaning;
            r.tell(at, "second color " + a.word->meaning + whose, object.id);
        } else {
            take(&PromptObject::color, "color");
        }
    } else if (a.is(WordKind::material)) {
        take(&PromptObject::material, "material");
        if (object.color.empty()) object.color = added_by(*a.word, "color");
        if (object.pattern.empty()) object.pattern = added_by(*a.word, "pattern");
    } else if (a.is(WordKind::pattern) && !object.pattern.empty() && a.words.starts_with("pattern")) {
        r.tell(at, "pattern " + object.pattern + whose, object.id);  // "trellis patterned"
    } else if (a.is(WordKind::pattern)) {
        take(&PromptObject::pattern, "pattern");
        const bool shown = !is_one_of(object.kind, {"wall", "ceiling"}) || is_print(a.word->meaning) ||
                           a.word->meaning == "plain";
        if (!shown) r.tell_near(at, "pattern " + a.word->meaning + whose + ": no paper of ours has it", object.id);
    } else if (a.is(WordKind::size) && a.words == "open") {
        r.tell_near(at, "of the " + object.words + ": as such pieces are",
                    object.id);  // rooms are large when they are open, shelves are not
    } else if (a.is(WordKind::size)) {
        if (object.size.empty()) object.size = a.word->meaning == "small" ? "small" : "large";
        constexpr float kLongTable = 2.2f;
        if (object.kind == "dining_table" && a.words == "long" && !(object.size_m.x > 0)) object.size_m.x = kLongTable;
        if (object.kind == "window" && object.pattern.empty() &&
            is_one_of(a.words, {"floor to ceiling", "full height"}))
            object.pattern = kFullHeight;
        r.tell(at, "size " + object.size + whose, object.id);
    } else if (a.is(WordKind::style)) {
        object.style = a.word->meaning;
        if (a.word->exact) r.tell(at, "style " + object.style + whose, object.id);
        else r.tell_near(at, "style " + object.style + whose, object.id);
    } else if (is_shade(a) && is_lamp(object.kind) && is_one_of(a.words, {"dim", "bright"})) {
        // Of lamps it is their light.
        if (r.spec.light.empty()) r.spec.light = a.words;
        if (r.spec.light == a.words) r.tell(at, "light: " + a.words, object.id);
        else r.tell_near(at, "light: contradicts " + r.spec.light + ", which came first");
    } else if (is_shade(a)) {
        if (object.color.empty())
            object.color = shade_of(a.words, object), r.tell(at, "color " + object.color + whose, object.id);
        else r.tell_near(at, "the color" + whose + " stays " + object.color, object.id);
    } else if (a.is(WordKind::count)) {
        // "a dozen red roses" are one bouquet, "two bouquets of roses" are two.
        const bool flowers = object.kind == "bouquet" && n.word->meaning == "bouquet" &&
                             !is_one_of(n.words, {"bouquet", "bouquets", "flower arrangement", "flower arrangements",
                                                  "floral arrangement", "floral arrangements", "centerpiece",
                                                  "centerpieces", "posy", "posies"});
        if (is_article(a) && (a.words == "a" || a.words == "an")) {
            if (!object.counted) object.count = 1;
        } else if (flowers) {
            if (!object.counted) object.count = 1;
            r.tell_near(at, "of flowers in a vase: as many as it holds", object.id);
        } else if (is_heap(a.words) && has_role(object.kind, Role::heap)) {
            if (!object.counted) object.count = 1, object.counted = true;
            r.tell(at, object.kind + " is one", object.id);
        } else if (is_vague(a.words) && has_pattern_of(r, object.kind)) {
            r.tell(at, "as many " + object.words + " as such a room has", object.id);
        } else if (can_be_counted(n)) {
            object.count = std::stoi(a.word->meaning);
            if (has_role(object.kind, Role::two_of_them)) object.count = (object.count + 1) / 2;
            object.counted = true;
            object.in_row = object.in_row || a.words.find("row of") != std::string::npos;
            r.tell(at, "count " + a.word->meaning + whose, object.id);
        }
    }
}

namespace {

// Whether the adjectives before `connector` (a comma or "and") belong to the phrase behind it.
bool crosses(const Reading& r, std::size_t connector, std::size_t noun) {
    if (connector == 0 || connector + 1 >= r.m.size()) return false;
    const Match &left = r.m[connector - 1], &right = r.m[connector + 1];
    if (!(is_adjective(left) || left.is(WordKind::nuance) || is_shade(left)) || right.is(WordKind::count) ||
        right.is(WordKind::function))
        return false;
    if (left.comma) return false;
    // "with white linen, blue walls": a material ends its own phrase.
    if (left.is(WordKind::material) && !right.is(WordKind::material) && connector + 1 != noun) return false;
    // "emerald tiles and brass taps": tiles are a surface, said as a noun.
    if (left.is(WordKind::material) &&
        is_one_of(left.words, {"tiles", "bricks", "tiling", "planks", "floorboards", "paneling", "panels"}))
        return false;
    if (connector + 1 == noun) return false;
    // "in red and blue curtains": what "in" leads belongs to the noun before.
    std::size_t k = connector;
    while (k > 0 && (is_adjective(r.m[k - 1]) || r.m[k - 1].is(WordKind::nuance) || is_shade(r.m[k - 1]))) --k;
    if (k > 0 && leads_back(r.m[k - 1]) && r.m[k - 1].words != "with" && r.m[k - 1].words != "mit" &&
        r.m[k - 1].words != "avec" && r.m[k - 1].words != "con") {
        for (std::size_t j = k - 1; j-- > 0;)
            if (is_noun(r.m[j])) return false;
            else if (r.m[j].comma || r.m[j].is(WordKind::room)) break;
    }
    return true;
}

// Everything before the noun that describes it, back to its article.
std::size_t phrase_start(const Reading& r, std::size_t noun) {
    std::size_t i = noun;
    while (i > 0) {
        const Match& before = r.m[i - 1];
        if (before.negated != r.m[noun].negated && before.is(WordKind::negation)) break;
        if (before.comma || is_and(before)) {
            if (!crosses(r, i - 1, noun)) break;
            --i;
            continue;
        }
        if (!modifies(before)) break;
        --i;
        if (before.is(WordKind::count)) {
            // "a pair of two": one count is enough; "a large set of three red vases" goes on.
            if (is_article(before) || i == 0 || !modifies(r.m[i - 1]) || r.m[i - 1].is(WordKind::count)) break;
        }
    }
    return i;
}

void bind_before(Reading& r, std::size_t noun) {
    const std::size_t begin = phrase_start(r, noun);
    // The material first: what "dark" means depends on it.
    for (std::size_t i = begin; i < noun; ++i)
        if (r.m[i].is(WordKind::material)) bind_adjective(r, i, noun);
    for (std::size_t i = begin; i < noun; ++i)
        if (is_adjective(r.m[i]) || r.m[i].is(WordKind::count) || r.m[i].is(WordKind::style) || is_shade(r.m[i]))
            bind_adjective(r, i, noun);
    // "two windows and a door": an article alone says one.
    if (begin > 0 && r.m[begin - 1].is(WordKind::count) && is_noun(r.m[noun])) bind_adjective(r, begin - 1, noun);
}

// French, Spanish, Italian: the adjectives behind the noun.
void bind_after(Reading& r, std::size_t noun) {
    for (std::size_t i = noun + 1; i < r.m.size(); ++i) {
        if (r.m[i].comma || is_noun(r.m[i]) || r.m[i].is(WordKind::count) || r.m[i].is(WordKind::relation)) break;
        if (r.m[i].is(WordKind::function) &&
            !(leads_back(r.m[i]) && i + 1 < r.m.size() && r.m[i + 1].is(WordKind::material)))
            break;
        if (is_adjective(r.m[i]) || is_shade(r.m[i])) bind_adjective(r, i, noun);
    }
}

// … between a noun and an adjective that looks back at it.
bool may_stand_between(const Match& m) {
    return is_adjective(m) || m.is(WordKind::nuance) || m.is(WordKind::style) || is_shade(m) || is_and(m) ||
           is_article(m) || m.is_function("but") || m.is_function("that") || m.is_function("which") ||
           m.is_function("the");
}

// The noun that an adjective nobody took looks back at: "sofa in dark blue", "the walls are white", "bed with white
// linen".
std::optional<std::size_t> noun_behind(const Reading& r, std::size_t at) {
    std::size_t i = at;
    bool led = false;
    while (i > 0) {
        const Match& before = r.m[i - 1];
        if (is_noun(before)) return led ? std::optional(i - 1) : std::nullopt;
        if (leads_back(before)) led = true;
        else if (before.is(WordKind::negation) && r.m[i].negated) led = true;  // "not brown", "aren't white"
        else if (!may_stand_between(before) &&
                 !(before.comma && i < at && ((!led && is_adjective(r.m[i])) || r.m[i].is(WordKind::negation))))
            return {};
        --i;
    }
    return {};
}

// "a rattan chair" is one to lounge in; at a table or a desk, or where there are many, it is a chair like others.
void name_lounge_chairs(Reading& r) {
    const auto sits_up = [](const Match& m) {
        static constexpr std::array<std::string_view, 6> kUpright{"dining_table",   "dining_table_round", "desk",
                                                                  "kitchen_island", "kitchen_counter",    "piano"};
        return (m.is(WordKind::room) && room_type(m.word->meaning).upright_chairs) ||
               (m.is(WordKind::object) &&
                std::find(kUpright.begin(), kUpright.end(), m.word->meaning) != kUpright.end());
    };
    if (std::any_of(r.m.begin(), r.m.end(), sits_up)) return;
    for (PromptObject& o : r.spec.objects)
        if (o.kind == "chair" && o.material == "rattan" && o.count <= 2 && !o.forbidden) o.kind = "armchair";
}

// "fifty sofas in a small bathroom": of the room.
bool leads_to_a_room(const Reading& r, std::size_t at) {
    for (std::size_t k = at + 1; k < r.m.size(); ++k) {
        if (r.m[k].is(WordKind::room)) return !r.m[k].negated;
        if (!modifies(r.m[k]) && !r.m[k].is(WordKind::mood) && !r.m[k].is(WordKind::light) && !is_and(r.m[k]))
            return false;
    }
    return false;
}

}  // namespace

bool modifies(const Match& m) {
    return is_adjective(m) || m.is(WordKind::nuance) || m.is(WordKind::style) || m.is(WordKind::count) ||
           m.is(WordKind::unit) || is_shade(m) || (!m.word && !m.comma);
}

void bind_adjectives(Reading& r) {
    const bool follow = adjectives_follow(r.language);
    for (std::size_t i = 0; i < r.m.size(); ++i)
        if (is_noun(r.m[i])) {
            if (follow) bind_after(r, i);
            bind_before(r, i);
        }
    for (std::size_t i = 0; i < r.m.size(); ++i)
        if (r.m[i].noun < 0 && (is_adjective(r.m[i]) || is_shade(r.m[i])) && !leads_to_a_room(r, i))
            if (const auto noun = noun_behind(r, i); noun && (!r.m[*noun].negated || r.m[i].negated))
                bind_adjective(r, i, *noun);
    pass_on_cloth(r);
    name_lounge_chairs(r);
}

}  // namespace fastscene::reading
