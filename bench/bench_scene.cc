// What each part of a scene costs, from the sentence to splats, without files in between; on the processor or with
// splats on a graphics card. One line of JSON for the record.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>

#include "cpu_clock.h"
#include "fastscene/base/json.h"
#include "fastscene/base/parallel.h"
#include "fastscene/image/color.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/metrics/metrics.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/pipeline/quality.h"
#include "fastscene/splat/splat.h"
#include "fastscene/trace/standable.h"
#include "fastscene/views/views.h"
#include "fastscene/walk/room_outside.h"
#include "fastscene/walk/room_walk.h"

namespace {

using namespace fastscene;

// Adds the seconds of a part to `out`.
template <class Work>
auto timed(Json& out, const char* name, Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    const double cpu = cpu_seconds();
    auto result = work();
    out[name] = {
        {"wall_s", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()},
        {"cpu_s", cpu_seconds() - cpu},
    };
    return result;
}

std::vector<Panorama> walk(const RoomPanorama& made, const StandableFloor& floor, const SceneParams& params,
                           const Run& run) {
    Panorama first = made.panorama;
    std::vector<Panorama> all;
    walk_through_room(first, *made.room, floor, params.walk, panorama_parts(params.panorama.trace), run,
                      [&](const Panorama& p) { all.push_back(p); });
    return all;
}

// As `fastscene metrics --truth --where room` measures: at poses anywhere on the floor, against the room itself, lit
// with more paths.
Json truth_of(const std::string& prompt, PanoramaParams panorama, const Panorama& first, const Splats& splats,
              const TruthParams& asked, const std::filesystem::path& dir, const Run& run) {
    panorama.trace.cell_samples = std::max(panorama.trace.cell_samples, asked.samples);
    const auto lit = make_traced_room(RoomOrigin{prompt, {}}, panorama, run);
    TruthInputs inputs;
    inputs.truth = make_truth_set(*lit, asked, {99, nullptr, {}});
    inputs.first = first;
    inputs.first.range = inputs.first.seen_range();
    inputs.splats = splats;
    Json truth = measure_truth(inputs, asked, dir, run);
    truth.erase("views");
    return truth;
}

}  // namespace

int main(int argc, char** argv) try {
    std::string prompt, quality = "standard", device, trace_device, out;
    int threads = 0, truth = 0;
    std::uint64_t seed = 0;
    CLI::App app{"Cost of a scene, part by part"};
    app.add_option("prompt", prompt)->required();
    app.add_option("--quality", quality, "Preset")->capture_default_str();
    app.add_option("--device", device, "Train the splats on this graphics card instead of the processor");
    app.add_option("--trace-device", trace_device, "Trace the room on this graphics card instead of the processor");
    app.add_option("--threads", threads, "Worker threads; 0: all cores");
    app.add_option("--seed", seed, "Of the room");
    app.add_option("--truth", truth, "Also compare the splats with the room at this many poses");
    app.add_option("-o,--out", out, "Folder for panorama.png and scene.ply");
    CLI11_PARSE(app, argc, argv);

    set_threads(threads);
    SceneParams params = params_of_quality(quality);
    if (!device.empty()) params.splat.backend = {"vulkan", device};
    if (!trace_device.empty()) params.panorama.trace.backend = {"vulkan", trace_device};
    params.splat.sh_degree = 2;  // as for renderings of a known room
    const Run run{seed, nullptr, {}};
    Json parts, json;
    const auto start = std::chrono::steady_clock::now();
    const RoomPanorama made = timed(parts, "panorama", [&] {
        return panorama_of_room({prompt, {}}, params.panorama, run);
    });
    const StandableFloor floor = passable_floor(*made.room);
    std::vector<Panorama> panoramas = timed(parts, "walk", [&] { return walk(made, floor, params, run); });
    const Outside outside = timed(parts, "outside", [&] {
        return outside_of_room(*made.room, floor, made.panorama.world_from_pano.rotation, made.panorama.size(), run);
    });
    const ViewSet views = timed(parts, "views",
                                [&] { return project_views(std::move(panoramas), params.views, run, &outside); });
    params.splat.count = count_for(views.points, params.splat);
    const FittedSplats fitted = timed(parts, "splat", [&] { return fit_splats(views, params.splat, run); });
    json["wall_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    json["parts"] = parts, json["device"] = fitted.device, json["trace_device"] = made.room->device();
    json["threads"] = thread_count();
    json["views"] = views.views.size(), json["splats"] = fitted.splats.size();
    json["psnr_train"] = fitted.curve.empty() ? 0.f : fitted.curve.back().psnr;
    if (truth > 0) {
        TruthParams asked;
        asked.views = truth;
        const auto dir = out.empty() ? std::filesystem::temp_directory_path() / "bench_scene"
                                     : std::filesystem::path(out);
        json["truth"] = timed(parts, "truth", [&] {
            return truth_of(prompt, params.panorama, made.panorama, fitted.splats, asked, dir, run);
        });
        json["parts"] = parts;
    }
    if (!out.empty()) {
        save_png(out + "/panorama.png", srgb8_from_linear(made.panorama.color));
        save_splat_ply(out + "/scene.ply", fitted.splats);
    }
    fmt::print("{}\n", json.dump(2));
    return 0;
} catch (const std::exception& e) {
    fmt::print(stderr, "bench_scene: {}\n", e.what());
    return 1;
}
