// Runs that are broken on purpose.
#include "fastscene/pipeline/health.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fastscene/base/file.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

struct Warnings : EventSink {
    std::vector<std::string> texts;
    void tell(const Event& event) override {
        if (const auto* warning = std::get_if<WarningEvent>(&event)) texts.push_back(warning->text);
    }
};

class Health : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_.root = fs::path(::testing::TempDir()) /
                       (std::string("fastscene-health-") +
                        ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder_.root);
        for (const char* name : {"panorama", "depth", "splat"}) make_directories(folder_.root / name);
        save_png(folder_.panorama_color(), picture());
        save_exr(folder_.depth_range(), ImageF(64, 32, 2.f));
        save_splat_ply(folder_.scene_ply(), ball());
    }
    void TearDown() override { fs::remove_all(folder_.root); }

    static ImageRgb8 picture() {
        ImageRgb8 out(64, 32);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 64; ++x)
                out.at(x, y) = {static_cast<std::uint8_t>(40 + 2 * x), static_cast<std::uint8_t>(60 + 3 * y), 90};
        return out;
    }
    // Opaque splats all around, of many colors.
    static Splats ball() {
        Splats s;
        constexpr int kRings = 24;
        s.resize(2 * kRings * kRings);
        for (std::size_t i = 0; i < s.size(); ++i) {
            const float lat = (static_cast<float>(i / (2 * kRings)) + 0.5f) / kRings * 3.14159f - 1.5708f;
            const float lon = static_cast<float>(i % (2 * kRings)) / kRings * 3.14159f;
            s.mean_m[i] = Vec3f{std::cos(lat) * std::sin(lon), -std::sin(lat), std::cos(lat) * std::cos(lon)} * 3.f;
            s.log_scale[i] = Vec3f{1, 1, 1} * std::log(0.25f);
            s.rotation[i] = {1, 0, 0, 0};
            s.opacity_logit[i] = 5;
            s.sh0[i] = {std::sin(3 * lon), std::cos(2 * lat), 0.3f};
        }
        return s;
    }
    Json look() {
        warnings_.texts.clear();
        return check_health(folder_, {0, &warnings_, {}});
    }
    // The one problem of a run, which is warned of, too.
    std::string problem() {
        const Json health = look();
        EXPECT_FALSE(health.at("ok"));
        EXPECT_EQ(health.at("problems").size(), 1u) << health.dump();
        EXPECT_EQ(warnings_.texts.size(), health.at("problems").size());
        const std::string text = health.at("problems").empty() ? "" : health.at("problems")[0].get<std::string>();
        EXPECT_TRUE(text.starts_with(folder_.root.string())) << text;
        return text.substr(std::min(text.size(), folder_.root.string().size() + 1));
    }

    RunFolder folder_;
    Warnings warnings_;
};

TEST_F(Health, ASoundRunHasNoProblem) {
    const Json health = look();
    EXPECT_TRUE(health.at("ok")) << health.dump();
    EXPECT_EQ(health.at("looked_at"), 3);
    EXPECT_LT(health.at("splats").at("transparent"), 0.01);
    EXPECT_TRUE(warnings_.texts.empty());
}

TEST_F(Health, ABlackPanoramaIsFound) {
    save_png(folder_.panorama_color(), ImageRgb8(64, 32));
    EXPECT_EQ(problem(), "panorama/color.png: 100 % of it is black");
}

TEST_F(Health, AWhitePreviewIsFound) {
    save_jpeg(folder_.preview_jpg(), ImageRgb8(64, 32, {255, 255, 255}));
    EXPECT_EQ(problem(), "preview.jpg: 100 % of it is white");
}

TEST_F(Health, AViewOfAnEvenWallIsSoundAndABlackOneIsNot) {
    make_directories(folder_.views() / "images");
    save_png(folder_.views() / "images/0.png", ImageRgb8(16, 16, {90, 80, 70}));
    EXPECT_TRUE(look().at("ok"));
    save_png(folder_.views() / "images/1.png", ImageRgb8(16, 16));
    EXPECT_EQ(problem(), "views/images/1.png: 100 % of it is black");
}

TEST_F(Health, ARangeWithoutNumbersIsFound) {
    ImageF range(64, 32, 2.f);
    range.at(3, 3) = std::numeric_limits<float>::quiet_NaN();
    save_exr(folder_.depth_range(), range);
    EXPECT_EQ(problem(), "depth/range.exr: 1 of its pixels are no numbers");
    save_exr(folder_.depth_range(), ImageF(64, 32, 0.f));
    EXPECT_EQ(problem(), "depth/range.exr: 100 % of it has no range");
}

TEST_F(Health, SplatsThatOneSeesThroughAreFound) {
    Splats faint = ball();
    for (std::size_t i = 0; i < faint.size() / 2; ++i) faint.opacity_logit[i] = -9;
    save_splat_ply(folder_.scene_ply(), faint);
    const std::string text = problem();
    EXPECT_TRUE(text.starts_with("splat/scene.ply: seen from where it was made, ")) << text;
    EXPECT_NE(text.find("transparent, expected at most 5 %"), std::string::npos) << text;
}

TEST_F(Health, AFileThatCannotBeReadIsAProblem) {
    write_file(folder_.panorama_color(), std::string_view("no picture"));
    EXPECT_TRUE(problem().starts_with("panorama/color.png: "));
}

TEST_F(Health, SplatsThatAreNoNumbersAreFound) {
    Splats broken = ball();
    broken.mean_m[7].y = std::numeric_limits<float>::quiet_NaN();
    save_splat_ply(folder_.scene_ply(), broken);
    EXPECT_EQ(problem(), "splat/scene.ply: 1 of its splats are no numbers");
}

}  // namespace
}  // namespace fastscene
