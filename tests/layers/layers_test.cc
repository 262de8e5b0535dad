// Verifies dependencies between modules: docs/architecture.md assigns modules to layers, the root CMakeLists.txt lists
// what each module may use, and the sources include headers. All three must agree.
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
    std::map<std::string, int> layer;  // of each module
    std::map<std::string, int> place;  // position from left to right within its layer
};

// The table in docs/architecture.md: | 4 | trace, rooms | … |
Drawing drawing() {
    Drawing drawn;
    std::istringstream lines(text_of(kRoot / "docs/architecture.md"));
    const std::regex row(R"(^\| (\d) \| ([^|]+) \|.*)"), word("[a-z]+");
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (!std::regex_match(line, match, row)) continue;
        const std::string modules = match[2];
        int place = 0;
        for (std::sregex_iterator it(modules.begin(), modules.end(), word), end; it != end; ++it) {
            drawn.layer[it->str()] = std::stoi(match[1]);
            drawn.place[it->str()] = place++;
        }
    }
    return drawn;
}

struct BuildModule {
    int layer = 0;
    std::set<std::string> uses;
};

// fastscene_module(walk LAYER 5 USES base … LINKS …) in the root CMakeLists.txt.
std::map<std::string, BuildModule> build_modules() {
    std::map<std::string, BuildModule> modules;
    const std::string text = text_of(kRoot / "CMakeLists.txt");
    const std::regex call(R"(fastscene_module\((\w+) LAYER (\d)([^)]*)\))"), uses(R"(USES ([a-z\s]+))"), word("[a-z]+");
    for (std::sregex_iterator it(text.begin(), text.end(), call), end; it != end; ++it) {
        BuildModule& module = modules[(*it)[1]];
        module.layer = std::stoi((*it)[2]);
        const std::string rest = (*it)[3];
        std::smatch match;
        if (!std::regex_search(rest, match, uses)) continue;
        const std::string names = match[1];
        for (std::sregex_iterator name(names.begin(), names.end(), word); name != end; ++name)
            module.uses.insert(name->str());
    }
    return modules;
}

struct Include {
    std::string module;  // of the including file
    fs::path file;       // the including file, relative to src/fastscene
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
        if (!file.has_parent_path()) continue;  // umbrella headers of the installed libraries, outside any module
        std::istringstream lines(text_of(entry.path()));
        for (std::string line; std::getline(lines, line);) {
            std::smatch match;
            if (std::regex_match(line, match, line_form))
                found.push_back({file.begin()->string(), file, match[1], file.string().ends_with("_test.cc")});
        }
    }
    return found;
}

// Whether `from` may use `to` at all.
bool drawing_allows(const Drawing& drawn, const std::string& from, const std::string& to) {
    if (from == to) return true;
    const int a = drawn.layer.at(from), b = drawn.layer.at(to);
    if (b != a) return b < a;
    // Stages may use those to their left, and so may math, image and geometry. Other modules of one layer are
    // independent.
    return (a == 5 || a == 1) && drawn.place.at(to) < drawn.place.at(from);
}

TEST(Layers, TheDrawingAndTheBuildNameTheSameModules) {
    const Drawing drawn = drawing();
    std::map<std::string, int> built;
    for (const auto& [name, module] : build_modules()) built[name] = module.layer;
    built["cli"] = 8;  // a program, not a library: src/fastscene/cli/CMakeLists.txt
    EXPECT_EQ(drawn.layer, built);
    EXPECT_GE(drawn.layer.size(), 15u);
}

TEST(Layers, EveryFolderIsAModule) {
    const Drawing drawn = drawing();
    for (const auto& entry : fs::directory_iterator(kRoot / "src/fastscene"))
        EXPECT_TRUE(!entry.is_directory() || drawn.layer.contains(entry.path().filename().string())) << entry.path();
}

TEST(Layers, TheBuildLinksOnlyWhatTheDrawingAllows) {
    const Drawing drawn = drawing();
    for (const auto& [name, module] : build_modules())
        for (const std::string& other : module.uses)
            EXPECT_TRUE(drawing_allows(drawn, name, other)) << name << " uses " << other;
}

TEST(Layers, SourcesIncludeDownwardAndThroughFrontDoors) {
    const Drawing drawn = drawing();
    const auto modules = build_modules();
    std::size_t checked = 0;
    for (const Include& include : includes()) {
        if (!include.target.starts_with("fastscene/") || include.target == "fastscene/build_sources.h") continue;
        const fs::path target = fs::path(include.target).lexically_relative("fastscene");
        const std::string to = target.begin()->string();
        const std::string text = include.file.string() + " includes " + include.target;
        ASSERT_TRUE(drawn.layer.contains(to)) << text;
        EXPECT_TRUE(fs::exists(kRoot / "src" / include.target)) << text;
        if (to == include.module) continue;
        ++checked;
        EXPECT_TRUE(drawing_allows(drawn, include.module, to)) << text << ": not downward";
        EXPECT_TRUE(include.module == "cli" || modules.at(include.module).uses.contains(to))
            << text << ": not among its USES";
        if (drawn.layer.at(include.module) == 5 && drawn.layer.at(to) == 5) {
            EXPECT_EQ(target, fs::path(to) / (to + ".h")) << text << ": stages meet at front headers only";
        }
    }
    EXPECT_GT(checked, 50u);
}

TEST(Layers, TheBuildNamesNoModuleThatIsNotIncluded) {
    std::map<std::string, std::set<std::string>> included;
    for (const Include& include : includes())
        if (include.target.starts_with("fastscene/"))
            included[include.module].insert(fs::path(include.target).lexically_relative("fastscene").begin()->string());
    for (const auto& [name, module] : build_modules())
        for (const std::string& other : module.uses)
            EXPECT_TRUE(included[name].contains(other)) << name << " has " << other << " among its USES for nothing";
}

// splat.h, rooms.h and fastscene.h are the umbrella headers of the installed libraries.
TEST(Layers, TheLibrariesHeadersNameHeadersThatAreThere) {
    const std::regex form(R"re(^#include "(fastscene/[^"]+)")re");
    int checked = 0;
    for (const char* header : {"splat.h", "rooms.h", "fastscene.h"}) {
        std::istringstream lines(text_of(kRoot / "src/fastscene" / header));
        for (std::string line; std::getline(lines, line);) {
            std::smatch match;
            if (!std::regex_search(line, match, form) || match[1] == "fastscene/version.h") continue;
            EXPECT_TRUE(fs::exists(kRoot / "src" / match[1].str())) << header << " includes " << match[1];
            ++checked;
        }
    }
    EXPECT_GT(checked, 30);
}

// Third-party libraries restricted to certain modules: include prefix, then the modules.
TEST(Layers, ForeignLibrariesStayInTheirModules) {
    const std::vector<std::pair<std::string, std::vector<std::string>>> rules{
        {"embree", {"trace"}},
        {"httplib", {"cli", "studio"}},
        {"CLI/", {"cli"}},
        {"png", {"io"}},
        {"jpeglib", {"io"}},
        {"Imf", {"io"}},
        {"OpenEXR", {"io"}},
        {"zlib", {"io"}},
        {"zstd", {"io"}},
        {"tbb/", {"base"}},
        {"nlohmann", {"base"}},
        {"toml++", {"io"}},
        {"torch", {"nn"}},
        {"ATen", {"nn"}},
        {"c10", {"nn"}},
        {"unicode/", {"nn"}},
        {"curl/", {"models"}},
        {"openssl/", {"models"}},
        {"meshopt", {"export", "io"}},
        {"iostream", {"cli"}},
        {"cstdio", {"io", "base"}},
    };
    for (const Include& include : includes()) {
        if (include.is_test) continue;
        for (const auto& [library, modules] : rules)
            EXPECT_TRUE(!include.target.starts_with(library) ||
                        std::find(modules.begin(), modules.end(), include.module) != modules.end())
                << include.file << " includes " << include.target;
    }
}

TEST(Layers, EmbreeAndHttplibAreNotInHeaders) {
    for (const Include& include : includes())
        if (include.target.starts_with("embree") || include.target.starts_with("httplib")) {
            const bool inner_header_of_trace = include.module == "trace" && include.file.filename() != "trace.h";
            EXPECT_TRUE(include.file.extension() == ".cc" || inner_header_of_trace) << include.file;
        }
}

// The library neither prints nor exits: it uses events and exceptions.
TEST(Layers, OnlyTheCommandLinePrintsAndExits) {
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
