// CLIP from files: defaults of config.json, and the same network in each published format.
#include "fastscene/nn/libtorch.h"
#include "fastscene/nn/clip.h"

#include <gtest/gtest.h>
#include <torch/script.h>

#include <map>
#include <limits>
#include <regex>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/nn/hashed.h"
#include "fastscene/nn/layers.h"
#include "fastscene/nn/lpips.h"
#include "fastscene/nn/perceptual.h"
#include "fastscene/weights/safetensors.h"
#include "fastscene/nn/tiny_model.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;
using nn::HashedWeights;
using nn::Scope;

void expect_tower(const nn::ClipTower& t, std::int64_t width, std::int64_t inner, std::int64_t layers,
                  std::int64_t heads) {
    EXPECT_EQ(t.width, width);
    EXPECT_EQ(t.inner, inner);
    EXPECT_EQ(t.layers, layers);
    EXPECT_EQ(t.heads, heads);
}

TEST(ClipConfig, WhatIsLeftOutIsViTB32) {
    for (const Json& json :
         {Json{{"model_type", "clip"}}, Json{{"text_config", {{"model_type", "clip_text_model"}}},
                                             {"vision_config", {{"model_type", "clip_vision_model"}}}}}) {
        const nn::ClipConfig c = nn::clip_config(json, "config.json");
        expect_tower(c.text, 512, 2048, 12, 8);
        expect_tower(c.vision, 768, 3072, 12, 12);
        EXPECT_EQ(c.vision.patch, 32);
        EXPECT_EQ(c.vision.image_size, 224);
        EXPECT_EQ(c.text.positions, 77);
        EXPECT_EQ(c.text.vocabulary, 49408);
        EXPECT_EQ(c.dimension, 512);
        EXPECT_TRUE(c.text.quick_gelu && c.vision.quick_gelu);
    }
}

// As in ViT-L/14's file: the differences from B/32 are in separate dictionaries, beside towers with other values.
TEST(ClipConfig, TheOlderDictionariesWin) {
    const Json json = {
        {"model_type", "clip"},
        {"projection_dim", 768},
        {"text_config", {{"hidden_size", 512}, {"vocab_size", 49408}}},
        {"vision_config", nullptr},
        {"text_config_dict",
         {{"hidden_size", 768}, {"intermediate_size", 3072}, {"num_attention_heads", 12}, {"num_hidden_layers", 12}}},
        {"vision_config_dict",
         {{"hidden_size", 1024},
          {"intermediate_size", 4096},
          {"num_attention_heads", 16},
          {"num_hidden_layers", 24},
          {"patch_size", 14}}}};
    const nn::ClipConfig c = nn::clip_config(json, "config.json");
    expect_tower(c.text, 768, 3072, 12, 12);
    expect_tower(c.vision, 1024, 4096, 24, 16);
    EXPECT_EQ(c.vision.patch, 14);
    EXPECT_EQ(c.dimension, 768);
}

TEST(ClipConfig, WhatIsNoClipIsNamed) {
    const auto why = [](const Json& json) { return message_of([&] { (void)nn::clip_config(json, "x/config.json"); }); };
    EXPECT_NE(
        why({{"model_type", "clip_text_model"}, {"hidden_size", 768}}).find("x/config.json: expected \"text_config\""),
        std::string::npos);
    EXPECT_NE(why({{"model_type", "clip"}, {"text_config", 7}}).find("\"text_config\" to be an object, found 7"),
              std::string::npos);
    EXPECT_NE(why({{"model_type", "clip"}, {"projection_dim", "wide"}}).find("projection_dim"), std::string::npos);
    EXPECT_NE(why({{"model_type", "clip"}, {"vision_config", {{"num_attention_heads", 7}}}})
                  .find("x/config.json: vision_config"),
              std::string::npos);
    EXPECT_NE(why({{"model_type", "clip"}, {"vision_config", {{"patch_size", 0}}}}).find("patch_size"),
              std::string::npos);
}

// ---- a tiny network: heads of 64, pictures of 64 pixels in patches of 32 ----

const Json kTiny = {
    {"model_type", "clip"},
    {"projection_dim", 24},
    {"text_config",
     {{"hidden_size", 64}, {"intermediate_size", 96}, {"num_hidden_layers", 2}, {"num_attention_heads", 1}}},
    {"vision_config",
     {{"hidden_size", 128},
      {"intermediate_size", 160},
      {"num_hidden_layers", 1},
      {"num_attention_heads", 2},
      {"image_size", 64}}}};

using Named = std::map<std::string, at::Tensor>;

// Under transformers' names, in half precision.
Named tiny_tensors() {
    const c10::InferenceMode inference;
    const nn::ClipConfig c = nn::clip_config(kTiny, "tiny");
    HashedWeights weights;
    nn::clip_text_features(Scope(weights), c.text, at::full({1, 2}, 7, at::kLong), c.dimension);
    nn::clip_image_features(Scope(weights), c.vision, at::zeros({1, 3, 64, 64}), c.dimension);
    Named out;
    for (const auto& [key, tensor] : weights.seen()) out[key] = tensor.to(at::kHalf);
    return out;
}

Named as_openai_names_them(Named from) {
    const std::vector<std::pair<std::regex, std::string>> names{
        {std::regex("^text_model\\.encoder\\.layers"), "transformer.resblocks"},
        {std::regex("^vision_model\\.encoder\\.layers"), "visual.transformer.resblocks"},
        {std::regex("layer_norm([12])"), "ln_$1"},
        {std::regex("mlp\\.fc1"), "mlp.c_fc"},
        {std::regex("mlp\\.fc2"), "mlp.c_proj"},
        {std::regex("self_attn"), "attn"},
        {std::regex("^text_model\\.embeddings\\.token_embedding"), "token_embedding"},
        {std::regex("^text_model\\.embeddings\\.position_embedding.weight"), "positional_embedding"},
        {std::regex("^text_model\\.final_layer_norm"), "ln_final"},
        {std::regex("^vision_model\\.embeddings\\.class_embedding"), "visual.class_embedding"},
        {std::regex("^vision_model\\.embeddings\\.patch_embedding"), "visual.conv1"},
        {std::regex("^vision_model\\.embeddings\\.position_embedding.weight"), "visual.positional_embedding"},
        {std::regex("^vision_model\\.pre_layrnorm"), "visual.ln_pre"},
        {std::regex("^vision_model\\.post_layernorm"), "visual.ln_post"}};
    from["text_projection"] = from.at("text_projection.weight").t().contiguous();
    from["visual.proj"] = from.at("visual_projection.weight").t().contiguous();
    from.erase("text_projection.weight");
    from.erase("visual_projection.weight");
    Named out;
    for (const auto& [key, tensor] : from) {
        std::string name = key;
        for (const auto& [pattern, with] : names) name = std::regex_replace(name, pattern, with);
        if (const std::size_t q = name.find("q_proj."); q != std::string::npos) {
            const auto other = [&](const char* which) {
                return from.at(std::regex_replace(key, std::regex("q_proj"), which));
            };
            out[name.substr(0, q) + "in_proj_" + name.substr(q + 7)] = at::cat(
                {tensor, other("k_proj"), other("v_proj")}, 0);
        } else if (name.find("k_proj.") == std::string::npos && name.find("v_proj.") == std::string::npos) {
            out[name] = tensor;
        }
    }
    out["logit_scale"] = at::full({}, 4.6f).to(at::kHalf);
    return out;
}

Weights weights_of(const Named& tensors) {
    Weights out;
    for (const auto& [key, tensor] : tensors) out.tensors[key] = nn::weight_of(tensor);
    return out;
}

// Nested modules as the dotted names imply.
torch::jit::Module module_of(const Named& tensors, int& count) {
    torch::jit::Module module("__torch__.tiny.Part" + std::to_string(count++));
    std::map<std::string, Named> parts;
    for (const auto& [key, tensor] : tensors)
        if (const std::size_t dot = key.find('.'); dot == std::string::npos)
            module.register_parameter(key, tensor.clone(), false);
        else parts[key.substr(0, dot)][key.substr(dot + 1)] = tensor;
    for (const auto& [name, part] : parts) module.register_module(name, module_of(part, count));
    return module;
}

struct Clip : testing::Test {
    fs::path root = fs::temp_directory_path() / ("fastscene-clip-" + std::to_string(::getpid()));
    void SetUp() override {
        fs::remove_all(root);
        fs::create_directories(root / "folder");
        write_tiny_tokenizer(root / "folder");
        fs::copy_file(root / "folder/merges.txt", root / "merges.txt");
        write_json(root / "folder/config.json", kTiny);
        save_safetensors(root / "folder/model.safetensors", weights_of(tiny_tensors()));
    }
    void TearDown() override { fs::remove_all(root); }
    static ImageRgb8 noise(int width, int height, std::uint64_t seed) {
        Random random(seed, "clip");
        ImageRgb8 out(width, height);
        for (Rgb8& p : out.pixels)
            p = {static_cast<std::uint8_t>(random.index(256)), static_cast<std::uint8_t>(random.index(256)),
                 static_cast<std::uint8_t>(random.index(256))};
        return out;
    }
};

// Ten times the difference of cosines between instruction sets (2e-7).
constexpr double kSameDirection = 3e-6;

TEST_F(Clip, EveryPublishedFormGivesTheSameVectors) {
    const Named openai = as_openai_names_them(tiny_tensors());
    int count = 0;
    module_of(openai, count).save(root / "ViT-B-32.pt");
    save_safetensors(root / "ViT-B-32.safetensors", weights_of(openai));
    const ClipMeasure expected(root / "folder"), script(root / "ViT-B-32.pt"), plain(root / "ViT-B-32.safetensors");
    const ImageRgb8 picture = noise(90, 70, 1);
    const std::vector<float> seen = expected.of_picture(picture), read = expected.of_text("a red armchair");
    ASSERT_EQ(seen.size(), 24u);
    EXPECT_NEAR(cosine(seen, seen), 1, kSameDirection);
    EXPECT_LT(cosine(seen, expected.of_picture(noise(90, 70, 2))), 0.9999);
    EXPECT_LT(cosine(read, expected.of_text("a green garden")), 0.9999);
    for (const ClipMeasure* other : {&script, &plain}) {
        EXPECT_EQ(other->of_picture(picture), seen);
        EXPECT_EQ(other->of_text("a red armchair"), read);
    }
    EXPECT_EQ(expected.files(), std::vector{root / "folder/model.safetensors"});
    EXPECT_EQ(script.files(), std::vector{root / "ViT-B-32.pt"});
}

TEST_F(Clip, PicturesTogetherAreSeenAsEachAlone) {
    const ClipMeasure clip(root / "folder");
    const std::vector<ImageRgb8> pictures{noise(90, 70, 1), noise(40, 200, 2), noise(64, 64, 3)};
    const std::vector<std::vector<float>> together = clip.of_pictures({&pictures[0], &pictures[1], &pictures[2]});
    ASSERT_EQ(together.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(cosine(together[i], clip.of_picture(pictures[i])), 1, kSameDirection) << i;
    EXPECT_LT(cosine(together[0], together[1]), 0.9999);
}

// Without a listener, the last layer is computed for the class token only; the result must not change.
TEST(ClipVision, ListeningChangesNothing) {
    const c10::InferenceMode inference;
    const nn::ClipConfig c = nn::clip_config(kTiny, "tiny");
    HashedWeights weights;
    std::map<std::string, at::Tensor> heard;
    const nn::Listener listener = [&](const std::string& name, const at::Tensor& out) { heard[name] = out; };
    const at::Tensor pixels = nn::hashed_input("pixels", {2, 3, 64, 64}),
                     alone = nn::clip_vision(Scope(weights), c.vision, pixels);
    EXPECT_LT((alone - nn::clip_vision(Scope(weights, "", &listener), c.vision, pixels)).abs().max().item<double>(),
              1e-5);
    EXPECT_EQ(heard.at("vision_model.encoder.layers.0").sizes(), (at::IntArrayRef{2, 5, 128}));
}

TEST(QuickGelu, IsItsFormulaOfAnyNumber) {
    const auto formula = [](const at::Tensor& x) { return x.to(at::kDouble) * at::sigmoid(1.702 * x.to(at::kDouble)); };
    for (const std::int64_t count : {1, 15, 16, 100'003}) {
        const at::Tensor x = 40 * nn::hashed_input("x", {count});
        const at::Tensor tried = nn::quick_gelu(x);  // with gradients enabled, which need the original x
        EXPECT_TRUE(at::equal(x, 40 * nn::hashed_input("x", {count})));
        const at::NoGradGuard no_gradients;
        const at::Tensor expected = formula(x), found = nn::quick_gelu(x.clone());
        EXPECT_LT(((found - expected).abs() / (expected.abs() + 1e-6)).max().item<double>(), 2e-6) << count;
        EXPECT_LT((tried - expected).abs().max().item<double>(), 1e-5) << count;
    }
    const at::NoGradGuard no_gradients;
    // Shared tensors and views must stay unchanged; a tensor moved in gives up its memory.
    const at::Tensor held = nn::hashed_input("x", {64});
    nn::quick_gelu(held);
    nn::quick_gelu(held.narrow(0, 32, 32));
    EXPECT_TRUE(at::equal(held, nn::hashed_input("x", {64})));
    at::Tensor given = nn::hashed_input("x", {64}).clone();
    const void* memory = given.data_ptr();
    EXPECT_EQ(nn::quick_gelu(std::move(given)).data_ptr(), memory);
    const at::Tensor ends = nn::quick_gelu(
        at::tensor({-1e30f, -1e3f, 0.f, 1e3f, 1e30f, std::numeric_limits<float>::quiet_NaN()}));
    EXPECT_TRUE(at::allclose(ends.narrow(0, 1, 4), at::tensor({0.f, 0.f, 1e3f, 1e30f})));
    EXPECT_TRUE(ends[5].isnan().item<bool>());
}

TEST_F(Clip, OfATorchScriptArchiveOnlyTheDataIsRead) {
    int count = 0;
    const fs::path file = root / "module.pt";
    module_of({{"a.b.0.weight", at::arange(6, at::kFloat).reshape({2, 3})},
               {"a.b.1.weight", at::full({4}, 2.5).to(at::kHalf)},
               {"scale", at::full({}, 3.0f)}},
              count)
        .save(file);
    const Weights w = load_weights(file);
    EXPECT_EQ(w.tensors.size(), 3u);
    EXPECT_EQ(w.at("a.b.0.weight").floats(), (std::vector<float>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(w.at("a.b.1.weight").type, NumberType::f16);
    EXPECT_EQ(w.at("scale").floats(), (std::vector<float>{3}));
    const std::string whole = read_file(file);
    EXPECT_NE(whole.find("code/__torch__"), std::string::npos) << "there is code in it";
    // Truncated anywhere or with any byte changed, a file is refused with its name or harmless.
    Random random(7, "archive");
    const fs::path broken = root / "broken.pt";
    for (int i = 0; i < 300; ++i) {
        std::string bytes = i < 60 ? whole.substr(0, whole.size() * static_cast<std::size_t>(i) / 60) : whole;
        if (i >= 60)
            for (int k = random.index(4); k >= 0; --k)
                bytes[static_cast<std::size_t>(random.index(static_cast<int>(bytes.size())))] = static_cast<char>(
                    random.next_u32());
        write_file(broken, bytes);
        const std::string what = message_of([&] {
            for (const auto& [name, tensor] : load_weights(broken).tensors) (void)tensor.floats();
        });
        EXPECT_TRUE(i >= 60 || !what.empty()) << "cut to " << bytes.size();
        EXPECT_TRUE(what.empty() || what.find(broken.string()) != std::string::npos) << what;
    }
}

TEST_F(Clip, WhatIsBrokenIsNamed) {
    const auto why = [](const fs::path& place) { return message_of([&] { const ClipMeasure clip(place); }); };
    Named openai = as_openai_names_them(tiny_tensors());
    const fs::path file = root / "broken.safetensors";
    const auto without = [&](const char* key) {
        Named rest = openai;
        rest.erase(key);
        save_safetensors(file, weights_of(rest));
        return why(file);
    };
    EXPECT_NE(without("visual.transformer.resblocks.0.attn.in_proj_bias")
                  .find(file.string() + ": expected the tensor \"visual.transformer.resblocks.0.attn.in_proj_bias\""),
              std::string::npos);
    EXPECT_NE(without("text_projection").find("text_projection"), std::string::npos);
    openai["visual.proj"] = at::zeros({127, 24});
    EXPECT_NE(without("logit_scale").find("visual_projection.weight: expected shape [24, 128], found [24, 127]"),
              std::string::npos)
        << without("logit_scale");
    openai["visual.layer1.0.conv1.weight"] = at::zeros({1});
    EXPECT_NE(without("logit_scale").find("a ResNet"), std::string::npos);

    fs::create_directories(root / "empty");
    EXPECT_NE(why(root / "empty").find((root / "empty").string() + ": expected CLIP's merges.txt"), std::string::npos);
    Json small = kTiny;
    small["text_config"]["max_position_embeddings"] = 10;
    write_json(root / "folder/config.json", small);
    EXPECT_NE(why(root / "folder").find("expected a text tower for 77 places"), std::string::npos);
    fs::remove(root / "folder/config.json");
    EXPECT_NE(why(root / "folder").find("config.json"), std::string::npos);
}

TEST_F(Clip, LpipsIsZeroForEqualPicturesAndGrowsWithTheDifference) {
    const c10::InferenceMode inference;
    HashedWeights backbone, heads;
    nn::lpips(Scope(backbone), Scope(heads), nn::LpipsNet::alex, at::zeros({1, 3, 64, 64}), at::zeros({1, 3, 64, 64}));
    const auto save = [&](const HashedWeights& weights, const char* name, bool positive) {
        Named tensors;
        for (const auto& [key, tensor] : weights.seen())
            tensors[key] = positive ? tensor.abs() : tensor;  // as trained: nonnegative head weights
        save_safetensors(root / name, weights_of(tensors));
    };
    save(backbone, "alexnet.safetensors", false);
    save(heads, "alex.safetensors", true);
    const LpipsMeasure lpips("alex", root / "alexnet.safetensors", root / "alex.safetensors");
    const ImageRgb8 a = noise(64, 48, 1);
    const auto shifted = [&](int by) {
        ImageRgb8 out = a;
        for (Rgb8& p : out.pixels) p.g = static_cast<std::uint8_t>(std::min(255, p.g + by));
        return out;
    };
    EXPECT_EQ(lpips.distance(a, a), 0);
    EXPECT_GT(lpips.distance(a, shifted(10)), 0);
    EXPECT_GT(lpips.distance(a, shifted(90)), lpips.distance(a, shifted(10)));
    EXPECT_NEAR(lpips.distance(a, shifted(90)), lpips.distance(shifted(90), a), 1e-6);
    EXPECT_NE(message_of([&] { (void)lpips.distance(a, noise(64, 49, 1)); }).find("64 x 48 and 64 x 49"),
              std::string::npos);
    EXPECT_NE(message_of([&] { (void)lpips.distance(noise(31, 40, 1), noise(31, 40, 1)); }).find("31 x 40"),
              std::string::npos);
    EXPECT_NE(message_of([&] {
                  const LpipsMeasure other("vgg", root / "alexnet.safetensors", root / "alex.safetensors");
              }).find("alexnet.safetensors"),
              std::string::npos);
    EXPECT_NE(message_of([&] {
                  const LpipsMeasure other("alex", root / "alex.safetensors", root / "alex.safetensors");
              }).find("alex.safetensors"),
              std::string::npos);
    for (const float dead :
         // pictures are indistinguishable: the score would always be perfect
         {0.f, std::numeric_limits<float>::quiet_NaN()}) {
        Named tensors;
        for (const auto& [key, tensor] : backbone.seen()) tensors[key] = at::full_like(tensor, dead);
        save_safetensors(root / "dead.safetensors", weights_of(tensors));
        const std::string why = message_of(
            [&] { const LpipsMeasure other("alex", root / "dead.safetensors", root / "alex.safetensors"); });
        EXPECT_NE(why.find("dead.safetensors: expected a network that"), std::string::npos) << why;
    }
}

}  // namespace
}  // namespace fastscene
