#include "fastscene/metrics/images.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <span>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/io/image_io.h"
#include "fastscene/metrics/niqe.h"
#include "fastscene/models/sha256.h"
#include "fastscene/nn/perceptual.h"
#include "fastscene/weights/safetensors.h"
#include "fastscene/nn/tiny_tokenizer.h"

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
    // A model of pristine pictures whose features have the given mean and standard deviation 1.
    static NiqeModel plain_model(double mean) {
        NiqeModel model{std::vector<double>(kNiqeFeatures, mean), std::vector<double>(kNiqeFeatures * kNiqeFeatures)};
        for (std::size_t i = 0; i < kNiqeFeatures; ++i) model.covariance[i * kNiqeFeatures + i] = 1;
        return model;
    }
    fs::path root_;
};

TEST_F(Images, LikenessNeedsNoWeightsAndWhatIsMissingIsSaid) {
    const Json report = measure_images({root_ / "ours", root_ / "true", "a room", root_ / "empty", {}}, {});
    EXPECT_EQ(report["count"], 2);
    EXPECT_NEAR(report["pictures"][0]["psnr"].get<double>(), 20 * std::log10(255 / 10.0), 1e-9);
    EXPECT_EQ(report["pictures"][1]["psnr"], "inf");
    EXPECT_NEAR(report["mean"]["psnr"].get<double>(), 20 * std::log10(255 / 10.0), 1e-9)
        << "infinity does not swallow the mean";
    EXPECT_NEAR(report["pictures"][1]["ssim_wang"].get<double>(), 1, 1e-12);
    for (const char* name :
         {"niqe", "brisque", "brisque_opencv", "lpips_alex", "lpips_vgg", "clip_b32", "clip_l14", "clip_s"}) {
        ASSERT_TRUE(report["missing"].contains(name)) << name;
        EXPECT_TRUE(report["missing"][name].get<std::string>().starts_with("fetch ")) << report["missing"][name];
    }
    EXPECT_FALSE(report["missing"].contains("niqe_own")) << "nobody misses a model of one's own";
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
    const Json report = measure_images(
        {root_ / "empty", root_ / "empty", "", root_, {"psnr", "ssim_wang", "ssim_3dgs"}}, {});
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
    const Json report = measure_images({root_ / "empty", root_ / "gray", "", root_, {"psnr", "ssim_wang"}},
                                       {0, &heard, {}});
    const Json& psnr = report["pictures"][0]["psnr"];
    EXPECT_TRUE(psnr == "inf" || psnr.get<double>() > 48) << psnr;
    EXPECT_NE(heard.notes.find("veil.png: transparent in parts, measured over black"), std::string::npos)
        << heard.notes;
    EXPECT_EQ(report["transparent"], Json::array({(root_ / "empty/veil.png").string()}));
    const Json other_way = measure_images({root_ / "gray", root_ / "empty", "", root_, {"psnr"}}, {});
    EXPECT_EQ(other_way["transparent"], Json::array({(root_ / "empty/veil.png").string()}))
        << "a reference can be transparent too";
}

TEST_F(Images, TheMeanSaysOfHowManyPictures) {
    save_png(root_ / "ours/even.png", ImageRgb8(200, 200, Rgb8{9, 9, 9}));
    save(root_ / "ours/large.png", 5, 0, 200);
    save_niqe_model(root_ / "modelparameters.mat", plain_model(1));
    const Json report = measure_images({root_ / "ours", "", "", root_, {"niqe"}}, {});
    EXPECT_EQ(report["count"], 4);
    EXPECT_EQ(report["mean_of"]["niqe"], 1);
    EXPECT_EQ(report["mean"]["niqe"], report["pictures"][3]["niqe"]);
    EXPECT_NE(
        image_table(report).find("niqe: the mean is over 1 of 4 pictures; not defined for 3 (a.png: NIQE: expected"),
        std::string::npos)
        << image_table(report);
    const Json likeness = measure_images({root_ / "ours/b.png", root_ / "true/b.png", "", root_, {"psnr"}}, {});
    EXPECT_NE(image_table(likeness).find("over 0 of 1 pictures; infinite for 1"), std::string::npos);
}

TEST_F(Images, TheAuthorsModelAndOnesOwnHaveNamesOfTheirOwn) {
    save(root_ / "empty/large.png", 5, 0, 200);
    const fs::path own = root_ / "niqe.json", authors = root_ / "modelparameters.mat";
    const auto measured = [&](std::vector<std::string> wanted) {
        return measure_images({root_ / "empty", "", "", root_, std::move(wanted)}, {});
    };
    save_niqe_model(own, plain_model(1));
    Json report = measured({});
    EXPECT_TRUE(report["missing"].contains("niqe")) << "one's own never stands in for the authors'";
    const Json score = report["mean"]["niqe_own"];
    EXPECT_GT(score.get<double>(), 0);
    save_niqe_model(authors, plain_model(9));
    report = measured({});
    EXPECT_EQ(report["mean"]["niqe_own"], score);
    EXPECT_NE(report["mean"]["niqe"], score);
    EXPECT_EQ(report["models"]["niqe_own"], Json::array({{{"file", own.string()}, {"sha256", sha256_of_file(own)}}}));
    EXPECT_EQ(report["models"]["niqe"][0]["file"], authors.string());
    EXPECT_NE(
        image_table(report).find(fmt::format("niqe by {} (sha256 {:.12})", authors.string(), sha256_of_file(authors))),
        std::string::npos)
        << image_table(report);
    EXPECT_FALSE(report["mean"].contains("niqe_y"));
    EXPECT_NE(measured({"niqe_y"})["mean"]["niqe_y"], report["mean"]["niqe"]);
}

TEST_F(Images, ABrokenFileCostsNoOtherMeasure) {
    save(root_ / "empty/large.png", 5, 0, 200);
    save_niqe_model(root_ / "modelparameters.mat", plain_model(1));
    write_file(root_ / "allmodel", "not a model");
    write_file(root_ / "allrange", "nor this");
    fs::create_directories(root_ / "clip-vit-base-patch32");
    const ImageMeasures inputs{root_ / "empty", "", "a room", root_, {"niqe", "brisque", "clip_b32", "clip_l14"}};
    const Json report = measure_images(inputs, {});
    EXPECT_TRUE(report["mean"]["niqe"].is_number());
    EXPECT_NE(report["missing"]["brisque"].get<std::string>().find((root_ / "allmodel").string() + ":"),
              std::string::npos)
        << report["missing"];
    EXPECT_NE(report["missing"]["clip_b32"].get<std::string>().find("clip-vit-base-patch32: expected"),
              std::string::npos)
        << report["missing"];
    EXPECT_TRUE(report["missing"]["clip_l14"].get<std::string>().starts_with("fetch clip-vit-large-patch14"));
    EXPECT_EQ(not_measured(report, inputs.wanted), (std::vector<std::string>{"brisque", "clip_b32", "clip_l14"}));
    EXPECT_THROW(metrics_weights(root_ / "nowhere"), Error);
    EXPECT_THROW(metrics_weights(root_ / "allmodel"), Error) << "a file";
    EXPECT_EQ(metrics_weights(root_), root_);
}

TEST_F(Images, ReferencesThatNothingIsComparedWithAreCounted) {
    save(root_ / "true/c.png", 3, 0);
    save(root_ / "true/d.png", 4, 0);
    Heard heard;
    const Json report = measure_images({root_ / "ours", root_ / "true", "", root_, {"psnr"}}, {0, &heard, {}});
    EXPECT_EQ(report["without_picture"], 2);
    EXPECT_NE(heard.notes.find("2 of its pictures have no picture of the same name"), std::string::npos) << heard.notes;
}

// CLIP in OpenAI's format, but tiny: one layer per tower, heads of 64, input of `patches` x `patches` patches of
// `patch` x `patch` pixels.
void write_tiny_clip(const fs::path& file, float size = 0.3f, std::int64_t patch = 32, std::int64_t patches = 2) {
    Weights out;
    Random random(3, "tiny clip");
    const auto add = [&](const std::string& name, std::vector<std::int64_t> shape) {
        WeightTensor tensor{NumberType::f32, std::move(shape), {}, {}};
        auto numbers = std::make_shared<std::vector<float>>(static_cast<std::size_t>(tensor.count()));
        for (float& v : *numbers) v = random.uniform(-size, size);
        tensor.bytes = std::as_bytes(std::span(*numbers));
        tensor.owner = numbers;
        out.tensors[name] = tensor;
    };
    const auto add_both = [&](const std::string& name, std::int64_t rows, std::int64_t columns = 0) {
        add(name + "weight", columns ? std::vector{rows, columns} : std::vector{rows});
        add(name + "bias", {rows});
    };
    constexpr std::int64_t w = 64, inner = 128, common = 16;
    for (const std::string tower : {"", "visual."}) {
        const std::string block = tower + "transformer.resblocks.0.";
        add_both(block + "attn.in_proj_", 3 * w, w);
        add_both(block + "attn.out_proj.", w, w);
        add_both(block + "mlp.c_fc.", inner, w);
        add_both(block + "mlp.c_proj.", w, inner);
        for (const std::string norm : {"ln_1.", "ln_2."}) add_both(block + norm, w);
    }
    for (const std::string norm : {"ln_final.", "visual.ln_pre.", "visual.ln_post."}) add_both(norm, w);
    add("token_embedding.weight", {49408, w});
    add("positional_embedding", {77, w});
    add("text_projection", {w, common});
    add("visual.conv1.weight", {w, 3, patch, patch});
    add("visual.class_embedding", {w});
    add("visual.positional_embedding", {patches * patches + 1, w});
    add("visual.proj", {w, common});
    save_safetensors(file, out);
}

TEST_F(Images, BothClipScoresAreMeasuredByTheirFormulas) {
    write_tiny_clip(root_ / "ViT-B-32.pt");
    write_tiny_tokenizer(root_);
    const Json report = measure_images({root_ / "ours", "", "a red room", root_, {"clip_b32", "clip_s"}}, {});
    ASSERT_TRUE(report["missing"].empty()) << report["missing"];
    const ClipMeasure clip(root_ / "ViT-B-32.pt");
    const std::vector<float> words = clip.of_text("a red room"), caption = clip.of_text("A photo depicts a red room");
    for (const Json& row : report["pictures"]) {
        const std::vector<float> seen = clip.of_picture(load_rgb8(root_ / "ours" / row["name"].get<std::string>()));
        EXPECT_NEAR(row["clip_b32"].get<double>(), 100 * cosine(seen, words),
                    1e-4);  // rounding differs between single and batched evaluation
        EXPECT_NEAR(row["clip_s"].get<double>(), 2.5 * std::max(0.0, cosine(seen, caption)), 1e-5);
    }
    EXPECT_NE(cosine(words, caption), 1);
    EXPECT_EQ(report["models"]["clip_s"], report["models"]["clip_b32"]);
    EXPECT_EQ(report["models"]["clip_s"][0]["file"], (root_ / "ViT-B-32.pt").string());
}

// In a batch, an invalid or unreadable picture must not affect the others.
TEST_F(Images, OneThatClipCannotBeShownCostsNoOther) {
    write_tiny_clip(root_ / "ViT-B-32.pt");
    write_tiny_tokenizer(root_);
    for (int i = 0; i < 14; ++i) save(root_ / "ours" / fmt::format("c{:02}.png", i), static_cast<std::uint64_t>(i), i);
    save_png(root_ / "ours/c03.png", ImageRgb8(200, 2));
    write_file(root_ / "ours/c10.png", "no picture");
    const Json report = measure_images({root_ / "ours", "", "a red room", root_, {"clip_b32", "clip_s"}}, {});
    EXPECT_EQ(report["count"], 15);
    EXPECT_EQ(report["mean_of"]["clip_b32"], 14);
    EXPECT_TRUE(report["left_out"].contains("c10.png"));
    const ClipMeasure clip(root_ / "ViT-B-32.pt");
    const std::vector<float> words = clip.of_text("a red room");
    std::string before;
    for (const Json& row : report["pictures"]) {
        const std::string name = row["name"];
        EXPECT_LT(before, name) << "by name";
        before = name;
        if (name == "c03.png") {
            EXPECT_TRUE(row["clip_b32"].is_null() && row["clip_s"].is_null());
            EXPECT_NE(report["undefined"][name]["clip_b32"].get<std::string>().find("found 200 x 2"), std::string::npos)
                << report["undefined"];
        } else {
            EXPECT_NEAR(row["clip_b32"].get<double>(),
                        100 * cosine(clip.of_picture(load_rgb8(root_ / "ours" / name)), words), 1e-4)
                << name;
        }
    }
}

TEST_F(Images, AScoreIsNamedAfterTheNetworkThatGaveIt) {
    write_tiny_tokenizer(root_);
    const auto why = [&](const std::string& measure) {
        return measure_images({root_ / "ours/a.png", "", "a room", root_, {measure}}, {})["missing"].value(
            measure, std::string());
    };
    write_tiny_clip(root_ / "ViT-L-14.pt");
    EXPECT_NE(why("clip_l14").find("ViT-L-14.pt: expected the CLIP of patches of 14 pixels, found one of 32 pixels"),
              std::string::npos)
        << why("clip_l14");
    write_tiny_clip(root_ / "ViT-B-32.pt", 0.3f, 14);
    for (const char* measure : {"clip_b32", "clip_s"})
        EXPECT_NE(why(measure).find("expected the CLIP of patches of 32 pixels, found one of 14"), std::string::npos)
            << why(measure);
    write_tiny_clip(root_ / "ViT-L-14.pt", 0.3f, 14, 24);
    EXPECT_NE(why("clip_l14").find("expected the CLIP of pictures of 224 pixels, found one of 336 pixels"),
              std::string::npos)
        << why("clip_l14");
    write_tiny_clip(root_ / "ViT-L-14.pt", 0.3f, 14, 16);
    EXPECT_EQ(why("clip_l14"), "");
}

TEST_F(Images, ANetworkThatGivesNoNumberIsNoScore) {
    write_tiny_clip(root_ / "ViT-B-32.pt", 0);
    write_tiny_tokenizer(root_);
    const Json report = measure_images({root_ / "ours/a.png", "", "a red room", root_, {"clip_b32"}}, {});
    EXPECT_TRUE(report["pictures"][0]["clip_b32"].is_null()) << report;
    EXPECT_NE(report["undefined"]["a.png"]["clip_b32"].get<std::string>().find("expected a number"), std::string::npos);
    EXPECT_EQ(not_measured(report, {"clip_b32"}).size(), 1u);
}

TEST_F(Images, ADamagedPictureIsLeftOutAndTheRestMeasured) {
    const auto cut = [&](const fs::path& path, std::size_t keep) { write_file(path, read_file(path).substr(0, keep)); };
    for (const char* name : {"c.png", "d.png", "e.png"})
        for (const char* folder : {"ours", "true"}) save(root_ / folder / name, 3, 0);
    cut(root_ / "ours/c.png", 300);  // its header is intact
    cut(root_ / "ours/d.png", 0);
    cut(root_ / "true/e.png", 300);  // its reference
    struct Warned : EventSink {
        std::string warnings;
        void tell(const Event& event) override {
            if (const auto* warning = std::get_if<WarningEvent>(&event)) warnings += warning->text + "\n";
        }
    } warned;
    const Json report = measure_images({root_ / "ours", root_ / "true", "", root_, {"psnr"}}, {0, &warned, {}});
    EXPECT_EQ(report["count"], 2);
    EXPECT_EQ(report["pictures"].size(), 2u);
    EXPECT_EQ(report["mean_of"]["psnr"], 1) << "a and b, of which b is equal";
    ASSERT_EQ(report["left_out"].size(), 3u) << report["left_out"];
    EXPECT_NE(report["left_out"]["e.png"].get<std::string>().find("true/e.png"), std::string::npos);
    EXPECT_NE(warned.warnings.find("left out: " + (root_ / "ours/c.png").string()), std::string::npos)
        << warned.warnings;
    EXPECT_NE(image_table(report).find("3 of 5 pictures cannot be read and are left out"), std::string::npos)
        << image_table(report);
    for (const char* name : {"a.png", "b.png"}) cut(root_ / "ours" / name, 300);
    cut(root_ / "ours/e.png", 300);
    EXPECT_THROW(measure_images({root_ / "ours", "", "", root_, {"ssim_wang"}}, {}), Error) << "nothing was measured";
}

TEST_F(Images, PicturesOfOtherKindsAreNotPassedOverInSilence) {
    const auto why = [&] {
        try {
            measure_images({root_ / "empty", "", "", root_, {"niqe"}}, {});
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    write_file(root_ / "empty/readme.txt", "text");
    EXPECT_NE(why().find("found none"), std::string::npos) << why();
    for (const char* name : {"a.exr", "b.EXR", "c.gif"}) write_file(root_ / "empty" / name, "");
    EXPECT_NE(why().find("found only 2 .exr, 1 .gif"), std::string::npos) << why();
    save(root_ / "empty/a.png", 1, 0);
    Heard heard;
    (void)measure_images({root_ / "empty", root_ / "true", "", root_, {"psnr"}}, {0, &heard, {}});
    EXPECT_NE(heard.notes.find("2 .exr, 1 .gif are not measured"), std::string::npos) << heard.notes;
}

TEST_F(Images, WrongInputsAreErrors) {
    EXPECT_THROW(measure_images({root_ / "empty", "", "", root_, {}}, {}), Error) << "no pictures";
    EXPECT_THROW(measure_images({root_ / "ours", root_ / "empty", "", root_, {}}, {}), Error) << "no partners";
    EXPECT_THROW(measure_images({root_ / "ours", "", "", root_, {"psnr"}}, {}), UsageError)
        << "nothing to compare with";
    save(root_ / "true/a.png", 1, 0, 41);
    EXPECT_THROW(measure_images({root_ / "ours", root_ / "true", "", root_, {}}, {}), Error) << "other sizes";
}

}  // namespace
}  // namespace fastscene
