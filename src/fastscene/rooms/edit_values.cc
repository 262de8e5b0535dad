// How words want things to be: colors, materials, patterns, sizes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/document_parts.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/materials.h"
#include "fastscene/rooms/prompt_parts.h"
#include "fastscene/rooms/prompt_text.h"

namespace fastscene {
namespace editing {
namespace {

constexpr float kMore = 1.25f;     // "larger": to be seen at once
constexpr float kALittle = 1.12f;  // "a bit larger"
constexpr float kMuch = 1.6f;      // "much larger"

// Which extents a word of size means, and which way.
struct SizeWord {
    std::string_view more, less, plain;  // "wider", "narrower", "wide"
    Vec3f axes;                          // 1: along this one; width, height, depth
};
constexpr std::array<SizeWord, 11> kSizeWords{{
    {"bigger", "smaller", "big", {1, 1, 1}},
    {"larger", "tinier", "large", {1, 1, 1}},
    {"huger", "littler", "small", {1, 1, 1}},
    {"wider", "narrower", "wide", {1, 0, 0}},
    {"broader", "slimmer", "broad", {1, 0, 0}},
    {"longer", "shorter", "long", {1, 0, 0}},
    {"taller", "lower", "tall", {0, 1, 0}},
    {"higher", "lower", "high", {0, 1, 0}},
    {"deeper", "shallower", "deep", {0, 0, 1}},
    {"thicker", "thinner", "thick", {0, 0, 1}},
    {"larger", "smaller", "size", {1, 1, 1}},
}};

Vec3f along(Vec3f axes, float factor) {
    Vec3f out{1, 1, 1};
    for (std::size_t a = 0; a < 3; ++a)
        if (axes[a] > 0) out[a] = factor;
    return out;
}

// "twice as large", "half the size", "two times bigger"; nothing: no such phrase.
std::optional<Vec3f> times(const Words& words) {
    float factor = 0;
    Vec3f axes{1, 1, 1};
    bool sized = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& w = words[i];
        if (is_one_of(w, {"twice", "double", "doubled"})) factor = 2;
        else if (w == "half") factor = 0.5f;
        else if (w == "triple") factor = 3;
        else if (const auto n = number_said(w); n && i + 1 < words.size() && words[i + 1] == "times") factor = *n, ++i;
        else if (!is_one_of(w, {"as", "the", "its", "by", "of"})) {
            const auto found = std::find_if(kSizeWords.begin(), kSizeWords.end(), [&](const SizeWord& s) {
                return w == s.plain || w == s.more || w == s.less;
            });
            if (found == kSizeWords.end()) return {};
            axes = found->axes, sized = true;
        }
    }
    if (!(factor > 0) || (!sized && words.size() > 1)) return {};
    return along(axes, factor);
}

// "much larger", "a bit wider", "20 percent smaller", "larger by 20 percent".
std::optional<Vec3f> compared(const Words& words, bool* length = nullptr) {
    const SizeWord* size = nullptr;
    bool more = true;
    float factor = kMore;
    bool share = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& w = words[i];
        if (const auto n = number_said(w); n && i + 1 < words.size() && words[i + 1] == "percent") {
            factor = 1 + *n / 100, ++i;
            continue;
        }
        // "by a third", "a quarter wider"
        if (is_one_of(w, {"third", "quarter", "half"})) {
            factor = w == "third" ? 4.f / 3 : w == "half" ? 1.5f : 1.25f, share = true;
            continue;
        }
        if (is_one_of(w, {"bit", "little", "slightly", "somewhat", "touch"})) {
            factor = kALittle;
            continue;
        }
        if (is_one_of(w, {"much", "lot", "way", "far", "considerably", "significantly"})) {
            factor = kMuch;
            continue;
        }
        if (is_one_of(w, {"a", "even", "by", "more", "of"})) continue;
        const auto found = std::find_if(kSizeWords.begin(), kSizeWords.end(),
                                        [&](const SizeWord& s) { return w == s.more || w == s.less; });
        if (size || found == kSizeWords.end()) return {};
        size = &*found, more = w == found->more;
    }
    if (!size) return {};
    if (length) *length = size->plain == "long";
    // 20 percent smaller is that much less.
    const bool percent = share || std::find(words.begin(), words.end(), "percent") != words.end();
    const float less = percent ? std::max(0.2f, 2 - factor) : 1 / factor;
    return along(size->axes, more ? factor : less);
}

std::optional<float> brighter(const Words& words, bool& shines) {
    constexpr float kLighter = 1.5f, kDarker = 0.6f;
    float out = 1;
    for (const std::string& w : words) {
        if (is_one_of(w, {"lighter", "brighter", "paler"})) out = kLighter;
        else if (is_one_of(w, {"darker", "dimmer"})) out = kDarker;
        else if (!is_one_of(w, {"a", "bit", "little", "much", "slightly", "lot"})) return {};
        shines = shines || is_one_of(w, {"brighter", "dimmer"});
    }
    return out == 1 ? std::nullopt : std::optional(out);
}

// "Black and white" are two colors.
bool parts_looks(const std::string& word) { return is_one_of(word, {"and", ","}); }

// "Cream linen", "linen navy"; "walnut brown" is one color.
bool is_color_and_material(const Words& words) {
    const auto last = material_named(plain_name(words.back())), first = material_named(plain_name(words.front()));
    if (last && color_named(text_of(words, 0, words.size() - 1))) return true;
    return first && first->pattern != Pattern::wood && color_named(text_of(words, 1));
}

// One look of up to so many words at `i`; how many it takes, 0: none.
std::size_t take_look(const Words& tokens, std::size_t i, PromptObject& out) {
    constexpr std::size_t kLongest = 3;  // words of a color: "dark olive green"
    for (std::size_t length = std::min(kLongest, tokens.size() - i); length > 0; --length) {
        if (std::any_of(tokens.begin() + static_cast<std::ptrdiff_t>(i),
                        tokens.begin() + static_cast<std::ptrdiff_t>(i + length), parts_looks))
            continue;
        const std::string term = text_of(tokens, i, i + length);
        if (is_one_of(term, {"sheer", "see through", "transparent", "translucent", "voile", "gauzy", "airy"})) {
            out.material = "voile";
            return length;
        }
        const auto word = look_up(term);
        if (length > 1 && !word && is_color_and_material(part_of(tokens, i, i + length))) continue;
        std::string* to = word && word->kind == WordKind::pattern                                     ? &out.pattern
                          : word && word->kind == WordKind::material && material_named(word->meaning) ? &out.material
                          : color_named(plain_name(term))                                             ? &out.color
                          : material_named(plain_name(term))                                          ? &out.material
                                                                                                      : nullptr;
        if (!to) continue;
        const bool look = word && (word->kind == WordKind::pattern || word->kind == WordKind::material ||
                                   word->kind == WordKind::color);
        if (to == &out.color && !out.color.empty()) to = &out.color2;  // "black and white"
        *to = look ? word->meaning : plain_name(term);
        // "black marble" is one word of the lexicon.
        if (const std::string color = word ? reading::added_by(*word, "color") : "";
            !color.empty() && to == &out.material)
            (out.color.empty() ? out.color : out.color2) = color;
        return length;
    }
    return 0;
}

}  // namespace

namespace {

// The looks among the words that have only something like them.
std::vector<std::string> stand_ins(const Words& words) {
    std::vector<std::string> out;
    constexpr std::size_t kLongest = 3;  // words of a look
    for (std::size_t i = 0; i < words.size(); ++i)
        for (std::size_t length = std::min(kLongest, words.size() - i); length > 0; --length) {
            const std::string term = text_of(words, i, i + length);
            const auto word = look_up(term);
            if (!word || (word->kind != WordKind::material && word->kind != WordKind::pattern)) continue;
            if (!word->exact) out.push_back(term);
            i += length - 1;
            break;
        }
    return out;
}

}  // namespace

std::string comparative_of(const std::string& word) {
    if (word == "low") return "lower";
    if (is_one_of(word, {"narrow", "slim"})) return "narrower";
    if (word == "small") return "smaller";
    if (word == "short") return "shorter";
    for (const SizeWord& s : kSizeWords)
        if (word == s.plain && s.plain != "size") return std::string(s.more);
    return {};
}

Vec3f usual_factor(const Words& words) {
    constexpr float kSaid = 1.35f, kLow = 0.65f;  // to be seen without the usual one beside it
    Vec3f out{1, 1, 1};
    for (const std::string& w : words) {
        Vec3f axes{};
        float factor = kSaid;
        for (const SizeWord& s : kSizeWords)
            if (!(s.axes == Vec3f{1, 1, 1}) && is_one_of(w, {s.plain, s.more, s.less}))
                axes = s.axes, factor = w == s.less ? kLow : kSaid;
        if (w == "low") axes = {0, 1, 0}, factor = kLow;
        else if (is_one_of(w, {"narrow", "slim"})) axes = {1, 0, 0}, factor = kLow;
        else if (is_one_of(w, {"shallow", "thin"})) axes = {0, 0, 1}, factor = kLow;
        for (std::size_t a = 0; a < 3; ++a)
            if (axes[a] > 0) out[a] = factor;
    }
    return out;
}

std::string shape_said(const Words& words) {
    std::string out;
    for (const std::string& w : words) {
        const std::string shape = is_one_of(w, {"round", "circular", "rounder"})                       ? "round"
                                  : is_one_of(w, {"oval", "elliptical"})                               ? "oval"
                                  : w == "square"                                                      ? "square"
                                  : is_one_of(w, {"rectangular", "oblong", "rectangle", "rectangles"}) ? "rectangular"
                                                                                                       : "";
        if (shape.empty() ? !is_one_of(w, {"a", "an", "in", "shape", "shaped", "form", "one"}) : !out.empty())
            return {};
        if (!shape.empty()) out = shape;
    }
    return out;
}

std::optional<PromptObject> looks_of(const std::string& words) {
    PromptObject out;
    if (words.size() == 7 && words[0] == '#' && document_fields::color_said(words)) {
        out.color = words;
        return out;
    }
    Words tokens = tokens_of(words);
    std::erase_if(tokens, [](const std::string& w) {
        return is_one_of(w, {"a", "an", "the", "in", "of", "out", "color", "colored", "paint", "tone", "shade", "nice",
                             "made", "with", "to", "into"});
    });
    for (std::size_t i = 0; i < tokens.size();) {
        const std::size_t length = parts_looks(tokens[i]) ? 1 : take_look(tokens, i, out);
        if (length == 0) return {};
        i += length;
    }
    if (std::all_of(tokens.begin(), tokens.end(), parts_looks)) return {};
    return out;
}

std::optional<Value> value_of(const Words& words) {
    Value out;
    if (words.empty()) return {};
    Words without = words;
    if (const auto metres = take_length(without)) {
        // "20 cm wider", "wider by 20 cm"
        const auto factor = compared(without, &out.length);
        if (!factor) return {};
        for (std::size_t a = 0; a < 3; ++a)
            if ((*factor)[a] != 1) out.exactly = true, out.by[a] = (*factor)[a] > 1 ? *metres : -*metres;
        return out;
    }
    if (const auto factor = compared(words, &out.length)) {
        out.factor = *factor;
        out.exactly = std::find(words.begin(), words.end(), "percent") != words.end();
        return out;
    }
    if (const auto factor = times(words)) {
        out.factor = *factor, out.exactly = true;
        return out;
    }
    if (const auto factor = brighter(words, out.shines)) {
        out.brighter = *factor;
        return out;
    }
    if (const std::string shape = shape_said(words); !shape.empty()) {
        out.shape = shape;
        return out;
    }
    auto looks = looks_of(text_of(words));
    // "Dark herringbone parquet"
    if (!looks && words.size() > 1 && is_one_of(words.front(), {"dark", "light", "pale"})) {
        looks = looks_of(text_of(words, 1));
        if (!looks || looks->material.empty() || !looks->color.empty()) return {};
        out.brighter = words.front() == "dark" ? 0.6f : 1.5f;
    }
    if (!looks) return {};
    out.looks = *looks;
    out.near = stand_ins(words);
    return out;
}

}  // namespace editing

PromptObject looks_named(const std::string& words) {
    if (const auto looks = editing::looks_of(words)) return *looks;
    throw UsageError("expected a color, a material or a pattern, found \"{}\"", words);
}

}  // namespace fastscene
