#include "fastscene/base/file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "fastscene/base/error.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/json.h"
#include "fastscene/base/writable.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// A new empty folder for each test.
class File : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(::testing::TempDir()) /
                  (std::string("fastscene-file-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder_);
        make_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    static std::string complaint(const std::function<void()>& act) {
        try {
            act();
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    }
    fs::path folder_;
};

// A pipe without a writer would block, and a device has no end.
TEST_F(File, OnlyFilesAreRead) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    EXPECT_NE(complaint([&] { read_file(folder_ / "pipe"); }).find("pipe: cannot be read: expected a file"),
              std::string::npos);
    EXPECT_NE(complaint([] { read_file("/dev/zero"); }).find("/dev/zero: cannot be read: expected a file"),
              std::string::npos);
}

TEST_F(File, WritesWhatItReads) {
    std::string bytes("a\0b\n", 4);
    write_file(folder_ / "x", bytes);
    EXPECT_EQ(read_file(folder_ / "x"), bytes);
    write_file(folder_ / "x", "");
    EXPECT_EQ(read_file(folder_ / "x"), "");
}

TEST_F(File, PiecesFollowOneAnother) {
    write_pieces(folder_ / "x", [](const auto& put) {
        for (const char* piece : {"one ", "", "two"}) put(piece);
    });
    EXPECT_EQ(read_file(folder_ / "x"), "one two");
    EXPECT_EQ(complaint([&] {
                  write_pieces(folder_ / "x", [](const auto& put) {
                      put("half");
                      throw Error("no more");
                  });
              }),
              "no more");
    EXPECT_EQ(read_file(folder_ / "x"), "one two");
}

TEST_F(File, LeavesNoTemporaryBehind) {
    write_file(folder_ / "x", "1");
    complaint([&] {
        write_renamed(folder_ / "y", [](const fs::path& temporary) {
            std::ofstream(temporary) << "half";
            throw Error("no more");
        });
    });
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_)) ++count;
    EXPECT_EQ(count, 1u);
}

TEST_F(File, ErrorsNameThePath) {
    const fs::path absent = folder_ / "absent";
    EXPECT_NE(complaint([&] { read_file(absent); }).find(absent.string()), std::string::npos);
    EXPECT_NE(complaint([&] { read_file(folder_); }).find("found a directory"), std::string::npos);
    EXPECT_NE(complaint([&] { write_file(absent / "deep", "x"); }).find((absent / "deep").string()), std::string::npos);
    write_file(folder_ / "file", "x");
    EXPECT_NE(complaint([&] { make_directories(folder_ / "file" / "below"); }).find("file/below"), std::string::npos);
    EXPECT_NE(complaint([&] { make_directories(folder_ / "file"); }), "");
}

TEST_F(File, WhatCannotBeWrittenIsKnownBeforehand) {
    check_writable(folder_ / "x");
    EXPECT_TRUE(fs::is_empty(folder_));
    write_file(folder_ / "x", "old");
    check_writable(folder_ / "x");
    EXPECT_EQ(read_file(folder_ / "x"), "old");
    EXPECT_NE(complaint([&] { check_writable(folder_ / "none" / "x"); }).find("none/x: cannot be written: No such"),
              std::string::npos);
    EXPECT_NE(complaint([&] { check_writable(folder_); }).find("found a folder"), std::string::npos);
}

TEST_F(File, NamesMayBeAsLongAsTheFileSystemTakes) {
    const fs::path longest = folder_ / std::string(255, 'n'), twin = folder_ / (std::string(254, 'n') + 'm');
    check_writable(longest);
    write_file(longest, "one");
    write_pieces(twin, [&](const auto& put) {
        put("two");
        write_file(longest, "three");  // no two share a temporary name
    });
    EXPECT_EQ(read_file(longest) + read_file(twin), "threetwo");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);
}

TEST_F(File, OfSeveralWritersOneWinsWhole) {
    std::vector<std::thread> writers;
    for (int i = 0; i < 4; ++i)
        writers.emplace_back([&, i] {
            for (int round = 0; round < 200; ++round)
                write_file(folder_ / "x", std::string(5000, static_cast<char>('a' + i)));
        });
    for (std::thread& writer : writers) writer.join();
    const std::string text = read_file(folder_ / "x");
    EXPECT_EQ(text, std::string(5000, text.front()));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

// A file size limit simulates a full disk: the write fails half-way with an error.
TEST_F(File, AFullDiskIsAnErrorAndKeepsTheOldFile) {
    write_file(folder_ / "x", "old");
    rlimit old_limit{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{4096, old_limit.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string text = complaint([&] { write_file(folder_ / "x", std::string(100'000, 'n')); });
    ::setrlimit(RLIMIT_FSIZE, &old_limit);
    std::signal(SIGXFSZ, old_handler);
    EXPECT_NE(text.find((folder_ / "x").string()), std::string::npos) << text;
    EXPECT_EQ(read_file(folder_ / "x"), "old");
}

TEST_F(File, BrokenJsonNamesFileAndByte) {
    write_file(folder_ / "x.json", "{\"a\": 1,, }");
    const std::string text = complaint([&] { read_json(folder_ / "x.json"); });
    EXPECT_NE(text.find("x.json"), std::string::npos);
    write_file(folder_ / "x.json", "{\"a\": [1e400]}");
    const std::string large = complaint([&] { read_json(folder_ / "x.json"); });
    EXPECT_NE(large.find("x.json: expected numbers"), std::string::npos) << large;
    EXPECT_NE(text.find("byte 9"), std::string::npos) << text;
}

TEST_F(File, JsonComesBackWithItsOrderAndItsFloats) {
    const float third = 1.f / 3.f;
    write_json(folder_ / "x.json", {{"z", third}, {"a", 2}});
    const Json json = read_json(folder_ / "x.json");
    EXPECT_EQ(json.at("z").get<float>(), third);
    EXPECT_EQ(json.begin().key(), "z");
}

TEST(Hash, HangsOnEveryByteOrderAndBoundary) {
    EXPECT_EQ(Hash().add("abc").hex(), Hash().add("abc").hex());
    EXPECT_EQ(Hash().hex().size(), 32u);
    EXPECT_NE(Hash().add("ab").add("c").hex(), Hash().add("a").add("bc").hex());
    EXPECT_NE(Hash().add("a").add("b").hex(), Hash().add("b").add("a").hex());
    EXPECT_NE(Hash().add("").hex(), Hash().hex());
    std::string bytes(1000, 'x');
    const std::string before = Hash().add(bytes).hex();
    for (const std::size_t i : {0u, 7u, 8u, 500u, 999u}) {
        std::string changed = bytes;
        changed[i] ^= 1;
        EXPECT_NE(Hash().add(changed).hex(), before) << i;
    }
}

}  // namespace
}  // namespace fastscene
