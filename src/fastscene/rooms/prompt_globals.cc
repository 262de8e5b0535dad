// What a prompt says of the room as a whole: type, style, hour, weather, light, mood, and adjectives that no noun took.
#include <algorithm>
#include <array>

#include "fastscene/rooms/prompt_parts.h"

namespace fastscene::reading {
namespace {

// The first to speak is heard; who contradicts is reported.
void choose(Reading& r, std::size_t i, std::string PromptSpec::* field, const char* name, const std::string& title) {
    Match& m = r.m[i];
    if (m.negated) return r.tell(i, "not " + title);
    std::string& value = r.spec.*field;
    if (value.empty()) value = m.word->meaning;
    if (value != m.word->meaning) return r.tell_near(i, std::string(name) + ": contradicts " + value + ", which came first");
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

// A material that belongs to no noun is a surface of the room: "a brick loft", "exposed brick", "marble bathroom".
void read_surface(Reading& r, std::size_t i) {
    const std::string& material = r.m[i].word->meaning;
    static constexpr std::array<std::string_view, 5> kFloors{"carpet", "parquet", "planks", "marble", "terrazzo"};
    static constexpr std::array<std::string_view, 7> kWalls{"brick", "tile", "concrete", "stone", "plaster", "wood", "marble"};
    const bool floor = std::find(kFloors.begin(), kFloors.end(), material) != kFloors.end();
    const bool wall = std::find(kWalls.begin(), kWalls.end(), material) != kWalls.end();
    if (r.m[i].negated) return r.tell(i, "no " + material);
    if (!floor && !wall) return r.tell_near(i, "accent material: shows in some of the furniture");
    PromptObject surface;
    surface.klass = floor ? "floor" : "wall";
    surface.material = material;
    surface.words = r.m[i].words;
    surface.id = static_cast<int>(r.spec.objects.size());
    if (i > 0 && r.m[i - 1].is(WordKind::color) && r.m[i - 1].noun < 0) {
        surface.color = r.m[i - 1].word->meaning;
        r.m[i - 1].noun = static_cast<int>(i);
        r.tell(i - 1, "color " + surface.color + " of the " + surface.klass, surface.id);
    } else if (r.m[i].word->adds.starts_with("color=")) {
        surface.color = r.m[i].word->adds.substr(6);
    }
    r.spec.objects.push_back(surface);
    r.m[i].object = surface.id;
    if (r.m[i].word->exact) r.tell(i, "material " + material + " of the " + surface.klass, surface.id);
    else r.tell_near(i, "material " + material + " of the " + surface.klass, surface.id);
}

void read_style(Reading& r, std::size_t i) {
    if (r.m[i].negated) return r.tell(i, "not " + r.m[i].word->meaning);
    choose(r, i, &PromptSpec::style, "style", r.m[i].word->meaning);
}

void read_nuance(Reading& r, std::size_t i) {
    const std::string& what = r.m[i].word->meaning;
    constexpr std::string_view kView = "view=";
    const std::string& adds = r.m[i].word->adds;
    if (what == "outside" && adds.starts_with(kView) && !r.m[i].negated) {
        const std::string view = adds.substr(kView.size());
        if (r.spec.outlook.empty()) r.spec.outlook = view;
        if (r.spec.outlook == view && r.m[i].word->exact) r.tell(i, "outlook: " + view);
        else r.tell_near(i, "outlook: " + r.spec.outlook);
    } else if (what == "outside") r.tell_near(i, "what lies outside");
    else if (what == "house") r.tell(i, "the house around the room");
    else if (what == "kind") r.tell(i, "the kind of " + r.m[i + 1].words);
    else if (what == "owner") r.tell_near(i, "whose it is: nothing in the room shows it");
    else r.tell_near(i, "nothing in the room shows it");
}

void read_one(Reading& r, std::size_t i) {
    Match& m = r.m[i];
    switch (m.word->kind) {
        case WordKind::room:
            // A second room of another kind is not made; the studio and the loft have room for both.
            choose(r, i, &PromptSpec::room, "room", room_title(m.word->meaning));
            break;
        case WordKind::style: read_style(r, i); break;
        case WordKind::time: choose(r, i, &PromptSpec::time, "time", m.word->meaning); break;
        case WordKind::weather: choose(r, i, &PromptSpec::weather, "weather", m.word->meaning); break;
        case WordKind::light: choose(r, i, &PromptSpec::light, "light", m.word->meaning); break;
        case WordKind::mood: {
            const bool clutter = m.word->meaning == "cluttered" || m.word->meaning == "bare";
            choose(r, i, clutter ? &PromptSpec::clutter : &PromptSpec::mood, "mood", m.word->meaning);
            break;
        }
        case WordKind::color:
            if (m.negated) {
                r.tell(i, "no " + m.word->meaning);
            } else {
                r.spec.colors.push_back(m.word->meaning);
                r.tell(i, (beside_room(r, i) ? "color of the room: " : "accent color: ") + m.word->meaning);
            }
            break;
        case WordKind::material: read_surface(r, i); break;
        case WordKind::pattern: r.tell_near(i, "pattern: belongs to no piece that was named"); break;
        case WordKind::size:
            if (m.negated) r.tell(i, "not " + m.word->meaning);
            else if (r.spec.size.empty()) r.spec.size = m.word->meaning == "small" ? "small" : "large", r.tell(i, "size of the room: " + r.spec.size);
            else r.tell_near(i, "the room stays " + r.spec.size);
            break;
        case WordKind::count:
            if (m.word->meaning != "1" && !m.listed) r.tell_near(i, "counts nothing that can be placed");
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
        case WordKind::object:
        case WordKind::structure:
        case WordKind::relation:
        case WordKind::function: break;  // nouns and relations are told elsewhere
    }
}

}  // namespace

void read_globals(Reading& r) {
    for (std::size_t i = 0; i < r.m.size(); ++i) {
        Match& m = r.m[i];
        if (m.comma) continue;
        if (!m.word) {
            m.listed = true;
            m.fate = PromptWord::Fate::not_understood;
        } else if (m.noun < 0 || m.is(WordKind::nuance)) {
            read_one(r, i);
        } else if (!m.listed && m.is(WordKind::count) && m.word->meaning != "1") {
            r.tell_near(i, "of something that is not counted");
        }
    }
    // A style that only a piece has is a good guess for its room.
    for (const PromptObject& o : r.spec.objects)
        if (r.spec.style.empty() && !o.style.empty() && !o.forbidden) {
            r.spec.style = o.style;
            r.spec.assumed.push_back("style: " + o.style + ", as the " + o.words);
        }
}

}  // namespace fastscene::reading
