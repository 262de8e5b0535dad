// What path tracing a room costs on the processor and on a graphics card: gathering its light, its panorama, and views
// from where visitors stand; and how far the two pictures are apart. One line of JSON for the record.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>

#include "fastscene/base/json.h"
#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/pipeline/quality.h"
#include "fastscene/rooms/document.h"
#include "fastscene/trace/vulkan/card_gatherer.h"
#include "fastscene/trace/vulkan/card_pixels.h"

namespace {

using namespace fastscene;

template <class Work>
auto timed(Json& out, const char* name, Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    auto result = work();
    out[name] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

double squares_between(const ImageColor& a, const ImageColor& b) {
    double sum = 0;
    const ImageRgb8 p = srgb8_from_linear(a), q = srgb8_from_linear(b);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto add = [&](int d) { sum += d * d; };
        add(p.pixels[i].r - q.pixels[i].r), add(p.pixels[i].g - q.pixels[i].g), add(p.pixels[i].b - q.pixels[i].b);
    }
    return sum / (3 * static_cast<double>(p.size()));
}
double psnr_of(double squares) { return squares > 0 ? 10 * std::log10(255. * 255. / squares) : 99; }

struct Pictures {
    ImageColor panorama, paths;
    std::vector<ImageColor> views;
};

struct Asked {
    std::string prompt;
    PanoramaParams params;
    int views = 100, view_size = 512, paths = 16;
    std::uint64_t seed = 0;
};

Pictures render(const Asked& asked, const TraceBackend& backend, Json& out) {
    PanoramaParams params = asked.params;
    params.trace.backend = backend;
    const Run run{asked.seed, nullptr, {}};
    Json seconds;
    // With the outside, and on a card the room's tree and the compilation of kernels that gather.
    const auto room = timed(seconds, "gather", [&] { return make_traced_room({asked.prompt, {}}, params, run); });
    const EquirectSize size{params.width, params.width / 2};
    ShotParts parts = panorama_parts(params.trace);
    parts.range = parts.object = false;
    // On a card: with the compilation of their kernel.
    timed(seconds, "first_picture", [&] { return room->panorama({}, {64, 32}, parts, run); });
    Pictures made;
    made.panorama = timed(seconds, "panorama", [&] { return room->panorama({}, size, parts, run).color; });
    Random random(asked.seed, "bench.views");
    const ShotParts view_parts{.range = false, .pixel_samples = 16, .contacts = true, .denoise = true, .noise = 0.012f};
    made.views = timed(seconds, "views", [&] {
        std::vector<ImageColor> views;
        for (int i = 0; i < asked.views; ++i) {
            Vec3f at{random.uniform(-0.5f, 0.5f), random.uniform(-0.2f, 0.2f), random.uniform(-0.5f, 0.5f)};
            const float turn = random.uniform(0.f, 2 * kPi);
            if (!room->sees({}, at)) at = {};
            const Rigid pose{Mat3f::from_columns({std::cos(turn), 0, -std::sin(turn)}, {0, 1, 0},
                                                 {std::sin(turn), 0, std::cos(turn)}),
                             at};
            views.push_back(
                room->perspective(pose, Pinhole::with_fov(asked.view_size, asked.view_size, 80), view_parts, run)
                    .color);
        }
        return views;
    });
    if (asked.paths > 0) {
        ShotParts path_parts{.range = false, .pixel_samples = asked.paths, .paths = true};
        timed(seconds, "first_paths", [&] { return room->panorama({}, {64, 32}, path_parts, run); });
        made.paths = timed(seconds, "paths", [&] { return room->panorama({}, {512, 256}, path_parts, run).color; });
    }
    out["seconds"] = seconds;
    out["device"] = room->device();
    return made;
}

// Milliseconds of each kernel for gathering and the panorama, once more.
Json kernel_times(const Asked& asked, const std::string& device) {
    const Run run{asked.seed, nullptr, {}};
    DocumentRoom known = known_room({asked.prompt, {}}, asked.params, run);
    const Room room = room_of(known);
    Json out, seconds;
    const auto bvh = timed(seconds, "embree_trees", [&] { return std::make_unique<SceneBvh>(room); });
    const auto lights = timed(seconds, "lights",
                              [&] { return std::make_unique<Lights>(room, asked.params.trace.outside_detail); });
    const auto tracer = timed(
        seconds, "to_card", [&] { return std::make_unique<vulkan::Tracer>(device, "--trace-device", room, *lights); });
    vulkan::CardGatherer gatherer(*tracer);
    tracer->device().kernel_times();
    const IrradianceCache light = timed(seconds, "gather", [&] {
        return IrradianceCache::gather(room, *bvh, *lights, asked.params.trace, run, {Vec3f{}}, &gatherer);
    });
    ShotParts parts = panorama_parts(asked.params.trace);
    const ShadeScene scene{room, *bvh, *lights, light, true, false, 0};
    const MakePixelTracer make = [&](const PixelPlan& plan) {
        return std::make_unique<vulkan::CardPixels>(*tracer, vulkan::ShadeOptions{true, false, 0}, plan);
    };
    const EquirectSize size{asked.params.width, asked.params.width / 2};
    timed(seconds, "panorama", [&] {
        return cached_picture(scene, panorama_camera({}, size), parts, parts.pixel_samples, &room.look, nullptr, run,
                              make);
    });
    std::size_t triangles = 0;
    for (const Mesh& m : room.meshes) triangles += m.triangles.size() / 3;
    out["cells"] = light.size(), out["triangles"] = triangles, out["seconds"] = seconds;
    out["kernels_ms"] = tracer->device().kernel_times();
    out["longest_submission_s"] = tracer->longest_submission_s();
    return out;
}

}  // namespace

int main(int argc, char** argv) try {
    Asked asked;
    asked.prompt = "a cozy bedroom with a red armchair and a large window";
    std::string quality = "standard", device = "auto", out;
    int threads = 0;
    bool card_only = false;
    CLI::App app{"Path tracing of a room on the processor and on a graphics card"};
    app.add_option("prompt", asked.prompt)->capture_default_str();
    app.add_option("--quality", quality, "Preset")->capture_default_str();
    app.add_option("--trace-device", device, "Graphics card, as of fastscene make")->capture_default_str();
    app.add_option("--views", asked.views, "Views of 512 x 512")->capture_default_str();
    app.add_option("--paths", asked.paths, "Paths a pixel of a path-traced panorama of 512 x 256; 0: none")
        ->capture_default_str();
    float cell_m = 0;
    int cell_samples = 0, width = 0;
    app.add_option("--cell", cell_m, "Size of the irradiance cache's cells in metres; 0: the preset's");
    app.add_option("--cell-samples", cell_samples, "Light paths a cell; 0: the preset's");
    app.add_option("--width", width, "Of the panorama; 0: the preset's");
    app.add_option("--threads", threads, "Worker threads; 0: all cores");
    app.add_option("--seed", asked.seed, "Of the room");
    app.add_flag("--card-only", card_only, "Leave out the processor");
    app.add_option("-o,--out", out, "Folder for the panoramas");
    CLI11_PARSE(app, argc, argv);

    set_threads(threads);
    asked.params = params_of_quality(quality).panorama;
    if (cell_m > 0) asked.params.trace.cell_m = cell_m;
    if (cell_samples > 0) asked.params.trace.cell_samples = cell_samples;
    if (width > 0) asked.params.width = width;
    Json json;
    json["threads"] = thread_count();
    const Pictures card = render(asked, {"vulkan", device}, json["card"]);
    json["once_more"] = kernel_times(asked, device);
    if (!out.empty()) save_png(out + "/panorama_card.png", srgb8_from_linear(card.panorama));
    if (!card_only) {
        const Pictures processor = render(asked, {"cpu", ""}, json["processor"]);
        double views = 0;
        for (std::size_t i = 0; i < card.views.size(); ++i) views += squares_between(card.views[i], processor.views[i]);
        json["psnr"] = {{"panorama", psnr_of(squares_between(card.panorama, processor.panorama))}};
        if (!card.views.empty()) json["psnr"]["views"] = psnr_of(views / static_cast<double>(card.views.size()));
        if (asked.paths > 0) json["psnr"]["paths"] = psnr_of(squares_between(card.paths, processor.paths));
        if (!out.empty()) save_png(out + "/panorama_processor.png", srgb8_from_linear(processor.panorama));
    }
    fmt::print("{}\n", json.dump(2));
    return 0;
} catch (const std::exception& e) {
    fmt::print(stderr, "bench_trace: {}\n", e.what());
    return 1;
}
