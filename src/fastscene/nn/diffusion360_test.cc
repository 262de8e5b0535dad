#include "fastscene/nn/diffusion360.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/nn/clip_image.h"
#include "fastscene/nn/diffusion_memory.h"
#include "fastscene/nn/file_weights.h"
#include "fastscene/nn/hashed.h"
#include "fastscene/nn/painting_files.h"
#include "fastscene/nn/photo_sphere.h"
#include "fastscene/weights/safetensors.h"
#include "fastscene/nn/scheduler.h"
#include "fastscene/nn/sphere_tiles.h"
#include "fastscene/nn/tiny_model.h"
#include "fastscene/nn/upscale360.h"
#include "fastscene/weights/weights.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

class Painted : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        model_ = fs::temp_directory_path() / "fastscene_diffusion360_test" / "model";
        fs::remove_all(model_.parent_path());
        write_tiny_model(model_);
    }
    // A copy that a test may damage.
    fs::path copy(const std::string& name) const {
        const fs::path to = model_.parent_path() / name;
        fs::remove_all(to);
        fs::copy(model_, to, fs::copy_options::recursive);
        return to;
    }
    static std::string complaint(const fs::path& weights, const Diffusion360Settings& settings = small()) {
        try {
            Diffusion360(weights, settings, {});
        } catch (const Error& e) {
            return e.what();
        }
        return "none";
    }
    static Diffusion360Settings small() {
        Diffusion360Settings s;
        s.width = 256;
        s.steps = 2;
        return s;
    }
    static fs::path model_;
};
fs::path Painted::model_;

// Mean difference between two columns.
double step_between(const ImageRgb8& image, int a, int b) {
    double sum = 0;
    for (int y = 0; y < image.height; ++y) {
        const Rgb8 p = image.at(a, y), q = image.at(b, y);
        sum += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b);
    }
    return sum / (3 * image.height);
}

// The seam is no more visible than the boundary between any two adjacent columns.
void expect_closed(const ImageRgb8& image) {
    double most = 0;
    for (int x = 0; x + 1 < image.width; ++x) most = std::max(most, step_between(image, x, x + 1));
    EXPECT_LE(step_between(image, image.width - 1, 0), most);
    EXPECT_GT(most, 0) << "the picture is one color";
}

TEST_F(Painted, TheEndsMeetAndTheSeedDecides) {
    const Diffusion360 model(model_, small(), {});
    EXPECT_EQ(model.info().prediction, "epsilon");
    EXPECT_GT(model.info().peak_bytes, model.info().parameters);
    fastscene::Run run;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        run.seed = seed;
        int previews = 0;
        const ImageRgb8 image = model.paint("a room", run, [&](const ImageRgb8& preview) {
            ++previews;
            EXPECT_EQ(preview.width, 128);
            EXPECT_EQ(preview.height, 64);
        });
        ASSERT_EQ(image.width, 256);
        ASSERT_EQ(image.height, 128);
        EXPECT_EQ(previews, 1);
        expect_closed(image);
        if (seed == 1) {
            EXPECT_EQ(model.paint("a room", run), image);
            EXPECT_NE(model.paint("another room", run), image);
        }
    }
}

TEST_F(Painted, OtherSamplersNumbersAndLittleMemory) {
    fastscene::Run run;
    Diffusion360Settings settings = small();
    settings.low_memory = true;
    const Diffusion360 model(model_, settings, {});
    const ImageRgb8 twice = model.paint("a room", run);
    EXPECT_EQ(model.paint("a room", run), twice) << "weights that were let go come back";
    settings.precision = "bf16";
    const ImageRgb8 coarse = Diffusion360(model_, settings, {}).paint("a room", run);
    double difference = 0;
    for (std::size_t i = 0; i < coarse.size(); ++i) difference += std::abs(coarse.pixels[i].g - twice.pixels[i].g);
    EXPECT_LT(difference / static_cast<double>(coarse.size()), 8) << "16 bits paint the same picture";
    for (const char* sampler : {"ddim", "unipc"}) {
        settings.sampler = sampler;
        EXPECT_EQ(Diffusion360(model_, settings, {}).paint("a room", run).width, 256);
    }
}

TEST_F(Painted, MissingComponentsAreNamed) {
    EXPECT_NE(complaint(model_.parent_path() / "nowhere").find("nowhere"), std::string::npos);
    const fs::path broken = copy("missing");
    fs::remove_all(broken / "vae");
    EXPECT_NE(complaint(broken).find("vae/"), std::string::npos);
    const fs::path no_weights = copy("no_weights");
    fs::remove(no_weights / "unet/diffusion_pytorch_model.safetensors");
    EXPECT_NE(complaint(no_weights).find("diffusion_pytorch_model"), std::string::npos);
    const fs::path inside = model_.parent_path() / "whole";
    fs::remove_all(inside);
    fs::create_directories(inside);
    fs::copy(model_, inside / "sd-base", fs::copy_options::recursive);
    EXPECT_EQ(complaint(inside), "none") << "the official layout";
}

TEST_F(Painted, MixedModelsAreToldByShapes) {
    const fs::path mixed = model_.parent_path() / "mixed";
    write_tiny_model(mixed, {.denoiser_text_width = 32, .encoder_text_width = 64, .prediction = "epsilon"});
    const std::string text = complaint(mixed);
    EXPECT_NE(text.find("width 32"), std::string::npos) << text;
    EXPECT_NE(text.find("width 64"), std::string::npos) << text;
}

TEST_F(Painted, DamagedFilesAreRefusedBeforeAnythingIsComputed) {
    const fs::path cut = copy("cut");
    const fs::path file = cut / "unet/diffusion_pytorch_model.safetensors";
    fs::resize_file(file, fs::file_size(file) - 100);
    EXPECT_NE(complaint(cut).find(file.filename().string()), std::string::npos) << complaint(cut);
    const fs::path other = copy("other");
    Json config = read_json(other / "unet/config.json");
    config["block_out_channels"] = {16, 64};
    write_json(other / "unet/config.json", config);
    EXPECT_NE(complaint(other).find("expected shape"), std::string::npos) << complaint(other);
    config["block_out_channels"] = "many";
    write_json(other / "unet/config.json", config);
    EXPECT_NE(complaint(other).find("block_out_channels"), std::string::npos) << complaint(other);
    Diffusion360Settings settings = small();
    settings.width = 250;
    EXPECT_NE(complaint(model_, settings).find("128"), std::string::npos);
    settings.width = 1 << 17;
    EXPECT_NE(complaint(model_, settings).find("GiB"), std::string::npos) << "more memory than there is";
}

TEST_F(Painted, VelocityModelsAreRead) {
    const fs::path velocity = model_.parent_path() / "velocity";
    write_tiny_model(velocity, {.denoiser_text_width = 32, .encoder_text_width = 32, .prediction = "v_prediction"});
    const Diffusion360 model(velocity, small(), {});
    EXPECT_EQ(model.info().prediction, "v_prediction");
    EXPECT_NE(model.paint("a room", {}), Diffusion360(model_, small(), {}).paint("a room", {}));
}

// For any weights, decoded in bands, in tiles and in one piece.
TEST_F(Painted, TheEndsMeetForOtherWeights) {
    for (const int sample_size : {64, 512})
        for (const char* salt : {"a", "b"}) {
            const fs::path folder = model_.parent_path() / "salted";
            fs::remove_all(folder);
            write_tiny_model(folder, {.salt = salt, .sample_size = sample_size});
            Diffusion360Settings settings = small();
            for (const bool tiles : {false, true}) {
                SCOPED_TRACE(fmt::format("{} {} {}", sample_size, salt, tiles));
                settings.low_memory = tiles;
                expect_closed(Diffusion360(folder, settings, {}).paint("a room", {}));
            }
        }
}

struct Heard : EventSink {
    std::vector<std::string> warnings;
    void tell(const Event& event) override {
        if (const auto* warning = std::get_if<WarningEvent>(&event)) warnings.push_back(warning->text);
    }
};

TEST_F(Painted, LongPromptsAreReadInPiecesAndWhatIsLeftOutIsSaid) {
    const Diffusion360 model(model_, small(), {});
    Heard heard;
    fastscene::Run run;
    run.events = &heard;
    std::string words = "a";
    for (int i = 0; i < 90; ++i) words += " b";
    const ImageRgb8 image = model.paint(words, run);
    EXPECT_TRUE(heard.warnings.empty()) << "more than 77 tokens are read";
    EXPECT_NE(image, model.paint(words + " c c c c", run));
    for (int i = 0; i < 200; ++i) words += " b";
    (void)model.paint(words, run);
    ASSERT_EQ(heard.warnings.size(), 1u);
    EXPECT_NE(heard.warnings[0].find("225"), std::string::npos) << heard.warnings[0];
}

TEST_F(Painted, ShardsAreReadTogetherAndEachMustBeWhole) {
    const fs::path sharded = copy("sharded");
    const fs::path second = sharded / "unet/diffusion_pytorch_model-00002-of-00002.safetensors";
    save_in_parts(sharded / "unet", "diffusion_pytorch_model-0000{}-of-00002.safetensors",
                  "diffusion_pytorch_model.safetensors.index.json");
    EXPECT_EQ(Diffusion360(sharded, small(), {}).paint("a room", {}),
              Diffusion360(model_, small(), {}).paint("a room", {}));
    fs::resize_file(second, fs::file_size(second) - 10);
    EXPECT_NE(complaint(sharded).find("00002-of-00002"), std::string::npos) << complaint(sharded);
    fs::resize_file(second, 30);
    EXPECT_NE(complaint(sharded).find("00002-of-00002"), std::string::npos) << complaint(sharded);
    fs::remove(second);
    EXPECT_NE(complaint(sharded).find("00002-of-00002"), std::string::npos) << complaint(sharded);
}

TEST_F(Painted, SchedulesOfOtherModelsAreRefused) {
    const fs::path other = copy("other_schedule");
    Json config = read_json(other / "scheduler/scheduler_config.json");
    for (const auto& [key, value] : {std::pair{"prediction_type", Json("sample")},
                                     {"beta_schedule", Json("sigmoid")},
                                     {"rescale_betas_zero_snr", Json(true)}}) {
        Json changed = config;
        changed[key] = value;
        write_json(other / "scheduler/scheduler_config.json", changed);
        EXPECT_NE(complaint(other).find(key), std::string::npos) << complaint(other);
    }
}

TEST_F(Painted, AStreamedNetworkKeepsNothing) {
    nn::FileWeights kept(model_ / "unet", at::kBFloat16), streamed(model_ / "unet", at::kBFloat16, false);
    const std::string key = "conv_in.weight";
    EXPECT_TRUE(at::equal(kept.get(key, kept.shape_of(key)), streamed.get(key, streamed.shape_of(key))));
    EXPECT_GT(kept.kept_bytes(), 0);
    EXPECT_EQ(streamed.kept_bytes(), 0);
    EXPECT_GT(streamed.largest_bytes(), 0);
    EXPECT_LT(streamed.largest_bytes(), streamed.bytes());
}

// The official folder: a separate model for photos and for upscaling.
class PaintedFurther : public Painted {
  protected:
    fs::path official() const {
        const fs::path folder = model_.parent_path() / "official";
        fs::remove_all(folder);
        fs::create_directories(folder);
        for (const char* part : {"sd-base", "sr-base"}) fs::copy(model_, folder / part, fs::copy_options::recursive);
        write_tiny_control(folder / "sd-i2p", 4);
        write_tiny_control(folder / "sr-control", 3);
        write_tiny_enlarger(folder / "RealESRGAN_x2plus.pth");
        return folder;
    }
    static ImageRgb8 photo(int shift) {
        ImageRgb8 image(40, 30);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                image.at(x, y) = {static_cast<std::uint8_t>(6 * x + shift), static_cast<std::uint8_t>(8 * y), 90};
        return image;
    }
};

TEST_F(PaintedFurther, AroundOnePhoto) {
    const fs::path folder = official();
    const Diffusion360 model(folder, small(), {}, Diffusion360::From::photo);
    const ImageRgb8 image = model.paint_around(photo(0), "a room", {});
    ASSERT_EQ(image.width, 256);
    expect_closed(image);
    EXPECT_EQ(model.paint_around(photo(0), "a room", {}), image);
    EXPECT_NE(model.paint_around(photo(9), "a room", {}), image);
    fs::remove_all(folder / "sd-i2p");
    EXPECT_THROW(Diffusion360(folder, small(), {}, Diffusion360::From::photo), Error);
    write_tiny_control(folder / "sd-i2p", 3);
    EXPECT_THROW(Diffusion360(folder, small(), {}, Diffusion360::From::photo), Error)
        << "a ControlNet for another task";
}

TEST_F(PaintedFurther, ThePhotoLiesInTheMiddle) {
    const nn::PhotoOnSphere placed = nn::photo_on_sphere(photo(0), 256, 90);
    const double share = placed.mask.mean().item<double>();
    EXPECT_GT(share, 0.08);
    EXPECT_LT(share, 0.17);  // 90 of 360 degrees wide, 74 of 180 high, rounded by the projection
    EXPECT_EQ(placed.mask[0][0][64][128].item<float>(), 1);
    EXPECT_EQ(placed.mask[0][0][64][128 + 31].item<float>(), 1) << "45 degrees to the right";
    EXPECT_EQ(placed.mask[0][0][64][128 + 33].item<float>(), 0);
    EXPECT_NEAR(placed.color[0][0][64][128].item<double>() * 255, 6 * 19.5, 8) << "its middle looks forward";
    EXPECT_GT(placed.color[0][1][80][128].item<double>(), placed.color[0][1][50][128].item<double>()) << "upright";
}

TEST_F(PaintedFurther, LargerPicturesCloseToo) {
    const fs::path folder = official();
    const ImageRgb8 small_picture = pillow_bicubic(Diffusion360(folder, small(), {}).paint("a room", {}), 64, 32);
    Upscale360Settings settings;
    settings.tile = 128;
    settings.steps = 2;
    settings.to = "6-refined";
    settings.low_memory = true;
    const ImageRgb8 image = Upscale360(folder, 64, settings, {}).enlarge(small_picture, "a room", {});
    ASSERT_EQ(image.width, 6 * 64);
    ASSERT_EQ(image.height, 6 * 32);
    expect_closed(image);
    settings.to = "3";
    EXPECT_EQ(Upscale360(folder, 64, settings, {}).enlarge(small_picture, "a room", {}).width, 3 * 64);
    settings.to = "6";
    fs::remove(folder / "RealESRGAN_x2plus.pth");
    try {
        Upscale360(folder, 256, settings, {});
        ADD_FAILURE() << "nothing was missed";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("RealESRGAN_x2plus.pth"), std::string::npos);
    }
}

// The published tile is larger than three times the smallest panorama.
TEST_F(PaintedFurther, SmallPicturesAreOneTileHigh) {
    const fs::path folder = official();
    Upscale360Settings settings;
    settings.steps = 2;
    settings.to = "3";
    EXPECT_EQ(Upscale360(folder, 64, settings, {}).enlarge(ImageRgb8(64, 32, {90, 120, 200}), "a room", {}).width, 192);
}

TEST_F(PaintedFurther, StepsThatAreKeptAreNotMadeAgain) {
    const fs::path folder = official();
    Upscale360Settings settings;
    settings.steps = 2;
    settings.to = "6-refined";
    const Upscale360 larger(folder, 64, settings, {});
    std::map<std::string, ImageRgb8> kept;
    int made = 0;
    const Upscale360::Keep keep = [&](const std::string& step, const std::function<ImageRgb8()>& make) {
        if (!kept.contains(step)) kept[step] = (++made, make());
        return kept[step];
    };
    const ImageRgb8 picture(64, 32, {90, 120, 200}), whole = larger.enlarge(picture, "a room", {}, keep);
    EXPECT_EQ(made, 3);
    EXPECT_EQ(kept.at("3").width, 192);
    EXPECT_EQ(kept.at("6").width, 384);
    kept.erase("6-refined");
    EXPECT_EQ(larger.enlarge(picture, "a room", {}, keep), whole) << "the same bytes, from its last step on";
    EXPECT_EQ(made, 4);
}

TEST_F(PaintedFurther, OnlyWhatIsOpenedBelongsToThePainting) {
    const fs::path folder = official();
    const std::vector<fs::path> before = painting_files(folder, false);
    write_file(folder / "sd-base/unet/readme.txt", std::string_view("x"));
    write_file(folder / "other.safetensors", std::string_view("x"));
    EXPECT_EQ(painting_files(folder, false), before);
    for (const fs::path& file : before)
        EXPECT_TRUE(fs::exists(file) && file.string().starts_with((folder / "sd-base").string())) << file;
    const auto has = [](const std::vector<fs::path>& files, const fs::path& file) {
        return std::find(files.begin(), files.end(), file) != files.end();
    };
    EXPECT_TRUE(has(before, folder / "sd-base/unet/diffusion_pytorch_model.safetensors"));
    EXPECT_TRUE(has(painting_files(folder, true), folder / "sd-i2p/diffusion_pytorch_model.safetensors"));
    EXPECT_FALSE(has(enlarging_files(folder, "3"), folder / "RealESRGAN_x2plus.pth"));
    EXPECT_TRUE(has(enlarging_files(folder, "6"), folder / "RealESRGAN_x2plus.pth"));
    fs::remove_all(folder / "sd-base/vae");
    EXPECT_THROW(painting_files(folder, false), Error);
}

TEST(TimesThePainting, GrowsWithThePictureAndFallsWithThePaintersSteps) {
    const auto times = [](const char* to, int steps) {
        Upscale360Settings settings;
        settings.to = to;
        return times_the_painting(1024, steps, settings);
    };
    // nine times the pixels, with a ControlNet, a quarter of the steps, in overlapping tiles
    EXPECT_GT(times("3", 20), 5);
    EXPECT_LT(times("3", 20), 20);
    EXPECT_GT(times("6", 20), times("3", 20));
    EXPECT_GT(times("6-refined", 20), 4 * times("3", 20));
    EXPECT_LT(times("3", 50), times("3", 20));
}

TEST(SphereTiles, NeitherBordersNorTheSeamShow) {
    const at::Tensor x = nn::hashed_input("x", {1, 2, 20, 50});
    nn::SphereTiles how{16, 4, 1, 2, {}};
    int calls = 0;
    const auto twice = [&](const at::Tensor& t) {
        ++calls;
        return at::upsample_nearest2d(t, {2 * t.size(2), 2 * t.size(3)});
    };
    const at::Tensor y = nn::over_sphere(x, how, twice);
    EXPECT_LT((y - at::upsample_nearest2d(x, {40, 100})).abs().max().item<double>(), 1e-6);
    EXPECT_EQ(calls, 2 * 5);
    // A bias towards tile borders is blended away: no jump between adjacent columns.
    const auto tilted = [](const at::Tensor& t) {
        return at::zeros({1, 1, t.size(2), t.size(3)}) + at::arange(t.size(3), at::kFloat);
    };
    how.out = 1;
    const at::Tensor ramp = nn::over_sphere(x, how, tilted);
    const double jump = (ramp - at::roll(ramp, {1}, {3})).abs().max().item<double>();
    EXPECT_LT(jump, 6) << "16 columns fall over an overlap of 4";
    EXPECT_LT(
        (nn::over_sphere(at::roll(x, {10}, {3}), how, tilted) - at::roll(ramp, {10}, {3})).abs().max().item<double>(),
        1e-5)
        << "column 0 is no special one";
}

TEST(DiffusionMemory, WhatIsKnownBeforehand) {
    const std::int64_t gib = 1 << 30;
    EXPECT_GT(standard_diffusion_memory(1024, "float", false), 5 * gib);
    EXPECT_LT(standard_diffusion_memory(1024, "float", false), 8 * gib);
    EXPECT_LT(standard_diffusion_memory(1024, "bf16", false), standard_diffusion_memory(1024, "float", false));
    EXPECT_LT(standard_diffusion_memory(1024, "float", true), 3 * gib);
    EXPECT_GT(standard_diffusion_memory(2048, "float", false), standard_diffusion_memory(1024, "float", false));
    EXPECT_THROW(check_memory("x", std::int64_t{1} << 50, ""), Error);
}

// Given a perfect denoiser, every sampler must recover the clean latent.
TEST(Samplers, FollowAPerfectDenoiserToTheCleanLatent) {
    for (const nn::Sampler sampler : {nn::Sampler::euler_ancestral, nn::Sampler::ddim, nn::Sampler::unipc})
        for (const nn::Prediction prediction : {nn::Prediction::noise, nn::Prediction::velocity}) {
            nn::ScheduleConfig config;
            config.prediction = prediction;
            const auto s = nn::make_scheduler(sampler, config, 25);
            const at::Tensor clean = at::sin(at::arange(64, at::kFloat)).reshape({1, 4, 4, 4});
            at::Tensor x = at::cos(7 * at::arange(64, at::kFloat)).reshape({1, 4, 4, 4}) * 1.4 * s->init_noise_sigma();
            const at::Tensor alphas = nn::alphas_cumprod(config);
            for (int i = 0; i < s->steps(); ++i) {
                const double a = alphas[static_cast<std::int64_t>(s->timestep(i))].item<double>();
                const at::Tensor input = s->scaled_input(x, i);
                const at::Tensor noise = (input - std::sqrt(a) * clean) / std::sqrt(1 - a);
                const at::Tensor output = prediction == nn::Prediction::noise
                                              ? noise
                                              : std::sqrt(a) * noise - std::sqrt(1 - a) * clean;
                x = s->step(output, i, x, at::zeros_like(x));
            }
            EXPECT_LT((x - clean).abs().max().item<double>(), 0.12)
                << static_cast<int>(sampler) << ' ' << static_cast<int>(prediction);
        }
}

}  // namespace
}  // namespace fastscene
