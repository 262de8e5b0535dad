#include "fastscene/evaluate/scores.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstdlib>
#include <filesystem>

#include "fastscene/base/content_identity.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/evaluate/measure_sheet.h"
#include "fastscene/evaluate/parameters.h"
#include "fastscene/io/image_io.h"
#include "fastscene/metrics/niqe.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// Counts how often pictures were measured.
struct Listener : EventSink {
    int judged = 0;
    void tell(const Event& event) override {
        if (const auto* note = std::get_if<NoteEvent>(&event))
            judged += note->text.find("judging") != std::string::npos;
    }
};

ImageRgb8 grainy(std::uint64_t seed, int spread) {
    Random random(seed, "grain");
    ImageRgb8 image(200, 200);
    for (Rgb8& p : image.pixels)
        p.r = p.g = p.b = static_cast<std::uint8_t>(128 + random.uniform(-1, 1) * static_cast<float>(spread));
    return image;
}

// One color, half opaque.
void save_transparent(const fs::path& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = 200;
    image.format = PNG_FORMAT_RGBA;
    const std::vector<png_byte> pixels(4 * 200 * 200, 128);
    ASSERT_TRUE(png_image_write_to_file(&image, file.c_str(), 0, pixels.data(), 0, nullptr));
}

// Models that differ in their means only: files of equal size.
NiqeModel model_about(double mean) {
    NiqeModel model{std::vector<double>(kNiqeFeatures, mean), std::vector<double>(kNiqeFeatures * kNiqeFeatures, 0)};
    for (int i = 0; i < kNiqeFeatures; ++i) model.covariance[static_cast<std::size_t>(i * kNiqeFeatures + i)] = 1;
    return model;
}

class Scores : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(folder_);
        for (const char* name : {"out/work", "pictures", "weights"}) make_directories(folder_ / name);
        save_png(folder_ / "pictures/a.png", grainy(1, 90));
        save_png(folder_ / "pictures/b.png", grainy(2, 60));
        ::setenv("FASTSCENE_MODELS", (folder_ / "none").c_str(),
                 1);  // must not depend on the models pulled by the user running the test
    }
    void TearDown() override { fs::remove_all(folder_); }

    Measured judge() {
        const MeasureInputs inputs{.suite = &suite_,
                                   .out = folder_ / "out",
                                   .work = folder_ / "out/work",
                                   .truth = {},
                                   .weights = folder_ / "weights",
                                   .prompt = ""};
        const fastscene::Run run{0, &listener_, {}};
        MeasureSheet sheet(inputs, run);
        sheet.scores("stills", "", folder_ / "pictures", "");
        return sheet.take();
    }

    fs::path folder_ = fs::temp_directory_path() / "fastscene_scores_test";
    Suite suite_ = read_suite("measures = [\"stills\"]\ncolumns = [\"niqe\"]\n[[scene]]\nprompt = \"a\"\n", "s",
                              "s.toml");
    Listener listener_;
};

TEST_F(Scores, AnotherParameterFileIsAnotherScore) {
    const fs::path file = folder_ / "weights/modelparameters.mat";
    EXPECT_FALSE(judge().samples[0].values.contains("niqe"));
    EXPECT_EQ(judge().samples[0].notes.at("niqe").at(0).substr(0, 6), "fetch ");
    save_niqe_model(file, model_about(1.5));
    const auto time = fs::last_write_time(file);
    const Measured first = judge();
    EXPECT_EQ(judge().samples[0].values.at("niqe"), first.samples[0].values.at("niqe"));
    EXPECT_EQ(listener_.judged, 1) << "judged once";
    EXPECT_EQ(first.parameters.at("niqe").at("files"), Json({file.generic_string()}));

    save_niqe_model(file, model_about(2.5));
    fs::last_write_time(file, time);  // same size and time as the previous file
    const Measured second = judge();
    EXPECT_EQ(listener_.judged, 2);
    EXPECT_NE(second.samples[0].values.at("niqe"), first.samples[0].values.at("niqe"));
    EXPECT_NE(second.parameters.at("niqe").at("identity"), first.parameters.at("niqe").at("identity"));
}

TEST_F(Scores, OneMoreColumnJudgesThatAlone) {
    save_niqe_model(folder_ / "weights/modelparameters.mat", model_about(1.5));
    judge();
    suite_.columns = {"niqe", "brisque"};
    const Measured both = judge();
    EXPECT_EQ(listener_.judged, 1) << "brisque has no parameters, niqe is there";
    EXPECT_TRUE(both.samples[0].values.contains("niqe"));
    EXPECT_TRUE(both.samples[0].notes.contains("brisque"));
}

TEST_F(Scores, PicturesThatHaveNoneAreCountedAndTransparentOnesNamed) {
    save_niqe_model(folder_ / "weights/modelparameters.mat", model_about(1.5));
    save_png(folder_ / "pictures/c.png", ImageRgb8(200, 200, Rgb8{90, 90, 90}));
    save_transparent(folder_ / "pictures/d.png");
    const Measured measured = judge();
    const Sample& sample = measured.samples[0];
    EXPECT_TRUE(sample.values.at("niqe").is_number());
    ASSERT_EQ(sample.notes.at("niqe").size(), 2u);
    EXPECT_EQ(sample.notes.at("niqe")[1], "1 of 4 pictures are transparent in parts: measured over black");
    EXPECT_EQ(sample.notes.at("niqe")[0].find("undefined for 2 of 4 pictures, which the mean leaves out (c.png: "), 0u)
        << sample.notes.at("niqe")[0];
    EXPECT_EQ(sample.pictures.at("niqe").counted, 2);
    EXPECT_EQ(sample.pictures.at("niqe").of, 4);
    const Json report{{"pictures", {{{"psnr", 30.0}}, {{"psnr", "inf"}}}},
                      {"mean", {{"psnr", 30.0}}},
                      {"missing", Json::object()},
                      {"undefined", Json::object()}};
    const Score score = score_from_report(report, "psnr", 1);
    EXPECT_EQ(score.counted, 1);
    ASSERT_EQ(score.notes.size(), 2u);
    EXPECT_NE(score.notes[0].find("infinite for 1 of 2 pictures"), std::string::npos);
    EXPECT_NE(score.notes[1].find("1 of 2 pictures are transparent"), std::string::npos);
    Json without = report;
    without["left_out"] = {{"e.png", "peer/e.png: expected a whole PNG picture"}};
    EXPECT_EQ(score_from_report(without, "psnr", 0).notes[0],
              "1 of 3 pictures cannot be read and are left out (peer/e.png: expected a whole PNG picture)");
}

TEST(Parameters, ContentIsWhatCounts) {
    const fs::path folder = fs::temp_directory_path() / "fastscene_parameters_test";
    fs::remove_all(folder);
    make_directories(folder / "one");
    make_directories(folder / "two");
    std::string bytes(17u << 20, 'w');  // files of this size are hashed partially, including both ends
    write_file(folder / "one/model", bytes);
    write_file(folder / "two/model", bytes);
    EXPECT_EQ(content_identity(folder / "one/model"), content_identity(folder / "two/model"));
    EXPECT_EQ(content_identity(folder / "one"), content_identity(folder / "two"));
    bytes.back() = 'x';
    write_file(folder / "two/model", bytes);
    EXPECT_NE(content_identity(folder / "one"), content_identity(folder / "two"));
    for (char& c : bytes) c = 'v';
    bytes.front() = 'w', bytes.back() = 'w';
    write_file(folder / "two/model", bytes);
    EXPECT_NE(content_identity(folder / "one"), content_identity(folder / "two"))
        << "nor do equal ends make an equal network";
    fs::remove_all(folder);
}

}  // namespace
}  // namespace fastscene
