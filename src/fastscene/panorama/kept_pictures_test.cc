#include "fastscene/panorama/kept_pictures.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

class Kept : public testing::Test {
  protected:
    void SetUp() override { fs::remove_all(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    ImageRgb8 get(const std::string& key, std::uint8_t shade) {
        return KeptPictures(folder_).get("1", key, [&] { return ++made_, ImageRgb8(8, 4, {shade, 2, 3}); }).picture;
    }
    fs::path folder_ = fs::temp_directory_path() / ("fastscene_kept_test_" + std::to_string(::getpid()));
    int made_ = 0;
};

TEST_F(Kept, UnderTheSameKeyItIsMadeOnce) {
    const ImageRgb8 first = get("a", 10);
    EXPECT_EQ(get("a", 20), first);
    EXPECT_EQ(made_, 1);
    EXPECT_NE(get("b", 20), first);
    EXPECT_NE(get("a", 30), first) << "the other key's picture has taken its place";
    EXPECT_EQ(made_, 3);
}

TEST_F(Kept, WhatIsDamagedIsMadeAgain) {
    const ImageRgb8 first = get("a", 10);
    const std::string bytes = read_file(folder_ / "1.png");
    write_file(folder_ / "1.png", bytes.substr(0, bytes.size() / 2));
    EXPECT_EQ(get("a", 10), first);
    EXPECT_EQ(made_, 2);
    write_file(folder_ / "1.json", std::string_view("{\"key\": 7"));
    EXPECT_EQ(get("a", 10), first);
    fs::remove(folder_ / "1.png");
    EXPECT_EQ(get("a", 10), first);
    EXPECT_EQ(made_, 4);
}

TEST_F(Kept, WithoutAFolderNothingIs) {
    EXPECT_FALSE(KeptPictures(fs::path()).get("1", "a", [] { return ImageRgb8(8, 4); }).was_there);
    EXPECT_FALSE(KeptPictures(fs::path()).get("1", "a", [] { return ImageRgb8(8, 4); }).was_there);
    EXPECT_THROW(KeptPictures(folder_).get("1", "a", []() -> ImageRgb8 { throw Error("no paint"); }), Error);
    EXPECT_FALSE(fs::exists(folder_));
}

}  // namespace
}  // namespace fastscene
