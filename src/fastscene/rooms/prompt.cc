#include <algorithm>
#include <cctype>

#include "fastscene/base/error.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/rooms.h"

namespace fastscene {
namespace {

constexpr std::size_t kMaxBytes = 2000;
// How far an adjective reaches for its noun ("brown, soft leather sofa").
constexpr std::size_t kReach = 3;

// The byte where the text stops being UTF-8, or npos.
std::size_t first_bad_byte(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto c = static_cast<unsigned char>(text[i]);
        const std::size_t length = c < 0x80 ? 1 : c >= 0xc2 && c < 0xe0 ? 2 : c >= 0xe0 && c < 0xf0 ? 3 : c >= 0xf0 && c < 0xf5 ? 4 : 0;
        if (length == 0 || i + length > text.size()) return i;
        // Overlong forms, surrogates and what lies beyond U+10FFFF are no UTF-8 either (RFC 3629).
        const unsigned char second = length > 1 ? static_cast<unsigned char>(text[i + 1]) : 0x80;
        if ((c == 0xe0 && second < 0xa0) || (c == 0xed && second > 0x9f) || (c == 0xf0 && second < 0x90) || (c == 0xf4 && second > 0x8f)) return i;
        for (std::size_t k = 1; k < length; ++k)
            if ((static_cast<unsigned char>(text[i + k]) & 0xc0) != 0x80) return i;
        i += length;
    }
    return std::string_view::npos;
}

void check_prompt(const std::string& text) {
    if (std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c) || c == 0; }))
        throw UsageError("prompt: expected a sentence such as \"a cozy bedroom with a red armchair\", found nothing");
    if (text.size() > kMaxBytes) throw UsageError("prompt: expected at most {} bytes, found {}", kMaxBytes, text.size());
    if (const std::size_t at = first_bad_byte(text); at != std::string_view::npos)
        throw UsageError("prompt: expected UTF-8 text, found another encoding at byte {}", at);
}

// Lower-case words; a comma (or another mark) between phrases is a token of its own.
std::vector<std::string> tokens_of(const std::string& text) {
    std::vector<std::string> tokens;
    std::string word;
    const auto flush = [&] {
        if (!word.empty()) tokens.push_back(word);
        word.clear();
    };
    for (const char ch : text) {
        const auto c = static_cast<unsigned char>(ch);
        if (std::isalnum(c) || c >= 0x80) {
            word += static_cast<char>(c < 0x80 ? std::tolower(c) : c);
        } else if (ch != '\'') {  // kid's = kids
            flush();
            if (std::ispunct(c) && ch != '-' && ch != '_') tokens.push_back(",");
        }
    }
    flush();
    return tokens;
}

// A matched piece of the prompt.
struct Match {
    std::string words;
    std::optional<Word> word;  // nothing: not understood
    bool comma = false;
};

std::string joined(const std::vector<std::string>& tokens, std::size_t begin, std::size_t count) {
    std::string out;
    for (std::size_t i = begin; i < begin + count; ++i) out += (i > begin ? " " : "") + tokens[i];
    return out;
}

// Longest match first, up to four words; then a typo of one letter.
std::vector<Match> match(const std::vector<std::string>& tokens, PromptSpec& spec) {
    std::vector<Match> matches;
    for (std::size_t i = 0; i < tokens.size();) {
        if (tokens[i] == ",") {
            matches.push_back({",", {}, true});
            ++i;
            continue;
        }
        bool found = false;
        for (std::size_t n = std::min<std::size_t>(4, tokens.size() - i); n > 0 && !found; --n) {
            const std::string term = joined(tokens, i, n);
            if (const auto word = look_up(term)) {
                matches.push_back({term, word});
                i += n;
                found = true;
            }
        }
        if (found) continue;
        if (const auto term = nearest_term(tokens[i])) {
            spec.approximated.push_back("read \"" + tokens[i] + "\" as \"" + *term + "\"");
            matches.push_back({tokens[i], look_up(*term)});
        } else {
            matches.push_back({tokens[i], {}});
        }
        ++i;
    }
    return matches;
}

bool is_adjective(WordKind kind) { return kind == WordKind::color || kind == WordKind::material || kind == WordKind::size || kind == WordKind::pattern; }
bool takes_adjectives(WordKind kind) { return kind == WordKind::object || kind == WordKind::structure; }

// The noun that the adjective at `at` belongs to: the next one within reach, in the same phrase.
std::optional<std::size_t> noun_after(const std::vector<Match>& matches, std::size_t at) {
    std::size_t steps = 0;
    for (std::size_t i = at + 1; i < matches.size() && steps <= kReach; ++i, ++steps) {
        if (matches[i].comma) {
            // "a red, soft sofa": a comma between adjectives does not end the phrase.
            // A word that we do not know may be one too, when an adjective stands behind it ("black, silky leather sofa").
            std::size_t next = i + 1;
            if (next + 1 < matches.size() && !matches[next].comma && (!matches[next].word || matches[next].word->kind == WordKind::stop)) ++next;
            if (next >= matches.size() || !matches[next].word || !is_adjective(matches[next].word->kind)) return {};
            continue;
        }
        if (!matches[i].word) continue;
        const WordKind kind = matches[i].word->kind;
        if (takes_adjectives(kind)) return i;
        if (kind == WordKind::room || kind == WordKind::negation || kind == WordKind::relation || (kind == WordKind::count && i > at + 1)) return {};
        if (kind == WordKind::stop && matches[i].words != "and" && matches[i].words != "wall mounted" && matches[i].words != "old" && matches[i].words != "new" && matches[i].words != "soft" && matches[i].words != "fluffy" &&
            matches[i].words != "colored" && matches[i].words != "coloured")
            return {};
    }
    return {};
}

// "Dark" and "bright" before a noun, with nothing but its adjectives between, speak of the noun: what color they mean.
// Elsewhere they speak of the room's light.
std::optional<std::string> shade_of_noun(const std::vector<Match>& matches, std::size_t at, std::size_t noun) {
    const std::string& word = matches[at].words;
    if (word != "dark" && word != "bright" && word != "dim") return {};
    bool brown = false;
    for (std::size_t i = at + 1; i < noun; ++i) {
        if (!matches[i].word || !is_adjective(matches[i].word->kind) || matches[i].word->kind == WordKind::color) return {};
        const std::string& meaning = matches[i].word->meaning;
        brown = brown || meaning == "wood" || meaning == "oak" || meaning == "walnut" || meaning == "pine" || meaning == "leather" || meaning == "planks" || meaning == "parquet" || meaning == "rattan";
    }
    if (word == "bright") return brown ? "light brown" : "white";
    return brown ? "dark brown" : "charcoal";
}

// "A table" is the table one expects in that room.
void name_tables(std::vector<Match>& matches) {
    std::string room, meaning;
    for (const Match& m : matches)
        if (m.word && m.word->kind == WordKind::room && room.empty()) room = m.word->meaning;
    if (room == "dining" || room == "kitchen") meaning = "dining_table";
    if (room == "living" || room == "sunroom" || room == "loft") meaning = "coffee_table";
    for (Match& m : matches)
        if (!meaning.empty() && m.word && (m.words == "table" || m.words == "tables")) m.word = Word{WordKind::object, meaning, true};
}

std::string described(const PromptObject& object) {
    std::string text = object.klass;
    for (const auto& [name, value] : {std::pair{"color", &object.color}, {"material", &object.material}, {"pattern", &object.pattern}, {"size", &object.size}})
        if (!value->empty()) text += std::string(", ") + name + " " + *value;
    if (object.count > 1) text += ", " + std::to_string(object.count) + " of them";
    if (!object.relation.empty()) text += ", " + object.relation + (object.relation_to.empty() ? "" : " the " + object.relation_to);
    return text;
}

}  // namespace

PromptSpec understand_prompt(const std::string& text, bool strict) {
    check_prompt(text);
    PromptSpec spec;
    spec.text = text;
    std::vector<Match> matches = match(tokens_of(text), spec);
    name_tables(matches);

    // Nouns first, so that the adjectives find them.
    std::vector<int> object_at(matches.size(), -1);
    bool negated = false;
    for (std::size_t i = 0; i < matches.size(); ++i) {
        if (!matches[i].word) {
            if (matches[i].comma) negated = false;
            continue;
        }
        const Word& word = *matches[i].word;
        if (word.kind == WordKind::negation) negated = true;
        if (word.kind == WordKind::stop && (matches[i].words == "with" || matches[i].words == "but")) negated = false;
        if (!takes_adjectives(word.kind)) continue;
        // "the desk" is the desk that the prompt speaks of elsewhere, not a second one.
        const bool definite = i > 0 && matches[i - 1].words == "the";
        for (std::size_t k = 0; k < i && word.kind == WordKind::object; ++k)
            if (object_at[k] >= 0 && spec.objects[static_cast<std::size_t>(object_at[k])].klass == word.meaning && (definite || (k > 0 && matches[k - 1].words == "the")) && !negated)
                object_at[i] = object_at[k];
        if (object_at[i] >= 0) continue;
        object_at[i] = static_cast<int>(spec.objects.size());
        PromptObject object;
        object.klass = word.meaning;
        object.words = matches[i].words;
        object.forbidden = negated;
        // A bare plural means more than one ("plants", "chairs").
        if ((word.kind == WordKind::object || word.meaning == "window" || word.meaning == "door") && matches[i].words.ends_with("s") && !word.meaning.ends_with("s") && word.meaning != "kitchen_counter" &&
            word.meaning != "curtain" && word.meaning != "towel_rail" && word.meaning != "toy_box" && !matches[i].words.ends_with("drawers") && !matches[i].words.ends_with("shelves"))
            object.count = 2;
        spec.objects.push_back(object);
    }
    std::vector<std::pair<std::size_t, Understood>> understood;
    const auto remember = [&](std::size_t i, std::string meaning) { understood.push_back({i, {matches[i].words, std::move(meaning)}}); };

    for (std::size_t i = 0; i < matches.size(); ++i) {
        if (matches[i].comma) continue;
        if (!matches[i].word) {
            spec.not_understood.push_back(matches[i].words);
            continue;
        }
        const Word& word = *matches[i].word;
        if (!word.exact && word.kind != WordKind::stop) spec.approximated.push_back(matches[i].words + " -> " + word.meaning);
        const std::optional<std::size_t> noun = noun_after(matches, i);
        PromptObject* object = noun ? &spec.objects[static_cast<std::size_t>(object_at[*noun])] : nullptr;
        const auto bind = [&](std::string PromptObject::* field, const char* name) {
            if (!object) return false;
            (object->*field) = (object->*field).empty() ? word.meaning : object->*field;
            remember(i, std::string(name) + " " + word.meaning + " of " + object->klass);
            return true;
        };
        switch (word.kind) {
            case WordKind::room:
                if (spec.room.empty()) spec.room = word.meaning;
                remember(i, "room: " + room_title(word.meaning));
                break;
            case WordKind::style:
                if (spec.style.empty()) spec.style = word.meaning;
                remember(i, "style: " + word.meaning);
                break;
            case WordKind::time: spec.time = word.meaning, remember(i, "time: " + word.meaning); break;
            case WordKind::weather: spec.weather = word.meaning, remember(i, "weather: " + word.meaning); break;
            case WordKind::light:
                if (const auto shade = noun ? shade_of_noun(matches, i, *noun) : std::nullopt) {
                    if (object->color.empty()) object->color = *shade;
                    remember(i, "color " + object->color + " of " + object->klass);
                } else {
                    if (spec.mood.empty() || word.meaning != "bright") spec.mood = word.meaning;
                    remember(i, "light: " + word.meaning);
                }
                break;
            case WordKind::mood: spec.mood = word.meaning, remember(i, "mood: " + word.meaning); break;
            case WordKind::color:
                if (!bind(&PromptObject::color, "color")) spec.colors.push_back(word.meaning), remember(i, "accent color: " + word.meaning);
                break;
            case WordKind::material:
                // A material without a noun after it may stand for the floor ("carpet", "parquet") or the walls ("brick").
                if (!bind(&PromptObject::material, "material")) {
                    PromptObject surface;
                    surface.klass = word.meaning == "carpet" || word.meaning == "parquet" || word.meaning == "planks" ? "floor" : "wall";
                    const bool whole = word.meaning == "carpet" || word.meaning == "parquet" || word.meaning == "planks" || word.meaning == "brick" || word.meaning == "tile";
                    surface.material = word.meaning;
                    surface.words = matches[i].words;
                    if (whole) {
                        if (i > 0 && matches[i - 1].word && matches[i - 1].word->kind == WordKind::color) surface.color = matches[i - 1].word->meaning;
                        spec.objects.push_back(surface);
                        remember(i, "material " + word.meaning + " of the " + surface.klass);
                    } else {
                        remember(i, "accent material: " + word.meaning);
                    }
                }
                break;
            case WordKind::pattern:
                if (!bind(&PromptObject::pattern, "pattern")) remember(i, "pattern: " + word.meaning);
                break;
            case WordKind::size:
                if (word.meaning == "spacious" || !bind(&PromptObject::size, "size")) spec.size = word.meaning == "small" ? "small" : "large", remember(i, "size of the room: " + spec.size);
                break;
            case WordKind::count:
                if (object && noun && (matches[*noun].word->kind == WordKind::object || object->klass == "window" || object->klass == "door")) {
                    const int count = std::stoi(word.meaning);
                    if (count > 1) object->count = count, remember(i, "count " + word.meaning + " of " + object->klass);
                    else if (matches[i].words != "the") object->count = 1;
                }
                break;
            case WordKind::negation: remember(i, "without what follows"); break;
            case WordKind::relation: {
                // "X under the Y": X is the object before, Y the one after.
                int before = -1;
                for (std::size_t k = i; k-- > 0 && before < 0;) before = object_at[k];
                if (before < 0) break;
                PromptObject& subject = spec.objects[static_cast<std::size_t>(before)];
                std::optional<std::size_t> target;
                for (std::size_t k = i + 1; k < matches.size() && k <= i + 4 && !target && !matches[k].comma; ++k)
                    if (object_at[k] >= 0) target = k;
                if (word.meaning == "in the corner" || target) {
                    subject.relation = word.meaning;
                    if (target && word.meaning != "in the corner") subject.relation_to = matches[*target].word->meaning;
                    remember(i, subject.klass + " " + word.meaning + (subject.relation_to.empty() ? "" : " the " + subject.relation_to));
                }
                break;
            }
            case WordKind::object:
            case WordKind::structure: break;  // reported below, with all that was bound to it
            case WordKind::stop: break;
        }
    }
    for (std::size_t i = 0; i < matches.size(); ++i)
        if (object_at[i] >= 0 && std::find(object_at.begin(), object_at.begin() + static_cast<std::ptrdiff_t>(i), object_at[i]) == object_at.begin() + static_cast<std::ptrdiff_t>(i)) {
            const PromptObject& object = spec.objects[static_cast<std::size_t>(object_at[i])];
            remember(i, (object.forbidden ? "without: " : "object: ") + described(object));
        }
    std::stable_sort(understood.begin(), understood.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [at, what] : understood) spec.understood.push_back(std::move(what));

    if (strict && !spec.not_understood.empty())
        throw UsageError("--strict: expected only words that are understood, found {}", fmt::join(spec.not_understood, ", "));
    if (strict && spec.understood.empty()) throw UsageError("--strict: expected a prompt about a room, found \"{}\"", text);
    return spec;
}

Json to_json(const PromptSpec& spec) {
    Json objects = Json::array();
    for (const PromptObject& o : spec.objects)
        objects.push_back({{"class", o.klass}, {"words", o.words}, {"count", o.count}, {"color", o.color}, {"material", o.material}, {"pattern", o.pattern},
                           {"size", o.size}, {"relation", o.relation}, {"relation_to", o.relation_to}, {"forbidden", o.forbidden}});
    Json understood = Json::array();
    for (const Understood& u : spec.understood) understood.push_back({{"words", u.words}, {"meaning", u.meaning}});
    return {{"text", spec.text}, {"room", spec.room}, {"style", spec.style}, {"time", spec.time}, {"weather", spec.weather}, {"mood", spec.mood},
            {"size", spec.size}, {"colors", spec.colors}, {"objects", objects}, {"understood", understood}, {"assumed", spec.assumed},
            {"approximated", spec.approximated}, {"not_placed", spec.not_placed}, {"not_understood", spec.not_understood}};
}

}  // namespace fastscene
