// Tokenizer, samplers, CLIP, U-Net, ControlNet, VAE, Diffusion360's loops, LPIPS, RRDBNet.
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <regex>

#include "fastscene/base/file.h"
#include "fastscene/io/image_io.h"
#include "fastscene/nn/circular.h"
#include "fastscene/nn/clip_image.h"
#include "fastscene/nn/lpips.h"
#include "fastscene/nn/panorama_loops.h"
#include "fastscene/nn/rrdbnet.h"
#include "golden.h"

namespace fastscene::golden {
namespace {

using at::Tensor;
using nn::HashedWeights;
using nn::Scope;

// CLIP's vocabulary is OpenAI's and not part of the source tree.
const OthersFile kVocabulary{"data/clip/bpe_simple_vocab_16e6.txt.gz", "clip-vit-base-patch32", ""};

// Null if the vocabulary is absent, also if the pulled model's folder has no merges.txt.
const ClipTokenizer* tokenizer(const Case& c) {
    static std::unique_ptr<ClipTokenizer> one;
    if (one) return one.get();
    const auto file = find_others_file(c.network().set(), kVocabulary);
    if (file && (!std::filesystem::is_directory(*file) || std::filesystem::exists(*file / "merges.txt")))
        one = std::make_unique<ClipTokenizer>(*file);
    return one.get();
}

// ---- tokenizer -----------------------------------------------------------------------------------------------------

std::string text_of_hex(const std::string& hex) {
    std::string out;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        out += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
    return out;
}

// The parts that do not need the vocabulary.
void parse_prompt(const std::string& text, Json& ours) {
    Json pieces = Json::array();
    for (const WeightedText& piece : parse_weights(text)) pieces.push_back({piece.text, piece.weight});
    ours["parse_prompt_attention"] = pieces;
}

void encode_prompt(const ClipTokenizer& t, const std::string& text, const Json& p, Json& ours) {
    if (p.contains("hf_ids_untruncated")) {
        std::vector<int> ids = t.encode(text);
        ids.insert(ids.begin(), ClipTokenizer::kBegin);
        ids.push_back(ClipTokenizer::kEnd);
        ours["hf_ids_untruncated"] = ids;
        if (p.contains("n_tokens")) ours["n_tokens"] = ids.size();
    }
    if (p.contains("sd15_ids77_pad49407")) ours["sd15_ids77_pad49407"] = t.padded(text, ClipTokenizer::kEnd);
    if (p.contains("sd2_ids77_pad0")) ours["sd2_ids77_pad0"] = t.padded(text, 0);
    if (p.contains("openai_clip_tokenize77") && p.value("hf_equals_openai", true))
        ours["openai_clip_tokenize77"] = t.padded(text, 0);
    if (p.contains("parse_prompt_attention")) {
        const WeightedTokens w = weighted_tokens(t, {text}, ClipTokenizer::kEnd)[0];
        ours["padded_tokens"] = w.tokens;
        Json weights = Json::array();  // single precision here, double there
        for (std::size_t i = 0; i < w.weights.size(); ++i) {
            const Json& theirs = p["padded_weights"].size() == w.weights.size() ? p["padded_weights"][i] : Json(-1e9);
            weights.push_back(w.weights[i] == static_cast<float>(theirs.get<double>()) ? theirs : Json(w.weights[i]));
        }
        ours["padded_weights"] = weights;
        ours["max_embeddings_multiples"] = w.chunks;
    }
}

void check_prompt(Case& c, const std::string& name, const Json& p) {
    const std::string text = p.contains("prompt_utf8_hex") ? text_of_hex(p["prompt_utf8_hex"])
                                                           : p.at("prompt").get<std::string>();
    const ClipTokenizer* t = tokenizer(c);
    Json ours = p;
    if (p.contains("parse_prompt_attention")) parse_prompt(text, ours);
    if (t) encode_prompt(*t, text, p, ours);
    if (t || p.contains("parse_prompt_attention")) c.value(name, ours);
    if (!t) c.lack(name, kVocabulary.relative);
}

void check_tokenizer(Case& c) {
    // nothing to check without the vocabulary
    if (!tokenizer(c) && c.name() == "prompts") throw Skipped(kVocabulary.relative);
    for (const Json& entry : c.json().at("values")) check_prompt(c, entry.at("name"), entry.at("value"));
}

// Appends to a file in the format of prompt_tokens.json.
void record_tokens(const std::filesystem::path& file, const std::string& prompt, const std::string& negative, int pad,
                   const std::vector<WeightedTokens>& tokens) {
    Json all = std::filesystem::exists(file) ? read_json(file) : Json::array();
    Json entry{{"prompts", {prompt, negative}}, {"pad", pad}, {"tokens", Json::array()}};
    for (const WeightedTokens& one : tokens)
        entry["tokens"].push_back({{"tokens", one.tokens}, {"weights", one.weights}, {"chunks", one.chunks}});
    for (const Json& known : all)
        if (known == entry) return;
    all.push_back(entry);
    write_file(file, all.dump() + "\n");
}

// The prompt and its negative. The source tree has no vocabulary, but the token ids of the prompts in these cases are
// recorded in prompt_tokens.json, so that the networks can still be tested; if the vocabulary is present, the record is
// verified.
std::vector<WeightedTokens> prompt_tokens(const Case& c, const std::string& prompt, const std::string& negative,
                                          int pad) {
    const std::filesystem::path file = c.network().set() / "prompt_tokens.json";
    const ClipTokenizer* t = tokenizer(c);
    std::vector<WeightedTokens> out, recorded;
    if (t) out = weighted_tokens(*t, {prompt, negative}, pad);
    if (std::filesystem::exists(file))
        for (const Json& entry : read_json(file))
            if (entry.at("prompts") == Json{prompt, negative} && entry.at("pad") == pad)
                for (const Json& one : entry.at("tokens"))
                    recorded.push_back({one.at("tokens").get<std::vector<int>>(),
                                        one.at("weights").get<std::vector<float>>(), one.at("chunks").get<int>()});
    if (recorded.empty() && !t) throw Skipped(kVocabulary.relative);
    if (!t) return recorded;
    for (std::size_t i = 0; i < recorded.size(); ++i)
        if (recorded[i].tokens != out[i].tokens || recorded[i].weights != out[i].weights ||
            recorded[i].chunks != out[i].chunks)
            throw Error("{}: expected the tokens that the vocabulary gives for \"{}\", found others", file.string(),
                        i == 0 ? prompt : negative);
    if (const char* record = std::getenv("FASTSCENE_RECORD_TOKENS"); record && recorded.empty())
        record_tokens(record, prompt, negative, pad, out);
    return out;
}

// ---- samplers ------------------------------------------------------------------------------------------------------

nn::Sampler sampler_of(const std::string& name) {
    return name.starts_with("euler")  ? nn::Sampler::euler_ancestral
           : name.starts_with("ddim") ? nn::Sampler::ddim
                                      : nn::Sampler::unipc;
}

// "x after step 4", "scale_model_input[1]": compares what the case stores.
void run_sampler(Case& c, nn::Scheduler& s, int start, bool fresh_each_step) {
    const std::string in = c.input();
    Tensor x = raw(in + "/x", c.shape()) * (start == 0 && !fresh_each_step ? s.init_noise_sigma() : 1.0);
    for (int i = start, k = 0; i < s.steps(); ++i, ++k) {
        // The case's keys count steps from 0 wherever the sampler starts.
        c.tensor(fmt::format("scale_model_input[{}]", k), s.scaled_input(x, i));
        const Tensor noise = s.wants_noise() ? raw(in + fmt::format("/noise{}", k), c.shape()) : Tensor();
        const Tensor output = raw(in + fmt::format("/eps{}", k), c.shape());
        x = fresh_each_step ? s.clone()->step(output, i, x, noise) : s.step(output, i, x, noise);
        c.tensor(fmt::format("x after step {}", k), x);
        if (fresh_each_step)
            c.value(
                fmt::format("state after step {}", k),
                Json{
                    {"lower_order_nums", 1}, {"this_order", 1}, {"step_index", i + 1}, {"last_sample_is_none", false}});
    }
}

void check_scheduler(Case& c) {
    const Json& manifest = c.network().json();
    const nn::Sampler sampler = sampler_of(c.name());
    const Json* config = c.json().contains("resulting_config") ? &c.json()["resulting_config"] : nullptr;
    for (const char* key : {"sd15_scheduler_config", "scheduler_config"})
        if (!config && manifest.contains(key)) config = &manifest[key];
    const int steps = c.json().value("num_inference_steps", 7);
    nn::ScheduleConfig schedule = nn::schedule_config(*config, c.name(), sampler);
    const auto s = nn::make_scheduler(sampler, schedule, steps);
    c.tensor("timesteps", at::tensor(s->timesteps(), at::kDouble));
    if (!s->sigmas().empty()) c.tensor("sigmas", at::tensor(s->sigmas()));
    c.value("init_noise_sigma", s->init_noise_sigma());
    c.tensor("alphas_cumprod", nn::alphas_cumprod(schedule));
    for (const std::string& name : c.tensor_names()) {
        std::smatch match;
        if (!std::regex_match(name, match, std::regex(R"(add_noise\(x,noise,timesteps\[(\d+)\]\))"))) continue;
        const int i = std::stoi(match[1]);
        c.tensor(name, s->noised(raw(c.input() + "/x", c.shape()), raw(c.input() + "/noise", c.shape()), i));
        c.value("timestep", s->timestep(i));
    }
    const bool reset = c.name().find("reset") != std::string::npos;
    const int start = c.json().value("start_index", reset ? 2 : 0);
    if (c.name().find("add_noise") == std::string::npos) run_sampler(c, *s, start, reset);
}

// ---- CLIP ----------------------------------------------------------------------------------------------------------

Tensor ids_of(const Json& list) {
    std::vector<std::int64_t> flat;
    for (const Json& row : list)
        for (const Json& id : row) flat.push_back(id.get<std::int64_t>());
    return at::tensor(flat, at::kLong).reshape({static_cast<std::int64_t>(list.size()), -1});
}

// "text_model.encoder.layers.3" -> "hidden_states[4]", "text_model.embeddings" or "vision_model.pre_layrnorm" ->
// "hidden_states[0]".
nn::Listener hidden_states(Case& c, const std::string& tower, const std::string& label) {
    return [&c, tower, label](const std::string& name, const Tensor& output) {
        std::smatch match;
        if (name == tower + ".embeddings" || name == tower + ".pre_layrnorm")
            c.tensor(label + "hidden_states[0]", output);
        if (std::regex_match(name, match, std::regex(tower + R"(\.encoder\.layers\.(\d+))")))
            c.tensor(fmt::format("{}hidden_states[{}]", label, std::stoi(match[1]) + 1), output);
    };
}

void check_clip_text(Case& c) {
    HashedWeights weights;
    const nn::ClipTower tower = nn::clip_text_tower(c.network().json().at("config"), c.network().name());
    if (c.json().contains("input_ids")) {
        const nn::Listener listener = hidden_states(c, "text_model", "");
        const nn::ClipText out = nn::clip_text(Scope(weights, "", &listener), tower, ids_of(c.json()["input_ids"]));
        c.tensor("last_hidden_state", out.states);
        c.tensor("pooler_output(argmax of ids)", out.pooled);
        return;
    }
    // The padding token depends on the tokenizer: "!" in Stable Diffusion 2.x (whose text encoder has exact GELU), else
    // the end token.
    const int pad = c.network().json().at("config").at("hidden_act") == "gelu" ? 0 : ClipTokenizer::kEnd;
    const auto tokens = prompt_tokens(c, c.json().at("prompt"), c.json().at("negative"), pad);
    const nn::PromptEmbedding prompt = nn::embed_prompt(Scope(weights), tower, tokens[0]),
                              negative = nn::embed_prompt(Scope(weights), tower, tokens[1]);
    c.tensor("text_embeddings", prompt.states);
    c.tensor("uncond_embeddings", negative.states);
    c.tensor("text_embeddings_unweighted", prompt.plain);
    c.value("mean_ratio_scale", (prompt.states.abs().mean() / prompt.plain.abs().mean()).item<double>());
}

Tensor normalized(const ImageRgb8& image) {
    const auto row = [](double r, double g, double b) {
        return at::tensor(std::vector<double>{r, g, b}, at::kFloat).reshape({3, 1, 1});
    };
    return (bytes_of(image).permute({2, 0, 1}).to(at::kFloat) / 255 - row(.48145466, .4578275, .40821073)) /
           row(.26862954, .26130258, .27577711);
}

ImageRgb8 cropped(const ImageRgb8& image, int left, int top, int right, int bottom) {
    ImageRgb8 out(right - left, bottom - top);
    for (int y = 0; y < out.height; ++y) std::copy_n(image.row(top + y) + left, out.width, out.row(y));
    return out;
}

// "inputs/pano_*.png": the one that exists.
std::filesystem::path picture_of(const Case& c, std::string name) {
    if (const std::size_t star = name.find('*'); star != std::string::npos) {
        const std::string one = name.substr(0, star) + c.name() + name.substr(star + 1);
        if (std::filesystem::exists(c.network().set() / one)) return c.network().set() / one;
        for (const auto& entry :
             std::filesystem::directory_iterator(c.network().set() / std::filesystem::path(name).parent_path()))
            if (entry.path().filename().string().starts_with(
                    std::filesystem::path(name.substr(0, star)).filename().string()))
                return entry.path();
    }
    return needed_input(c.network().set(), name);
}

void check_clip(Case& c) {
    HashedWeights weights;
    const Json& config = c.network().json().at("config");
    const nn::ClipTower vision = nn::clip_vision_tower(config.at("v"), "v"),
                        text = nn::clip_text_tower(config.at("t"), "t");
    const auto dimension = config.at("p").get<std::int64_t>();
    if (c.json().contains("input")) {
        c.tensor("image_features",
                 nn::clip_image_features(Scope(weights), vision,
                                         raw(c.input(), {1, 3, vision.image_size, vision.image_size}), dimension));
        return;
    }
    const ImageRgb8 whole = load_rgb8(picture_of(c, c.json().at("image")));
    std::vector<Tensor> pixels;
    for (const Json& crop : c.json().at("crops")) {
        const Json& box = crop.at("box_left_upper_right_lower");
        const ImageRgb8 image = clip_crop(cropped(whole, box[0], box[1], box[2], box[3]),
                                          static_cast<int>(vision.image_size));
        const std::string name = crop.at("name");
        pixels.push_back(normalized(image));
        c.tensor("pixel_values " + name, pixels.back());
        c.tensor("resized_cropped_uint8 " + name, bytes_of(image));
    }
    const nn::Listener states = hidden_states(c, "vision_model", "vision ");
    const nn::Listener listener = [&](const std::string& name, const Tensor& out) {
        states(name, out);
        if (name == "vision_model.post_layernorm") c.tensor("vision pooler_output", out);
    };
    const Tensor images = nn::clip_image_features(Scope(weights, "", &listener), vision, at::stack(pixels), dimension);
    const Tensor texts = nn::clip_text_features(Scope(weights), text, ids_of(c.json().at("input_ids")), dimension);
    c.tensor("image_features (before L2 norm)", images);
    c.tensor("text_features (before L2 norm)", texts);
    const auto unit_rows = [](const Tensor& t) { return t / t.norm(2, {1}, true); };
    const Tensor cosine = unit_rows(texts).matmul(unit_rows(images).t());
    c.tensor("cosine[text,image]", cosine);
    c.tensor("logits_per_image", cosine.t() / 0.07);  // exp(logit_scale), which is initialized to ln(1 / 0.07)
}

// ---- U-Net, ControlNet, VAE
// ------------------------------------------------------------------------------------------

void check_unet(Case& c, HashedWeights& weights) {
    const nn::UNetConfig config = nn::unet_config(c.network().json().at("config"), c.network().name());
    const nn::Listener listener = c.listener();
    c.tensor("sample", nn::unet(Scope(weights, "", &listener), config, raw(c.input() + "/sample", c.shape("sample")),
                                c.json().at("timestep").get<double>(), raw(c.input() + "/ctx", c.shape("ctx"))));
}

void check_controlnet(Case& c, HashedWeights& weights) {
    const nn::UNetConfig config = nn::controlnet_config(c.network().json().at("config"), c.network().name());
    const std::vector<std::int64_t> shape = c.shape("sample");
    const std::vector<std::int64_t> text_shape = c.json().contains("ctx")
                                                     ? c.shape("ctx")
                                                     : std::vector<std::int64_t>{shape[0], 77, config.text_width};
    const Tensor sample = raw(c.input() + "/sample", shape), text = raw(c.input() + "/ctx", text_shape);
    const Tensor picture = unit(c.input() + "/cond", {shape[0], config.picture_channels, 8 * shape[2], 8 * shape[3]});
    const double t = c.json().at("timestep").get<double>();
    const nn::Listener listener = c.listener();
    const nn::Residuals out = nn::controlnet(Scope(weights, "", &listener), config, sample, t, text, picture);
    for (std::size_t i = 0; i < out.down.size(); ++i)
        c.tensor(fmt::format("down_block_res_samples[{}]", i), out.down[i]);
    c.tensor("mid_block_res_sample", out.middle);
    for (const std::string& name : c.tensor_names()) {
        if (!name.ends_with("(sample,t,ctx,+residuals).sample")) continue;
        HashedWeights unet_weights;  // the U-Net matching this ControlNet's shapes; its decoder mirrors the encoder
        nn::UNetConfig whole = config;
        whole.up_attention.assign(config.down_attention.rbegin(), config.down_attention.rend());
        c.tensor(name, nn::unet(Scope(unet_weights), whole, sample, t, text, &out));
    }
}

void check_vae(Case& c, HashedWeights& weights) {
    const nn::VaeConfig config = nn::vae_config(c.network().json().at("config"), c.network().name());
    const nn::Listener listener = c.listener();
    const Scope s(weights, "", &listener);
    const Tensor x = raw(c.input(), c.shape());
    if (c.name().starts_with("dec")) return c.tensor("sample", nn::vae_decode(s, config, x));
    const nn::Gaussian out = nn::vae_encode(s, config, x);
    c.tensor("mean", out.mean);
    c.tensor("logvar (clamped -30..20)", out.log_variance);
}

// Cases of one network share their weights: generating 860 million of them takes longer than a small case.
Checker sharing(void (*check)(Case&, HashedWeights&)) {
    auto network = std::make_shared<std::string>();
    auto weights = std::make_shared<std::unique_ptr<HashedWeights>>();
    return [=](Case& c) {
        if (*network != c.network().name()) {
            *network = c.network().name();
            *weights = std::make_unique<HashedWeights>();
        }
        check(c, **weights);
    };
}

// ---- Diffusion360 --------------------------------------------------------------------------------------------------

struct Tiny {
    HashedWeights unet, vae, text, control;
    nn::UNetConfig unet_config, control_config;
    nn::VaeConfig vae_config;
    nn::ClipTower tower;
    explicit Tiny(const Case& c) {
        const Json& models = c.network().json().at("tiny_models");
        unet_config = nn::unet_config(models.at("unet"), "unet");
        control_config = models.contains("controlnet") ? nn::controlnet_config(models["controlnet"], "controlnet")
                                                       : unet_config;
        vae_config = nn::vae_config(models.at("vae"), "vae");
        tower = nn::clip_text_tower(models.at("text_encoder"), "text_encoder");
    }
    Tensor prompts(const Case& c, const std::string& prompt, const std::string& negative) {
        const auto tokens = prompt_tokens(c, prompt, negative, ClipTokenizer::kEnd);
        return at::cat({nn::embed_prompt(Scope(text), tower, tokens[1]).states,
                        nn::embed_prompt(Scope(text), tower, tokens[0]).states},
                       0);
    }
};

// As scheduler_config.json of Stable Diffusion 1.5 has it.
const Json kSchedule = {{"_class_name", "PNDMScheduler"},   {"beta_end", 0.012},
                        {"beta_schedule", "scaled_linear"}, {"beta_start", 0.00085},
                        {"num_train_timesteps", 1000},      {"set_alpha_to_one", false},
                        {"skip_prk_steps", true},           {"steps_offset", 1}};

void check_blend(Case& c) {
    const auto count = c.json().at("blend_extent").get<std::int64_t>();
    const Tensor a = raw(c.input() + "/a", c.shape()), b = raw(c.input() + "/b", c.shape());
    c.tensor("blend_h(a,b)", nn::blend_columns(a, b.clone(), count));
    c.tensor("blend_v(a,b)", nn::blend_rows(a, b.clone(), count));
    const Tensor same = a.clone();
    c.tensor("blend_h(a,a) aliased (latent step)", nn::blend_columns(same, same, count));
}

void check_tiled(Case& c) {
    Tiny tiny(c);
    std::smatch match;
    const std::string how = c.json().at("how");
    if (!std::regex_search(how, match, std::regex(R"(tile_latent_min_size (\d+))")))
        throw Error("the case does not name its tile_latent_min_size");
    const Tensor z = raw(c.input(), c.shape());
    c.tensor("sample", nn::circular_decode(Scope(tiny.vae), tiny.vae_config, z, std::stoi(match[1])));
    if (c.wants("plain decode for comparison"))
        c.tensor("plain decode for comparison", nn::vae_decode(Scope(tiny.vae), tiny.vae_config, z));
}

void check_text_to_panorama(Case& c) {
    Tiny tiny(c);
    const Json& j = c.json();
    const auto height = j.at("height").get<std::int64_t>(), width = j.at("width").get<std::int64_t>();
    const auto scheduler = nn::make_scheduler(
        nn::Sampler::euler_ancestral, nn::schedule_config(kSchedule, "", nn::Sampler::euler_ancestral), j.at("steps"));
    nn::TextToPanorama how;
    how.guidance = j.at("guidance_scale");
    how.seam = nn::Seam::published;
    how.blend_columns = width / 8 / 32;
    how.noise = [&](int i, const Tensor& like) { return raw(c.input() + fmt::format("/noise{}", i), like.sizes()); };
    how.listener = [&](int i, double t, const Tensor& x) {
        c.tensor(fmt::format("latents after scheduler step {} (before blend_h), t={}", i, std::lround(t)), x);
    };
    const Tensor text = tiny.prompts(c, j.at("prompt"), j.at("negative"));
    const Tensor latents = nn::text_to_panorama(Scope(tiny.unet), tiny.unet_config, *scheduler,
                                                raw(c.input() + "/latents", {1, 4, height / 8, width / 8}), text, how);
    c.value("blend_extend", static_cast<double>(how.blend_columns));
    c.tensor("final latents (blended, cropped)", latents);
    const std::int64_t tile = tiny.vae_config.sample_size / tiny.vae_config.factor();
    c.value("vae tiling", Json{{"tile_latent_min_size", tile},
                               {"tile_sample_min_size", tiny.vae_config.sample_size},
                               {"tile_overlap_factor", 0.25}});
    const Tensor picture = nn::circular_decode(Scope(tiny.vae), tiny.vae_config, latents / tiny.vae_config.scale, tile);
    c.tensor("vae.decode(final/0.18215) tiled+circular", picture);
    c.tensor("image in [0,1]", at::clamp(picture / 2 + 0.5, 0, 1).permute({0, 2, 3, 1}));
}

void check_refine(Case& c) {
    Tiny tiny(c);
    const Json& j = c.json();
    const auto height = j.at("height").get<std::int64_t>(), width = j.at("width").get<std::int64_t>();
    const std::string how_text = j.at("how");
    const auto number_after = [&](const std::string& pattern, double fallback) {
        std::smatch match;
        return std::regex_search(how_text, match, std::regex(pattern)) ? std::stod(match[1]) : fallback;
    };
    const auto text_after = [&](const std::string& pattern, const std::string& fallback) {
        std::smatch match;
        return std::regex_search(how_text, match, std::regex(pattern)) ? match[1].str() : fallback;
    };
    const int steps = static_cast<int>(number_after(R"((\d+) steps)", 7));
    const double strength = number_after(R"(strength ([\d.]*\d))", 0.8);
    const auto scheduler = nn::make_scheduler(nn::Sampler::unipc,
                                              nn::schedule_config(kSchedule, "", nn::Sampler::unipc), steps);
    nn::RefinePanorama how;
    how.guidance = number_after(R"(guidance ([\d.]*\d))", 15);
    how.control = j.value("controlnet_conditioning_scale", 1.0);  // as the published program calls it
    how.tile = j.at("context_size").get<std::int64_t>() / 8;
    how.first_step = steps - std::min(static_cast<int>(steps * strength), steps);
    how.batch = 3;  // not the published rows: the result must not depend on it
    int last = 0;
    how.listener = [&](int i, double t, const Tensor& x) {
        last = i;
        for (const std::string& name : c.tensor_names())
            if (name.starts_with("latents after") && name.ends_with(fmt::format("t={}", std::lround(t))))
                c.tensor(name, x);
    };
    const Tensor bytes = at::floor(unit(c.input() + "/img", {height, width, 3}) * 256);
    const Tensor picture = (bytes / 255).permute({2, 0, 1}).unsqueeze(0).contiguous();
    const Tensor text = tiny.prompts(c, text_after("prompt '([^']*)'", ""), text_after("negative '([^']*)'", ""));
    const Tensor latents = nn::refine_panorama(
        Scope(tiny.unet), tiny.unet_config, Scope(tiny.control), tiny.control_config, *scheduler,
        raw(c.input() + "/latents", {1, 4, height / 8, width / 8}), picture, text, how);
    c.tensor("final latents", latents);
    c.value("last sigma / state", Json{{"lower_order_nums", 1}, {"step_index", last + 1}});
}

void check_diffusion360(Case& c) {
    if (c.name().starts_with("blend")) return check_blend(c);
    if (c.name().starts_with("tiled")) return check_tiled(c);
    if (c.name().starts_with("sr")) return check_refine(c);
    check_text_to_panorama(c);
}

// ---- LPIPS, RRDBNet ------------------------------------------------------------------------------------------------

Tensor signed_picture(const ImageRgb8& image) {
    return (bytes_of(image).permute({2, 0, 1}).to(at::kFloat) / 127.5 - 1).unsqueeze(0).contiguous();
}

void check_lpips(Case& c) {
    const Network& network = c.network();
    HashedWeights backbone, heads;
    for (const Json& t : network.json().at("cases").at("heads").at("tensors"))
        heads.set(t.at("name"), network.stored(t).reshape(t.at("shape").get<std::vector<std::int64_t>>()));
    if (c.name() == "heads") {
        for (const std::string& name : c.tensor_names()) c.tensor(name, heads.seen().at(name));
        return;
    }
    const Json& cases = network.json()["cases"];
    const bool identical = c.name() == "identical";
    const Json& how = identical && !c.json().contains("image") && !c.json().contains("input")
                          ? cases.at("pano_crop_shift")
                          : c.json();
    Tensor a, b;
    if (how.contains("input")) {
        const std::string in = how["input"];
        const auto shape = how["shape"].get<std::vector<std::int64_t>>();
        a = raw(in + "/a", shape);
        b = at::clamp(a + 0.2f * raw(in + "/b", shape), -1, 1);
    } else {
        const ImageRgb8 whole = load_rgb8(picture_of(c, how["image"]));
        const Json& crop = how["crop_xywh"];
        const int x = crop[0], y = crop[1], w = crop[2], h = crop[3], dx = how["shift_dx_dy"][0],
                  dy = how["shift_dx_dy"][1];
        a = signed_picture(cropped(whole, x, y, x + w, y + h));
        b = signed_picture(cropped(whole, x + dx, y + dy, x + dx + w, y + dy + h));
    }
    if (identical) b = a;
    const nn::Lpips out = nn::lpips(
        Scope(backbone), Scope(heads),
        network.name().find("vgg") != std::string::npos ? nn::LpipsNet::vgg : nn::LpipsNet::alex, a, b);
    c.tensor("lpips", out.distance);
    c.tensor("spatial map", out.map);
    for (std::size_t i = 0; i < out.layers.size(); ++i) {
        c.tensor(fmt::format("per_layer[{}]", i), out.layers[i]);
        c.tensor(fmt::format("backbone relu[{}](in0)", i), out.first_maps[i]);
    }
}

void check_rrdbnet(Case& c, HashedWeights& weights) {
    const Json& j = c.network().json().at("config");
    const nn::RrdbConfig config{j.at("num_feat"), j.at("num_block"), j.at("num_grow_ch"), j.at("scale")};
    const nn::Listener listener = c.listener();
    c.tensor("output", nn::rrdbnet(Scope(weights, "", &listener), config, unit(c.input(), c.shape())));
}

}  // namespace

void add_diffusion_checkers(Checkers& checkers) {
    checkers.emplace_back("tokenizer", check_tokenizer);
    checkers.emplace_back("schedulers", check_scheduler);
    checkers.emplace_back("clip_text*", check_clip_text);
    checkers.emplace_back("clip_vit*", check_clip);
    checkers.emplace_back("unet*", sharing(check_unet));
    checkers.emplace_back("controlnet*", sharing(check_controlnet));
    checkers.emplace_back("vae*", sharing(check_vae));
    checkers.emplace_back("diffusion360", check_diffusion360);
    checkers.emplace_back("lpips*", check_lpips);
    checkers.emplace_back("rrdbnet*", sharing(check_rrdbnet));
}

}  // namespace fastscene::golden
