// The sentences of tests/data/sentences.txt are understood as the table says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/rooms/rooms.h"

namespace fastscene {
namespace {

std::vector<std::string> split(std::string_view text, char at) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(at, begin), text.size());
        std::string_view part = text.substr(begin, end - begin);
        while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
        while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
        parts.emplace_back(part);
        begin = end + 1;
    }
    return parts;
}

std::string joined(const std::vector<std::string>& parts) {
    std::string out;
    for (const std::string& part : parts) out += (out.empty() ? "" : ", ") + part;
    return out;
}

std::string words_with(const PromptSpec& spec, PromptWord::Fate fate) {
    std::vector<std::string> out;
    for (const PromptWord& word : spec.words_with(fate)) out.push_back(word.words);
    return joined(out);
}

// "approximated: read as sofa"; empty if no word of the sentence is reported that way.
std::string report_of(const PromptSpec& spec, std::string_view words) {
    static constexpr const char* kFates[] = {"understood", "approximated", "not understood"};
    for (const PromptWord& word : spec.words)
        if (word.words == words) return std::string(kFates[static_cast<std::size_t>(word.fate)]) + ": " + word.meaning;
    return {};
}

const PromptObject* find_object(const PromptSpec& spec, std::string_view kind, bool forbidden) {
    const auto found = std::find_if(spec.objects.begin(), spec.objects.end(),
                                    [&](const PromptObject& o) { return o.kind == kind && o.forbidden == forbidden; });
    return found == spec.objects.end() ? nullptr : &*found;
}

// The value of a field of the sentence ("room") or of a thing ("sofa.color"); none if there is no such thing.
std::optional<std::string> value_of(const PromptSpec& spec, const std::string& name) {
    using Spec = std::string PromptSpec::*;
    static const std::map<std::string, Spec> kFields{
        {"room", &PromptSpec::room},           {"style", &PromptSpec::style},
        {"time", &PromptSpec::time},           {"weather", &PromptSpec::weather},
        {"size", &PromptSpec::size},           {"structure", &PromptSpec::structure},
        {"next_room", &PromptSpec::next_room}, {"mood", &PromptSpec::mood},
        {"light", &PromptSpec::light},         {"light_color", &PromptSpec::light_color},
        {"clutter", &PromptSpec::clutter},     {"outlook", &PromptSpec::outlook},
        {"outline", &PromptSpec::outline},     {"language", &PromptSpec::language},
        {"unread", &PromptSpec::unread},
    };
    using Object = std::string PromptObject::*;
    static const std::map<std::string, Object> kObjectFields{
        {"color", &PromptObject::color},
        {"color2", &PromptObject::color2},
        {"not_color", &PromptObject::not_color},
        {"material", &PromptObject::material},
        {"pattern", &PromptObject::pattern},
        {"size", &PromptObject::size},
        {"relation", &PromptObject::relation},
        {"relation_to", &PromptObject::relation_to},
        {"holder_color", &PromptObject::holder_color},
        {"holder_material", &PromptObject::holder_material},
    };
    if (name == "colors") return joined(spec.colors);
    if (const auto field = kFields.find(name); field != kFields.end()) return spec.*field->second;
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos) throw Error("unknown field \"{}\"", name);
    const std::string thing = name.substr(0, dot), field = name.substr(dot + 1);
    const PromptObject* object = thing == "everything" ? &spec.everything : find_object(spec, thing, false);
    const auto member = kObjectFields.find(field);
    if (field != "count" && member == kObjectFields.end()) throw Error("unknown field \"{}\"", name);
    if (!object) return {};
    return field == "count" ? std::to_string(object->count) : object->*member->second;
}

bool compare(const std::string& found, const std::string& op, const std::string& expected) {
    if (op == "=") return found == expected;
    if (op == "!=") return found != expected;
    const int a = std::atoi(found.c_str()), b = std::atoi(expected.c_str());
    return op == ">" ? a > b : a >= b;
}

// Empty if it holds, else what was found.
std::string check(const PromptSpec& spec, const std::string& claim) {
    const auto after = [&](std::string_view start) -> std::optional<std::string> {
        if (!claim.starts_with(start)) return {};
        return claim.substr(start.size());
    };
    const auto same = [](const std::string& found, const std::string& expected) {
        return found == expected ? std::string() : "found \"" + found + "\"";
    };
    if (claim == "no objects") return spec.objects.empty() ? "" : "found " + spec.objects[0].kind;
    if (claim == "no colors") return same(joined(spec.colors), "");
    if (claim == "all understood") return same(words_with(spec, PromptWord::Fate::not_understood), "");
    if (const auto w = after("not understood: ")) return same(words_with(spec, PromptWord::Fate::not_understood), *w);
    if (const auto w = after("approximated: ")) return same(words_with(spec, PromptWord::Fate::approximated), *w);
    if (claim.starts_with('"')) {
        const std::size_t end = claim.find("\" is ");
        if (end == std::string::npos) throw Error("expected \"WORDS\" is FATE, found {}", claim);
        const std::string found = report_of(spec, claim.substr(1, end - 1));
        return found.starts_with(claim.substr(end + 5)) ? "" : "found \"" + found + "\"";
    }
    if (const auto kind = after("forbidden ")) return find_object(spec, *kind, true) ? "" : "is not forbidden";
    if (const auto kind = after("no ")) return find_object(spec, *kind, false) ? "is asked for" : "";
    const std::size_t at = claim.find_first_of("!=>");
    if (at == std::string::npos) return find_object(spec, claim, false) ? "" : "is not asked for";
    const std::size_t value = claim.find_first_not_of("!=>", at);
    const std::string op = claim.substr(at, std::min(value, claim.size()) - at),
                      expected = value == std::string::npos ? "" : claim.substr(value);
    const std::optional<std::string> found = value_of(spec, claim.substr(0, at));
    if (!found) return "is not asked for";
    return compare(*found, op, expected) ? "" : "found \"" + *found + "\"";
}

TEST(Sentences, AreUnderstoodAsTheTableSays) {
    const std::string path = std::string(FASTSCENE_SOURCE_DIR) + "/tests/data/sentences.txt";
    std::ifstream file(path);
    ASSERT_TRUE(file) << path;
    std::string line;
    int sentences = 0;
    for (int number = 1; std::getline(file, line); ++number) {
        if (line.empty() || line[0] == '#') continue;
        const std::string where = path + ":" + std::to_string(number);
        const std::vector<std::string> columns = split(line, '|');
        if (columns.size() != 2) {
            ADD_FAILURE() << where << ": expected a sentence, |, and what must hold";
            continue;
        }
        const PromptSpec spec = understand_prompt(columns[0], false);
        ++sentences;
        for (const std::string& claim : split(columns[1], ';')) {
            try {
                const std::string found = check(spec, claim);
                EXPECT_TRUE(found.empty()) << where << ": " << columns[0] << "\n  " << claim << ": " << found;
            } catch (const Error& e) {
                ADD_FAILURE() << where << ": " << e.what();
            }
        }
    }
    EXPECT_GE(sentences, 100);
}

// A table whose claims could not fail would hold nothing.
TEST(Sentences, AWrongClaimIsFound) {
    const PromptSpec spec = understand_prompt("a bedroom with two red armchairs and no tv", false);
    for (const char* claim : {"room=kitchen", "sofa", "no armchair", "forbidden armchair", "armchair.color=blue",
                              "armchair.count>2", "armchair.count=3", "no objects", "not understood: red",
                              "approximated: red", "\"red\" is approximated", "colors=red", "sofa.color="})
        EXPECT_FALSE(check(spec, claim).empty()) << claim;
    for (const char* claim : {"room=bedroom", "armchair", "no sofa", "forbidden tv", "armchair.color=red",
                              "armchair.count>=2", "all understood", "no colors", "room!=kitchen"})
        EXPECT_EQ(check(spec, claim), "") << claim;
    EXPECT_THROW(check(spec, "roof=flat"), Error);
    EXPECT_THROW(check(spec, "armchair.roof=flat"), Error);
}

}  // namespace
}  // namespace fastscene
