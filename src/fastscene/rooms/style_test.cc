#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "fastscene/base/error.h"
#include "fastscene/rooms/layout.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/rooms/style_file.h"
#include "fastscene/rooms/validate.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;
const fs::path kSources = fs::path(FASTSCENE_SOURCE_DIR) / "src/fastscene/rooms";

std::string style_text(const fs::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

// The error of a file in which the first match of `pattern` is replaced.
std::string error_with(const std::string& pattern, const std::string& replacement) {
    const std::string text = style_text(kSources / "styles/modern.toml");
    const std::string changed = std::regex_replace(text, std::regex(pattern), replacement,
                                                   std::regex_constants::format_first_only);
    EXPECT_NE(changed, text) << pattern;
    try {
        (void)read_style(changed, "styles/mine.toml");
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

TEST(StyleFiles, EachIsAStyle) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(kSources / "styles")) {
        const Style style = read_style(style_text(entry.path()), entry.path().string());
        EXPECT_TRUE(names.insert(style.name).second) << style.name << " is the name of two files";
        EXPECT_EQ(style_named(style.name).rank, style.rank);
    }
    const std::vector<std::string> all = styles();
    EXPECT_EQ(names, std::set<std::string>(all.begin(), all.end()));
}

TEST(StyleFiles, ErrorsNameFileKeyAndWhatWasExpected) {
    const auto says = [](const std::string& error, const std::string& part) {
        EXPECT_NE(error.find(part), std::string::npos) << error;
        EXPECT_TRUE(error.starts_with("styles/mine.toml:")) << error;
    };
    says(error_with("rank = ", "rang = "), "unknown key \"rang\"; did you mean rank?");
    says(error_with("\\[light\\]\nlamp = .*\n", "[light]\n"), "[light]: lamp: expected one of drum, globe");
    says(error_with("lamp = \"dome\"", "lamp = \"torch\""), "expected one of drum, globe");
    says(error_with("paint = \"white\"", "paint = \"spaceship\""), "expected a color's name, found \"spaceship\"");
    says(error_with("sofa = \\[[^\\]]*\\]", "sofa = [\"padded\", \"inflated\"]"), "expected one of padded, framed");
    says(error_with("sofa = \\[[^\\]]*\\]", "sofa = [\"padded\"]"), "expected two of padded, framed");
    says(error_with("height_m = [^\n]*", "height_m = 270"), "expected a number from 2.2 to 6");
    says(error_with("bunk = \"second wood\"", "bunk = \"third wood\""), "expected one of wood, second wood");
    says(error_with("palette = \\[[^\\]]*\\]", "palette = [\"teal\"]"), "expected 6 colors, found 1");
    says(error_with("\\[windows\\]", "[window]"), "unknown key \"window\"");
}

TEST(StyleFiles, TheirWordsNameThem) {
    for (const auto& [term, style] : style_words()) {
        const auto word = look_up(term);
        ASSERT_TRUE(word.has_value()) << term;
        EXPECT_EQ(word->kind, WordKind::style) << term;
        EXPECT_EQ(word->meaning, style) << term;
        EXPECT_TRUE(word->exact) << term;
    }
}

TEST(StyleFiles, EachFurnishesARoomWithoutFault) {
    for (const std::string& style : styles()) {
        PromptSpec spec = understand_prompt("a " + style + " bedroom", false);
        EXPECT_EQ(spec.style, style);
        const FurnishedRoom room = furnish_room(spec, {});
        EXPECT_EQ(room.plan.style.name, style);
        EXPECT_GT(room.placed.size(), 5u) << style;
        for (const Fault& fault : room_faults(room.plan, room.placed, room.camera))
            ADD_FAILURE() << style << ": " << fault.kind << ": " << fault.text;
    }
}

// A style's file is all that there is of it.
TEST(StyleFiles, NoCodeKnowsAStyleByName) {
    std::string names;
    for (const std::string& style : styles()) names += (names.empty() ? "" : "|") + style;
    // Compared, assigned, or the key of a row of a table. (Words alone may be others': "classic blue".)
    const std::regex compared("style(\\.name|->name)?\\s*[!=]=\\s*\"|\"(" + names + ")\"\\s*[!=]="),
        assigned("style\\s*=\\s*\"(" + names + ")\""), in_table("\\{\\s*\"(" + names + ")\"\\s*,");
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kSources)) {
        const std::string path = entry.path().string();
        if ((!path.ends_with(".cc") && !path.ends_with(".h")) || path.ends_with("_test.cc")) continue;
        ++files;
        std::ifstream in(entry.path());
        int number = 0;
        for (std::string line; std::getline(in, line);) {
            ++number;
            const std::string code = line.substr(0, line.find("//"));
            for (const std::regex* form : {&compared, &assigned, &in_table})
                EXPECT_FALSE(std::regex_search(code, *form)) << path << ':' << number << ": " << line;
        }
    }
    EXPECT_GT(files, 100u);
}

}  // namespace
}  // namespace fastscene
