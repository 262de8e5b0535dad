#include "fastscene/panorama/more_panoramas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

class MoreList : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / "fastscene_more_test";
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    std::vector<MorePanorama> read(const std::string& text) {
        write_file(folder_ / "list.json", text);
        return read_more_panoramas(folder_ / "list.json");
    }
    std::string complaint(const std::string& entry) {
        try {
            read("{\"panoramas\": [" + entry + "]}");
        } catch (const Error& e) {
            return e.what();
        }
        return "none";
    }
    fs::path folder_;
};

TEST_F(MoreList, PosesAreMatricesOrPlacesWithAYaw) {
    const auto list = read(R"({"panoramas": [
        {"color": "b.jpg", "position": [1, -0.5, 2], "yaw_deg": 90},
        {"color": "c.jpg", "range": "c.exr",
         "world_from_pano": [[0, 0, 1, 3], [0, 1, 0, 0], [-1, 0, 0, 1], [0, 0, 0, 1]]}]})");
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].color, folder_ / "b.jpg");
    EXPECT_TRUE(list[0].range.empty());
    EXPECT_EQ(list[1].range, folder_ / "c.exr");
    EXPECT_EQ(list[0].world_from_pano.translation, (Vec3f{1, -0.5f, 2}));
    // Yawed right by 90 degrees, forward is where right was; the second entry's matrix says the same.
    for (const MorePanorama& one : list)
        EXPECT_LT(length(one.world_from_pano.rotation * Vec3f{0, 0, 1} - Vec3f{1, 0, 0}), 1e-6f);
}

TEST_F(MoreList, WhatIsNotSoIsNamed) {
    EXPECT_NE(complaint(R"({"position": [0, 0, 0]})").find("panorama 1: expected color"), std::string::npos);
    EXPECT_NE(complaint(R"({"color": "b.jpg"})").find("either world_from_pano or position, found neither"),
              std::string::npos);
    EXPECT_NE(complaint(R"({"color": "b.jpg", "positon": [0, 0, 0]})").find("found positon"), std::string::npos);
    EXPECT_NE(complaint(R"({"color": "b.jpg", "position": [0, 0]})").find("expected 3 numbers"), std::string::npos);
    EXPECT_NE(complaint(R"({"color": "b.jpg", "position": [0, 0, "1"]})").find("expected a number"), std::string::npos);
    EXPECT_NE(complaint(R"({"color": "b.jpg", "position": [0, 5000, 0]})").find("within a kilometre"),
              std::string::npos);
    EXPECT_NE(complaint(R"({"color": "b.jpg", "world_from_pano": [[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]})")
                  .find("a mirror"),
              std::string::npos);
    EXPECT_NE(complaint(R"({"color": "b.jpg", "world_from_pano": [[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]})")
                  .find("other lengths"),
              std::string::npos);
    EXPECT_NE(complaint("3").find("expected an object"), std::string::npos);
    EXPECT_THROW(read("{}"), Error);
    EXPECT_THROW(read("[]"), Error);
    EXPECT_THROW(read("{\"panoramas\": []}"), Error);
}

TEST(FirstOrientation, AYawShiftsTheColumns) {
    const EquirectSize size{64, 32};
    Panorama turned;
    turned.color = ImageColor(size.width, size.height);
    turned.range = ImageF(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            turned.color.at(x, y) = {static_cast<float>(x) / 64, static_cast<float>(y) / 32, 0.5f};
            turned.range.at(x, y) = 1 + static_cast<float>(x);
        }
    turned.world_from_pano.rotation = {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};  // faces right
    turned.world_from_pano.translation = {1, 2, 3};
    const Panorama straight = in_first_orientation(turned, size);
    EXPECT_EQ(straight.world_from_pano.translation, (Vec3f{1, 2, 3}));
    EXPECT_EQ(straight.world_from_pano.rotation, Mat3f{});
    for (int y = 4; y < 28; ++y)
        for (int x = 0; x < size.width; ++x) {
            const int from = wrap_column(x - 16, 64);  // its center is 90 degrees to the right
            EXPECT_EQ(straight.range.at(x, y), turned.range.at(from, y)) << x << ", " << y;
            if (from <= 1 || from >= 62) continue;  // color discontinuities
            EXPECT_LT(length(straight.color.at(x, y) - turned.color.at(from, y)), 0.02f) << x << ", " << y;
        }
}

}  // namespace
}  // namespace fastscene
