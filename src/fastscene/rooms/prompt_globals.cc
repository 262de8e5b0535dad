// What a prompt says of the room as a whole: type, style, hour, weather, light, mood, and adjectives that no noun took.
#include <algorithm>
#include <array>

#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/prompt_parts.h"
#include "fastscene/rooms/style.h"

namespace fastscene::reading {
namespace {

// The first to speak is heard; who contradicts is reported.
void choose(Reading& r, std::size_t i, std::string PromptSpec::*field, const char* name, const std::string& title) {
    Match& m = r.m[i];
    if (m.negated) return r.tell(i, "not " + title);
    std::string& value = r.spec.*field;
    if (value.empty()) value = m.word->meaning;
    if (value != m.word->meaning)
        return r.tell_near(i, std::string(name) + ": contradicts " + value + ", which came first");
    if (m.word->exact) r.tell(i, std::string(name) + ": " + title);
    else r.tell_near(i, std::string(name) + ": " + title);
}

bool beside_room(const Reading& r, std::size_t i) {
    for (std::size_t k = i + 1; k < r.m.size() && k <= i + 4; ++k) {
        if (r.m[k].is(WordKind::room)) return true;
        if (r.m[k].comma || r.m[k].is(WordKind::function) || r.m[k].is(WordKind::relation)) return false;
    }
    return false;
}

bool is_floor(const std::string& material) {
    static constexpr std::array<std::string_view, 9> kFloors{"carpet",   "parquet", "planks", "marble", "terrazzo",
                                                             "linoleum", "vinyl",   "cork",   "rubber"};
    return std::find(kFloors.begin(), kFloors.end(), material) != kFloors.end();
}
bool is_wall(const std::string& material) {
    static constexpr std::array<std::string_view, 7> kWalls{"brick",   "tile", "concrete", "stone",
                                                            "plaster", "wood", "marble"};
    return std::find(kWalls.begin(), kWalls.end(), material) != kWalls.end();
}
// Tiles of other rooms lie on the floor.
bool has_tiled_walls(const Reading& r) {
    const auto room = std::find_if(r.m.begin(), r.m.end(),
                                   [](const Match& m) { return m.is(WordKind::room) && !m.negated; });
    const std::string kind = !r.spec.room.empty() ? r.spec.room : room == r.m.end() ? "" : room->word->meaning;
    const RoomType* type = find_room_type(kind);
    return kind.empty() || (type && type->wall_tiles);
}
bool is_free(const Match& m) {
    return m.noun < 0 && !m.settled && !m.negated && (m.is(WordKind::color) || m.is(WordKind::pattern));
}

// The colors and the pattern of a material that stands as a noun: "black and white checkered tiles", "tiled in
// turquoise".
std::vector<std::size_t> adjectives_of_surface(const Reading& r, std::size_t i) {
    std::vector<std::size_t> out;
    const auto joins = [&](std::size_t k) { return r.m[k].is_function("and") && k > 0 && is_free(r.m[k - 1]); };
    for (std::size_t k = i;
         k-- > 0 && (is_free(r.m[k]) || r.m[k].is(WordKind::nuance) || r.m[k].is(WordKind::size) || joins(k));)
        if (is_free(r.m[k])) out.insert(out.begin(), k);
    for (std::size_t k = i + 1; adjectives_follow(r.language) && k < r.m.size() && is_free(r.m[k]); ++k)
        out.push_back(k);  // "azulejos azules"
    const std::size_t behind = i + 2;
    const bool in = behind < r.m.size() && r.m[i + 1].is_function("in") && is_free(r.m[behind]);
    if (in && (behind + 1 == r.m.size() || !is_noun(r.m[behind + 1]))) out.push_back(behind);
    return out;
}

// "rattan furniture", "dark wood furnishings": of the pieces, whatever the material.
bool is_furnitures(const Reading& r, std::size_t i) {
    std::size_t k = i + 1;
    while (k < r.m.size() && modifies(r.m[k]) && !r.m[k].words.starts_with("furni")) ++k;
    return k < r.m.size() && r.m[k].words.starts_with("furni");
}
// What of a room is of an accent material; "": nothing.
const char* shows_in(const std::string& material) {
    if (is_one_of(material, {"rattan", "wicker", "cane"})) return "seats and low tables";
    if (is_one_of(material, {"leather", "velvet"})) return "seats";
    const auto m = material_named(material);
    if (m && m->metal > 0.5f) return "lamps, frames and handles";
    if (m && m->pattern == Pattern::wood) return "the furniture's wood";
    return "";
}

// A material that belongs to no noun is a surface of the room: "a brick loft", "exposed brick", "marble bathroom".
void read_surface(Reading& r, std::size_t i) {
    const std::string material = r.m[i].word->meaning;
    if (r.m[i].negated) return r.tell(i, "no " + material);
    const std::vector<std::size_t> adjectives = adjectives_of_surface(r, i);
    const bool checkered = std::any_of(adjectives.begin(), adjectives.end(),
                                       [&](std::size_t k) { return r.m[k].word->meaning == "checkered"; });
    const bool terracotta = std::any_of(adjectives.begin(), adjectives.end(),
                                        [&](std::size_t k) { return r.m[k].word->meaning == "terracotta"; });
    const bool floor = is_floor(material) || (material == "tile" && (checkered || terracotta || !has_tiled_walls(r)));
    if (is_furnitures(r, i) || (!floor && !is_wall(material))) {
        r.spec.accents.push_back(material);
        r.m[i].settled = true;
        const char* where = shows_in(material);
        return *where ? r.tell(i, std::string("accent material: of ") + where)
                      : r.tell_near(i, "accent material: nothing in the room shows it");
    }
    PromptObject& surface = r.add_object(floor ? "floor" : "wall", r.m[i].words);
    surface.material = material;
    surface.color = added_by(*r.m[i].word, "color");
    for (const std::size_t k : adjectives) {
        const std::string& what = r.m[k].word->meaning;
        std::string& field = r.m[k].is(WordKind::pattern) ? surface.pattern
                             : surface.color.empty()      ? surface.color
                                                          : surface.color2;
        r.m[k].noun = static_cast<int>(i);
        if (field.empty() || (r.m[k].is(WordKind::pattern) && r.m[k].words.starts_with("pattern")))
            r.tell(k, (r.m[k].is(WordKind::pattern) ? "pattern " : "color ") + what + " of the " + surface.kind,
                   surface.id);
        else r.tell_near(k, "the " + surface.kind + " stays " + field, surface.id);
        if (field.empty()) field = what;
    }
    if (surface.pattern.empty()) surface.pattern = added_by(*r.m[i].word, "pattern");
    r.m[i].object = surface.id;
    r.m[i].settled = true;
    if (r.m[i].word->exact) r.tell(i, "material " + material + " of the " + surface.kind, surface.id);
    else r.tell_near(i, "material " + material + " of the " + surface.kind, surface.id);
}

// "formal", "minimalist", "modern": qualifies a style as well as naming one.
bool gives_way(const Word& style) { return !style.exact || !added_by(style, "yields").empty(); }

// "minimalist japandi", "a formal art deco room": the style that is named, wherever it stands.
const Match* named_style(const Reading& r) {
    const auto named = std::find_if(r.m.begin(), r.m.end(), [](const Match& m) {
        return m.is(WordKind::style) && m.noun < 0 && !m.negated && !gives_way(*m.word);
    });
    return named == r.m.end() ? nullptr : &*named;
}

void read_style(Reading& r, std::size_t i) {
    if (r.m[i].negated) return r.tell(i, "not " + r.m[i].word->meaning);
    const Match* named = gives_way(*r.m[i].word) ? named_style(r) : nullptr;
    if (named && named->word->meaning != r.m[i].word->meaning)
        r.tell_near(i, "style: " + named->word->meaning + ", which is named");
    else choose(r, i, &PromptSpec::style, "style", r.m[i].word->meaning);
    // "minimalist" speaks of how much there is, too.
    if (const std::string clutter = added_by(*r.m[i].word, "clutter"); !clutter.empty() && r.spec.clutter.empty()) {
        r.spec.clutter = clutter;
        r.m[i].meaning += ", with few things";
    }
}

// Whether what the windows show was only guessed so far, from the name of a place.
bool outlook_is_a_guess(const Reading& r, std::size_t i) {
    return std::none_of(r.m.begin(), r.m.begin() + static_cast<std::ptrdiff_t>(i), [](const Match& m) {
        return m.is(WordKind::nuance) && !m.negated && m.word->meaning == "outside" &&
               m.word->adds.starts_with("view=") && m.word->exact;
    });
}

// The first noun from here on.
std::size_t noun_from(const Reading& r, std::size_t i) {
    while (i < r.m.size() && !is_noun(r.m[i])) ++i;
    return i;
}

// "an octagonal library", "a round room", "une chambre ronde": of the room, not of a piece in it.
bool shapes_room(const Reading& r, std::size_t i) {
    const auto is_room = [](const Match& m) {
        return m.is(WordKind::room) || (m.is(WordKind::filler) && m.word->meaning == "room");
    };
    for (std::size_t k = i + 1; k < r.m.size(); ++k) {
        if (is_room(r.m[k])) return true;
        if (!modifies(r.m[k]) && !r.m[k].is(WordKind::mood) && !r.m[k].is(WordKind::light)) break;
    }
    return adjectives_follow(r.language) && i > 0 && is_room(r.m[i - 1]);
}

void read_nuance(Reading& r, std::size_t i) {
    const std::string& what = r.m[i].word->meaning;
    constexpr std::string_view kView = "view=";
    const std::string& adds = r.m[i].word->adds;
    if (const std::string vault = added_by(*r.m[i].word, "vault"); !vault.empty() && shapes_room(r, i)) {
        PromptObject& object = r.add_object("vault", r.m[i].words);
        object.pattern = vault, object.forbidden = r.m[i].negated;
        r.m[i].object = object.id;
        r.tell(i, (object.forbidden ? "no " : "") + ("vault: " + vault), object.id);
    } else if (const std::string outline = added_by(*r.m[i].word, "outline"); !outline.empty() && shapes_room(r, i)) {
        if (r.m[i].negated) return r.tell(i, "not " + r.m[i].words);
        if (r.spec.outline.empty()) r.spec.outline = outline;
        if (r.spec.outline != outline) r.tell_near(i, "the room stays " + r.spec.outline);
        else if (r.m[i].word->exact) r.tell(i, "outline of the room: " + outline);
        else r.tell_near(i, "outline of the room: " + outline);
    } else if (what == "outside" && adds.starts_with(kView) && !r.m[i].negated) {
        const std::string view = added_by(*r.m[i].word, "view");
        // "Lisbon" is a city, more or less; "the sea" is the sea.
        if (r.spec.outlook.empty() || (r.m[i].word->exact && outlook_is_a_guess(r, i))) r.spec.outlook = view;
        if (r.spec.outlook == view && r.m[i].word->exact) r.tell(i, "outlook: " + view);
        else r.tell_near(i, "outlook: " + r.spec.outlook);
    } else if (what == "outside") {
        // "overlooking the garden", "facing a forest": the word itself only leads on to what is seen.
        std::size_t next = i + 1;
        while (next < r.m.size() && (modifies(r.m[next]) || r.m[next].is(WordKind::function)) &&
               !(r.m[next].is(WordKind::nuance) && r.m[next].word->meaning == what))
            ++next;
        const bool leads = next < r.m.size() && r.m[next].is(WordKind::nuance) && r.m[next].word->meaning == what &&
                           r.m[next].word->adds.starts_with(kView);
        if (leads) r.tell(i, "what the windows show");
        else r.tell_near(i, "what lies outside");
    } else if (what == "next room") {
        const std::string title = "a " + room_title(r.spec.next_room) + " behind a doorway";
        if (r.m[i].word->exact) r.tell(i, title);
        else r.tell_near(i, title);
    } else if (what == "house") r.tell(i, "the house around the room");
    else if (what == "structure")
        r.tell(i, room_type(r.spec.structure).sloped_ceiling ? "sloped ceiling of an attic"
                                                             : "high ceiling and large windows of a loft");
    else if (what == "round" || what == "arched") r.tell(i, "shape: " + what);
    else if (what == "bunk stairs") r.tell(i, "stairs up to the bunk, a drawer in each step");
    else if (what == "kind") r.tell(i, "the kind of " + r.m[std::min(noun_from(r, i + 1), r.m.size() - 1)].words);
    else if (r.m[i].words == "framed") r.tell(i, "pictures hang in frames");
    else if (r.m[i].words == "colored" && i > 0 && r.m[i - 1].is(WordKind::color)) r.tell(i, "of that color");
    else if (r.m[i].words == "turned" && i + 1 < r.m.size() &&
             (r.m[i + 1].is_function("into") || r.m[i + 1].words == "into"))
        r.tell(i, "what the room was before");
    else if (what == "windowless") r.tell(i, "without: window");
    else if (what == "asleep") r.tell(i, "lies there asleep");
    else if (what == "corner shape") r.tell(i, "shape: it reaches around a corner");
    else if (what == "on the wall") r.tell(i, "hangs on the wall");
    else if (what == "owner") r.tell_near(i, "whose it is: nothing in the room shows it");
    else r.tell_near(i, "nothing in the room shows it");
}

// "a simple chair", "empty bottles": of the piece, not of the room.
bool stands_before_piece(const Reading& r, std::size_t i) {
    for (std::size_t k = i + 1; k < r.m.size(); ++k) {
        if (r.m[k].is(WordKind::object)) return true;
        if (!modifies(r.m[k]) && !r.m[k].is(WordKind::mood)) return false;
    }
    return false;
}

// "purple neon lights", "blue led strips"
bool colors_the_light(const Reading& r, std::size_t i) {
    std::size_t k = i + 1;
    while (k < r.m.size() && (modifies(r.m[k]) || r.m[k].is_function("and"))) ++k;
    return k < r.m.size() && r.m[k].is(WordKind::light) && r.m[k].word->meaning == "neon" && !r.m[k].negated;
}

// "a rotunda", "a turret room": the word for the room says its shape.
void take_shape(Reading& r, std::size_t i) {
    const Word word = *r.m[i].word;
    if (r.m[i].negated || r.spec.room != word.meaning) return;
    if (const std::string outline = added_by(word, "outline"); r.spec.outline.empty()) r.spec.outline = outline;
    const bool vaulted = std::any_of(r.spec.objects.begin(), r.spec.objects.end(),
                                     [](const PromptObject& o) { return o.kind == "vault"; });
    if (const std::string vault = added_by(word, "vault"); !vault.empty() && !vaulted)
        r.add_object("vault", r.m[i].words).pattern = vault;
}

void read_one(Reading& r, std::size_t i) {
    Match& m = r.m[i];
    switch (m.word->kind) {
        case WordKind::room:
            // A second room of another kind is not made; the studio and the loft have room for both.
            if (r.spec.room != m.word->meaning && is_same_room(r.spec.room, m.word->meaning) && !m.negated)
                r.tell(i, "room: " + room_title(r.spec.room));
            else choose(r, i, &PromptSpec::room, "room", room_title(m.word->meaning));
            take_shape(r, i);
            break;
        case WordKind::style: read_style(r, i); break;
        case WordKind::time: choose(r, i, &PromptSpec::time, "time", m.word->meaning); break;
        case WordKind::weather: choose(r, i, &PromptSpec::weather, "weather", m.word->meaning); break;
        case WordKind::light: choose(r, i, &PromptSpec::light, "light", m.word->meaning); break;
        case WordKind::mood: {
            const bool clutter = is_one_of(m.word->meaning, {"cluttered", "bare", "empty", "minimal"}) ||
                                 is_state(m.word->meaning);
            if (m.word->meaning == "messy" && stands_before_piece(r, i))
                m.word->meaning = "cluttered";  // "a messy desk" is no mess on the floor
            if (clutter && m.word->meaning != "cluttered" && stands_before_piece(r, i))
                return r.tell_near(i, "of a piece: as such pieces are");
            choose(r, i, clutter ? &PromptSpec::clutter : &PromptSpec::mood, "mood", m.word->meaning);
            break;
        }
        case WordKind::color:
            if (m.negated) {
                r.tell(i, "no " + m.word->meaning);

            } else if (colors_the_light(r, i)) {
                r.spec.light_color = m.word->meaning;
                r.tell(i, "color of the light: " + m.word->meaning);
            } else {
                r.spec.colors.push_back(m.word->meaning);
                r.tell(i, (beside_room(r, i) ? "color of the room: " : "accent color: ") + m.word->meaning);
            }
            break;
        case WordKind::material: read_surface(r, i); break;  // those that are no surface
        case WordKind::pattern:
            if (m.word->meaning == "herringbone" && !m.negated) {  // "a study in oak and herringbone"
                PromptObject& floor = r.add_object("floor", m.words);
                floor.pattern = m.word->meaning;
                r.tell(i, "pattern herringbone of the floor", floor.id);
            } else r.tell_near(i, "pattern: belongs to no piece that was named");
            break;
        case WordKind::size:
            if (m.negated) r.tell(i, "not " + m.word->meaning);
            else if (r.spec.size.empty())
                r.spec.size = m.words == "narrow"          ? "narrow"
                              : m.word->meaning == "small" ? "small"
                                                           : "large",
                r.tell(i, "size of the room: " + r.spec.size);
            else r.tell_near(i, "the room stays " + r.spec.size);
            break;
        case WordKind::count:
            if ((m.word->meaning != "1" || m.word->adds == "seats") && !m.listed)
                r.tell_near(i, "counts nothing that can be placed");
            break;
        case WordKind::negation: r.tell(i, "without what follows"); break;
        case WordKind::detail:
            if (!m.listed) r.tell_near(i, "part of a piece: as the piece has it");
            break;
        case WordKind::nuance: read_nuance(r, i); break;
        case WordKind::filler:
            r.tell(i, m.word->meaning == "picture"   ? "speaks of the picture, not of the room"
                      : m.word->meaning == "address" ? "addressed to the program"
                                                     : "the room as such");
            break;
        case WordKind::bound: r.tell_near(i, "how much: nothing in the room shows it"); break;
        case WordKind::unit: r.tell_near(i, "part of a piece: as the piece has it"); break;
        case WordKind::scope:
        case WordKind::other:
        case WordKind::object:
        case WordKind::structure:
        case WordKind::relation: break;  // told elsewhere
        case WordKind::function:
            if (!m.note.empty()) r.tell(i, "");
            break;
    }
}

}  // namespace

void read_globals(Reading& r) {
    // Surfaces first: they take colors that would be the room's.
    for (std::size_t i = 0; i < r.m.size(); ++i)
        if (r.m[i].is(WordKind::material) && r.m[i].noun < 0 && !r.m[i].settled) read_surface(r, i);
    for (std::size_t i = 0; i < r.m.size(); ++i) {
        Match& m = r.m[i];
        if (m.comma || m.settled) continue;
        if (!m.word) {
            m.listed = true;
            m.fate = PromptWord::Fate::not_understood;
        } else if (m.noun < 0 || m.is(WordKind::nuance)) {
            read_one(r, i);
        } else if (!m.listed && m.is(WordKind::count) && m.word->meaning != "1") {
            r.tell_near(i, "of something that is not counted");
        }
    }
    // "City lights" are seen by night, when no hour is said.
    for (const Match& m : r.m) {
        const std::string time = m.is(WordKind::nuance) && m.word->meaning == "outside" && !m.negated
                                     ? added_by(*m.word, "time")
                                     : "";
        if (time.empty() || !r.spec.time.empty()) continue;
        r.spec.time = time;
        r.spec.assumed.push_back("time: " + time + ", as " + m.words + " suggests");
    }
    // Whose room it is says how it looks: "grandma's kitchen", "a bachelor's flat".
    for (const Match& m : r.m) {
        const auto word = m.is(WordKind::nuance) && m.word->meaning == "owner" && !m.negated && r.spec.style.empty()
                              ? look_up(m.words)
                              : std::nullopt;
        const std::string style = word ? added_by(*word, "style") : "";
        if (style.empty()) continue;
        r.spec.style = style;
        r.spec.assumed.push_back("style: " + r.spec.style + ", as " + m.words + " suggests");
    }
    // So does what the room is for: "a speakeasy", "a smithy".
    for (const Match& m : r.m) {
        const std::string style = m.is(WordKind::room) && !m.negated ? added_by(*m.word, "style") : "";
        if (style.empty() || !r.spec.style.empty()) continue;
        r.spec.style = style;
        r.spec.assumed.push_back("style: " + style + ", as " + m.words + " suggests");
    }
    // A style that only a piece has is a good guess for its room.
    for (const PromptObject& o : r.spec.objects)
        if (r.spec.style.empty() && !o.style.empty() && !o.forbidden) {
            r.spec.style = o.style;
            r.spec.assumed.push_back("style: " + o.style + ", as the " + o.words);
        }
}

}  // namespace fastscene::reading
