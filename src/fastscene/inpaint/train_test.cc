// Training on holes: the resulting file is loadable by the program, and better than the initial network.
#include "fastscene/inpaint/train.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/parallel.h"
#include "fastscene/image/color.h"
#include "fastscene/inpaint/inpaint.h"
#include "fastscene/io/image_io.h"
#include "fastscene/weights/safetensors.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// Uniform pictures with brighter blocks, and the holes are exactly these: a network can learn that, the harmonic fill
// cannot.
struct Blocks {
    fs::path path = fs::temp_directory_path() / ("fastscene-inpaint-train-" + std::to_string(::getpid()));
    Blocks() {
        fs::remove_all(path);
        for (const char* part : {"train", "held-out"})
            for (int i = 0; i < 6; ++i) save(path / part, i, part[0] == 'h');
    }
    ~Blocks() { fs::remove_all(path); }
    static void save(const fs::path& part, int i, bool held_out) {
        make_directories(part / "images");
        make_directories(part / "masks");
        ImageRgb8 image(64, 64);
        ImageMask mask(64, 64);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const bool block = (x / 6 + y / 6 + i) % 3 == 0;
                const auto v = static_cast<std::uint8_t>(60 + 10 * i + (held_out ? 5 : 0) + (block ? 60 : 0));
                image.at(x, y) = {v, v, 90};
                mask.at(x, y) = block ? 255 : 0;
            }
        save_png(part / "images" / fmt::format("{:08}-front.png", i), image);
        save_png(part / "masks" / fmt::format("{:08}-front-00.png", i), mask);
    }
};

fastscene::Run seeded(std::uint64_t seed) {
    fastscene::Run run;
    run.seed = seed;
    return run;
}

InpaintTrainParams small(const std::string& holes, int steps) {
    InpaintTrainParams p;
    p.size = 64;
    p.held_out = 3;
    p.network.width = 8;
    p.network.blocks = 1;
    p.network.holes = holes;
    p.network.l1_holes = 1;
    p.network.adversarial = 0;
    p.network.training.batch = 2;
    p.network.training.steps = steps;
    p.network.training.learning_rate = p.network.training.final_learning_rate = 4e-3;
    p.network.training.warmup = 0;
    p.network.training.ema_decay = 0.8;
    p.network.training.clip = 1;
    p.network.training.precision = "f32";
    return p;
}

double figure(const std::vector<std::pair<std::string, double>>& figures, const std::string& name) {
    for (const auto& [found, value] : figures)
        if (found == name) return value;
    ADD_FAILURE() << name;
    return 0;
}

TEST(InpaintTraining, BeatsTheHarmonicFillItBeginsFrom) {
    set_threads(1);
    const Blocks data;
    const auto figures = train_inpainter(data.path, small("harmonic", 60), data.path / "run", seeded(1));
    EXPECT_GT(figure(figures, "psnr"), figure(figures, "psnr of the harmonic fill") + 1);
    // The program reproduces the improvement with the saved file.
    const fs::path part = data.path / "held-out";
    const ImageColor truth = linear_from_srgb8(load_rgb8(part / "images/00000000-front.png"));
    const ImageMask hole = load_mask_png(part / "masks/00000000-front-00.png");
    const auto error_of = [&](const Inpainter& inpainter) {
        const ImageColor out = inpainter.fill(truth, hole, {});
        float sum = 0;
        for (std::size_t i = 0; i < out.size(); ++i) sum += length(out.pixels[i] - truth.pixels[i]);
        return sum;
    };
    EXPECT_LT(error_of(*make_inpainter("aotgan", data.path / "run/generator.safetensors")),
              0.9f * error_of(*make_inpainter("harmonic")));
    set_threads(0);
}

TEST(InpaintTraining, AsPublishedWithADiscriminator) {
    set_threads(1);
    const Blocks data;
    InpaintTrainParams p = small("white", 4);
    p.network.adversarial = 0.01;
    p.network.training.learning_rate = p.network.training.final_learning_rate = 1e-3;
    train_inpainter(data.path, p, data.path / "run", seeded(1));
    EXPECT_NE(read_file(data.path / "run/curves.csv").find("discriminator"), std::string::npos);
    EXPECT_NO_THROW(make_inpainter("aotgan", data.path / "run/generator.safetensors"));
    set_threads(0);
}

TEST(InpaintTraining, BrokenPicturesArePassedOver) {
    const Blocks data;
    write_file(data.path / "train/images/00000003-front.png", std::string_view("no picture"));
    const HoleSet set = find_holes(data.path / "train");
    ASSERT_EQ(set.faces.size(), 6u);
    std::atomic<std::int64_t> broken{0};
    for (int i = 0; i < 30; ++i) {
        Random rng(5, "broken", static_cast<std::uint64_t>(i));
        EXPECT_EQ(draw_example(set, small("harmonic", 1), false, rng, broken).truth.width, 64);
    }
    EXPECT_GT(broken, 0);
}

// With few panoramas none may be held out; that is a warning, not an error.
TEST(InpaintTraining, GoesWithoutHeldOutFaces) {
    set_threads(1);
    const Blocks data;
    fs::remove_all(data.path / "held-out");
    struct : EventSink {
        std::string warnings;
        void tell(const Event& event) override {
            if (const auto* warning = std::get_if<WarningEvent>(&event)) warnings += warning->text;
        }
    } heard;
    EXPECT_FALSE(train_inpainter(data.path, small("harmonic", 1), data.path / "run", {1, &heard, {}}).empty());
    EXPECT_NE(heard.warnings.find("expected held-out faces, found none"), std::string::npos) << heard.warnings;
    set_threads(0);
}

template <class Act>
std::string complaint(Act&& act) {
    try {
        act();
    } catch (const Error& e) {
        return e.what();
    }
    return "no complaint";
}

TEST(InpaintTraining, WeightsOfAnotherNetworkOrWithoutNumbersAreRefused) {
    set_threads(1);
    const Blocks data;
    InpaintTrainParams p = small("harmonic", 1);
    train_inpainter(data.path, p, data.path / "run", seeded(1));
    Weights weights = load_weights(data.path / "run/generator.safetensors");
    WeightTensor& bias = weights.tensors.at("middle.0.fuse.1.bias");
    auto bytes = std::make_shared<std::vector<std::byte>>(bias.bytes.begin(), bias.bytes.end());
    (*bytes)[0] = std::byte{0x00};
    (*bytes)[1] = std::byte{0x7e};  // NaN in half precision
    bias.bytes = *bytes;
    bias.owner = bytes;
    save_safetensors(data.path / "nan.safetensors", weights);
    EXPECT_NE(complaint([&] {
                  make_inpainter("aotgan", data.path / "nan.safetensors");
              }).find("nan.safetensors: middle.0.fuse.1.bias: expected numbers, found NaN"),
              std::string::npos);

    Weights other{{}, {{"patch_embed.0.weight", weights.tensors.at("encoder.1.weight")}}, {}, {}};
    save_safetensors(data.path / "other.safetensors", other);
    p.network.start = (data.path / "other.safetensors").string();
    EXPECT_NE(complaint([&] {
                  train_inpainter(data.path, p, data.path / "run2", seeded(1));
              }).find("other.safetensors: expected the tensor \"encoder.1.weight\""),
              std::string::npos);
    set_threads(0);
}

TEST(InpaintTraining, OddRequestsAreRefused) {
    const Blocks data;
    InpaintTrainParams p = small("harmonic", 1);
    p.size = 72;
    EXPECT_THROW(train_inpainter(data.path, p, data.path / "run", {}), UsageError);  // larger than the faces
    p.size = 60;
    EXPECT_THROW(train_inpainter(data.path, p, data.path / "run", {}), UsageError);  // not a multiple of 8
    EXPECT_THROW(find_holes(data.path / "nowhere"), UsageError);
    fs::remove_all(data.path / "train/masks");
    make_directories(data.path / "train/masks");
    EXPECT_THROW(find_holes(data.path / "train"), UsageError);
}

}  // namespace
}  // namespace fastscene
