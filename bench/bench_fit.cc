// Benchmark of trainer settings: CPU seconds and held-out PSNR on the views of a run, or on synthetic views; peak
// memory, and rendering speed.
// bench_fit out/bedroom/views --splat-count 250000 --splat-steps 3000
// bench_fit --plain 100 --size 512 --splat-count 200000 --splat-steps 20 (memory only: empty pictures)
#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/textured_room.h"
#include "cpu_clock.h"
#include "fastscene/base/json.h"
#include "fastscene/cli/flags.h"
#include "fastscene/io/view_io.h"
#include "fastscene/splat/engine.h"
#include "fastscene/splat/train.h"

namespace {

using namespace fastscene;

double peak_mb() {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    return static_cast<double>(use.ru_maxrss) / 1e3;
}

// A room's cameras and points without its light: sufficient for memory and time of a step, and quick to make.
ViewSet plain_views(int size, int views, int points) {
    ViewSet set;
    const auto cuts = bench::fourteen_cuts();
    for (int i = 0; i < views; ++i) {
        Random random(3, "bench.plain", static_cast<std::uint64_t>(i));
        View view{fmt::format("{}.png", i + 1),
                  Pinhole::with_fov(size, size, 90),
                  {cuts[static_cast<std::size_t>(i) % cuts.size()], {}},
                  ImageRgb8(size, size),
                  {}};
        view.world_from_camera.translation = {random.uniform(-0.3f, 0.3f), random.uniform(-0.3f, 0.3f),
                                              random.uniform(-0.3f, 0.3f)};
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                view.color.at(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                                       static_cast<std::uint8_t>(i)};
        set.views.push_back(std::move(view));
    }
    const float radius = 4.f / std::sqrt(static_cast<float>(points));
    for (int i = 0; i < points; ++i) {
        Random random(4, "bench.plain", static_cast<std::uint64_t>(i));
        const Vec3f d = normalize(Vec3f{random.normal(), random.normal(), random.normal()});
        set.points.push_back(
            {d * (2.f / std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)})), d * -1.f, {90, 120, 150}, radius});
    }
    return set;
}

// Frames per second of the forward pass alone, cycling through the views.
double frames_a_second(const Splats& splats, const std::vector<View>& views) {
    const splat::Cloud cloud(splats, false);
    splat::Engine engine(splat::choose_kernel());
    constexpr int kFrames = 60;
    double before = 0;
    for (int i = -5; i < kFrames; ++i) {
        if (i == 0) before = cpu_seconds();
        const View& view = views[static_cast<std::size_t>(i + 5) % views.size()];
        engine.render(cloud, view.camera, view.world_from_camera, {}, false, view.model);
    }
    return kFrames / (cpu_seconds() - before);
}

}  // namespace

int main(int argc, char** argv) try {
    std::string folder;
    int plain = 0, size = 512, threads = 1, holdout = 8;
    bool frames = false;
    SplatParams params;
    splat::TrainTuning tuning;
    CLI::App app{"What settings of the trainer are worth"};
    app.add_option("views", folder, "views/ of a run");
    app.add_option("--plain", plain, "Instead so many views without content, to see what memory they take")
        ->check(CLI::Range(1, 100000));
    app.add_option("--size", size, "Width and height of those")->check(CLI::Range(16, 8192));
    app.add_option("--threads", threads, "Worker threads")->check(CLI::Range(1, 1024));
    app.add_option("--holdout", holdout, "Every so manieth view measures; 0: all teach")->check(CLI::Range(0, 1000));
    app.add_flag("--frames", frames, "How many frames a second the result is drawn with, on the views' cameras");
    app.add_option("--scale", tuning.scale), app.add_option("--rotation", tuning.rotation);
    app.add_option("--sh0", tuning.sh0), app.add_option("--mean-end", tuning.mean_end),
        app.add_option("--other-end", tuning.other_end);
    app.add_option("--relocate", tuning.relocate_fraction), app.add_option("--noise", tuning.noise);
    auto given = std::make_shared<cli::Given>();
    cli::add_fields(app, "splat", params, given, "Trainer");
    CLI11_PARSE(app, argc, argv);
    cli::apply_fields("splat", params, *given);
    if (folder.empty() == (plain == 0))
        throw Error("expected a folder of views or --plain N, found {}", plain ? "both" : "neither");

    set_threads(threads);
    ViewSet set = plain ? plain_views(size, plain, params.count) : load_views(folder);
    if (holdout > 0) params.eval_every = 1000000, params.holdout = holdout;
    const double before = cpu_seconds();
    const FittedSplats fitted = splat::fit(set, params, tuning, Run{});
    Json out{{"views", set.views.size()},
             {"count", fitted.splats.size()},
             {"steps", fitted.steps},
             {"cpu_s", cpu_seconds() - before},
             {"peak_mb", peak_mb()}};
    if (!fitted.evals.empty()) out["psnr"] = fitted.evals.back().psnr, out["ssim"] = fitted.evals.back().ssim;
    if (frames) out["frames_a_second"] = frames_a_second(fitted.splats, set.views);
    fmt::print("{}\n", out.dump());
    return 0;
} catch (const std::exception& e) {
    fmt::print(stderr, "bench_fit: {}\n", e.what());
    return 1;
}
