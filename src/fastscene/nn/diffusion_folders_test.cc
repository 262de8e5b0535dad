// Weight folders as users provide them: all naming variants, mixed up, damaged, from other models. Whatever is wrong is
// reported by name before computing, or else as soon as it becomes detectable.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <span>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/nn/diffusion360.h"
#include "fastscene/weights/safetensors.h"
#include "fastscene/nn/tiny_model.h"
#include "fastscene/nn/upscale360.h"
#include "fastscene/weights/weights.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// Records events, and requests a stop when `stops_at` says so.
struct Overheard : EventSink {
    std::vector<std::string> warnings;
    std::vector<std::int64_t> done;
    std::stop_source stop;
    std::function<bool(const Event&)> stops_at;
    void tell(const Event& event) override {
        if (const auto* warning = std::get_if<WarningEvent>(&event)) warnings.push_back(warning->text);
        if (const auto* progress = std::get_if<ProgressEvent>(&event)) done.push_back(progress->done);
        if (stops_at && stops_at(event)) stop.request_stop();
    }
};

class Folders : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        home_ = fs::temp_directory_path() / "fastscene_diffusion_folders_test";
        fs::remove_all(home_);
        write_tiny_model(home_ / "model");
    }
    static void TearDownTestSuite() { fs::remove_all(home_); }

    // A copy that a test may damage.
    static fs::path copy() {
        fs::remove_all(home_ / "copy");
        fs::copy(home_ / "model", home_ / "copy", fs::copy_options::recursive);
        return home_ / "copy";
    }
    static fs::path with_photo() {
        const fs::path folder = home_ / "official";
        fs::remove_all(folder);
        fs::create_directories(folder);
        fs::copy(home_ / "model", folder / "sr-base", fs::copy_options::recursive);
        write_tiny_control(folder / "sd-i2p", 4);
        return folder;
    }
    static void change(const fs::path& file, const std::string& key, const Json& value) {
        Json json = read_json(file);
        json[key] = value;  // null counts as absent
        write_json(file, json);
    }
    static Diffusion360Settings small() {
        Diffusion360Settings s;
        s.width = 256;
        s.steps = 2;
        return s;
    }
    static std::string complaint(const fs::path& folder, Diffusion360::From from = Diffusion360::From::text,
                                 const Diffusion360Settings& settings = small()) {
        return message_of([&] { (void)Diffusion360(folder, settings, {}, from); });
    }
    static ImageRgb8 painted(const fs::path& folder) { return Diffusion360(folder, small(), {}).paint("a room", {}); }
    static fs::path home_;
};
fs::path Folders::home_;

void expect_says(const std::string& text, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        EXPECT_NE(text.find(word), std::string::npos) << "\"" << word << "\" is not in: " << text;
}

TEST_F(Folders, ConfigurationsThatCannotBeComputedAreRefused) {
    struct Case {
        std::string file, key;
        Json value;
        std::vector<std::string> says;
    };
    const std::string unet = "unet/config.json", vae = "vae/config.json", text = "text_encoder/config.json";
    for (const Case& c : {Case{unet, "up_block_types", nullptr, {"up_block_types"}},
                          {unet, "block_out_channels", {17, 34}, {"block_out_channels"}},
                          {unet, "addition_embed_type", "text_time", {"addition_embed_type", "Stable Diffusion XL"}},
                          {unet, "transformer_layers_per_block", {1, 2}, {"transformer_layers_per_block", "[1,2]"}},
                          {unet, "act_fn", "gelu", {"act_fn", "gelu"}},
                          {unet, "num_class_embeds", 10, {"num_class_embeds", "10"}},
                          {unet, "only_cross_attention", {true, false}, {"only_cross_attention", "[true,false]"}},
                          {unet, "center_input_sample", true, {"center_input_sample"}},
                          {unet, "resnet_time_scale_shift", "scale_shift", {"resnet_time_scale_shift", "default"}},
                          {unet, "mid_block_scale_factor", 2, {"mid_block_scale_factor", "2"}},
                          {vae, "act_fn", "relu", {"act_fn", "relu"}},
                          {text, "num_hidden_layers", 0, {"num_hidden_layers", "0"}},
                          {vae, "norm_num_groups", 0, {"norm_num_groups", "0"}},
                          {vae, "norm_num_groups", 3, {"norm_num_groups", "3"}},
                          {vae, "sample_size", 0, {"sample_size", "multiple of 32"}},
                          {vae, "sample_size", 8, {"sample_size", "multiple of 32"}},
                          {vae, "sample_size", 72, {"sample_size", "multiple of 32"}},
                          {vae, "latent_channels", 0, {"latent_channels"}},
                          {vae, "up_block_types", {"UpDecoderBlock2D"}, {"4 down and 1 up"}},
                          {text, "vocab_size", 49000, {"vocab_size", "49408", "49000"}},
                          {text, "max_position_embeddings", 10, {"max_position_embeddings", "77", "10"}}}) {
        SCOPED_TRACE(c.file + " " + c.key + " " + c.value.dump());
        const fs::path folder = copy();
        change(folder / c.file, c.key, c.value);
        if (c.key == "block_out_channels")
            change(folder / c.file, "norm_num_groups", 1), change(folder / c.file, "attention_head_dim", 1);
        const std::string said = complaint(folder);
        expect_says(said, c.says);
        expect_says(said, {c.file});
    }
}

TEST_F(Folders, WhatNewerFilesWriteOutIsTheUsual) {
    const fs::path file = copy() / "unet/config.json";
    Json whole = read_json(file);
    whole.update({{"act_fn", "swish"},
                  {"mid_block_type", "UNetMidBlock2DCrossAttn"},
                  {"mid_block_scale_factor", 1.0},
                  {"only_cross_attention", {false, false}},
                  {"resnet_time_scale_shift", "default"},
                  {"attention_type", "default"},
                  {"time_embedding_type", "positional"},
                  {"conv_in_kernel", 3},
                  {"time_embedding_act_fn", nullptr},
                  {"dropout", 0.0},
                  {"num_class_embeds", nullptr},
                  {"dual_cross_attention", false}});
    write_json(file, whole);
    EXPECT_EQ(painted(home_ / "copy"), painted(home_ / "model"));
}

TEST_F(Folders, LayersThatTheConfigurationDoesNotKnowAreNamed) {
    for (const auto& [file, key] :
         {std::pair<std::string, std::string>{"unet/diffusion_pytorch_model.safetensors",
                                              "up_blocks.1.resnets.2.norm1.weight"},
          {"vae/diffusion_pytorch_model.safetensors", "decoder.up_blocks.4.resnets.0.norm1.weight"}}) {
        const fs::path folder = copy();
        Weights weights = load_weights(folder / file);
        weights.tensors["some_note"] = weights.tensors.begin()->second;
        save_safetensors(folder / file, Weights(weights));
        EXPECT_EQ(complaint(folder), "") << "beside the layers";
        weights.tensors[key] = weights.tensors.begin()->second;
        save_safetensors(folder / file, weights);
        expect_says(complaint(folder), {(folder / file).parent_path().string(), key, "config.json"});
    }
}

TEST_F(Folders, WordsAreWeighedWithinReason) {
    const auto paint = [&](const std::string& prompt) {
        return message_of([&] { (void)Diffusion360(home_ / "model", small(), {}).paint(prompt, {}); });
    };
    EXPECT_EQ(paint("(a:900) (b:-2) ((c))"), "");
    expect_says(paint("(a:99999)"), {"the prompt", "1000", "99999"});
    expect_says(paint(std::string(3000, '(') + "a"), {"the prompt", "inf"});
}

TEST_F(Folders, AControlNetMayTakeBlueFirst) {
    const fs::path folder = with_photo();
    ImageRgb8 photo(32, 32);
    for (std::size_t i = 0; i < photo.size(); ++i)
        photo.pixels[i] = {static_cast<std::uint8_t>(i % 251), static_cast<std::uint8_t>(i % 7 * 30), 90};
    const auto paint = [&] {
        return Diffusion360(folder, small(), {}, Diffusion360::From::photo).paint_around(photo, "a room", {});
    };
    const ImageRgb8 plain = paint();
    change(folder / "sd-i2p/config.json", "controlnet_conditioning_channel_order", "bgr");
    EXPECT_NE(paint(), plain);
    // The same network with its first kernel's channels reversed must give the same output.
    const fs::path file = folder / "sd-i2p/diffusion_pytorch_model.safetensors";
    Weights weights = load_weights(file);
    WeightTensor& kernel = weights.tensors.at("controlnet_cond_embedding.conv_in.weight");
    const std::vector<float> old = kernel.floats();
    const auto values = std::make_shared<std::vector<float>>(old.size());
    const std::size_t channels = 4, area = 9;
    for (std::size_t i = 0; i < old.size(); ++i) {
        const std::size_t channel = i / area % channels;
        (*values)[i - channel * area + (channels - 1 - channel) * area] = old[i];
    }
    kernel = {NumberType::f32, kernel.shape, std::as_bytes(std::span(*values)), values};
    save_safetensors(file, weights);
    const ImageRgb8 again = paint();
    int most = 0;
    for (std::size_t i = 0; i < again.size(); ++i)
        most = std::max(most, std::abs(again.pixels[i].g - plain.pixels[i].g));
    EXPECT_LE(most, 1) << "but for the order of its sums";
}

TEST_F(Folders, AnEnlargerThatLacksALayerIsToldBeforeAnythingIsPainted) {
    const fs::path folder = with_photo(), file = folder / "RealESRGAN_x2plus.pth";
    write_tiny_control(folder / "sr-control", 3);
    write_tiny_enlarger(file);
    Upscale360Settings settings;
    settings.to = "6";
    EXPECT_EQ(message_of([&] { (void)Upscale360(folder, 256, settings, {}); }), "");
    Weights weights = load_weights(file);
    weights.tensors.erase("params_ema.conv_up2.weight");
    save_safetensors(file, weights);
    expect_says(message_of([&] { (void)Upscale360(folder, 256, settings, {}); }), {file.string(), "conv_up2.weight"});
}

TEST_F(Folders, AControlNetMustHaveTheLevelsOfItsModel) {
    const fs::path folder = with_photo(), file = folder / "sd-i2p/config.json";
    EXPECT_EQ(complaint(folder, Diffusion360::From::photo), "");
    const Json whole = read_json(file);
    for (const auto& [changes, says] :
         {std::pair{Json{{"block_out_channels", {16}}, {"down_block_types", {"CrossAttnDownBlock2D"}}},
                    "[16 reading text]"},
          {Json{{"layers_per_block", 2}}, "layers_per_block 2"},
          {Json{{"down_block_types", {"CrossAttnDownBlock2D", "CrossAttnDownBlock2D"}}}, "32 reading text"},
          {Json{{"in_channels", 9}}, "in_channels 9"},
          {Json{{"global_pool_conditions", true}}, "global_pool_conditions"},
          {Json{{"controlnet_conditioning_channel_order", "gbr"}}, "controlnet_conditioning_channel_order"},
          {Json{{"conditioning_embedding_out_channels", {4, 4, 8}}}, "conditioning_embedding_out_channels"},
          {Json{{"_class_name", "UNet2DConditionModel"}},
           "expected a ControlNetModel, found a UNet2DConditionModel"}}) {
        SCOPED_TRACE(changes.dump());
        Json other = whole;
        other.update(changes);
        write_json(file, other);
        expect_says(complaint(folder, Diffusion360::From::photo), {"sd-i2p", says});
    }
}

TEST_F(Folders, NoMoreStepsThanTheScheduleHas) {
    const fs::path folder = copy();
    change(folder / "scheduler/scheduler_config.json", "num_train_timesteps", 12);
    for (const auto& [sampler, most] : {std::pair{"euler-ancestral", 12}, {"ddim", 11}, {"unipc", 11}}) {
        SCOPED_TRACE(sampler);
        Diffusion360Settings settings = small();
        settings.sampler = sampler;
        settings.steps = most;
        EXPECT_EQ(Diffusion360(folder, settings, {}).paint("a room", {}).width, 256) << "every step computes";
        settings.steps = most + 1;
        expect_says(complaint(folder, Diffusion360::From::text, settings),
                    {"--panorama-steps", "12", std::to_string(most + 1)});
    }
}

TEST_F(Folders, ComponentsInEachOthersPlaceAreNamed) {
    const auto with = [](const std::string& place, const std::string& other) {
        const fs::path folder = copy();
        fs::remove_all(folder / place);
        fs::copy(home_ / "model" / other, folder / place, fs::copy_options::recursive);
        return folder;
    };
    expect_says(complaint(with("unet", "vae")),
                {"unet/config.json", "expected a UNet2DConditionModel, found an AutoencoderKL"});
    expect_says(complaint(with("vae", "unet")),
                {"vae/config.json", "expected an AutoencoderKL, found a UNet2DConditionModel"});
    expect_says(complaint(with("text_encoder", "unet")),
                {"text_encoder/config.json", "expected a CLIPTextModel, found a UNet2DConditionModel"});
    const fs::path folder = copy();
    change(folder / "text_encoder/config.json", "architectures", Json::array({"CLIPTextModel"}));
    EXPECT_EQ(complaint(folder), "");
    change(folder / "text_encoder/config.json", "architectures", Json::array({"T5EncoderModel"}));
    expect_says(complaint(folder), {"text_encoder/config.json", "found a T5EncoderModel"});
}

TEST_F(Folders, WeightsAreFoundUnderAllTheNamesTheyAreSavedWith) {
    const ImageRgb8 expected = painted(home_ / "model");
    save_in_parts(copy() / "unet", "diffusion_pytorch_model.fp16-0000{}-of-00002.safetensors",
                  "diffusion_pytorch_model.safetensors.index.fp16.json");
    EXPECT_EQ(painted(home_ / "copy"), expected);
    save_in_parts(copy() / "unet", "diffusion_pytorch_model-0000{}-of-00002.fp16.safetensors",
                  "diffusion_pytorch_model.fp16.safetensors.index.json");
    EXPECT_EQ(painted(home_ / "copy"), expected);
    save_in_parts(copy() / "unet", "diffusion_pytorch_model-0000{}-of-00002.bin",
                  "diffusion_pytorch_model.bin.index.json");
    EXPECT_EQ(painted(home_ / "copy"), expected);
    fs::remove(home_ / "copy/unet/diffusion_pytorch_model-00002-of-00002.bin");
    expect_says(complaint(home_ / "copy"), {"diffusion_pytorch_model.bin.index.json", "00002-of-00002.bin"});
    for (const char* name : {"diffusion_pytorch_model.bin", "pytorch_model.bin", "diffusion_pytorch_model.fp16.bin"}) {
        const fs::path unet = copy() / "unet";
        fs::rename(unet / "diffusion_pytorch_model.safetensors", unet / name);
        EXPECT_EQ(painted(home_ / "copy"), expected) << name;
    }
}

TEST_F(Folders, AStateDictIsUnwrapped) {
    const fs::path file = copy() / "unet/diffusion_pytorch_model.safetensors";
    Weights wrapped;
    for (const auto& [key, tensor] : load_weights(home_ / "model/unet" / file.filename()).tensors)
        wrapped.tensors["state_dict." + key] = tensor;
    save_safetensors(file, wrapped);
    EXPECT_EQ(painted(home_ / "copy"), painted(home_ / "model"));
}

TEST_F(Folders, WhatStandsForAFileIsCalledByItsName) {
    const fs::path file = copy() / "unet/diffusion_pytorch_model.safetensors", config = home_ / "copy/unet/config.json";
    write_file(file, "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 3438167536\n");
    expect_says(complaint(home_ / "copy"), {file.string(), "Git LFS", "fetch"});
    write_file(config, "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 743\n");
    expect_says(complaint(home_ / "copy"), {config.string(), "Git LFS"});
    fs::copy_file(home_ / "model/unet/config.json", config, fs::copy_options::overwrite_existing);
    write_file(file, "<!doctype html><html>log in</html>");
    expect_says(complaint(home_ / "copy"), {file.string(), "web page"});
}

TEST_F(Folders, WhatIsNotReadIsSaid) {
    const fs::path folder = copy();
    const auto warnings = [&](const std::string& prompt, const std::string& negative) {
        Overheard heard;
        fastscene::Run run;
        run.events = &heard;
        Diffusion360Settings settings = small();
        settings.negative = negative;
        (void)Diffusion360(folder, settings, {}).paint(prompt, run);
        return heard.warnings;
    };
    std::string words;
    for (int i = 0; i < 300; ++i) words += " b";
    EXPECT_TRUE(warnings("a", "b").empty());
    ASSERT_EQ(warnings("a", words).size(), 1u);
    expect_says(warnings("a", words)[0], {"the negative prompt", "225"});
    write_json(folder / "tokenizer/added_tokens.json", {{"<|endoftext|>", 49407}});
    EXPECT_TRUE(warnings("a", "b").empty()) << "CLIP's own piece";
    write_json(folder / "tokenizer/added_tokens.json", {{"<|endoftext|>", 49407}, {"<loft-style>", 49408}});
    ASSERT_EQ(warnings("a", "b").size(), 1u);
    expect_says(warnings("a", "b")[0], {"added_tokens.json", "<loft-style>"});
}

void spoil(const fs::path& file, const std::string& key) {
    Weights weights = load_weights(file);
    WeightTensor& tensor = weights.tensors.at(key);
    const auto values = std::make_shared<std::vector<float>>(tensor.floats());
    for (float& v : *values) v = std::numeric_limits<float>::quiet_NaN();
    tensor = {NumberType::f32, tensor.shape, std::as_bytes(std::span(*values)), values};
    save_safetensors(file, weights);
}

TEST_F(Folders, WeightsThatAreNotNumbersAreToldByTheirComponentAndEarly) {
    Diffusion360Settings settings = small();
    settings.steps = 4;
    struct Case {
        std::string folder, file, key;
        std::int64_t steps;  // completed before the stop took effect
    };
    for (const Case& c : {Case{"text_encoder", "model.safetensors", "text_model.final_layer_norm.bias", -1},
                          {"unet", "diffusion_pytorch_model.safetensors", "conv_in.bias", 0},
                          {"vae", "diffusion_pytorch_model.safetensors", "decoder.conv_in.bias", 4}}) {
        SCOPED_TRACE(c.folder);
        const fs::path folder = copy();
        spoil(folder / c.folder / c.file, c.key);
        Overheard heard;
        fastscene::Run run;
        run.events = &heard;
        expect_says(message_of([&] { (void)Diffusion360(folder, settings, {}).paint("a room", run); }),
                    {(folder / c.folder).string() + ":", "NaN or infinity"});
        EXPECT_EQ(heard.done.empty() ? -1 : heard.done.back(), c.steps);
    }
    const fs::path folder = with_photo();
    spoil(folder / "sd-i2p/diffusion_pytorch_model.safetensors", "controlnet_mid_block.bias");
    const auto paint = [&] {
        (void)Diffusion360(folder, settings, {}, Diffusion360::From::photo)
            .paint_around(ImageRgb8(40, 30), "a room", {});
    };
    expect_says(message_of(paint), {(folder / "sd-i2p").string() + ":", "NaN or infinity"});
}

TEST_F(Folders, LargerPicturesNameThePartThatIsNotNumbers) {
    for (const auto& [file, key] : {std::pair<std::string, std::string>{
                                        "sr-control/diffusion_pytorch_model.safetensors", "controlnet_mid_block.bias"},
                                    {"sr-base/unet/diffusion_pytorch_model.safetensors", "conv_in.bias"},
                                    {"sr-base/vae/diffusion_pytorch_model.safetensors", "encoder.conv_in.bias"}}) {
        SCOPED_TRACE(file);
        const fs::path folder = with_photo();
        write_tiny_control(folder / "sr-control", 3);
        spoil(folder / file, key);
        Upscale360Settings settings;
        settings.steps = 2;
        settings.to = "3";
        Overheard heard;
        fastscene::Run run;
        run.events = &heard;
        expect_says(
            message_of([&] {
                (void)Upscale360(folder, 64, settings, run).enlarge(ImageRgb8(64, 32, {90, 120, 200}), "a room", run);
            }),
            {(folder / file).parent_path().string() + ":", "NaN or infinity"});
        EXPECT_LE(heard.done.empty() ? 0 : heard.done.back(), 0) << "noticed in the first step";
    }
}

TEST_F(Folders, AStopIsHeardBetweenLayers) {
    const auto outcome = [&](const std::function<bool(const Event&)>& stops_at) {
        Overheard heard;
        heard.stops_at = stops_at;
        fastscene::Run run;
        run.events = &heard;
        run.stop = heard.stop.get_token();
        std::string words;
        for (int i = 0; i < 300; ++i) words += " b";  // warned about before it is encoded
        EXPECT_THROW((void)Diffusion360(home_ / "model", small(), {}).paint(words, run), Stopped);
        return heard.done;
    };
    const auto at = [](std::int64_t done) {
        return [done](const Event& event) {
            return std::holds_alternative<ProgressEvent>(event) && std::get<ProgressEvent>(event).done == done;
        };
    };
    EXPECT_TRUE(outcome([](const Event& event) { return std::holds_alternative<WarningEvent>(event); }).empty())
        << "while the prompt is read";
    EXPECT_EQ(outcome(at(0)), (std::vector<std::int64_t>{0})) << "in the first step";
    EXPECT_EQ(outcome(at(2)), (std::vector<std::int64_t>{0, 1, 2})) << "in the decoder";
}

}  // namespace
}  // namespace fastscene
