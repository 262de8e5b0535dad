#include "fastscene/metrics/images.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/random.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

class Images : public testing::Test {
  protected:
    void SetUp() override {
        root_ = fs::temp_directory_path() / "fastscene_images_test";
        fs::remove_all(root_);
        for (const char* name : {"ours", "true", "empty"}) fs::create_directories(root_ / name);
        save(root_ / "true/a.png", 1, 0);
        save(root_ / "ours/a.png", 1, 10);
        save(root_ / "true/b.png", 2, 0);
        save(root_ / "ours/b.png", 2, 0);
    }
    static void save(const fs::path& path, std::uint64_t seed, int shift, int side = 40) {
        Random random(seed, "images");
        ImageRgb8 image(side, side);
        for (Rgb8& p : image.pixels) p.r = p.g = p.b = static_cast<std::uint8_t>(random.index(200) + shift);
        save_png(path, image);
    }
    fs::path root_;
};

TEST_F(Images, LikenessNeedsNoWeightsAndWhatIsMissingIsSaid) {
    const Json report = measure_images({root_ / "ours", root_ / "true", "a room", root_ / "empty", {}}, {});
    EXPECT_EQ(report["count"], 2);
    EXPECT_NEAR(report["pictures"][0]["psnr"].get<double>(), 20 * std::log10(255 / 10.0), 1e-9);
    EXPECT_EQ(report["pictures"][1]["psnr"], "inf");
    EXPECT_NEAR(report["mean"]["psnr"].get<double>(), 20 * std::log10(255 / 10.0), 1e-9) << "infinity does not swallow the mean";
    EXPECT_NEAR(report["pictures"][1]["ssim_wang"].get<double>(), 1, 1e-12);
    for (const char* name : {"niqe", "brisque", "brisque_opencv", "lpips_alex", "lpips_vgg", "clip_b32", "clip_l14"})
        EXPECT_TRUE(report["missing"].contains(name)) << name;
    const std::string table = image_table(report);
    EXPECT_NE(table.find("niqe is not measured"), std::string::npos) << table;
    EXPECT_NE(table.find("a.png"), std::string::npos) << table;
}

TEST_F(Images, UndefinedScoresAreNullWithAReason) {
    save(root_ / "ours/c.png", 3, 0, 5);
    save(root_ / "true/c.png", 3, 0, 5);
    const Json report = measure_images({root_ / "ours", root_ / "true", "", root_ / "empty", {"ssim_wang"}}, {});
    EXPECT_TRUE(report["pictures"][2]["ssim_wang"].is_null());
    EXPECT_NE(report["undefined"]["c.png"]["ssim_wang"].get<std::string>().find("11 x 11"), std::string::npos);
}

TEST_F(Images, OnePixelAndOneColorAreAnsweredInWords) {
    save_png(root_ / "empty/dot.png", ImageRgb8(1, 1, Rgb8{9, 9, 9}));
    save_png(root_ / "empty/even.png", ImageRgb8(200, 200, Rgb8{9, 9, 9}));
    const Json report = measure_images({root_ / "empty", root_ / "empty", "", root_, {"psnr", "ssim_wang", "ssim_3dgs"}}, {});
    for (const Json& row : report["pictures"]) EXPECT_EQ(row["psnr"], "inf") << row;
    EXPECT_TRUE(report["pictures"][0]["ssim_wang"].is_null());
    EXPECT_NEAR(report["pictures"][1]["ssim_wang"].get<double>(), 1, 1e-12);
    EXPECT_NEAR(report["mean"]["ssim_3dgs"].get<double>(), 1, 1e-12);
}

struct Heard : EventSink {
    std::string notes;
    void tell(const Event& event) override {
        if (const auto* note = std::get_if<NoteEvent>(&event)) notes += note->text + "\n";
    }
};

TEST_F(Images, AlphaIsMeasuredOverBlackAndSaidSo) {
    constexpr int kSide = 20;
    std::vector<png_byte> half_white;
    for (int i = 0; i < kSide * kSide; ++i) half_white.insert(half_white.end(), {255, 255, 255, 128});
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = kSide;
    image.format = PNG_FORMAT_RGBA;
    ASSERT_TRUE(png_image_write_to_file(&image, (root_ / "empty/veil.png").c_str(), 0, half_white.data(), 0, nullptr));
    fs::create_directories(root_ / "gray");
    save_png(root_ / "gray/veil.png", ImageRgb8(kSide, kSide, Rgb8{128, 128, 128}));
    Heard heard;
    const Json report = measure_images({root_ / "empty", root_ / "gray", "", root_, {"psnr", "ssim_wang"}}, {0, &heard, {}});
    const Json& psnr = report["pictures"][0]["psnr"];
    EXPECT_TRUE(psnr == "inf" || psnr.get<double>() > 48) << psnr;
    EXPECT_NE(heard.notes.find("veil.png: transparent in parts, measured over black"), std::string::npos) << heard.notes;
}

TEST_F(Images, WrongInputsAreErrors) {
    EXPECT_THROW(measure_images({root_ / "empty", "", "", root_, {}}, {}), Error) << "no pictures";
    EXPECT_THROW(measure_images({root_ / "ours", root_ / "empty", "", root_, {}}, {}), Error) << "no partners";
    EXPECT_THROW(measure_images({root_ / "ours", "", "", root_, {"psnr"}}, {}), UsageError) << "nothing to compare with";
    save(root_ / "true/a.png", 1, 0, 41);
    EXPECT_THROW(measure_images({root_ / "ours", root_ / "true", "", root_, {}}, {}), Error) << "other sizes";
}

}  // namespace
}  // namespace fastscene
