// Benchmark of the networks on a device: seconds of a panorama, its steps and its enlargement, of depth networks and of
// the inpainter, and how far the results are from a CPU's. Weights of the published sizes come from
// `bench_diffusion --write`; DA-2's are made up. One line of JSON per part.
#include <ATen/ATen.h>
#include <c10/core/InferenceMode.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <vector>

#include "fastscene/base/failure.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/base/parallel.h"
#include "fastscene/image/image.h"
#include "fastscene/nn/aotgan.h"
#include "fastscene/nn/circular.h"
#include "fastscene/nn/da2_net.h"
#include "fastscene/nn/diffusion360.h"
#include "fastscene/nn/egformer.h"
#include "fastscene/nn/fused.h"
#include "fastscene/nn/hashed.h"
#include "fastscene/nn/hashed_aotgan.h"
#include "fastscene/nn/libtorch.h"
#include "fastscene/nn/panorama_loops.h"
#include "fastscene/nn/precision.h"
#include "fastscene/nn/replay.h"
#include "fastscene/nn/runtime.h"
#include "fastscene/nn/sd_model.h"
#include "fastscene/nn/turned_passes.h"
#include "fastscene/nn/upscale360.h"

namespace {

using namespace fastscene;
namespace fs = std::filesystem;
using at::Tensor;
using nn::Scope;

constexpr const char* kPrompt = "a living room with a sofa, a wooden table and a large window";

struct Settings {
    std::string part = "paint", weights, models, device = "auto", precision = "float", keep, against;
    int width = 1024, steps = 20, runs = 3, threads = 0;
};

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Seconds of each of `runs` calls.
std::vector<double> seconds_of(int runs, const at::Device& device, const std::function<void()>& work) {
    std::vector<double> out;
    for (int i = 0; i < runs; ++i) {
        nn::wait_for(device);
        const double begin = now_s();
        work();
        nn::wait_for(device);
        out.push_back(now_s() - begin);
    }
    return out;
}
double least(const std::vector<double>& all) { return *std::min_element(all.begin(), all.end()); }

struct Difference {
    double largest = 0, mean = 0;
    void add(double a, double b) {
        largest = std::max(largest, std::abs(a - b));
        mean += std::abs(a - b);
    }
    Json json(std::size_t count) const { return {{"largest", largest}, {"mean", mean / static_cast<double>(count)}}; }
};

// Of two pictures, in 255ths.
Json difference(const ImageRgb8& a, const ImageRgb8& b) {
    Difference d;
    for (std::size_t i = 0; i < a.size(); ++i) {
        d.add(a.pixels[i].r, b.pixels[i].r);
        d.add(a.pixels[i].g, b.pixels[i].g);
        d.add(a.pixels[i].b, b.pixels[i].b);
    }
    return d.json(3 * a.size());
}

void keep_or_compare(const Settings& with, const ImageRgb8& picture, Json& out) {
    const auto bytes = picture.size() * sizeof(Rgb8);
    if (!with.keep.empty())
        write_file(with.keep, std::string(reinterpret_cast<const char*>(picture.pixels.data()), bytes));
    if (with.against.empty() || !fs::exists(with.against)) return;
    const std::string other = read_file(with.against);
    if (other.size() != bytes) return;
    ImageRgb8 image(picture.width, picture.height);
    std::copy_n(reinterpret_cast<const Rgb8*>(other.data()), image.size(), image.pixels.data());
    out["difference_255ths"] = difference(picture, image);
}

Json paint(const Settings& with) {
    Diffusion360Settings settings;
    settings.width = with.width, settings.steps = with.steps;
    settings.device = with.device, settings.precision = with.precision;
    const double begin = now_s();
    const Diffusion360 painter(with.weights, settings, {});
    const double opened = now_s();
    ImageRgb8 picture = painter.paint(kPrompt, {});
    const double first = now_s();
    const std::vector<double> more = seconds_of(with.runs, at::kCPU, [&] { picture = painter.paint(kPrompt, {}); });
    Json out = {{"open_s", opened - begin}, {"first_s", first - opened}};
    if (!more.empty()) out["s"] = least(more), out["all_s"] = more;
    keep_or_compare(with, picture, out);
    return out;
}

// A picture with edges and gradients.
template <class Pixel, class Make>
Image<Pixel> drawn(int width, int height, Make&& make) {
    Image<Pixel> out(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(width),
                        v = static_cast<float>(y) / static_cast<float>(height);
            out.at(x, y) = make(u, v, ((x / 32 + y / 32) % 2) * 0.2f);
        }
    return out;
}
ImageColor drawn_color(int width, int height) {
    return drawn<Vec3f>(width, height, [](float u, float v, float check) {
        return Vec3f{0.2f + 0.6f * u, 0.3f + check, 0.2f + 0.5f * v};
    });
}

Json enlarge(const Settings& with) {
    Upscale360Settings settings;
    settings.device = with.device, settings.precision = with.precision;
    const ImageRgb8 start = drawn<Rgb8>(with.width, with.width / 2, [](float u, float v, float check) {
        const auto byte = [](float x) { return static_cast<std::uint8_t>(255 * x); };
        return Rgb8{byte(0.2f + 0.6f * u), byte(0.3f + check), byte(0.2f + 0.5f * v)};
    });
    const Upscale360 enlarger(with.weights, with.width, settings, {});
    Json runs = Json::array();
    ImageRgb8 picture;
    for (int i = 0; i <= with.runs; ++i) {
        Json stages = Json::object();
        const double begin = now_s();
        picture = enlarger.enlarge(start, kPrompt, {}, [&](const std::string& to, const auto& make) {
            const double from = now_s();
            ImageRgb8 made = make();
            stages[to] = now_s() - from;
            return made;
        });
        stages["s"] = now_s() - begin;
        runs.push_back(stages);
    }
    Json out = {{"runs", runs}, {"pixels", fmt::format("{} x {}", picture.width, picture.height)}};
    keep_or_compare(with, picture, out);
    return out;
}

// Seconds of each kind of layer in one step, the card waited for after every layer.
Json kinds_of(nn::SdModel& model, const Tensor& x, const Tensor& waves, const Tensor& text) {
    std::map<std::string, double> seconds;
    double last = 0;
    const nn::Listener listener = [&](const std::string& name, const Tensor& output) {
        nn::wait_for(output.device());
        const auto shape = model.unet->shape_of(name + ".weight");
        std::string kind = "other";
        if (name.ends_with("attn1.attention")) kind = "self-attention";
        else if (name.ends_with("attention")) kind = "cross-attention";
        else if (shape.size() == 4) kind = shape[2] == 3 ? "convolution 3x3" : "convolution 1x1";
        else if (shape.size() == 2) kind = "linear";
        else if (shape.size() == 1) kind = "norm";
        seconds[kind] += now_s() - last;
        last = now_s();
    };
    for (int i = 0; i < 2; ++i) {
        seconds.clear();
        nn::wait_for(x.device());
        last = now_s();
        nn::unet(Scope(*model.unet, "", &listener), model.unet_config, x, waves, text);
    }
    return Json(seconds);
}

// Our kernels against libtorch's layers, on a picture like those of a step: seconds of each, and the largest
// difference.
Json kernels_on(const at::TensorOptions& there, std::int64_t w, int runs) {
    const at::Device device = there.device();
    const Tensor x = at::randn({2, 320, w / 2, w}, at::kFloat).to(there).contiguous(at::MemoryFormat::ChannelsLast),
                 weight = at::randn({320}, at::kFloat).to(there), bias = at::randn({320}, at::kFloat).to(there),
                 both = at::randn({2, w / 2 * w, 2560}, at::kFloat).to(there);
    const auto compared = [&](const std::function<Tensor()>& ours, const std::function<Tensor()>& theirs) -> Json {
        Tensor a = ours(), b = theirs();
        if (!a.defined()) return nullptr;
        const double ours_s = least(seconds_of(runs, device, [&] { a = ours(); })),
                     theirs_s = least(seconds_of(runs, device, [&] { b = theirs(); }));
        return {{"s", ours_s},
                {"libtorch_s", theirs_s},
                {"differs_by", (a.to(at::kFloat) - b.to(at::kFloat)).abs().max().item<double>()}};
    };
    return {{"group_norm", compared([&] { return nn::fused_group_norm(x, weight, bias, 32, 1e-5, true); },
                                    [&] { return at::silu(at::group_norm(x, 32, weight, bias, 1e-5)); })},
            {"gated_gelu", compared([&] { return nn::fused_gated_gelu(both); },
                                    [&] {
                                        const std::vector<Tensor> halves = both.chunk(2, -1);
                                        return halves[0] * at::gelu(halves[1]);
                                    })}};
}

// What a panorama's seconds are made of.
Json parts(const Settings& with) {
    const fs::path base = fs::exists(fs::path(with.weights) / "sd-base") ? fs::path(with.weights) / "sd-base"
                                                                         : fs::path(with.weights);
    nn::SdModel model(base, nn::sd_options(with.precision, with.device, nn::Sampler::euler_ancestral, false, false));
    const at::Device device = model.options.device;
    const at::TensorOptions there = at::TensorOptions(device).dtype(model.options.type);
    const std::int64_t w = with.width / nn::kPixelsPerLatent;
    const double begin = now_s();
    Tensor text = model.read_prompt(kPrompt, kPrompt, {});
    nn::wait_for(device);
    const double read = now_s();
    Json out = {{"text_first_s", read - begin},
                {"text_s", least(seconds_of(3, device, [&] { text = model.read_prompt(kPrompt, kPrompt, {}); }))}};
    const Tensor x = at::randn({2, 4, w / 2, w + w / 32}).to(there),
                 waves = nn::waves_of_time(500, model.unet_config, x);
    const Scope denoiser(*model.unet);
    const nn::Replay::Net net = [&](const std::vector<Tensor>& in) {
        return nn::unet(denoiser, model.unet_config, in[0], in[1], in[2]);
    };
    Tensor eager, again;
    out["step_first_s"] = seconds_of(1, device, [&] { eager = net({x, waves, text}); })[0];
    out["step_s"] = least(seconds_of(with.runs, device, [&] { eager = net({x, waves, text}); }));
    nn::Replay replay;
    std::vector<double> recorded = seconds_of(2 + with.runs, device, [&] { again = replay({x, waves, text}, net); });
    out["record_s"] = recorded[1];
    recorded.erase(recorded.begin(), recorded.begin() + 2);
    out["replayed_step_s"] = least(recorded);
    out["replay_differs_by"] = (again - eager).abs().max().item<double>();
    out["step_deviation"] = eager.to(at::kFloat).std().item<double>();
    out["kinds_s"] = kinds_of(model, x, waves, text);
    const Tensor z = at::randn({1, 4, w / 2, w}).to(device, model.options.picture_type());
    Tensor picture;
    const auto decode = [&] {
        picture = nn::circular_decode(Scope(*model.vae), model.vae_config, z,
                                      model.vae_config.sample_size / nn::kPixelsPerLatent, true);
    };
    out["decode_first_s"] = seconds_of(1, device, decode)[0];
    out["decode_s"] = least(seconds_of(with.runs, device, decode));
    out["kernels"] = kernels_on(there, w, with.runs);
    out["decode_finite"] = at::isfinite(picture).all().item<bool>();
    return out;
}

Json depth(const Settings& with) {
    Json out = Json::object();
    for (const char* name : {"egformer-rooms-256", "egformer-rooms"}) {
        const fs::path file = fs::path(with.models) / (std::string(name) + ".safetensors");
        if (!fs::exists(file)) continue;
        const ImageColor picture = drawn_color(1024, 512);
        ImageF reference;
        for (const std::string& device : {std::string("cpu"), with.device}) {
            const Egformer network = Egformer::load(file, {device, "--device"});
            ImageF found;
            const double first = seconds_of(1, at::kCPU, [&] { found = network.relative_depth(picture, 1); })[0];
            const double s = least(
                seconds_of(with.runs, at::kCPU, [&] { found = network.relative_depth(picture, 1); }));
            Json& entry = out[name][device];
            entry = {{"first_s", first}, {"s", s}};
            if (reference.empty()) {
                reference = found;
                continue;
            }
            Difference d;
            for (std::size_t i = 0; i < found.size(); ++i)
                d.add(static_cast<double>(found.pixels[i]), static_cast<double>(reference.pixels[i]));
            entry["difference"] = d.json(found.size());
        }
    }
    return out;
}

// Multiplications and additions of DA-2's matrix products and convolutions, for a grid of patches.
double da2_operations(double rows, double columns) {
    const nn::Da2Shape shape;
    const double n = rows * columns, tokens = n + 1, pixels = n * nn::kDinoPatch * nn::kDinoPatch,
                 c = static_cast<double>(shape.dino.width), blocks = static_cast<double>(shape.dino.blocks),
                 f = static_cast<double>(shape.features);
    double products = blocks * (12 * c * c * tokens + 2 * tokens * tokens * c) +
                      3 * nn::kDinoPatch * nn::kDinoPatch * c * n;
    products += 4 * (n * c * f + 12 * f * f * n + 2 * n * n * f) + n * f * f;  // aligners, cross-attention
    products += n * f * f * 5 + n * f * (f / 2) * 16;                          // process_features
    const double in[] = {f, f, f / 2}, out[] = {f, f / 2, f / 4}, grid[] = {n, 4 * n, 16 * n};
    for (int i = 0; i < 3; ++i) products += grid[i] * (4 * 9 * in[i] * in[i] + in[i] * out[i]);
    products += 64 * n * (f / 4 * f / 4 + 9 * f / 4 * f / 8) + pixels * (9 * f / 8 * f / 16 + f / 16);
    return 2 * products;
}

// Neighbouring columns' mean difference of the logarithm: across the seam, and across all others.
Json seam_of(const Tensor& distance) {
    const Tensor log = distance.squeeze(0).to(at::kCPU).log(), step = (log - log.roll(1, 1)).abs().mean(0);
    const double seam = step[0].item<double>(), others = step.narrow(0, 1, step.size(0) - 1).mean().item<double>();
    return {{"seam", seam}, {"others", others}};
}

// A pass of DA-2 with made-up weights: seconds, operations against those of a plain matrix product of its own shape,
// memory, and what is left of the seam after passes of several turns.
Json da2(const Settings& with) {
    const at::Device device = nn::device_named(with.device, "--device");
    const std::int64_t columns = with.width / nn::kDinoPatch, rows = columns / 2, height = rows * nn::kDinoPatch,
                       width = columns * nn::kDinoPatch;
    nn::HashedWeights weights(at::TensorOptions(device).dtype(at::kFloat));
    const nn::Da2Size whole{height, width, {static_cast<double>(width), static_cast<double>(height)}};
    const ImageColor drawn = drawn_color(static_cast<int>(width), static_cast<int>(height));
    Tensor color = at::empty({1, 3, height, width});
    for (std::int64_t i = 0; i < color.numel() / 3; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            color.data_ptr<float>()[static_cast<std::int64_t>(c) * height * width + i] =
                drawn.pixels[static_cast<std::size_t>(i)][c];
    color = color.to(device);
    const nn::DistanceNet net = [&](const Tensor& seen) {
        return at::exp(nn::da2_log_distance(Scope(weights), {}, seen, whole, with.precision == "bf16")).squeeze(1);
    };
    Tensor found;
    const double first = seconds_of(1, device, [&] { found = net(color); })[0];
    const double s = least(seconds_of(with.runs, device, [&] { found = net(color); }));
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const Tensor a = at::randn({rows * columns + 1, 1024}).to(device), b = at::randn({4096, 1024}).to(device);
    const double product_s = least(seconds_of(5, device, [&] { at::linear(a, b); }));
    const double operations = da2_operations(static_cast<double>(rows), static_cast<double>(columns)),
                 speed = operations / s, peak = 2. * static_cast<double>(a.numel()) * 4096 / product_s;
    Json out = {{"pixels", fmt::format("{} x {}", width, height)},
                {"first_s", first},
                {"s", s},
                {"gflop", operations / 1e9},
                {"gflop_per_s", speed / 1e9},
                {"product_gflop_per_s", peak / 1e9},
                {"share", speed / peak},
                {"peak_mib", usage.ru_maxrss / 1024}};
    for (const int turns : {1, 2, 4}) out["turns"][std::to_string(turns)] = seam_of(nn::over_turns(color, turns, net));
    return out;
}

Json inpaint(const Settings& with) {
    Json out = Json::object();
    const int side = 512;
    ImageMask hole(side, side);
    for (int y = side / 4; y < side / 2; ++y)
        for (int x = side / 4; x < side / 2; ++x) hole.at(x, y) = 1;
    const std::vector<Aotgan::Picture> pictures(2, {drawn_color(side, side), hole});
    const fs::path ours = fs::path(with.models) / "aotgan-rooms.safetensors";
    for (const std::string& name : {std::string("aotgan-rooms"), std::string("width 64, 8 blocks")}) {
        if (name == "aotgan-rooms" && !fs::exists(ours)) continue;
        std::vector<ImageColor> reference;
        for (const std::string& device : {std::string("cpu"), with.device}) {
            const Aotgan network = name == "aotgan-rooms" ? Aotgan::load(ours, {device, "--device"})
                                                          : Aotgan::of(hashed_aotgan(64, 8), {device, "--device"});
            std::vector<ImageColor> found;
            const double first = seconds_of(1, at::kCPU, [&] { found = network.paint(pictures, {}); })[0];
            const double s = least(seconds_of(with.runs, at::kCPU, [&] { found = network.paint(pictures, {}); }));
            Json& entry = out[name][device];
            entry = {{"first_s", first}, {"s", s}};
            if (reference.empty()) {
                reference = found;
                continue;
            }
            Difference d;
            for (std::size_t i = 0; i < found[0].size(); ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    d.add(static_cast<double>(found[0].pixels[i][c]), static_cast<double>(reference[0].pixels[i][c]));
            entry["difference"] = d.json(3 * found[0].size());
        }
    }
    return out;
}

}  // namespace

int main(int argc, char** argv) try {
    Settings with;
    CLI::App app{"The networks on a device"};
    app.add_option("--part", with.part, "paint, parts, enlarge, depth, da2 or inpaint")
        ->check(CLI::IsMember({"paint", "parts", "enlarge", "depth", "da2", "inpaint"}));
    app.add_option("--weights", with.weights, "A folder that bench_diffusion --write made");
    app.add_option("--models", with.models, "The source tree's models/");
    app.add_option("--device", with.device, "auto, cpu or cuda")->check(CLI::IsMember({"auto", "cpu", "cuda"}));
    app.add_option("--precision", with.precision, "float, bf16 or fp16");
    app.add_option("--width", with.width, "Of the panorama in pixels")->check(CLI::Range(256, 4096));
    app.add_option("--steps", with.steps, "Of the sampler")->check(CLI::Range(1, 1000));
    app.add_option("--runs", with.runs, "That are timed after the first")->check(CLI::Range(1, 100));
    app.add_option("--threads", with.threads, "Worker threads; 0: all");
    app.add_option("--keep", with.keep, "Writes the picture's bytes here");
    app.add_option("--against", with.against, "Compares with bytes that --keep wrote");
    CLI11_PARSE(app, argc, argv);
    set_threads(with.threads);
    const c10::InferenceMode inference;
    use_our_threads();
    const std::map<std::string, std::function<Json(const Settings&)>> all{
        {"paint", paint}, {"parts", parts}, {"enlarge", enlarge}, {"depth", depth}, {"da2", da2}, {"inpaint", inpaint}};
    Json out = all.at(with.part)(with);
    out["part"] = with.part, out["device"] = with.device, out["precision"] = with.precision;
    out["width"] = with.width, out["steps"] = with.steps;
    const char* graphs = std::getenv("FASTSCENE_CUDA_GRAPHS");
    out["graphs"] = !graphs || std::string(graphs) != "0";
    out["libtorch"] = TORCH_VERSION;
    fmt::print("{}\n", out.dump());
    return 0;
} catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", fastscene::short_message(e));
    return 1;
}
