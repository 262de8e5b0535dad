// Benchmark of panorama generation with random weights of Stable Diffusion 1.5's sizes: CPU seconds and memory of its
// parts, the U-Net's layers by kind against the machine's matrix product, and the seam over many small models. --write
// creates a folder of such weights, so that the program's own commands can be timed at the published sizes without the
// official files.
#include <ATen/ATen.h>
#include <c10/core/InferenceMode.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <vector>

#include "cpu_clock.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/base/parallel.h"
#include "fastscene/nn/circular.h"
#include "fastscene/nn/clip.h"
#include "fastscene/nn/hashed.h"
#include "fastscene/nn/panorama_loops.h"
#include "fastscene/nn/precision.h"
#include "fastscene/nn/rrdbnet.h"
#include "fastscene/nn/runtime.h"
#include "fastscene/weights/safetensors.h"
#include "fastscene/nn/sd_model.h"
#include "fastscene/nn/tiny_tokenizer.h"
#include "fastscene/nn/weights_torch.h"

namespace {

using namespace fastscene;
using at::Tensor;
using nn::HashedWeights;
using nn::Scope;

double peak_gib() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == "VmHWM:") {
            double kib = 0;
            status >> kib;
            return kib / (1 << 20);
        }
    return 0;
}

const Json kUnet = {
    {"block_out_channels", {320, 640, 1280, 1280}},
    {"layers_per_block", 2},
    {"attention_head_dim", 8},
    {"cross_attention_dim", 768},
    {"down_block_types", {"CrossAttnDownBlock2D", "CrossAttnDownBlock2D", "CrossAttnDownBlock2D", "DownBlock2D"}},
    {"up_block_types", {"UpBlock2D", "CrossAttnUpBlock2D", "CrossAttnUpBlock2D", "CrossAttnUpBlock2D"}}};
const Json kVae = {
    {"block_out_channels", {128, 256, 512, 512}},
    {"layers_per_block", 2},
    {"latent_channels", 4},
    {"norm_num_groups", 32},
    {"sample_size", 512},
    {"down_block_types", {"DownEncoderBlock2D", "DownEncoderBlock2D", "DownEncoderBlock2D", "DownEncoderBlock2D"}},
    {"up_block_types", {"UpDecoderBlock2D", "UpDecoderBlock2D", "UpDecoderBlock2D", "UpDecoderBlock2D"}}};

void save_half(const HashedWeights& weights, const std::filesystem::path& file, const std::string& inside = "") {
    make_directories(file.parent_path());
    Weights out;
    for (const auto& [key, tensor] : weights.seen()) out.tensors[inside + key] = nn::weight_of(tensor.to(at::kHalf));
    save_safetensors(file, out);
}

// A folder in Diffusion360's layout: sd-base/, sr-base/ (a link to it), sr-control/, RealESRGAN_x2plus.pth. A small
// forward pass requests each network's weights; the vocabulary is the tests' synthetic one, since CLIP's cannot be
// distributed.
void write_models(const std::filesystem::path& folder) {
    constexpr const char* kModel = "diffusion_pytorch_model.safetensors";
    const auto base = folder / "sd-base";
    const auto configured = [](const std::filesystem::path& part, Json config, const char* name) {
        make_directories(part);
        config["_class_name"] = name;
        write_json(part / "config.json", config);
        return config;
    };
    {
        HashedWeights weights;
        const Json config = configured(base / "unet", kUnet, "UNet2DConditionModel");
        nn::unet(Scope(weights), nn::unet_config(config, "unet"), at::zeros({1, 4, 8, 8}), 1, at::zeros({1, 2, 768}));
        save_half(weights, base / "unet" / kModel);
    }
    {
        HashedWeights weights;
        const nn::VaeConfig config = nn::vae_config(configured(base / "vae", kVae, "AutoencoderKL"), "vae");
        nn::vae_decode(Scope(weights), config, at::zeros({1, 4, 2, 2}));
        nn::vae_encode(Scope(weights), config, at::zeros({1, 3, 16, 16}));
        save_half(weights, base / "vae" / kModel);
    }
    {
        HashedWeights weights;
        const Json config = configured(base / "text_encoder",
                                       {{"hidden_size", 768},
                                        {"intermediate_size", 3072},
                                        {"num_hidden_layers", 12},
                                        {"num_attention_heads", 12},
                                        {"hidden_act", "quick_gelu"}},
                                       "CLIPTextModel");
        nn::clip_text(Scope(weights), nn::clip_text_tower(config, "text"),
                      at::full({1, 2}, ClipTokenizer::kEnd, at::kLong));
        save_half(weights, base / "text_encoder/model.safetensors");
    }
    make_directories(base / "tokenizer");
    write_tiny_tokenizer(base / "tokenizer");
    make_directories(base / "scheduler");
    write_json(base / "scheduler/scheduler_config.json", {{"_class_name", "PNDMScheduler"},
                                                          {"beta_start", 0.00085},
                                                          {"beta_end", 0.012},
                                                          {"beta_schedule", "scaled_linear"},
                                                          {"num_train_timesteps", 1000},
                                                          {"set_alpha_to_one", false},
                                                          {"steps_offset", 1},
                                                          {"prediction_type", "epsilon"}});
    std::filesystem::create_directory_symlink("sd-base", folder / "sr-base");
    {
        HashedWeights weights;
        Json how = kUnet;
        how.erase("up_block_types");
        how["conditioning_channels"] = 3;
        how["conditioning_embedding_out_channels"] = {16, 32, 96, 256};
        const Json config = configured(folder / "sr-control", how, "ControlNetModel");
        nn::controlnet(Scope(weights), nn::controlnet_config(config, "control"), at::zeros({1, 4, 8, 8}), 1,
                       at::zeros({1, 2, 768}), at::zeros({1, 3, 64, 64}));
        save_half(weights, folder / "sr-control" / kModel);
    }
    HashedWeights weights;
    nn::rrdbnet(Scope(weights), {64, 23, 32, 2}, at::zeros({1, 3, 8, 8}));
    save_half(weights, folder / "RealESRGAN_x2plus.pth", "params_ema.");
}

// Attributes the time since the last layer's output to the kind of the current layer; also its operations, if they
// follow from its shapes.
class Kinds {
  public:
    explicit Kinds(const HashedWeights& weights) : weights_(weights) {}
    void start() { last_ = cpu_seconds(); }
    void hear(const std::string& name, const Tensor& out) {
        const double now = cpu_seconds();
        const auto weight = weights_.seen().find(name + ".weight");
        std::string kind = "other";
        double flops = 0;
        if (name.ends_with("attention")) {
            kind = "attention";
            const double keys = name.find("attn2") != std::string::npos ? 77 : static_cast<double>(out.size(1));
            flops = 4 * static_cast<double>(out.numel()) * keys;
        } else if (weight != weights_.seen().end() && weight->second.dim() >= 2) {
            const Tensor& w = weight->second;
            kind = w.dim() == 4 ? (w.size(2) == 3 ? "convolution 3x3" : "convolution 1x1") : "linear";
            flops = 2 * static_cast<double>(out.numel()) * static_cast<double>(w.numel() / w.size(0));
        } else if (weight != weights_.seen().end()) {
            kind = "norm";
        }
        seconds_[kind] += now - last_;
        flops_[kind] += flops;
        last_ = cpu_seconds();
    }
    Json json(double peak) const {
        Json out = Json::object();
        for (const auto& [kind, seconds] : seconds_) {
            const double gflops = flops_.at(kind) / 1e9;
            out[kind] = {{"cpu_s", seconds},
                         {"gflop", gflops},
                         {"gflop_per_cpu_s", gflops / seconds},
                         {"times_peak", gflops > 0 ? Json(peak / (gflops / seconds)) : Json()}};
        }
        return out;
    }

  private:
    const HashedWeights& weights_;
    std::map<std::string, double> seconds_, flops_;
    double last_ = 0;
};

double matrix_peak(at::ScalarType type) {  // GFLOP per CPU second
    const Tensor a = at::randn({2048, 2048}).to(type), b = at::randn({2048, 2048}).to(type);
    double best = 0;
    for (int i = 0; i < 5; ++i) {
        const double begin = cpu_seconds();
        at::mm(a, b);
        best = std::max(best, 2 * std::pow(2048., 3) / 1e9 / (cpu_seconds() - begin));
    }
    return best;
}

Json cost(int width, int steps, at::ScalarType type) {
    const nn::UNetConfig config = nn::unet_config(kUnet, "unet");
    const nn::VaeConfig pictures = nn::vae_config(kVae, "vae");
    const std::int64_t w = width / nn::kPixelsPerLatent;
    HashedWeights weights(type);
    const Tensor text = at::randn({2, 154, 768}).to(type);
    {
        const Tensor tiny = at::zeros({1, 4, 8, 8}).to(type);
        nn::unet(Scope(weights), config, tiny, 1, text.narrow(0, 0, 1));  // weights exist from here on
    }
    const double peak = matrix_peak(type);
    Kinds kinds(weights);
    const nn::Listener listener = [&](const std::string& name, const Tensor& out) { kinds.hear(name, out); };
    const Scope denoiser(weights, "", &listener);
    const Tensor x = at::randn({2, 4, w / 2, w + w / 32}).to(type);
    std::vector<double> seconds;
    for (int i = 0; i < steps; ++i) {
        const double begin = cpu_seconds();
        kinds.start();
        nn::unet(denoiser, config, x, 500, text);
        seconds.push_back(cpu_seconds() - begin);
    }
    Json out = {{"width", width},
                {"type", type == at::kFloat ? "float" : "bf16"},
                {"matrix_gflop_per_cpu_s", peak},
                {"step_cpu_s", seconds},
                {"denoiser_gib", peak_gib()},
                {"kinds", kinds.json(peak)}};
    HashedWeights decoder;
    nn::vae_decode(Scope(decoder), pictures, at::zeros({1, 4, 1, 1}));
    const Tensor z = at::randn({1, 4, w / 2, w});
    const auto decoded = [&](bool coarse) {
        const nn::Autocast bf16(at::kCPU, coarse);
        return nn::circular_decode(Scope(decoder), pictures, z, 64).to(at::kFloat);
    };
    const double begin = cpu_seconds();
    const Tensor picture = decoded(type != at::kFloat);
    out["decode_cpu_s"] = cpu_seconds() - begin;
    out["peak_gib"] = peak_gib();
    if (type != at::kFloat) {
        const Tensor exact = decoded(false);
        out["decoder_error_of_deviation"] = ((picture - exact).square().mean().sqrt() / exact.std()).item<double>();
    }
    const double step = *std::min_element(seconds.begin(), seconds.end());
    // Previews after a tenth of the steps and halfway; both are decoded at half size.
    const double looked = cpu_seconds();
    nn::circular_decode(Scope(decoder), pictures, at::avg_pool2d(z, {2, 2}), 64);
    const double look = cpu_seconds() - looked;
    out["preview_decode_cpu_s"] = look;
    out["first_preview_share"] = (2 * step + look) / (20 * step + 2 * look + out["decode_cpu_s"].get<double>());
    out["twenty_steps_cpu_min_extrapolated"] = (20 * step + out["decode_cpu_s"].get<double>()) / 60;
    return out;
}

// Mean difference between the two ends, relative to the largest one of all adjacent columns: 1 = as large.
Json seam(int runs) {
    const nn::VaeConfig pictures = nn::vae_config({{"block_out_channels", {8, 8, 16, 16}},
                                                   {"layers_per_block", 1},
                                                   {"latent_channels", 4},
                                                   {"norm_num_groups", 4},
                                                   {"sample_size", 64},
                                                   {"down_block_types", kVae["down_block_types"]},
                                                   {"up_block_types", kVae["up_block_types"]}},
                                                  "vae");
    const nn::UNetConfig config = nn::unet_config({{"norm_num_groups", 8},
                                                   {"block_out_channels", {16, 32}},
                                                   {"layers_per_block", 1},
                                                   {"attention_head_dim", 4},
                                                   {"cross_attention_dim", 32},
                                                   {"down_block_types", {"CrossAttnDownBlock2D", "DownBlock2D"}},
                                                   {"up_block_types", {"UpBlock2D", "CrossAttnUpBlock2D"}}},
                                                  "unet");
    Json out = Json::object();
    for (const nn::Seam kind : {nn::Seam::closed, nn::Seam::published}) {
        std::vector<double> against_most, against_middle;
        for (int run = 0; run < runs; ++run) {
            at::manual_seed(static_cast<std::uint64_t>(run));
            HashedWeights unet(at::kFloat, std::to_string(run)), vae(at::kFloat, std::to_string(run));
            nn::ScheduleConfig schedule;
            const auto sampler = nn::make_scheduler(nn::Sampler::euler_ancestral, schedule, 4);
            nn::TextToPanorama how;
            how.seam = kind;
            how.blend_columns = 1;
            how.noise = [](int, const Tensor& like) { return at::randn_like(like); };
            const Tensor latents = nn::text_to_panorama(Scope(unet), config, *sampler, at::randn({1, 4, 16, 32}),
                                                        at::randn({2, 77, 32}), how);
            const Tensor picture = nn::circular_decode(Scope(vae), pictures, latents / pictures.scale, 8,
                                                       kind == nn::Seam::closed);
            const Tensor steps = (picture - at::roll(picture, {1}, {3}))
                                     .abs()
                                     .mean(at::IntArrayRef{0, 1, 2});  // [W]: column x against x - 1
            const Tensor inside = steps.narrow(0, 1, steps.size(0) - 1);
            against_most.push_back((steps[0] / inside.max()).item<double>());
            against_middle.push_back((steps[0] / inside.median()).item<double>());
        }
        const auto mean = [](const std::vector<double>& v) {
            double sum = 0;
            for (const double x : v) sum += x;
            return sum / static_cast<double>(v.size());
        };
        out[kind == nn::Seam::closed ? "closed" : "published"] = {
            {"runs", runs},
            {"worst_against_greatest", *std::max_element(against_most.begin(), against_most.end())},
            {"mean_against_median", mean(against_middle)},
            {"worst_against_median", *std::max_element(against_middle.begin(), against_middle.end())}};
    }
    return out;
}

}  // namespace

int main(int argc, char** argv) try {
    int width = 1024, steps = 2, threads = 1, runs = 0;
    std::string type = "float", folder;
    CLI::App app{"Cost of painting a panorama; the seam"};
    app.add_option("--width", width, "Pixels")->check(CLI::Range(256, 4096));
    app.add_option("--steps", steps, "Steps that are timed")->check(CLI::Range(1, 100));
    app.add_option("--threads", threads, "Worker threads")->check(CLI::Range(1, 1024));
    app.add_option("--type", type, "float or bf16")->check(CLI::IsMember({"float", "bf16"}));
    app.add_option("--seam", runs, "Instead: measure the seam over so many small random models")
        ->check(CLI::Range(1, 10000));
    app.add_option("--write", folder, "Instead: a new folder of random weights of the published sizes, for --weights");
    CLI11_PARSE(app, argc, argv);
    set_threads(threads);
    const c10::InferenceMode inference;
    use_our_threads();
    if (!folder.empty()) {
        write_models(folder);
        return 0;
    }
    fmt::print("{}\n", (runs > 0 ? seam(runs) : cost(width, steps, nn::type_of_precision(type, at::kCPU))).dump(2));
    return 0;
} catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
}
