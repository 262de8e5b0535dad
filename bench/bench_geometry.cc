// Benchmark of spherical resampling: picture -> cube, cube -> picture, and warps, against memcpy on buffers of the same
// size and, if available, OpenCV's remap with the same maps. One JSON line per operation.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstring>
#include <iostream>

#include "cpu_clock.h"
#include "fastscene/base/json.h"
#include "fastscene/base/parallel.h"
#include "fastscene/geometry/resample.h"
#include "fastscene/image/color.h"
#include "fastscene/scene/synthetic.h"
#include "fastscene/walk/coarse_view.h"
#include "fastscene/walk/published_warp.h"
#ifdef FASTSCENE_BENCH_OPENCV
#include <opencv2/imgproc.hpp>
#endif

namespace fastscene {
namespace {

using Clock = std::chrono::steady_clock;

// One thread: its CPU time, which other load hardly affects; several threads: wall time.
double seconds_now() {
    if (thread_count() > 1) return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
    return cpu_seconds();
}

// Minimum seconds over `rounds`: the machine's capability without interference.
template <class Work>
double least_seconds(int rounds, const Work& work) {
    double least = 1e9;
    for (int i = 0; i < rounds; ++i) {
        const double begin = seconds_now();
        work();
        least = std::min(least, seconds_now() - begin);
    }
    return least;
}

// Bytes per second of copying `bytes` / 2 between buffers, with all threads.
double memcpy_rate(std::size_t bytes, int rounds) {
    std::vector<char> from(bytes / 2, 1), to(bytes / 2);
    const std::int64_t piece = 1 << 18, pieces = (static_cast<std::int64_t>(from.size()) + piece - 1) / piece;
    const double seconds = least_seconds(rounds, [&] {
        parallel_for(pieces, 1, [&](std::int64_t begin, std::int64_t) {
            const std::int64_t at = begin * piece;
            std::memcpy(
                to.data() + at, from.data() + at,
                static_cast<std::size_t>(std::min<std::int64_t>(piece, static_cast<std::int64_t>(from.size()) - at)));
        });
    });
    return static_cast<double>(bytes) / seconds;
}

void report(const char* name, std::size_t bytes, double seconds, int rounds, Json more = Json::object()) {
    const double rate = static_cast<double>(bytes) / seconds, copy = memcpy_rate(bytes, rounds);
    Json json{{"what", name},
              {"ms", 1e3 * seconds},
              {"gb_per_s", 1e-9 * rate},
              {"memcpy_gb_per_s", 1e-9 * copy},
              {"share_of_memcpy", rate / copy},
              {"threads", thread_count()}};
    json.update(more);
    std::cout << json.dump() << std::endl;
}

std::size_t bytes_of(const ImageColor& image) { return image.size() * sizeof(Vec3f); }

void bench_plan(const char* name, const SpherePicture& source, const SpherePicture& target, const ImageColor& picture,
                int rounds, Filter filter = Filter::point) {
    const auto begin = Clock::now();
    const ResamplePlan plan(source, target, filter);
    Json more{{"plan_ms", 1e3 * std::chrono::duration<double>(Clock::now() - begin).count()}};
    ImageColor out(target.width, target.height);
    const double seconds = least_seconds(rounds, [&] { plan.apply_to(picture, out); });
#ifdef FASTSCENE_BENCH_OPENCV
    // The same positions; where ours samples several (seams, poles), OpenCV gets the nearest of one.
    cv::setNumThreads(thread_count());
    cv::Mat mx(target.height, target.width, CV_32F), my(target.height, target.width, CV_32F),
        out_cv(target.height, target.width, CV_32FC3);
    for (int y = 0; y < target.height; ++y)
        for (int x = 0; x < target.width; ++x) {
            const Vec2f at = plan.place(x, y);
            mx.at<float>(y, x) = std::isnan(at.x) ? 0.f : at.x - 0.5f;
            my.at<float>(y, x) = std::isnan(at.y) ? 0.f : at.y - 0.5f;
        }
    const cv::Mat in(source.height, source.width, CV_32FC3, const_cast<Vec3f*>(picture.pixels.data()));
    cv::Mat fixed, fractions;
    cv::convertMaps(mx, my, fixed, fractions, CV_16SC2);
    const double floats = least_seconds(rounds, [&] { cv::remap(in, out_cv, mx, my, cv::INTER_LINEAR); });
    const double fixed_point = least_seconds(rounds,
                                             [&] { cv::remap(in, out_cv, fixed, fractions, cv::INTER_LINEAR); });
    more.update({{"opencv_ms", 1e3 * floats},
                 {"opencv_fixed_ms", 1e3 * fixed_point},
                 {"times_opencv", floats / seconds},
                 {"times_opencv_fixed", fixed_point / seconds}});
#endif
    report(name, bytes_of(picture) + bytes_of(out), seconds, rounds, more);
}

void bench_warps(int width, int rounds) {
    const SyntheticWorld world = SyntheticWorld::furnished(SyntheticPaint::smooth, SyntheticPaint::planks);
    const Panorama first = render_synthetic(world, {}, {width, width / 2}, 1);
    const Vec3f to{0.1f, 0.02f, 0.05f};
    const std::size_t bytes = 2 * (bytes_of(first.color) + first.range.size() * sizeof(float));
    const std::vector<WarpSource> sources{make_warp_source(first.color, first.range, {}, {}, {})};
    report("warp, ours (mesh)", bytes, least_seconds(rounds, [&] { coarse_view(sources, first.size(), to); }), rounds);
    const ImageRgb8 color = srgb8_from_linear(first.color);
    Image<double> range(first.range.width, first.range.height);
    std::copy(first.range.pixels.begin(), first.range.pixels.end(), range.pixels.begin());
    const std::size_t published = color.size() * (3 + 8) * 2;
    report("warp, as published", published,
           least_seconds(rounds,
                         [&] {
                             published_warp(color, range, {0.1, 0.02, 0.05});
                         }),
           rounds);
}

int run(int argc, char** argv) {
    CLI::App app("Costs of moving pictures of the sphere.");
    int width = 2048, rounds = 15, threads = 1;
    app.add_option("--width", width, "Width of the panorama.")->capture_default_str();
    app.add_option("--rounds", rounds, "The best of so many counts.")->capture_default_str();
    app.add_option("--threads", threads, "0 = all cores.")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    set_threads(threads);
    const SpherePicture pano = equirect_picture({width, width / 2}), cube = cube_picture(width / 4);
    ImageColor picture(width, width / 2), faces(cube.width, cube.height);
    for (std::size_t i = 0; i < picture.size(); ++i)
        picture.pixels[i] = Vec3f{0.1f, 0.2f, 0.3f} * static_cast<float>(i % 97);
    for (std::size_t i = 0; i < faces.size(); ++i)
        faces.pixels[i] = Vec3f{0.1f, 0.2f, 0.3f} * static_cast<float>(i % 89);
    bench_plan("E2C", pano, cube, picture, rounds);
    bench_plan("C2E", cube, pano, faces, rounds);
    bench_plan("E2C, antialiased", pano, cube, picture, rounds, Filter::bilinear);
    bench_plan("C2E, antialiased", cube, pano, faces, rounds, Filter::bilinear);
    bench_plan("equirect, turned", pano,
               equirect_picture({width, width / 2}, rotation_about(normalize(Vec3f{1, 2, 3}), 0.7f)), picture, rounds);
    bench_warps(width, std::max(1, rounds / 5));
    return 0;
}

}  // namespace
}  // namespace fastscene

int main(int argc, char** argv) { return fastscene::run(argc, argv); }
