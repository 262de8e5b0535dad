#include "fastscene/evaluate/suite.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/pipeline/stage_cache.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

const std::string kHead = "title = \"T\"\nmeasures = [\"stills\"]\n";
const std::string kScene = "[[scene]]\nprompt = \"a bedroom\"\n";

Suite read(const std::string& text, const std::string& quality = "") {
    return read_suite(text, "mine", "mine.toml", quality);
}

// The error message for an invalid suite; empty if it is valid.
std::string complaint(const std::string& text) {
    try {
        read(text);
        return "";
    } catch (const Error& e) {
        return e.what();
    }
}

TEST(Suite, EveryOneThatShipsIsWhole) {
    std::vector<std::string> names;
    for (const auto& [name, title] : shipped_suites()) names.push_back(name);
    EXPECT_EQ(names, (std::vector<std::string>{"depth", "inpainters", "paper-table1", "paper-table2", "paper-table3",
                                               "paper-table4", "resolutions", "truth"}));
    for (const std::string& name : names) {
        const SuiteText found = find_suite(name);
        const Suite suite = read_suite(found.text, found.name, found.file);
        EXPECT_GE(suite.scenes.size(), 2u) << name;
        EXPECT_FALSE(suite.columns.empty()) << name;
        EXPECT_FALSE(suite.notes.empty()) << name << " says how its protocol differs";
        for (const PublishedRow& row : suite.published)
            for (const auto& [column, value] : row.values)
                EXPECT_NE(std::find(suite.columns.begin(), suite.columns.end(), column), suite.columns.end())
                    << name << ": " << column << " is published but not shown";
    }
    const SuiteText two = find_suite("paper-table2");
    const Suite table2 = read_suite(two.text, two.name, two.file);
    EXPECT_EQ(table2.stills.count, 30) << "as the paper renders";
    EXPECT_EQ(table2.published.back().values.at("niqe"), 3.9);
}

TEST(Suite, SettingsComeFromTheQualityThenTheSuiteThenTheRow) {
    const std::string text = kHead +
                             "quality = \"draft\"\n[settings]\nsplat-steps = 7\nwalk-viewpoints = 3\n[[variant]]\nname "
                             "= \"a\"\n[[variant]]\nname = "
                             "\"b\"\nquality = \"standard\"\n"
                             "settings = { walk = \"paper\", splat-steps = 9 }\nbounds = true\n" +
                             kScene;
    const Suite suite = read(text);
    ASSERT_EQ(suite.variants.size(), 2u);
    EXPECT_EQ(suite.variants[0].params.panorama.width, params_of_quality("draft").panorama.width);
    EXPECT_EQ(suite.variants[0].params.splat.steps, 7);
    EXPECT_EQ(suite.variants[1].params.panorama.width, params_of_quality("standard").panorama.width);
    EXPECT_EQ(suite.variants[1].params.splat.steps, 9);
    EXPECT_EQ(suite.variants[1].params.walk.viewpoints, 3);
    EXPECT_EQ(suite.variants[1].params.walk.kind, "paper");
    EXPECT_TRUE(suite.variants[1].bounds);
    EXPECT_FALSE(suite.variants[0].bounds);
    EXPECT_EQ(read(text, "draft").variants[1].params.panorama.width, params_of_quality("draft").panorama.width)
        << "--quality wins";
    EXPECT_TRUE(read(text, "standard").notes.empty());
    ASSERT_EQ(read(text, "draft").notes.size(), 1u) << "and the table says so";
    EXPECT_NE(read(text, "draft").notes[0].find("not the preset that these rows name: b"), std::string::npos)
        << read(text, "draft").notes[0];
}

TEST(Suite, RowsThatArePresetsAreNotMadeTwiceUnderOtherNames) {
    const SuiteText shipped = find_suite("resolutions");
    for (const std::string& quality : qualities()) {
        const Suite suite = read_suite(shipped.text, shipped.name, shipped.file, quality);
        ASSERT_EQ(suite.variants.size(), 1u) << quality;
        EXPECT_NE(suite.variants[0].name.find(quality), std::string::npos)
            << suite.variants[0].name << " is not made with " << quality;
        EXPECT_NE(suite.notes.back().find("without the rows of other presets"), std::string::npos)
            << suite.notes.back();
    }
    EXPECT_EQ(read_suite(shipped.text, shipped.name, shipped.file).variants.size(), 3u);
}

TEST(Suite, NamesOfEveryAlphabetAreNames) {
    EXPECT_EQ(folder_name_of("Rote Küche"), "rote-küche");
    EXPECT_EQ(folder_name_of(" ../../etc/passwd "), "etc-passwd");
    EXPECT_EQ(folder_name_of("..."), "scene");
    for (const char* plain : {"A cozy bedroom, 3 chairs!", "x", "", "--a--"})
        EXPECT_EQ(folder_name_of(plain), slug_of(plain));
    std::string letters;
    for (int i = 0; i < 99; ++i) letters += "寝";
    for (std::size_t before = 0; before < 4; ++before) {
        const std::string name = folder_name_of(std::string(before, 'x') + letters);
        EXPECT_LE(name.size(), 60u);
        EXPECT_EQ((name.size() - before) % 3, 0u) << "no letter is cut in two: " << name;
    }
    const Suite suite = read(
        kHead + "[[scene]]\nname = \"部屋\"\nprompt = \"a\"\n[[scene]]\nname = \"寝室\"\nprompt = \"a\"\n");
    EXPECT_EQ(suite.scenes[1].name, "寝室");
}

TEST(Suite, ATypoNamesFileLineKeyAndWhatWasMeant) {
    const auto expect = [](const std::string& text, std::initializer_list<const char*> parts) {
        const std::string said = complaint(text);
        for (const char* part : parts)
            EXPECT_NE(said.find(part), std::string::npos) << "said: " << said << "\nof:\n" << text;
    };
    expect(kHead + "[[scene]]\npromt = \"a bedroom\"\n",
           {"mine.toml:4:", "promt", "[[scene]]", "did you mean prompt?"});
    expect("titel = \"T\"\n" + kHead + kScene, {"mine.toml:1:", "titel", "did you mean title?"});
    expect(kHead + "[settings]\nwalk-viewpoint = 3\n" + kScene,
           {"mine.toml:4:", "walk-viewpoint", "did you mean walk-viewpoints?"});
    expect(kHead + "[settings]\nwalk-viewpoints = \"many\"\n" + kScene,
           {"mine.toml:4:", "walk-viewpoints", "expected a number", "many"});
    expect(kHead + "[settings]\nwalk-viewpoints = 100000\n" + kScene,
           {"mine.toml:4:", "walk-viewpoints", "from 0 to 200"});
    expect(kHead + "[settings]\nsplat-steps = 2.5\n" + kScene, {"mine.toml:4:", "whole number"});
    expect(kHead + "quality = \"drat\"\n" + kScene, {"mine.toml:3:", "quality", "did you mean draft?"});
    expect("measures = [\"stils\"]\n" + kScene, {"mine.toml:1:", "measures", "did you mean stills?"});
    expect(kHead + "columns = [\"niqqe\"]\n" + kScene, {"mine.toml:3:", "did you mean niqe?"});
    expect(kHead + kScene + "[[published]]\nname = \"x\"\nbrisk = 3\n", {"mine.toml:7:", "brisk"});
    expect(kHead + "[stills]\ncount = 0\n" + kScene, {"mine.toml:4:", "count", "from 1"});
    expect(kHead + "[held-out]\nradii = [0.3, 50]\n" + kScene, {"mine.toml:4:", "radii", "50"});
    expect(kHead + kScene + "seeds = [1, -2]\n", {"mine.toml:5:", "seeds", "-2"});
    expect(kHead + kScene + kScene, {"mine.toml:5:", "twice"});
    expect(kHead, {"mine.toml", "scene", "found none"});
    expect(kScene, {"mine.toml", "measures", "found none"});
    expect(kHead + "[[scene]]\npanorama = \"none.jpg\"\n", {"mine.toml:4:", "panorama", "none.jpg"});
    expect(kHead + "columns = [\"niqe\",\n\"psnr\"]\n" + kScene,
           {"mine.toml:4: columns", "\"psnr\" is filled by the measure \"held-out\"", "found stills"});
    expect(kHead + "columns = [\"niqe\", \"niqe\"]\n" + kScene, {"mine.toml:3: columns", "\"niqe\" twice"});
    expect("measures = [\"stills\", \"stills\"]\n" + kScene, {"mine.toml:1: measures", "twice"});
    expect(kHead + kScene + "seeds = [1, 2, 1]\n", {"mine.toml:5: [[scene]]: seeds", "1 twice"});
    expect(kHead + kScene + "[[peer]]\nname = \"P\"\nfolder = \"p\"\n[[peer]]\nname = \"p\"\nfolder = \"q\"\n",
           {"mine.toml:9: [[peer]]: name", "twice"});
    expect(kHead + "[scene]\nprompt = \"x\"\n", {"mine.toml:3:", "[[scene]]"});
    expect(kHead + "quality = \"drat\"\n[[variant]]\nname = \"a\"\n" + kScene,
           {"mine.toml:3: quality: unknown \"drat\""});  // reported at its own line, not at the row's
    expect(kHead + kScene + "[held-out]\nradii = [0.3, 0.6, 0.3]\n", {"[held-out]", "radii", "0.3 twice"});
    expect(kHead + "quality = draft\n" + kScene, {"mine.toml:3:", "expected TOML"});
}

// A temporary folder with a file in it.
class SuiteFiles : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(folder_);
        write_file_in("weights.pt");
    }
    void TearDown() override { fs::remove_all(folder_); }
    void write_file_in(const std::string& name) const {
        make_directories((folder_ / name).parent_path());
        write_file(folder_ / name, "x");
    }
    Suite read_there(const std::string& text) const { return read_suite(text, "mine", folder_ / "mine.toml"); }
    std::string complaint_there(const std::string& text) const {
        try {
            read_there(text);
            return "";
        } catch (const Error& e) {
            return e.what();
        }
    }
    // A finished run, with what a suite reads from it.
    void make_run(const std::string& name, const std::string& last_stage) const {
        make_directories(folder_ / name);
        write_json(folder_ / name / "run.json", {{"prompt", "a loft"},
                                                 {"seed", 7},
                                                 {"quality", "draft"},
                                                 {"params", json_of_params(params_of_quality("draft"))}});
        run_stage(folder_ / name, last_stage, "key", {}, [](const fs::path& out) { write_file(out / "file", "x"); });
    }
    fs::path folder_ = fs::temp_directory_path() / "fastscene_suite_test";
};

TEST_F(SuiteFiles, PathsStartAtTheSuitesFolderAndMustBeThere) {
    const std::string weights = kHead + "[settings]\nwalk-inpaint-weights = \"weights.pt\"\n" + kScene;
    EXPECT_EQ(read_there(weights).variants[0].params.walk.inpaint_weights, (folder_ / "weights.pt").string());
    const auto expect = [&](const std::string& text, std::initializer_list<const char*> parts) {
        const std::string said = complaint_there(text);
        for (const char* part : parts)
            EXPECT_NE(said.find(part), std::string::npos) << "said: " << said << "\nof:\n" << text;
    };
    expect(kHead + "[settings]\nwalk-inpaint-weights = \"none.pt\"\n" + kScene,
           {"mine.toml:4: [settings]: walk-inpaint-weights", "expected a file", "none.pt"});
    expect(kHead + "[settings]\ndepth-weights = \"/none.pkl\"\n" + kScene,
           {"mine.toml:4: [settings]: depth-weights", "/none.pkl"});
    expect(kHead + "[[variant]]\nname = \"v\"\nsettings = { walk-inpaint-weights = \"none.pt\" }\n" + kScene,
           {"mine.toml:5: settings: walk-inpaint-weights"});
    expect("diffusion360 = \"painter\"\n" + kHead + kScene,
           {"mine.toml:1: diffusion360", "expected a folder", "painter"});
    expect("diffusion360 = \"weights.pt\"\n" + kHead + kScene, {"mine.toml:1: diffusion360", "expected a folder"});
}

TEST_F(SuiteFiles, HeldOutAloneNeedsARoomBehindAScene) {
    const std::string picture = "[[scene]]\npanorama = \"weights.pt\"\n";
    const std::string said = complaint_there("measures = [\"held-out\"]\n" + picture);
    for (const char* part : {"mine.toml:1: measures", "\"held-out\" needs a room", "found only pictures"})
        EXPECT_NE(said.find(part), std::string::npos) << said;
    EXPECT_EQ(complaint_there("measures = [\"held-out\"]\n" + picture + kScene), "") << "one scene has a room";
    EXPECT_EQ(complaint_there("measures = [\"held-out\", \"source\"]\n" + picture), "") << "the source is measured";
}

TEST_F(SuiteFiles, ARunIsASceneAsItIs) {
    make_run("loft", "splat");
    make_run("half", "depth");
    const Suite suite = read_there(kHead + "[[scene]]\nrun = \"loft/\"\n" + kScene);
    EXPECT_EQ(suite.scenes[0].name, "loft");
    EXPECT_EQ(suite.scenes[0].run, folder_ / "loft");
    EXPECT_EQ(prompt_of(suite.scenes[0].source), "a loft");
    EXPECT_EQ(suite.scenes[0].seeds, std::vector<std::uint64_t>{7});
    EXPECT_EQ(suite.scenes[0].variant, "ours");
    const std::string rows = "[[variant]]\nname = \"A\"\n[[variant]]\nname = \"B\"\n";
    EXPECT_EQ(read_there(kHead + rows + "[[scene]]\nrun = \"loft\"\nvariant = \"B\"\n").scenes[0].variant, "B");
    EXPECT_EQ(complaint_there("measures = [\"holes\"]\n[[scene]]\nrun = \"half\"\n"), "") << "holes need no splats";
    const auto expect = [&](const std::string& text, std::initializer_list<const char*> parts) {
        const std::string said = complaint_there(text);
        for (const char* part : parts)
            EXPECT_NE(said.find(part), std::string::npos) << "said: " << said << "\nof:\n" << text;
    };
    expect(kHead + "[[scene]]\nrun = \"half\"\n", {"mine.toml:4: [[scene]]: run", "finished as far as splat"});
    expect(kHead + "[[scene]]\nrun = \"none\"\n", {"mine.toml:4: [[scene]]: run", "no run.json"});
    expect(kHead + "[[scene]]\nrun = \"loft\"\nseeds = [1]\n", {"mine.toml:5: [[scene]]: seeds", "without run"});
    expect(kHead + rows + "[[scene]]\nrun = \"loft\"\n", {"mine.toml:7: [[scene]]: variant", "one of A, B"});
    expect(kHead + rows + "[[scene]]\nrun = \"loft\"\nvariant = \"C\"\n",
           {"mine.toml:9: [[scene]]: variant", "known: A, B"});
    expect(kHead + kScene + "variant = \"ours\"\n", {"mine.toml:5: [[scene]]: variant", "together with run"});
}

TEST(Suite, AnUnknownNameSaysWhatWasMeant) {
    try {
        find_suite("paper-tabel2");
        FAIL();
    } catch (const UsageError& e) {
        EXPECT_NE(std::string(e.what()).find("did you mean paper-table2?"), std::string::npos) << e.what();
    }
}

}  // namespace
}  // namespace fastscene
