// Holds the includes against the drawing: docs/architecture.md says which room stands on which floor,
// the root CMakeLists.txt says who may use whom, and the sources do what they do. All three must agree.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
const fs::path kRoot = FASTSCENE_SOURCE_DIR;

std::string text_of(const fs::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

struct Drawing {
    std::map<std::string, int> floor;  // of each room
    std::map<std::string, int> place;  // from left to right on its floor
};

// The table in docs/architecture.md: | 4 | trace, rooms | … |
Drawing drawing() {
    Drawing drawn;
    std::istringstream lines(text_of(kRoot / "docs/architecture.md"));
    const std::regex row(R"(^\| (\d) \| ([^|]+) \|.*)"), word("[a-z]+");
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (!std::regex_match(line, match, row)) continue;
        const std::string rooms = match[2];
        int place = 0;
        for (std::sregex_iterator it(rooms.begin(), rooms.end(), word), end; it != end; ++it) {
            drawn.floor[it->str()] = std::stoi(match[1]);
            drawn.place[it->str()] = place++;
        }
    }
    return drawn;
}

struct BuildRoom {
    int floor = 0;
    std::set<std::string> uses;
};

// fastscene_room(walk FLOOR 5 USES base … LINKS …) in the root CMakeLists.txt.
std::map<std::string, BuildRoom> build_rooms() {
    std::map<std::string, BuildRoom> rooms;
    const std::string text = text_of(kRoot / "CMakeLists.txt");
    const std::regex call(R"(fastscene_room\((\w+) FLOOR (\d)([^)]*)\))"), uses(R"(USES ([a-z\s]+))"), word("[a-z]+");
    for (std::sregex_iterator it(text.begin(), text.end(), call), end; it != end; ++it) {
        BuildRoom& room = rooms[(*it)[1]];
        room.floor = std::stoi((*it)[2]);
        const std::string rest = (*it)[3];
        std::smatch match;
        if (!std::regex_search(rest, match, uses)) continue;
        const std::string names = match[1];
        for (std::sregex_iterator name(names.begin(), names.end(), word); name != end; ++name)
            room.uses.insert(name->str());
    }
    return rooms;
}

struct Include {
    std::string room;    // that includes
    fs::path file;       // that includes, relative to src/fastscene
    std::string target;  // as written, without brackets
    bool is_test;
};

std::vector<Include> includes() {
    std::vector<Include> found;
    const std::regex line_form(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"].*)");
    const fs::path source = kRoot / "src/fastscene";
    for (const auto& entry : fs::recursive_directory_iterator(source)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cc") continue;
        const fs::path file = fs::relative(entry.path(), source);
        std::istringstream lines(text_of(entry.path()));
        for (std::string line; std::getline(lines, line);) {
            std::smatch match;
            if (std::regex_match(line, match, line_form))
                found.push_back({file.begin()->string(), file, match[1], file.string().ends_with("_test.cc")});
        }
    }
    return found;
}

// Whether `from` may know `to` at all.
bool drawing_allows(const Drawing& drawn, const std::string& from, const std::string& to) {
    if (from == to) return true;
    const int a = drawn.floor.at(from), b = drawn.floor.at(to);
    if (b != a) return b < a;
    // Stages know those to their left; so do math, image and geometry. Elsewhere siblings do not meet.
    return (a == 5 || a == 1) && drawn.place.at(to) < drawn.place.at(from);
}

TEST(Floors, TheDrawingAndTheBuildNameTheSameRooms) {
    const Drawing drawn = drawing();
    std::map<std::string, int> built;
    for (const auto& [name, room] : build_rooms()) built[name] = room.floor;
    built["cli"] = 8;  // a program, not a library: src/fastscene/cli/CMakeLists.txt
    EXPECT_EQ(drawn.floor, built);
    EXPECT_GE(drawn.floor.size(), 15u);
}

TEST(Floors, EveryFolderIsARoom) {
    const Drawing drawn = drawing();
    for (const auto& entry : fs::directory_iterator(kRoot / "src/fastscene"))
        EXPECT_TRUE(!entry.is_directory() || drawn.floor.contains(entry.path().filename().string())) << entry.path();
}

TEST(Floors, TheBuildLinksOnlyWhatTheDrawingAllows) {
    const Drawing drawn = drawing();
    for (const auto& [name, room] : build_rooms())
        for (const std::string& other : room.uses)
            EXPECT_TRUE(drawing_allows(drawn, name, other)) << name << " uses " << other;
}

TEST(Floors, SourcesIncludeDownwardAndThroughFrontDoors) {
    const Drawing drawn = drawing();
    const auto rooms = build_rooms();
    std::size_t checked = 0;
    for (const Include& include : includes()) {
        if (!include.target.starts_with("fastscene/") || include.target == "fastscene/build_sources.h") continue;
        const fs::path target = fs::path(include.target).lexically_relative("fastscene");
        const std::string to = target.begin()->string();
        const std::string text = include.file.string() + " includes " + include.target;
        ASSERT_TRUE(drawn.floor.contains(to)) << text;
        EXPECT_TRUE(fs::exists(kRoot / "src" / include.target)) << text;
        if (to == include.room) continue;
        ++checked;
        EXPECT_TRUE(drawing_allows(drawn, include.room, to)) << text << ": not downward";
        EXPECT_TRUE(include.room == "cli" || rooms.at(include.room).uses.contains(to))
            << text << ": not among its USES";
        if (drawn.floor.at(include.room) == 5 && drawn.floor.at(to) == 5) {
            EXPECT_EQ(target, fs::path(to) / (to + ".h")) << text << ": stages meet at front headers only";
        }
    }
    EXPECT_GT(checked, 50u);
}

// Libraries that only some rooms know: first the beginning of the include, then where it may stand.
TEST(Floors, ForeignLibrariesStayInTheirRooms) {
    const std::vector<std::pair<std::string, std::vector<std::string>>> rules{
        {"embree", {"trace"}}, {"httplib", {"cli"}},     {"CLI/", {"cli"}},      {"png", {"io"}},
        {"jpeglib", {"io"}},   {"Imf", {"io"}},          {"OpenEXR", {"io"}},    {"zlib", {"io"}},
        {"zstd", {"io"}},      {"tbb/", {"base"}},       {"nlohmann", {"base"}}, {"toml++", {"evaluate"}},
        {"torch", {"nn"}},     {"ATen", {"nn"}},         {"c10", {"nn"}},        {"unicode/", {"nn"}},
        {"curl/", {"models"}}, {"openssl/", {"models"}}, {"iostream", {"cli"}},  {"cstdio", {"io", "base"}},
    };
    for (const Include& include : includes()) {
        if (include.is_test) continue;
        for (const auto& [library, rooms] : rules)
            EXPECT_TRUE(!include.target.starts_with(library) ||
                        std::find(rooms.begin(), rooms.end(), include.room) != rooms.end())
                << include.file << " includes " << include.target;
    }
}

TEST(Floors, EmbreeAndHttplibAreNotInHeaders) {
    for (const Include& include : includes())
        if (include.target.starts_with("embree") || include.target.starts_with("httplib")) {
            const bool inner_header_of_trace = include.room == "trace" && include.file.filename() != "trace.h";
            EXPECT_TRUE(include.file.extension() == ".cc" || inner_header_of_trace) << include.file;
        }
}

// The library neither prints nor exits: it speaks through events and throws.
TEST(Floors, OnlyTheCommandLinePrintsAndExits) {
    const std::regex talk(R"(\b(std::cout|std::cerr|printf\s*\(|puts\s*\(|std::exit\s*\(|std::abort\s*\(|_exit\s*\())");
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / "src/fastscene")) {
        const fs::path& path = entry.path();
        if (path.extension() != ".h" && path.extension() != ".cc") continue;
        if (path.string().ends_with("_test.cc") || path.string().find("/cli/") != std::string::npos) continue;
        std::istringstream lines(text_of(path));
        int number = 0;
        for (std::string line; std::getline(lines, line);) {
            ++number;
            const std::string code = line.substr(0, line.find("//"));
            std::smatch match;
            if (!std::regex_search(code, match, talk)) continue;
            const bool formats_text = code.find("snprintf") != std::string::npos;
            EXPECT_TRUE(formats_text) << path << ":" << number << ": " << line;
        }
    }
}

}  // namespace
