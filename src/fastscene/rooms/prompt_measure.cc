// Sizes in metres, feet and the like: "a 4 by 5 metre bedroom", "3 m high ceiling", "a two metre wide bed".
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "fastscene/rooms/prompt_parts.h"
#include "fastscene/base/leading_number.h"
#include "fastscene/rooms/catalogue.h"

namespace fastscene::reading {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "1.80", "5", and small numbers in words: "two".
std::optional<float> number_of(const std::string& token, Language language) {
    if (is_digit(token[0])) {
        float value = 0;
        const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
        if (error == std::errc() && end == token.data() + token.size()) return value;
        return {};
    }
    const auto word = look_up(token, language);
    if (!word || word->kind != WordKind::count || token == "some" || token == "few") return {};
    return static_cast<float>(number_in(word->meaning).value_or(0));
}

bool is_times(const std::string& token) {
    static constexpr std::array<std::string_view, 6> kTimes{"by", "x", "mal", "por", "per", "times"};
    return std::find(kTimes.begin(), kTimes.end(), token) != kTimes.end();
}

struct Unit {
    float metres;
    bool area;
    std::size_t tokens;
};
std::optional<Unit> unit_at(const std::vector<std::string>& tokens, std::size_t at, Language language) {
    constexpr std::size_t kLongestUnit = 2;  // "square metres"
    for (std::size_t n = std::min(kLongestUnit, tokens.size() - std::min(at, tokens.size())); n > 0; --n) {
        const std::string term = n == 2 ? tokens[at] + " " + tokens[at + 1] : tokens[at];
        if (const auto word = look_up(term, language); word && word->kind == WordKind::unit)
            return Unit{static_cast<float>(number_in(word->meaning).value_or(0)), word->adds == "area", n};
    }
    return {};
}

// Width, height, depth by the word that says so ("wide", "3 m high").
enum class Extent : unsigned char { any, width, height, length, depth };
Extent extent_of(const Match& m) {
    static constexpr std::array<std::pair<std::string_view, Extent>, 4> kExtents{{{"extent=width", Extent::width},
                                                                                  {"extent=height", Extent::height},
                                                                                  {"extent=length", Extent::length},
                                                                                  {"extent=depth", Extent::depth}}};
    for (const auto& [adds, extent] : kExtents)
        if (m.word && m.word->adds == adds) return extent;
    return Extent::any;
}

bool takes_measure(const Match& m) {
    return (has_object(m) && (m.is(WordKind::object) || m.is(WordKind::structure))) || m.is(WordKind::room) ||
           (m.is(WordKind::filler) && m.word->meaning == "room");
}

// "a two metre wide bed": the noun behind, with nothing but adjectives between.
std::optional<std::size_t> owner_behind(const Reading& r, std::size_t at) {
    for (std::size_t k = at + 1; k < r.m.size(); ++k) {
        if (takes_measure(r.m[k])) return k;
        if (!modifies(r.m[k]) || r.m[k].is(WordKind::count) || !r.m[k].word) return {};
    }
    return {};
}
// "a bed two metres wide", "very high ceilings (4 metres)", "a bedroom measuring 4 by 5 m": the noun before.
std::optional<std::size_t> owner_before(const Reading& r, std::size_t at) {
    for (std::size_t k = at; k-- > 0;) {
        if (takes_measure(r.m[k])) return k;
        const bool goes_on = r.m[k].is(WordKind::function) || r.m[k].comma || modifies(r.m[k]) ||
                             r.m[k].is(WordKind::detail) || !r.m[k].metres.empty();
        if (!goes_on) return {};
    }
    return {};
}

Extent extent_near(Reading& r, std::size_t at) {
    for (const std::size_t k : {at + 1, at + 2, at - 1, at - 2}) {
        if (k >= r.m.size() || r.m[k].settled) continue;
        if (k == at + 2 && !r.m[at + 1].is(WordKind::function)) continue;  // "4 m in height"
        if (k == at - 2 && !r.m[at - 1].is_function("of")) continue;       // "a height of 4 m"
        const Extent extent = extent_of(r.m[k]);
        if (extent == Extent::any) continue;
        r.m[k].settled = true;
        return extent;
    }
    return Extent::any;
}

bool stands_tall(std::string_view kind) { return has_role(kind, Role::tall); }

std::string in_metres(float value) {
    std::string text = std::to_string(std::round(value * 100) / 100);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text + " m";
}

// The sizes of a piece; of a bed the longer side is its depth, of all others its width.
Vec3f piece_size(const PromptObject& object, const std::vector<float>& metres, Extent extent) {
    if (metres.size() == 1) {
        const float v = metres[0];
        if (extent == Extent::height || (extent == Extent::any && stands_tall(object.kind))) return {0, v, 0};
        const bool bed = object.kind.starts_with("bed");
        if (extent == Extent::depth || (extent == Extent::length && bed)) return {0, 0, v};
        if ((object.kind == "tv" || object.kind == "monitor") && extent == Extent::any)
            return {v * 0.87f, 0, 0};  // a screen's diagonal, 16:9
        return {v, 0, 0};
    }
    const auto [low, high] = std::minmax(metres[0], metres[1]);
    const float height = metres.size() > 2 ? metres[2] : 0.f;
    return object.kind.starts_with("bed") ? Vec3f{low, height, high} : Vec3f{high, height, low};
}

void give_room(Reading& r, std::size_t at, Extent extent) {
    Vec3f& size = r.spec.size_m;
    const std::vector<float>& metres = r.m[at].metres;
    std::string said;
    if (r.m[at].area) {
        r.spec.area_m2 = metres[0];
        said = in_metres(metres[0]) + "²";
    } else if (metres.size() == 1) {
        (extent == Extent::height ? size.y : extent == Extent::width ? size.x : size.z) = metres[0];
        said = in_metres(metres[0]) + (extent == Extent::height  ? " high"
                                       : extent == Extent::width ? " wide"
                                                                 : " long");
    } else {
        size = {metres[0], metres.size() > 2 ? metres[2] : size.y, metres[1]};
        said = in_metres(size.x) + " by " + in_metres(size.z) +
               (metres.size() > 2 ? ", " + in_metres(size.y) + " high" : "");
    }
    r.tell(at, "size of the room: " + said);
}

void give_piece(Reading& r, std::size_t at, std::size_t noun, Extent extent) {
    PromptObject& object = r.object_of(noun);
    const Vec3f size = piece_size(object, r.m[at].metres, extent);
    for (std::size_t a = 0; a < 3; ++a)
        if (size[a] > 0) object.size_m[a] = size[a];
    std::string said;
    for (const auto& [name, value] : {std::pair{" wide", size.x}, {" high", size.y}, {" deep", size.z}})
        if (value > 0) said += (said.empty() ? "" : ", ") + in_metres(value) + name;
    r.tell(at, "size of " + object.kind + ": " + said, object.id);
}

void bind_measure(Reading& r, std::size_t at) {
    const Extent extent = extent_near(r, at);
    auto owner = owner_behind(r, at);
    if (!owner) owner = owner_before(r, at);
    r.m[at].settled = true;
    r.m[at].measure = true;
    if (at + 1 < r.m.size() && r.m[at + 1].is(WordKind::relation))
        return r.tell_near(at, "how far: as far as such pieces stand apart");
    const bool ceiling = owner && has_object(r.m[*owner]) && r.object_of(*owner).kind == "ceiling";
    if (ceiling && r.m[at].metres.size() == 1) return give_room(r, at, Extent::height);
    if (r.m[at].area || !owner || !has_object(r.m[*owner])) {
        if (!owner && !r.m[at].area && r.m[at].metres.size() == 1)
            return r.tell_near(at, "the size of nothing that was named");
        return give_room(r, at, extent);
    }
    if (r.m[*owner].is(WordKind::structure))
        return r.tell_near(at, "the " + r.m[*owner].words + ": as large as the room has it", r.m[*owner].object);
    give_piece(r, at, *owner, extent);
}

}  // namespace

std::vector<std::string> with_numbers_apart(const std::vector<std::string>& tokens) {
    std::vector<std::string> out;
    for (const std::string& token : tokens) {
        // "20m2": all behind the digits may be one unit.
        const std::size_t digits = std::min(token.find_first_not_of("0123456789."), token.size());
        if (const auto unit = digits > 0 && digits < token.size() ? look_up(token.substr(digits)) : std::nullopt;
            unit && unit->kind == WordKind::unit) {
            out.insert(out.end(), {token.substr(0, digits), token.substr(digits)});
            continue;
        }
        std::vector<std::string> parts;
        for (const char c : token) {
            const bool number = is_digit(c) || c == '.';
            if (parts.empty() || number != (is_digit(parts.back().back()) || parts.back().back() == '.'))
                parts.emplace_back();
            parts.back() += c;
        }
        const bool apart = parts.size() > 1 && is_digit(token[0]) && !look_up(token) &&
                           std::all_of(parts.begin(), parts.end(), [](const std::string& part) {
                               const auto word = is_digit(part[0]) ? std::nullopt : look_up(part);
                               return is_digit(part[0]) || part == "x" || (word && word->kind == WordKind::unit);
                           });
        // "2x armchair": two of them.
        if (apart && parts.size() == 2 && parts[1] == "x") parts.pop_back();
        if (apart) out.insert(out.end(), parts.begin(), parts.end());
        else out.push_back(token);
    }
    return out;
}

namespace {

// "a table with four feet", "a foot stool": of pieces, not of rulers.
bool speaks_of_parts(const std::vector<std::string>& tokens, std::size_t begin, std::size_t end) {
    const auto says_which_way = [&] {
        const auto word = end < tokens.size() ? look_up(tokens[end]) : std::nullopt;
        return word && word->adds.starts_with("extent=");
    };
    if (tokens[begin] == "a" || tokens[begin] == "an") return !says_which_way();
    const bool feet = tokens[end - 1] == "feet" || tokens[end - 1] == "foot";
    const bool phrase_ends = end == tokens.size() || tokens[end] == "," || tokens[end] == "and";
    return feet && begin > 0 && (tokens[begin - 1] == "with" || tokens[begin - 1] == "on") && phrase_ends;
}

}  // namespace

std::optional<std::pair<Match, std::size_t>> measure_at(const std::vector<std::string>& tokens, std::size_t begin,
                                                        Language language) {
    struct Length {
        float value;
        std::optional<Unit> unit;
    };
    std::vector<Length> lengths;
    std::size_t at = begin;
    while (at < tokens.size() && lengths.size() < 3) {
        auto number = number_of(tokens[at], language);
        if (!number) break;
        std::size_t next = at + 1;
        if (next + 2 < tokens.size() && tokens[next] == "and" && tokens[next + 1] == "a" && tokens[next + 2] == "half")
            *number += 0.5f, next += 3;
        const auto unit = next < tokens.size() ? unit_at(tokens, next, language) : std::nullopt;
        lengths.push_back({*number, unit});
        at = next + (unit ? unit->tokens : 0);
        if (!(at + 1 < tokens.size() && is_times(tokens[at]) && number_of(tokens[at + 1], language))) break;
        ++at;
    }
    if (lengths.empty()) return {};
    const std::optional<Unit> last = lengths.back().unit;
    const bool digits = is_digit(tokens[begin][0]);
    if (!last && (lengths.size() < 2 || !digits)) return {};
    if (last && speaks_of_parts(tokens, begin, at)) return {};
    Match m;
    for (const Length& length : lengths) {
        constexpr float kCentimetresFrom = 60;  // "180x200" are no metres
        const float unit = length.unit                        ? length.unit->metres
                           : last                             ? last->metres
                           : length.value >= kCentimetresFrom ? 0.01f
                                                              : 1.f;
        m.metres.push_back(length.value * unit);
    }
    m.area = last && last->area;
    for (std::size_t k = begin; k < at; ++k) m.words += (k > begin ? " " : "") + tokens[k];
    m.word = Word{WordKind::unit, "1"};
    return std::pair{std::move(m), at - begin};
}

void bind_measures(Reading& r) {
    for (std::size_t i = 0; i < r.m.size(); ++i)
        if (!r.m[i].metres.empty()) bind_measure(r, i);
    // "4 metres wide": the word belongs to the measure.
    for (std::size_t i = 0; i < r.m.size(); ++i)
        if (r.m[i].settled && !r.m[i].listed) r.tell(i, "which way it is measured");
}

}  // namespace fastscene::reading
