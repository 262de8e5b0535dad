// DA-2 as a depth backend, with a small network of random weights.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <utility>

#include "fastscene/depth/estimator.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/nn/hashed_da2.h"
#include "fastscene/weights/safetensors.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

class Da2Backend : public testing::Test {
  protected:
    void SetUp() override {
        save_safetensors(file_, hashed_da2(64, 4, 64));
        params_.weights = file_.string();
    }
    void TearDown() override { fs::remove(file_); }
    const fs::path file_ = fs::temp_directory_path() / ("fastscene-da2-backend-" + std::to_string(::getpid()));
    DepthParams params_;
    const fastscene::Run run_;
};

ImageColor small_picture(EquirectSize size) {
    ImageColor color(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const float v = static_cast<float>(y) / static_cast<float>(size.height);
            color.at(x, y) = x > size.width / 4 && x < size.width / 3 ? Vec3f{0.9f, 0.9f, 1.f} : Vec3f{v, 0.5f, 0.3f};
        }
    return color;
}

TEST_F(Da2Backend, AutoRecognizesItsFile) {
    EXPECT_EQ(depth_backend_of(params_).name, "da2");
    params_.weights = (fs::path(FASTSCENE_SOURCE_DIR) / "models/egformer-rooms.safetensors").string();
    EXPECT_EQ(depth_backend_of(params_).name, "egformer");
}

TEST_F(Da2Backend, WithoutWeightsSaysWhereToGetThem) {
    params_.backend = "da2";
    params_.weights.clear();
    try {
        make_depth_estimator(params_);
        FAIL() << "expected an error";
    } catch (const UsageError& e) {
        EXPECT_NE(std::string(e.what()).find("fastscene models pull da2"), std::string::npos) << e.what();
    }
}

TEST_F(Da2Backend, GivesMetresOfThePicturesSize) {
    const ImageColor picture = small_picture({192, 96});
    for (const auto& [resize, tta] : {std::pair{"evaluation", 0}, std::pair{"inference", 1}}) {
        params_.da2_resize = resize;
        params_.tta = tta;
        const auto estimator = make_depth_estimator(params_);
        const EstimatedRange found = estimator->estimate(picture, run_);
        ASSERT_EQ(found.range.width, picture.width);
        ASSERT_EQ(found.range.height, picture.height);
        for (const float r : found.range.pixels) ASSERT_TRUE(std::isfinite(r) && r > 0) << r;
        EXPECT_EQ(found.assumptions.at("backend"), "da2");
        EXPECT_EQ(found.assumptions.at("resize"), resize);
        EXPECT_EQ(found.assumptions.at("tta"), tta == 0 ? 2 : 1);
        if (tta == 1) {
            EXPECT_EQ(estimator->estimate(picture, run_).range, found.range);
        }
    }
}

}  // namespace
}  // namespace fastscene
