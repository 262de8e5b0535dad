// Our side of comparisons with other trainers: writes views as a COLMAP model, evaluates any splats at the held-out
// poses, and reports our training cost for the same quality. Used by bench/peers/*.sh.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "bench/textured_room.h"
#include "cpu_clock.h"
#include "fastscene/base/json.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/view_io.h"
#include "fastscene/splat/splat.h"
#include "fastscene/views/spacing.h"

namespace {

using namespace fastscene;

double held_out_psnr(const Splats& splats, const std::vector<View>& views) {
    double sum = 0;
    for (const View& view : views) {
        const SplatPicture picture = render_splats(splats, view.camera, view.world_from_camera);
        double squares = 0;
        for (std::size_t i = 0; i < view.color.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                const float d = std::clamp(picture.color.pixels[i][c], 0.f, 1.f) -
                                unit_from_srgb8(view.color.pixels[i])[c];
                squares += static_cast<double>(d) * d;
            }
        sum += -10 * std::log10(squares / (3.0 * static_cast<double>(view.color.size())));
    }
    return sum / static_cast<double>(views.size());
}

// What a COLMAP model provides for a point: position and color; spacing follows from its neighbours.
ViewSet without_normals(ViewSet set) {
    std::vector<Vec3f> places;
    for (const SurfacePoint& p : set.points) places.push_back(p.position_m);
    const std::vector<float> spacing = spacings(places);
    for (std::size_t i = 0; i < places.size(); ++i) set.points[i].normal = {}, set.points[i].radius_m = spacing[i];
    return set;
}

}  // namespace

int main(int argc, char** argv) try {
    int size = 512, count = 50000, positions = 3, held_out = 8, samples = 2;
    double target = 0;
    std::string folder, file;
    std::vector<int> steps{20,  30,  40,  50,  60,  80,  100, 115, 130, 145, 160, 180, 200,
                           230, 260, 300, 350, 400, 450, 500, 550, 600, 700, 850, 1000};
    CLI::App app{"One side of a comparison between trainers"};
    app.require_subcommand(1);
    app.add_option("--size", size, "Width and height of the views")->check(CLI::Range(16, 4096));
    app.add_option("--count", count, "Gaussians, and points of the model")->check(CLI::Range(1, 10000000));
    bool orbit = false;
    app.add_option("--positions", positions, "Viewpoints, 14 views each")->check(CLI::Range(1, 8));
    app.add_flag("--orbit", orbit, "Instead a ring of cameras around a stage, as many");
    app.add_option("--samples", samples, "Rays a pixel along each side")->check(CLI::Range(1, 8));
    CLI::App* write = app.add_subcommand("write", "Write the training views as a COLMAP model");
    write->add_option("folder", folder)->required();
    CLI::App* eval = app.add_subcommand("eval", "PSNR of splats at the held-out poses");
    eval->add_option("file", file)->required();
    CLI::App* train = app.add_subcommand("train", "CPU seconds until the held-out PSNR is reached");
    train->add_option("--psnr", target, "PSNR to reach, dB")->required();
    train->add_option("--steps", steps, "Lengths of run to try, ascending");
    CLI11_PARSE(app, argc, argv);

    set_threads(1);
    const bench::RoomSet set = orbit ? bench::orbit_set(size, 14 * positions, count, held_out, samples)
                                     : bench::room_set(size, positions, count, held_out, samples);
    if (*write) save_views(folder, without_normals(set.train));
    if (*eval)
        fmt::print("{}\n", Json{{"held_out_psnr", held_out_psnr(load_splats(file).splats, set.held_out)}}.dump());
    if (*train) {
        const ViewSet views = without_normals(set.train);
        SplatParams params;
        params.count = count;
        for (const int n : steps) {
            params.steps = n;
            const double before = cpu_seconds();
            const FittedSplats fitted = fit_splats(views, params, Run{});
            const double cost = cpu_seconds() - before, psnr = held_out_psnr(fitted.splats, set.held_out);
            fmt::print("{}\n", Json{{"steps", n}, {"cpu_s", cost}, {"held_out_psnr", psnr}}.dump());
            if (psnr >= target) break;
        }
    }
    return 0;
} catch (const std::exception& e) {
    fmt::print(stderr, "bench_peer: {}\n", e.what());
    return 1;
}
