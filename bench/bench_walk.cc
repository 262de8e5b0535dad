// Accuracy of the walk's geometry, without light and noise: panorama 0 is the room's albedo with exact range. One JSON
// line per room: walked panoramas against true ones on pixels carried over from panorama 0, holes against true
// disocclusions, CPU seconds.
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "cpu_clock.h"
#include "fastscene/base/parallel.h"
#include "fastscene/geometry/range_edges.h"
#include "fastscene/image/color.h"
#include "fastscene/image/ssim.h"
#include "fastscene/rooms/rooms.h"
#include "fastscene/trace/trace.h"
#include "fastscene/walk/hole_table.h"
#include "fastscene/walk/published_warp.h"
#include "fastscene/walk/walk.h"

namespace fastscene {
namespace {

constexpr int kSilhouette = 2;  // pixels this close to a range edge count as silhouette

Panorama albedo_panorama(const TracedRoom& room, Vec3f position, EquirectSize size, int samples, const Run& run) {
    const Rigid pose{{}, position};
    ShotParts parts{.color = false, .range = true, .albedo = true};
    parts.pixel_samples = samples;
    Shot shot = room.panorama(pose, size, parts, run);
    return {std::move(shot.albedo), std::move(shot.range), {}, pose};
}

ImageMask near_edges(const ImageF& range) {
    const ImageMask cuts = range_edges(range);
    ImageMask out(range.width, range.height);
    for (int y = 0; y < range.height; ++y)
        for (int x = 0; x < range.width; ++x)
            if (cuts.at(x, y) & (kFarSide | kNearSide))
                for (int j = std::max(0, y - kSilhouette); j <= std::min(range.height - 1, y + kSilhouette); ++j)
                    for (int i = x - kSilhouette; i <= x + kSilhouette; ++i) out.at(wrap_column(i, range.width), j) = 1;
    return out;
}

struct Squares {
    double sum = 0, count = 0;
    void add(Rgb8 a, Rgb8 b) {
        const auto square = [](int d) { return static_cast<double>(d * d) / (255.0 * 255.0); };
        sum += (square(a.r - b.r) + square(a.g - b.g) + square(a.b - b.b)) / 3;
        ++count;
    }
    double db() const { return -10 * std::log10(sum / count + 1e-12); }
};

Json measure(const std::string& prompt_text, std::uint64_t seed, int width, int samples, bool with_holes,
             const WalkParams& params) {
    const Run run{seed, nullptr, {}};
    PromptSpec prompt = understand_prompt(prompt_text, false);
    TracedRoom room(make_room(prompt, run));
    room.gather_light({.cell_m = 0.5f, .cell_samples = 1, .pixel_samples = 1},
                      run);  // required, though no picture here is lit
    const EquirectSize size{width, width / 2};
    const Panorama first = albedo_panorama(room, {}, size, samples, run);

    const double before = cpu_seconds();
    const std::vector<Panorama> walked = walked_through(first, params, run).panoramas;
    const double seconds = cpu_seconds() - before;
    Squares all, smooth, floor;
    for (std::size_t k = 1; k < walked.size(); ++k) {
        const Panorama truth = albedo_panorama(room, walked[k].world_from_pano.translation, size, samples, run);
        const ImageRgb8 a = srgb8_from_linear(walked[k].color), b = srgb8_from_linear(truth.color);
        if (k == 1) {  // two renderings of one panorama with different camera rays: an upper bound for any walk
            const ImageRgb8 other = srgb8_from_linear(
                albedo_panorama(room, walked[k].world_from_pano.translation, size, samples, {seed + 1, nullptr, {}})
                    .color);
            for (std::size_t i = 0; i < b.size(); ++i) floor.add(b.pixels[i], other.pixels[i]);
        }
        const ImageMask edge = near_edges(truth.range), own_edge = near_edges(walked[k].range);
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (walked[k].known.pixels[i] != Known::original) continue;
            all.add(a.pixels[i], b.pixels[i]);
            if (!edge.pixels[i] && !own_edge.pixels[i]) smooth.add(a.pixels[i], b.pixels[i]);
        }
    }

    // Holes for steps of the paper's size along the axes and up.
    const Distance distance = [&](Vec3f from, Vec3f d) { return room.distance(from, d); };
    double most = 0;
    Image<double> range(width, width / 2);
    for (std::size_t i = 0; i < range.size(); ++i) {
        range.pixels[i] = static_cast<double>(first.range.pixels[i]);
        if (std::isfinite(range.pixels[i])) most = std::max(most, range.pixels[i]);
    }
    range = published_units(range);
    const WarpSource source = make_warp_source(first.color, first.range, {}, {}, {});
    Json holes = Json::array();
    for (const double share : with_holes ? std::vector{0.02, 0.05, 0.1, 0.15} : std::vector<double>{}) {
        double ours_ratio = 0, published = 0, n = 0;
        HoleTruth mean{0, 0, 0, 0, 0};
        for (const Vec3d axis : {Vec3d{1, 0, 0}, Vec3d{-1, 0, 0}, Vec3d{0, 0, 1}, Vec3d{0, 0, -1}, Vec3d{0, 1, 0}}) {
            const Vec3d world = world_from_published(axis) * (share * most);
            const Vec3f to{static_cast<float>(world.x), static_cast<float>(world.y), static_cast<float>(world.z)};
            if (!(room.distance({}, normalize(to)) > 1.1f * length(to))) continue;
            const ImageMask ours = our_holes(source, size, to);
            const HoleTruth t = hole_truth(source, to, distance);
            ours_ratio += static_cast<double>(std::count_if(ours.pixels.begin(), ours.pixels.end(),
                                                            [](std::uint8_t v) { return v != 0; })) /
                          static_cast<double>(ours.size());
            published += published_warp(ImageRgb8(width, width / 2), range, axis * share).hole_ratio();
            mean = {mean.ratio + t.ratio, mean.precision + t.precision, mean.recall + t.recall,
                    mean.precision_near + t.precision_near, mean.recall_near + t.recall_near};
            ++n;
        }
        if (n > 0)
            holes.push_back({{"share", share},
                             {"published", published / n},
                             {"ours", ours_ratio / n},
                             {"true", mean.ratio / n},
                             {"precision", mean.precision / n},
                             {"recall", mean.recall / n},
                             {"precision_near", mean.precision_near / n},
                             {"recall_near", mean.recall_near / n}});
    }
    return {{"prompt", prompt_text},
            {"seed", seed},
            {"width", width},
            {"walk_cpu_s", seconds},
            {"floor_db", floor.db()},
            {"known_db", all.db()},
            {"known_away_from_silhouettes_db", smooth.db()},
            {"holes", holes}};
}

int run(int argc, char** argv) {
    CLI::App app("The walk against the traced room.");
    std::string prompt;
    std::uint64_t seed = 0;
    int width = 2048, threads = 0, samples = 16;
    WalkParams params;
    app.add_option("prompt", prompt, "The room.")->required();
    app.add_option("--seed", seed, "")->capture_default_str();
    app.add_option("--width", width, "Width of the panoramas.")->capture_default_str();
    app.add_option("--viewpoints", params.viewpoints, "")->capture_default_str();
    app.add_option("--samples", samples, "Camera rays a pixel of all panoramas.")->capture_default_str();
    bool no_holes = false;
    app.add_flag("--no-holes", no_holes, "Leave the holes out.");
    app.add_option("--threads", threads, "")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    set_threads(threads);
    std::cout << measure(prompt, seed, width, samples, !no_holes, params).dump() << std::endl;
    return 0;
}

}  // namespace
}  // namespace fastscene

int main(int argc, char** argv) { return fastscene::run(argc, argv); }
