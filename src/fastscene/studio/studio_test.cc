// The studio without a browser: its library, its queue (with a shell script in the program's place), who may ask.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "fastscene/base/file.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/scene/walkable_json.h"
#include "fastscene/studio/api.h"
#include "fastscene/studio/refusal.h"

namespace fastscene::studio {
namespace {

namespace fs = std::filesystem;

class Studio : public testing::Test {
  protected:
    void SetUp() override {
        root = fs::temp_directory_path() / fmt::format("fastscene-studio-{}-{}", ::getpid(),
                                                       testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(root);
        make_directories(root);
    }
    void TearDown() override { fs::remove_all(root); }

    // As a run on disk: what a gallery reads of it.
    void add_scene(const std::string& name, const std::string& prompt = "a bedroom") const {
        make_directories(root / name);
        write_json(root / name / "run.json", {{"prompt", prompt},
                                              {"identity", "x"},
                                              {"contents", Json::object()},
                                              {"seed", 3},
                                              {"quality", "draft"},
                                              {"params", Json::object()}});
    }
    // A program in place of fastscene: it tells of progress, writes a panorama, and does what its prompt says.
    fs::path program() const {
        const fs::path file = root / ".program";
        write_file(file, std::string_view(R"(#!/bin/sh
verb=$1; all="$*"
for argument; do [ "$last" = -o ] && out=$argument; last=$argument; done
mkdir -p "$out/panorama"
case $all in *fails*) echo "fastscene: no room for a whale" >&2; exit 1;; esac
[ "$verb" = panorama ] && { echo png > "$out/panorama/color.png"; exit 0; }
echo "$$" >> "$out/starts"
echo '{"event":"progress","work":"panorama: light","done":1,"total":2,"overall":0.25,"seconds_left":9}' >&2
echo '{"event":"warning","text":"not understood: kraken"}' >&2
trap 'exit 143' TERM
case $all in *forever*) [ -e "$out/go" ] || while :; do sleep 0.05; done;; esac
echo '{}' > "$out/run.json"
)"));
        fs::permissions(file, fs::perms::owner_all);
        return file;
    }

    fs::path root;
};

template <class Condition>
bool soon(const Condition& condition) {
    for (int i = 0; i < 400; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(25));
    }
    return false;
}

// ---- the library

TEST_F(Studio, NamesOfScenesAreSingleVisibleFolders) {
    for (const char* good : {"bedroom", "a b", "büro", "x.y", "-"}) EXPECT_TRUE(is_scene_name(good)) << good;
    for (const std::string& bad :
         {std::string(""), std::string("."), std::string(".."), std::string(".studio"), std::string("a/b"),
          std::string("a\\b"), std::string("a\0b", 3), std::string(201, 'a')})
        EXPECT_FALSE(is_scene_name(bad)) << bad;
}

TEST_F(Studio, NoPathLeavesAScene) {
    Library library(root);
    add_scene("bedroom");
    add_scene("other");
    make_directories(root / "bedroom/panorama");
    write_file(root / "bedroom/panorama/color.png", std::string_view("png"));
    write_file(root / "secret", std::string_view("secret"));
    fs::create_symlink(root / "secret", root / "bedroom/link.txt");
    fs::create_directory_symlink(root / "other", root / "bedroom/folder");
    fs::create_directory_symlink(root / "other", root / "linked");
    EXPECT_TRUE(library.file("bedroom", "panorama/color.png"));
    for (const char* path : {"../secret", "../other/run.json", "panorama/../run.json", "/etc/passwd", "", ".",
                             "link.txt", "folder/run.json", "panorama", "panorama//color.png/..", "..\\secret"})
        EXPECT_FALSE(library.file("bedroom", path)) << path;
    EXPECT_FALSE(library.file("linked", "run.json"));
    EXPECT_FALSE(library.file("..", "etc/passwd"));
    EXPECT_FALSE(library.file(".studio", "jobs"));
    EXPECT_THROW(library.folder("linked"), Refusal);
}

TEST_F(Studio, OneStudioAFolder) {
    const Library first(root);
    EXPECT_THROW(Library{root}, Error);
}

TEST_F(Studio, DeletedScenesComeBackBesideNewOnes) {
    Library library(root);
    add_scene("bedroom");
    EXPECT_EQ(library.scenes().size(), 1u);
    const std::string trashed = library.remove("bedroom");
    EXPECT_EQ(library.scenes().size(), 0u);
    EXPECT_EQ(library.reserve("Bedroom"), "bedroom-2");  // the name is kept for the one in the trash
    add_scene("bedroom");
    EXPECT_EQ(library.restore(trashed), "bedroom-3");
    EXPECT_THROW(library.restore(trashed), Refusal);
    EXPECT_THROW(library.restore("../bedroom"), Refusal);
    EXPECT_TRUE(fs::exists(root / "bedroom-3/run.json"));
}

TEST_F(Studio, ADamagedSceneHidesNoOther) {
    Library library(root);
    add_scene("good", "an attic");
    add_scene("bad");
    write_file(root / "bad/run.json", std::string_view("{\"seed\": \"x\", "));
    make_directories(root / "good/metrics");
    write_json(root / "good/metrics/report.json", {{"truth", {{"psnr_mean", 31.5}}}});
    const Json scenes = library.scenes();
    ASSERT_EQ(scenes.size(), 2u);
    EXPECT_EQ(library.scene("good").at("psnr"), 31.5);
    EXPECT_EQ(library.scene("good").at("title"), "an attic");
    EXPECT_EQ(library.scene("bad").at("title"), "bad");
}

// ---- jobs

TEST_F(Studio, ALogTellsOfProgressWarningsAndTheError) {
    Job job;
    for (const char* line :
         {R"({"event":"progress","work":"splat: training","done":1,"total":4,"overall":0.6,"seconds_left":12.5})",
          R"({"event":"warning","text":"w"})", R"({"event":"warning","text":"w"})", "[1,2]", "noise",
          "fastscene: disk full"})
        read_line_of_log(line, job);
    EXPECT_EQ(job.work, "splat: training");
    EXPECT_DOUBLE_EQ(job.overall, 0.6);
    EXPECT_DOUBLE_EQ(job.seconds_left, 12.5);
    EXPECT_EQ(job.warnings, std::vector<std::string>{"w"});
    EXPECT_EQ(job.error, "disk full");
    const Job again = job_from_record(record_of_job(job), "x.json");
    EXPECT_EQ(record_of_job(again), record_of_job(job));
    EXPECT_THROW(job_from_record(Json{{"id", 3}}, "x.json"), Error);
}

struct Running {
    Library library;
    Board board;
    Api api;
    Running(const fs::path& root, const fs::path& program) : library(root), api(library, board, {program, {}, 0}) {}

    Json post(std::vector<std::string> path, const Json& body = Json::object()) {
        return api.answer({"POST", std::move(path), body}).json;
    }
    int status(std::vector<std::string> path, const Json& body = Json::object()) {
        return api.answer({"POST", std::move(path), body}).status;
    }
    std::string make(const std::string& prompt) {
        return post({"jobs"}, {{"prompt", prompt}, {"quality", "draft"}})["id"];
    }
    Json job(const std::string& id) {
        const Json live = api.live();
        for (const Json& job : live["jobs"])
            if (job["id"] == id) return job;
        return {};
    }
    bool reaches(const std::string& id, const std::string& state) {
        return soon([&] { return job(id).is_object() && job(id)["state"] == state; });
    }
};

TEST_F(Studio, AJobShowsAFirstPictureThenProgressAndIsFinished) {
    Running studio(root, program());
    const std::string id = studio.make("a bedroom forever");
    ASSERT_TRUE(soon([&] { return studio.job(id)["overall"] == 0.25; }));
    EXPECT_EQ(studio.job(id)["work"], "panorama: light");
    EXPECT_EQ(studio.job(id)["warnings"][0], "not understood: kraken");
    EXPECT_EQ(studio.job(id)["picture"], "look");
    EXPECT_EQ(studio.status({"scenes", id, "delete"}), 409);
    EXPECT_EQ(studio.status({"jobs", id, "forget"}), 409);
    studio.post({"jobs", id, "stop"});
    ASSERT_TRUE(studio.reaches(id, "stopped"));
    write_file(root / id / "go", std::string_view("1"));
    studio.post({"jobs", id, "resume"});
    ASSERT_TRUE(studio.reaches(id, "finished"));
    EXPECT_TRUE(studio.api.has_scene(id));
    EXPECT_FALSE(fs::exists(root / ".studio/jobs" / (id + ".json")));
}

TEST_F(Studio, AFailureSaysWhyAndLeavesTheOthers) {
    Running studio(root, program());
    const std::string bad = studio.make("a bedroom that fails"), good = studio.make("a bedroom");
    ASSERT_TRUE(studio.reaches(bad, "failed"));
    EXPECT_EQ(studio.job(bad)["error"], "no room for a whale");
    ASSERT_TRUE(studio.reaches(good, "finished"));
    EXPECT_EQ(studio.status({"jobs", bad, "forget"}), 200);
    EXPECT_EQ(studio.status({"jobs", bad, "forget"}), 404);
}

TEST_F(Studio, AStudioThatEndsLeavesItsJobsToTheNext) {
    std::string id;
    {
        Running studio(root, program());
        id = studio.make("a bedroom forever");
        ASSERT_TRUE(soon([&] { return studio.job(id)["overall"] == 0.25; }));
    }
    write_file(root / id / "go", std::string_view("1"));
    Running studio(root, program());
    ASSERT_TRUE(studio.reaches(id, "finished"));
}

// ---- what pages may ask

TEST_F(Studio, WhatCannotBeIsRefusedInWords) {
    Running studio(root, program());
    EXPECT_EQ(studio.status({"nothing"}), 404);
    EXPECT_EQ(studio.status({"jobs"}, Json::array()), 400);
    EXPECT_EQ(studio.status({"jobs"}, {{"prompt", ""}}), 422);
    EXPECT_EQ(studio.status({"jobs"}, {{"prompt", "a room"}, {"quality", "best"}}), 422);
    EXPECT_EQ(studio.status({"jobs"}, {{"prompt", "a room"}, {"seed", -1}}), 400);
    EXPECT_EQ(studio.status({"jobs"}, {{"prompt", 7}}), 400);
    EXPECT_EQ(studio.status({"jobs"}, {{"panorama", "../../etc/passwd"}}), 404);
    EXPECT_EQ(studio.status({"scenes", "..", "delete"}), 404);
    EXPECT_EQ(studio.api.answer({"GET", {"scenes", "nowhere"}, {}}).status, 404);
    EXPECT_EQ(studio.api.answer({"GET", {"state"}, {}}).json["jobs"].size(), 0u);
    EXPECT_EQ(std::distance(fs::directory_iterator(root), {}), 2);  // .studio and the program: nothing was made
}

TEST_F(Studio, APromptIsWordsWhateverItLooksLike) {
    Running studio(root, program());
    const std::string id = studio.make("--force <b>bedroom</b> forever");
    const std::string command = studio.job(id)["request"]["command"];
    EXPECT_TRUE(command.ends_with("-- '--force <b>bedroom</b> forever'")) << command;
    EXPECT_EQ(id, "force-b-bedroom-b-forever");
}

TEST_F(Studio, ASentenceIsReadAndPlanned) {
    Running studio(root, program());
    const Json plan = studio.post({"plan"}, {{"prompt", "a bedroom with a red armchair and a kraken"}, {"seed", 1}});
    const auto fate = [&](const std::string& words) {
        for (const Json& word : plan["words"])
            if (word["words"] == words) return word["fate"].get<std::string>();
        return std::string();
    };
    EXPECT_EQ(fate("armchair"), "understood");
    EXPECT_EQ(fate("kraken"), "not_understood");
    EXPECT_GT(plan["view"]["width"], 2);
    bool seen = false;
    for (const Json& thing : plan["view"]["things"])
        seen = seen || (thing["kind"] == "armchair" && thing["asked"] && thing["color"].get<std::string>().size() == 7);
    EXPECT_TRUE(seen);
    EXPECT_EQ(studio.status({"plan"}, {{"prompt", std::string(3000, 'a')}}), 422);
}

TEST_F(Studio, AFilmHasAPathThatCanBeChanged) {
    add_scene("hall");
    Running studio(root, program());
    const auto film = [&](const std::string& what, const Json& body) {
        return studio.api.answer({"POST", {"scenes", "hall", "film", what}, body});
    };
    EXPECT_EQ(studio.api.answer({"GET", {"scenes", "hall", "film"}, {}}).status, 409);  // no splats
    const RunFolder folder{root / "hall"};
    Splats splats;
    splats.resize(1);
    make_directories(folder.scene_ply().parent_path());
    make_directories(folder.walk());
    save_splat_ply(folder.scene_ply(), splats);
    write_json(folder.walkable_json(), walkable_json({{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}}, -0.3f, 0.4f, 1.5f}));
    const ApiAnswer tour = studio.api.answer({"GET", {"scenes", "hall", "film"}, {}});
    ASSERT_EQ(tour.status, 200) << tour.json.dump();
    EXPECT_GE(tour.json["path"]["keys"].size(), 2u);
    EXPECT_EQ(tour.json["rings"][0].size(), 4u);
    EXPECT_TRUE(tour.json["made"].is_null());

    Json path = tour.json["path"];
    path["keys"] = Json::parse(R"([{"time_s": 0, "position_m": [0, 0, 0], "yaw_deg": 0, "pitch_deg": 0},
                                   {"time_s": 4, "position_m": [0, 0, 4], "yaw_deg": 90, "pitch_deg": 0}])");
    const ApiAnswer drawn = film("path", {{"path", path}});
    ASSERT_EQ(drawn.status, 200) << drawn.json.dump();
    EXPECT_EQ(drawn.json["track"].front()[2], true);
    EXPECT_EQ(drawn.json["track"].back()[2], false);  // outside of the floor: said, not refused
    EXPECT_EQ(studio.api.answer({"GET", {"scenes", "hall", "film"}, {}}).json["path"]["keys"].size(), 2u);
    EXPECT_FALSE(film("frame", {{"time_s", 1}, {"width", 32}}).json["jpeg"].get<std::string>().empty());

    // Out to each program and back is the same path.
    for (const char* const format : {"fastscene", "nerfstudio", "blender", "supersplat"}) {
        const ApiAnswer file = studio.api.answer({"GET", {"scenes", "hall", "film", format}, {}});
        ASSERT_EQ(file.status, 200) << format;
        const ApiAnswer again = film("read", {{"text", read_file(file.file)}});
        ASSERT_EQ(again.status, 200) << format << again.json.dump();
        EXPECT_NEAR(again.json["path"]["keys"].back()["position_m"][2].get<float>(), 4, 1e-3) << format;
    }
    EXPECT_EQ(film("read", {{"text", "no path"}}).status, 422);
    EXPECT_EQ(film("path", {{"path", {{"keys", Json::array()}}}}).status, 422);
    EXPECT_EQ(film("plan", {{"kind", "flight"}}).status, 422);
    EXPECT_EQ(film("make", {{"ending", "exe"}}).status, 400);
    EXPECT_EQ(studio.api.answer({"GET", {"scenes", "hall", "film", "made"}, {}}).status, 404);
    EXPECT_EQ(studio.status({"scenes", "..", "film", "path"}, {{"path", path}}), 404);
}

TEST_F(Studio, UploadsAreWhatTheirBytesAre) {
    Running studio(root, program());
    const auto send = [&](const std::string& kind, const std::string& name, const std::string& bytes) {
        return studio.api.upload(kind, name, [&](const Uploads::Put& put) { return put(bytes); });
    };
    const ApiAnswer html = send("panorama", "room.jpg", "<html><script>alert(1)</script></html>");
    EXPECT_EQ(html.status, 422);
    EXPECT_NE(html.json["error"].get<std::string>().find("room.jpg"), std::string::npos) << html.json;
    EXPECT_EQ(send("range", "range.exr", "no map").status, 422);
    EXPECT_EQ(send("panorama", "empty.png", "").status, 400);
    const std::string piece(1 << 20, 'x');
    int pieces = 0;
    const ApiAnswer large = studio.api.upload("panorama", "large.png", [&](const Uploads::Put& put) {
        while (put(piece)) ++pieces;
        return false;
    });
    EXPECT_EQ(large.status, 413);
    EXPECT_EQ(pieces, kMostUploadBytes >> 20);
    EXPECT_TRUE(fs::is_empty(root / ".studio/uploads"));
}

}  // namespace
}  // namespace fastscene::studio
