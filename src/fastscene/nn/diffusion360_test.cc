#include "fastscene/nn/diffusion360.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/nn/scheduler.h"
#include "fastscene/nn/tiny_model.h"

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

// Mean difference of two columns.
double step_between(const ImageRgb8& image, int a, int b) {
    double sum = 0;
    for (int y = 0; y < image.height; ++y) {
        const Rgb8 p = image.at(a, y), q = image.at(b, y);
        sum += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b);
    }
    return sum / (3 * image.height);
}

TEST_F(Painted, TheEndsMeetAndTheSeedDecides) {
    const Diffusion360 model(model_, small(), {});
    EXPECT_EQ(model.info().prediction, "epsilon");
    EXPECT_GT(model.info().peak_bytes, model.info().parameters);
    fastscene::Run run;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        run.seed = seed;
        int glances = 0;
        const ImageRgb8 image = model.paint("a room", run, [&](const ImageRgb8& glance) {
            ++glances;
            EXPECT_EQ(glance.width, 32);
        });
        ASSERT_EQ(image.width, 256);
        ASSERT_EQ(image.height, 128);
        EXPECT_EQ(glances, 2);
        std::vector<double> steps;
        for (int x = 0; x + 1 < image.width; ++x) steps.push_back(step_between(image, x, x + 1));
        EXPECT_LE(step_between(image, image.width - 1, 0), *std::max_element(steps.begin(), steps.end())) << "seed " << seed;
        EXPECT_GT(*std::max_element(steps.begin(), steps.end()), 0) << "the picture is not one color";
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

// A network that knows the truth: every sampler must find the clean latent again.
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
                const at::Tensor output = prediction == nn::Prediction::noise ? noise : std::sqrt(a) * noise - std::sqrt(1 - a) * clean;
                x = s->step(output, i, x, at::zeros_like(x));
            }
            EXPECT_LT((x - clean).abs().max().item<double>(), 0.12) << static_cast<int>(sampler) << ' ' << static_cast<int>(prediction);
        }
}

}  // namespace
}  // namespace fastscene
