// Retrains the splats of a finished run with other settings and evaluates them against the ground truth cached by
// `metrics --truth --where room`. bench_tune out/bedroom --steps 1500 --count 250000
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cpu_clock.h"
#include "fastscene/base/parallel.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/view_io.h"
#include "fastscene/metrics/metrics.h"
#include "fastscene/splat/train.h"

using namespace fastscene;

int main(int argc, char** argv) {
    std::string dir, pictures;
    SplatParams params;
    splat::TrainTuning tuning;
    int threads = 0, first = 14;
    bool random_background = false;
    CLI::App app;
    app.add_option("run", dir)->required();
    app.add_option("--steps", params.steps);
    app.add_option("--count", params.count);
    app.add_option("--per-m2", params.per_m2);
    app.add_option("--coarse", params.coarse);
    app.add_option("--strategy", params.strategy);
    app.add_option("--lr-mean", params.learning_rate_mean_m);
    app.add_option("--opaque", params.opaque);
    app.add_option("--outside", params.outside_m);
    app.add_option("--lambda", params.lambda_dssim);
    app.add_option("--sh-degree", params.sh_degree);
    app.add_option("--lr-scale", tuning.scale);
    app.add_option("--lr-rotation", tuning.rotation);
    app.add_option("--lr-logit", params.learning_rate_logit);
    app.add_option("--start-opacity", params.start_opacity);
    app.add_option("--start-overlap", params.start_overlap);
    app.add_option("--lr-sh0", tuning.sh0);
    app.add_option("--mean-end", tuning.mean_end);
    app.add_option("--other-end", tuning.other_end);
    app.add_option("--relocate-fraction", tuning.relocate_fraction);
    app.add_option("--first", first, "Train on the first so many of each panorama's 14 views.");
    app.add_option("--threads", threads);
    app.add_option("--pictures", pictures, "Writes what the splats show at each pose there.");
    app.add_flag("--random-background", random_background);
    CLI11_PARSE(app, argc, argv);
    set_threads(threads);
    params.random_background = random_background;
    const Run run{0, nullptr, {}};
    ViewSet views = load_views(dir + "/views");
    constexpr std::size_t kViewsAPanorama = 14;
    std::vector<View> some;
    for (std::size_t i = 0; i < views.views.size(); ++i)
        if (i % kViewsAPanorama < static_cast<std::size_t>(first)) some.push_back(std::move(views.views[i]));
    views.views = std::move(some);
    params.count = count_for(views.points, params);
    const double before = cpu_seconds();
    Splats splats = splat::fit(views, params, tuning, run).splats;
    const double cpu = cpu_seconds() - before;
    const TruthSet truth = load_truth_set(dir + "/metrics/kept/room");
    std::vector<double> psnrs;
    double ssim = 0, open = 0;
    for (std::size_t i = 0; i < truth.poses.size(); ++i) {
        const SplatSight sight = splat_sight(splats, truth.poses[i], truth.pictures[i].color.width);
        const Likeness l = compare(sight.color, truth.pictures[i]);
        psnrs.push_back(l.psnr), ssim += l.ssim, open += sight.low_alpha_share;
        if (!pictures.empty()) save_png(fmt::format("{}/{:02}.png", pictures, i), sight.color);
    }
    std::sort(psnrs.begin(), psnrs.end());
    const double n = static_cast<double>(psnrs.size());
    double mean = 0, worst = 0;
    for (const double p : psnrs) mean += p / n;
    const std::size_t few = (psnrs.size() + 19) / 20;
    for (std::size_t i = 0; i < few; ++i) worst += psnrs[i] / static_cast<double>(few);
    fmt::print(
        "{:6} views {:7} splats {:5} steps {:7.1f} CPU s | {:.2f} dB worst5 {:.2f} worst {:.2f} ssim {:.4f} open "
        "{:.4f} %\n",
        views.views.size(), splats.size(), params.steps, cpu, mean, worst, psnrs[0], ssim / n, 100 * open / n);
}
