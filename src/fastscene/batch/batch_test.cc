#include "fastscene/batch/batch.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <set>

#include "fastscene/base/file.h"
#include "fastscene/batch/index_page.h"
#include "fastscene/batch/manifest.h"
#include "fastscene/batch/workspace.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

class Batch : public ::testing::Test {
  protected:
    void SetUp() override { fs::remove_all(folder_), fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path write(const std::string& name, const std::string& text) {
        write_file(folder_ / name, std::string_view(text));
        return folder_ / name;
    }
    // A program in place of fastscene, which gets its arguments.
    fs::path program(const std::string& script) {
        const fs::path file = write("program", "#!/bin/bash\n" + script);
        fs::permissions(file, fs::perms::owner_all);
        return file;
    }
    fs::path folder_ = fs::temp_directory_path() / ("fastscene_batch_" + std::to_string(::getpid()));
};

TEST_F(Batch, ListsOfPromptsAreRead) {
    const SceneList list = read_scene_list(write("list.txt", "a red room\n\n# not this\n  a blue room\r\n"), 7);
    EXPECT_TRUE(list.problems.empty());
    ASSERT_EQ(list.scenes.size(), 2u);
    EXPECT_EQ(list.scenes[0].name, "00000-a-red-room");
    EXPECT_EQ(list.scenes[1].seed, 8u);
    EXPECT_EQ(list.scenes[1].prompt, "  a blue room");
}

TEST_F(Batch, LinesThatGiveNoSceneAreNamedAndTheRestGoesOn) {
    const SceneList list = read_scene_list(
        write("list.jsonl",
              "{\"prompt\": \"a room\", \"seed\": 3, \"name\": \"one\"}\n"
              "{\"promt\": \"a room\"}\n"
              "a room\n"
              "{\"prompt\": \"a room\", \"name\": \"one\"}\n"
              "{\"prompt\": \"a room\", \"name\": \"../up\"}\n"
              "{\"prompt\": \"a room\", \"seed\": -1}\n"
              "{\"prompt\": \" \"}\n"
              "{\"prompt\": \"a hall\", \"quality\": \"high\", \"flags\": [\"--x\"]}\n"),
        0);
    ASSERT_EQ(list.scenes.size(), 2u);
    EXPECT_EQ(list.scenes[0].seed, 3u);
    EXPECT_EQ(list.scenes[1].quality, "high");
    EXPECT_EQ(list.scenes[1].flags, std::vector<std::string>{"--x"});
    ASSERT_EQ(list.problems.size(), 6u);
    EXPECT_NE(list.problems[0].find("list.jsonl:2: "), std::string::npos) << list.problems[0];
    EXPECT_NE(list.problems[0].find("\"promt\""), std::string::npos) << list.problems[0];
    EXPECT_NE(list.problems[2].find("\"one\", the name in line 1"), std::string::npos) << list.problems[2];
    EXPECT_THROW(read_scene_list(folder_ / "none.txt", 0), Error);
    EXPECT_THROW(read_scene_list(folder_, 0), Error);
}

TEST_F(Batch, MadeUpPromptsDifferAndKeepTheirOrder) {
    const SceneList few = varied_scenes(40, 1), many = varied_scenes(2000, 1);
    std::set<std::string> prompts, names;
    for (const BatchScene& s : many.scenes) prompts.insert(s.prompt), names.insert(s.name);
    EXPECT_EQ(prompts.size(), 2000u);
    EXPECT_EQ(names.size(), 2000u);
    for (std::size_t i = 0; i < few.scenes.size(); ++i) EXPECT_EQ(few.scenes[i].prompt, many.scenes[i].prompt);
    EXPECT_NE(varied_scenes(40, 2).scenes[0].prompt, few.scenes[0].prompt);
}

TEST_F(Batch, ScenesFailAloneAreTriedAgainAndDoneOnesStayDone) {
    // Fails always for "bad", once for "weak", and counts what it is called for.
    BatchParams params;
    params.program = program(R"(
echo "$2" >> )" + (folder_ / "calls").string() +
                             R"(
case "$2" in
  bad) echo "fastscene: no such luck" >&2; exit 1 ;;
  weak) [ -e )" + (folder_ / "weak_once").string() +
                             R"( ] || { touch )" + (folder_ / "weak_once").string() + R"(; exit 1; } ;;
esac
)");
    params.jobs = 2;
    const std::vector<BatchScene> scenes{{"a", "good", 0, {}, {}}, {"b", "bad", 1, {}, {}}, {"c", "weak", 2, {}, {}}};
    const auto calls = [&] {
        std::multiset<std::string> out;
        std::ifstream in(folder_ / "calls");
        for (std::string line; std::getline(in, line);) out.insert(line);
        return out;
    };
    const fs::path out = folder_ / "out";
    run_batch(scenes, out, params, fastscene::Run{});
    EXPECT_EQ(calls(), (std::multiset<std::string>{"good", "bad", "bad", "weak", "weak"}));
    Json status = batch_status(out);
    EXPECT_EQ(status["done"], 2);
    EXPECT_EQ(status["failed"], 1);
    EXPECT_EQ(status["failures"][0]["error"], "no such luck");

    // What failed is tried again, nothing else; other settings make all anew.
    fs::remove(folder_ / "calls");
    run_batch(scenes, out, params, fastscene::Run{});
    EXPECT_EQ(calls(), (std::multiset<std::string>{"bad", "bad"}));
    fs::remove(folder_ / "calls");
    params.flags = {"--views-size", "64"};
    run_batch(scenes, out, params, fastscene::Run{});
    EXPECT_EQ(calls().size(), 4u);
}

// Processes of a batch that was killed finish their scenes; the next batch waits for them.
TEST_F(Batch, AScenesOtherProcessIsWaitedFor) {
    BatchParams params;
    params.tries = 1;
    params.program = program("[ -e " + (folder_ / "free").string() + " ] || { touch " + (folder_ / "free").string() +
                             "; echo 'fastscene: a: another fastscene is working on this folder' >&2; exit 1; }");
    const auto records = run_batch({{"a", "a room", 0, {}, {}}}, folder_ / "out", params, fastscene::Run{});
    EXPECT_TRUE(records[0].done);
    EXPECT_EQ(records[0].tries, 1);
}

TEST_F(Batch, AWrongRequestIsTriedOnce) {
    BatchParams params;
    params.program = program("echo x >> " + (folder_ / "calls").string() +
                             "; echo 'fastscene: --x: unknown' >&2; exit 2");
    run_batch({{"a", "a room", 0, {}, {"--x"}}}, folder_ / "out", params, fastscene::Run{});
    EXPECT_EQ(read_file(folder_ / "calls"), "x\n");
    EXPECT_EQ(batch_status(folder_ / "out")["failures"][0]["error"], "--x: unknown");
}

TEST_F(Batch, AJournalThatWasCutShortIsReadUpToThere) {
    {
        BatchJournal journal(folder_);
        journal.add({"a", "x", "k", true, 1, 2.5, {}});
        journal.add({"b", "y", "k", false, 2, 1, "an error"});
        journal.add({"b", "y", "k", true, 1, 1, {}});
    }
    std::ofstream(folder_ / "batch.jsonl", std::ios::app) << "{\"name\": \"c\", \"pro";
    {
        BatchJournal journal(folder_);
        ASSERT_EQ(journal.records().size(), 2u);
        EXPECT_TRUE(journal.find("b")->done);
        journal.add({"c", "z", "k", true, 1, 1, {}});
    }
    EXPECT_EQ(BatchJournal(folder_).records().size(), 3u);
    std::ofstream(folder_ / "batch.jsonl", std::ios::app) << "nonsense\n";
    EXPECT_THROW(BatchJournal{folder_}, Error);
}

// A file size limit simulates a full disk.
TEST_F(Batch, AFullDiskLeavesNoHalfLineInAJournal) {
    BatchJournal journal(folder_);
    journal.add({"a", "x", "k", true, 1, 2.5, {}});
    const auto whole = fs::file_size(folder_ / "batch.jsonl");
    rlimit old_limit{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{whole + 10, old_limit.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    EXPECT_THROW(journal.add({"b", "y", "k", true, 1, 1, {}}), Error);
    ::setrlimit(RLIMIT_FSIZE, &old_limit);
    std::signal(SIGXFSZ, old_handler);
    EXPECT_EQ(fs::file_size(folder_ / "batch.jsonl"), whole);
    journal.add({"c", "z", "k", true, 1, 1, {}});
    EXPECT_EQ(BatchJournal(folder_).records().size(), 2u);
}

// Chunks share nothing but the folder; what they tell comes together, and is asked no second time.
TEST_F(Batch, ChunksMakeTheScenesThatAreLeft) {
    BatchParams params;
    params.flags = {"--views-size", "64"};
    params.program = program("echo \"$2\" >> " + (folder_ / "calls").string() +
                             "; [ \"$2\" != bad ] || { echo 'fastscene: no such luck' >&2; exit 1; }");
    const std::vector<BatchScene> scenes{
        {"a", "one", 0, {}, {}}, {"b", "two", 1, "draft", {"--x"}}, {"c", "bad", 2, {}, {}}, {"d", "four", 3, {}, {}}};
    const fs::path out = folder_ / "out";
    EXPECT_EQ(prepare_chunks(scenes, out, params, 3).chunks(), 2);
    EXPECT_EQ(run_chunk(out, 1, params, fastscene::Run{}).size(), 1u);
    EXPECT_EQ(read_file(folder_ / "calls"), "four\n");
    const auto records = run_chunk(out, 0, params, fastscene::Run{});
    ASSERT_EQ(records.size(), 3u);
    EXPECT_TRUE(records[1].done);
    EXPECT_FALSE(records[2].done);
    EXPECT_EQ(read_file(folder_ / "calls"), "four\none\ntwo\nbad\nbad\n");
    EXPECT_THROW(run_chunk(out, 2, params, fastscene::Run{}), UsageError);
    const Json status = batch_status(out);
    EXPECT_EQ(status["done"], 3);
    EXPECT_EQ(status["failed"], 1);
    EXPECT_EQ(status["total"], 4);

    // A chunk that is called again makes what is missing; so does a new plan.
    fs::remove(folder_ / "calls");
    run_chunk(out, 0, params, fastscene::Run{});
    EXPECT_EQ(read_file(folder_ / "calls"), "bad\nbad\n");
    const ChunkPlan plan = prepare_chunks(scenes, out, params, 1);
    EXPECT_EQ(plan.scenes, 1);
    EXPECT_FALSE(fs::exists(out / "tasks" / "000000.jsonl"));
    EXPECT_EQ(read_chunk(out, 0).scenes[0].name, "c");
    EXPECT_EQ(read_chunk(out, 0).params.flags, params.flags);

    Json settings = read_json(out / "batch.json");
    settings["version"] = "0.0.1";
    write_json(out / "batch.json", settings);
    EXPECT_THROW(run_chunk(out, 0, params, fastscene::Run{}), Error);
}

TEST_F(Batch, ChunksStayWithinTheArray) {
    std::vector<BatchScene> scenes;
    for (int i = 0; i < 10; ++i) scenes.push_back({std::to_string(i), "a room", 0, {}, {}});
    BatchParams params;
    EXPECT_EQ(write_manifest(scenes, folder_, params, 0, 100).chunks(), 10);
    const ChunkPlan plan = write_manifest(scenes, folder_, params, 0, 4);
    EXPECT_EQ(plan.of_chunk, 3);
    EXPECT_EQ(plan.chunks(), 4);
    EXPECT_EQ(read_chunk(folder_, 3).scenes.size(), 1u);
    EXPECT_THROW(write_manifest(scenes, folder_, params, 2, 4), UsageError);
}

TEST_F(Batch, AScratchFolderKeepsWhatIsUnfinishedAndLeavesNothing) {
    const fs::path home = folder_ / "set" / "a", scratch = folder_ / "scratch";
    fs::create_directories(home);
    write_file(home / "old", std::string_view("1"));
    {
        Workspace space(home, scratch);
        EXPECT_EQ(read_file(space.path() / "old"), "1");
        write_file(space.path() / "new", std::string_view("2"));
        EXPECT_FALSE(fs::exists(home / "new"));
    }
    // That process was killed; the next one on this machine finds what it had.
    Workspace space(home, scratch);
    EXPECT_TRUE(fs::exists(space.path() / "new"));
    space.bring_home();
    EXPECT_EQ(read_file(home / "new"), "2");
    EXPECT_TRUE(fs::is_empty(scratch));
    EXPECT_EQ(std::distance(fs::directory_iterator(home.parent_path()), fs::directory_iterator()), 1);

    EXPECT_EQ(Workspace(home, {}).path(), home);
}

TEST_F(Batch, NoPromptBecomesMarkup) {
    save_index({{"a", "</script><script>alert(1)</script>", "k", true, 1, 1, {}}}, folder_);
    const std::string page = read_file(folder_ / "index.html");
    EXPECT_EQ(page.find("<script>alert"), std::string::npos);
    EXPECT_NE(page.find("\\u003cscript>alert"), std::string::npos);
}

}  // namespace
}  // namespace fastscene
