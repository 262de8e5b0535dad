#include "fastscene/rooms/style.h"

#include <algorithm>

#include "fastscene/base/check.h"
#include "fastscene/base/error.h"
#include "fastscene/rooms/file_fields.h"
#include "fastscene/rooms/style_file.h"

namespace fastscene {

// styles/*.toml, by cmake/embed.cmake.
extern const file_fields::EmbeddedFile kStyleTexts[];
extern const std::size_t kStyleCount;

namespace {
std::string file_of(std::size_t i) { return "styles/" + std::string(kStyleTexts[i].first) + ".toml"; }
}  // namespace

Material Style::of(const MadeOf& part) const {
    if (part.own) return this->*part.own;
    Material m = part.other;
    if (part.in_accent) m.color_a = m.color_b = m.color_c = palette.front();
    return m;
}

std::vector<std::pair<std::string, std::string>> style_words() {
    std::vector<std::pair<std::string, std::string>> out;
    for (std::size_t i = 0; i < kStyleCount; ++i) {
        const toml::table document = parse_toml(kStyleTexts[i].second, file_of(i));
        const toml::array* words = document["words"].as_array();
        for (std::size_t w = 0; words && w < words->size(); ++w)
            if (const auto word = (*words)[w].value<std::string>())
                out.emplace_back(*word, document["name"].value_or(std::string()));
    }
    return out;
}

const std::vector<Style>& all_styles() {
    static const std::vector<Style> all = [] {
        std::vector<Style> out;
        for (std::size_t i = 0; i < kStyleCount; ++i) out.push_back(read_style(kStyleTexts[i].second, file_of(i)));
        std::stable_sort(out.begin(), out.end(), [](const Style& a, const Style& b) { return a.rank < b.rank; });
        return out;
    }();
    return all;
}

const Style& style_named(std::string_view name) {
    for (const Style& s : all_styles())
        if (plain_name(s.name) == plain_name(name)) return s;
    std::string known;
    for (const Style& s : all_styles()) known += (known.empty() ? "" : ", ") + s.name;
    throw Error("style: expected one of {}, found '{}'", known, std::string(name));
}

std::vector<std::string> styles() {
    std::vector<std::string> out;
    for (const Style& s : all_styles()) out.push_back(s.name);
    return out;
}

std::vector<std::string> styles_for(StyleMood mood) {
    std::vector<const Style*> chosen;
    for (const Style& s : all_styles())
        if (s.drawn_for.contains(mood)) chosen.push_back(&s);
    FASTSCENE_CHECK(!chosen.empty());
    std::stable_sort(chosen.begin(), chosen.end(),
                     [&](const Style* a, const Style* b) { return a->drawn_for.at(mood) < b->drawn_for.at(mood); });
    std::vector<std::string> out;
    for (const Style* s : chosen) out.push_back(s->name);
    return out;
}

std::string style_with_lamp(LampFamily lamp) {
    for (const Style& s : all_styles())
        if (s.lamp == lamp) return s.name;
    throw Error("styles/: expected a style with lamp = \"{}\", found none",
                kNamesOf<LampFamily>[static_cast<std::size_t>(lamp)]);
}

}  // namespace fastscene
