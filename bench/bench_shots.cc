// Benchmark of light and rendering: CPU seconds, and the difference of pictures with fewer rays from the best one.
// bench_shots "a bedroom" --width 1024
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

#include "cpu_clock.h"
#include "fastscene/image/color.h"
#include "fastscene/image/ssim.h"
#include "fastscene/panorama/panorama.h"
#include "fastscene/trace/standable.h"
#include "fastscene/walk/room_viewpoints.h"

using namespace fastscene;

namespace {
template <class F>
auto timed(const char* what, F&& f) {
    const double before = cpu_seconds();
    auto result = f();
    fmt::print("{:28} {:8.2f} CPU s\n", what, cpu_seconds() - before);
    return result;
}
}  // namespace

int main(int argc, char** argv) {
    std::string prompt;
    int width = 1024, cell_samples = 160;
    float cell_m = 0.03f;
    std::uint64_t seed = 0;
    std::string only;
    bool map = false;
    float radius = 0.15f;
    CLI::App app;
    app.add_option("--only", only, "The kind whose name begins so.");
    app.add_option("--radius", radius);
    app.add_flag("--map", map, "Draw the standable floor and stop.");
    app.add_option("prompt", prompt)->required();
    app.add_option("--width", width);
    app.add_option("--cell", cell_m);
    app.add_option("--cell-samples", cell_samples);
    app.add_option("--seed", seed);
    CLI11_PARSE(app, argc, argv);
    const Run run{seed, nullptr, {}};
    PanoramaParams params;
    params.trace = {.cell_m = cell_m, .cell_samples = cell_samples, .pixel_samples = 16};
    PromptSpec spec = read_prompt(prompt, params);
    auto room = timed("furnish", [&] { return std::make_unique<TracedRoom>(make_room(spec, run)); });
    const auto floor = timed("standable floor", [&] { return standable_floor(*room, {.clear_m = radius}); });
    fmt::print("standable {:.1f} m2\n", standable_area_m2(floor));
    if (map) {
        for (int row = floor.rows - 1; row >= 0; --row) {
            for (int column = 0; column < floor.columns; ++column) {
                const Vec2f c = floor.center(column, row);
                const bool here = std::fabs(c.x) < 0.051f && std::fabs(c.y) < 0.051f;
                fmt::print("{}", here                                                                ? '@'
                                 : floor.at(column, row)                                             ? 'o'
                                 : room->clearance({c.x, floor.floor_y - 0.3f, c.y}, 0.25f) >= 0.25f ? '.'
                                                                                                     : ' ');
            }
            fmt::print("\n");
        }
        return 0;
    }
    const auto points = timed("viewpoints", [&] { return choose_room_viewpoints(*room, floor, {}, run); });
    fmt::print("{} viewpoints, unseen {:.4f} coarse {:.4f} one-sided {:.4f}\n", points.positions_m.size(),
               points.unseen_share, points.coarse_share, points.one_sided_share);
    for (const Vec3f p : points.positions_m) fmt::print("  {:.2f} {:.2f} {:.2f}\n", p.x, floor.floor_y - p.y, p.z);
    timed("light", [&] {
        std::vector<Vec3f> viewpoints{Vec3f{}};
        for (const Vec3f p : points.positions_m) viewpoints.push_back(p);
        room->gather_light(params.trace, run, viewpoints);
        return 0;
    });
    const Rigid pose{{}, points.positions_m.empty() ? Vec3f{} : points.positions_m[0]};
    const EquirectSize size{width, width / 2};
    const ImageRgb8 best = timed(
        "best (final, 128)", [&] { return srgb8_from_linear(room->panorama(pose, size, final_parts(), run).color); });
    struct Kind {
        const char* name;
        ShotParts parts;
    };
    const Kind kinds[] = {
        {"panorama 0 (64)", panorama_parts(params.trace)},
        {"denoise 64, no contacts", {.pixel_samples = 64, .contacts = false, .denoise = true, .noise = 0.012f}},
        {"denoise 16, contacts", {.pixel_samples = 16, .contacts = true, .denoise = true, .noise = 0.012f}},
        {"denoise 16, no contacts", {.pixel_samples = 16, .contacts = false, .denoise = true, .noise = 0.012f}},
        {"truth frugal 128",
         {.pixel_samples = 128, .contacts = true, .frugal = true, .denoise = true, .noise = 0.006f}},
        {"truth frugal 64", {.pixel_samples = 64, .contacts = true, .frugal = true, .denoise = true, .noise = 0.009f}},
        {"plain 4, contacts", {.pixel_samples = 4, .contacts = true}},
        {"plain 4, no contacts", {.pixel_samples = 4, .contacts = false}},
        {"plain 8, contacts", {.pixel_samples = 8, .contacts = true}},
        {"plain 1, no contacts", {.pixel_samples = 1, .contacts = false}},
        {"frugal 1", {.pixel_samples = 1, .frugal = true}},
        {"frugal 4", {.pixel_samples = 4, .frugal = true}},
        {"frugal 16", {.pixel_samples = 16, .frugal = true}}};
    for (const Kind& kind : kinds) {
        if (!std::string_view(kind.name).starts_with(only)) continue;
        const ImageRgb8 picture = timed(kind.name, [&] {
            return srgb8_from_linear(room->panorama(pose, size, kind.parts, Run{seed + 1, nullptr, {}}).color);
        });
        fmt::print("    {:.2f} dB\n", psnr(picture, best));
    }
}
