// Inpainting benchmark: accuracy of filled holes, and cost per face, for our inpainters and OpenCV's if available.
// Prints a line per method; --sheet writes a picture with holes, each method, and the truth. --speed: cost of a whole
// face for the built-in network and the official one (by size; weights do not matter), relative to the machine's own
// matrix product.
#include <ATen/core/grad_mode.h>
#include <ATen/ops/mm.h>
#include <ATen/ops/rand.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>

#include "cpu_clock.h"
#include "fastscene/base/parallel.h"
#include "fastscene/image/color.h"
#include "fastscene/inpaint/inpaint.h"
#include "fastscene/inpaint/train.h"
#include "fastscene/io/image_io.h"
#include "fastscene/nn/aotgan.h"
#include "fastscene/nn/hashed_aotgan.h"
#include "fastscene/nn/runtime.h"
#include "fastscene/weights/shipped.h"

#ifdef FASTSCENE_BENCH_OPENCV
#include <opencv2/core.hpp>
#include <opencv2/photo.hpp>
#endif

namespace {

using namespace fastscene;

using Method = std::function<ImageRgb8(const ImageRgb8& torn, const ImageMask& hole)>;

Method ours(const std::string& name, const std::string& weights) {
    std::shared_ptr<Inpainter> inpainter = make_inpainter(name, weights);
    return [inpainter](const ImageRgb8& torn, const ImageMask& hole) {
        return srgb8_from_linear(inpainter->fill(linear_from_srgb8(torn), hole, {}));
    };
}

#ifdef FASTSCENE_BENCH_OPENCV
Method of_opencv(int flag, double radius) {
    return [flag, radius](const ImageRgb8& torn, const ImageMask& hole) {
        const cv::Mat in(torn.height, torn.width, CV_8UC3, const_cast<Rgb8*>(torn.pixels.data())),
            mask(hole.height, hole.width, CV_8UC1, const_cast<std::uint8_t*>(hole.pixels.data()));
        ImageRgb8 out(torn.width, torn.height);
        cv::Mat result(out.height, out.width, CV_8UC3, out.pixels.data()), painted;
        cv::inpaint(in, mask, painted, radius, flag);
        painted.copyTo(result);
        return out;
    };
}
#endif

float gray(const Rgb8& c) {
    return 0.299f * static_cast<float>(c.r) + 0.587f * static_cast<float>(c.g) + 0.114f * static_cast<float>(c.b);
}

double psnr_in_holes(const ImageRgb8& a, const ImageRgb8& b, const ImageMask& hole) {
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!hole.pixels[i]) continue;
        for (const double d : {double(a.pixels[i].r) - b.pixels[i].r, double(a.pixels[i].g) - b.pixels[i].g,
                               double(a.pixels[i].b) - b.pixels[i].b})
            squares += d * d;
        count += 3;
    }
    return 10 * std::log10(255.0 * 255.0 / std::max(squares / count, 1e-3));
}

// Gradient magnitude similarity deviation (Xue et al. 2014), at half size as published: difference of edges. 0 = equal.
double gmsd(const ImageRgb8& a, const ImageRgb8& b) {
    const auto half = [](const ImageRgb8& image) {
        ImageF out(image.width / 2, image.height / 2);
        for (int y = 0; y < out.height; ++y)
            for (int x = 0; x < out.width; ++x)
                out.at(x, y) = 0.25f * (gray(image.at(2 * x, 2 * y)) + gray(image.at(2 * x + 1, 2 * y)) +
                                        gray(image.at(2 * x, 2 * y + 1)) + gray(image.at(2 * x + 1, 2 * y + 1)));
        return out;
    };
    const auto slope = [](const ImageF& image, int x, int y) {  // Prewitt
        float across = 0, down = 0;
        for (int k = -1; k <= 1; ++k) {
            across += image.at(x + 1, y + k) - image.at(x - 1, y + k);
            down += image.at(x + k, y + 1) - image.at(x + k, y - 1);
        }
        return std::sqrt(across * across + down * down) / 3;
    };
    const ImageF p = half(a), q = half(b);
    double sum = 0, squares = 0, count = 0;
    for (int y = 1; y + 1 < p.height; ++y)
        for (int x = 1; x + 1 < p.width; ++x) {
            const double u = slope(p, x, y), v = slope(q, x, y), similar = (2 * u * v + 170) / (u * u + v * v + 170);
            sum += similar;
            squares += similar * similar;
            ++count;
        }
    return std::sqrt(std::max(0.0, squares / count - (sum / count) * (sum / count)));
}

// Rows of pictures side by side.
struct Sheet {
    ImageRgb8 all;
    void add(const std::vector<ImageRgb8>& row) {
        const int gap = 4, width = static_cast<int>(row.size()) * (row[0].width + gap) - gap;
        ImageRgb8 strip(width, row[0].height + gap, Rgb8{255, 255, 255});
        for (std::size_t k = 0; k < row.size(); ++k)
            for (int y = 0; y < row[k].height; ++y)
                std::copy_n(row[k].row(y), row[k].width, strip.row(y) + static_cast<int>(k) * (row[0].width + gap));
        all.width = width;
        all.height += strip.height;
        all.pixels.insert(all.pixels.end(), strip.pixels.begin(), strip.pixels.end());
    }
};

// Operations of the generator's convolutions for a side x side picture; a multiply-add is two.
double generator_gflop(double width, double blocks, double side) {
    const double whole = side * side, half = whole / 4, quarter = whole / 16, w = width;
    const double encoder = whole * 49 * 4 * w + half * 16 * w * 2 * w + quarter * 16 * 2 * w * 4 * w;
    const double block = quarter * 9 * (4 * w) * (4 * w) *
                         3;  // four branches with a quarter of the channels each, fuse, gate
    const double decoder = half * 9 * 4 * w * 2 * w + whole * 9 * 2 * w * w + whole * 9 * w * 3;
    return 2e-9 * (encoder + blocks * block + decoder);
}
// Minimum over several runs.
double seconds_of(int runs, const std::function<void()>& work) {
    double best = 1e9;
    for (int i = 0; i < runs; ++i) {
        const double begin = cpu_seconds();
        work();
        best = std::min(best, cpu_seconds() - begin);
    }
    return best;
}
void print_speed(int side) {
    use_our_threads();
    const at::NoGradGuard no_gradients;
    const at::Tensor a = at::rand({2048, 2048}), b = at::rand({2048, 2048});
    const double peak = 2e-9 * 2048. * 2048. * 2048. / seconds_of(6, [&] { (void)at::mm(a, b); });
    fmt::print("a product of 2048 x 2048 matrices: {:.0f} GFLOP per CPU second\n", peak);
    const Aotgan::Picture face{ImageColor(side, side, Vec3f{0.5f, 0.5f, 0.5f}), ImageMask(side, side, std::uint8_t{1})};
    const auto print = [&](const char* name, const Aotgan& network) {
        const double seconds = seconds_of(4, [&] { (void)network.paint({face}, {}); });
        fmt::print("{:<32} {:.2f} CPU s for a face of {}\n", name, seconds, side);
        return seconds;
    };
    if (is_shipped("aotgan-rooms")) print("aotgan-rooms", Aotgan::of(shipped_weights("aotgan-rooms")));
    const double work = generator_gflop(64, 8, side),
                 full = print("width 64, eight blocks", Aotgan::of(hashed_aotgan(64, 8)));
    fmt::print("{:.0f} GFLOP of convolutions, {:.0f} a CPU second: {:.0f} % of the product's\n", work, work / full,
               100 * work / full / peak);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Inpainting of held-out faces: PSNR in the holes, GMSD of the face, CPU seconds a face.");
    std::string data, weights, sheet_path;
    int count = 200, size = 256, sheet_rows = 6, threads = 1;
    bool speed = false;
    CLI::Option* const folder = app.add_option("data", data, "DIR/held-out of `fastscene inpaint dataset`.");
    app.add_flag("--speed", speed, "Instead: what a face of --size costs, all of it hole.")->excludes(folder);
    app.add_option("--weights", weights, "For aotgan; left out: those that come with the program.");
    app.add_option("--count", count);
    app.add_option("--size", size, "Side of the crops.");
    app.add_option("--threads", threads);
    app.add_option("--sheet", sheet_path);
    app.add_option("--sheet-rows", sheet_rows);
    CLI11_PARSE(app, argc, argv);
    set_threads(threads);
    if (speed) return print_speed(size), 0;
    if (data.empty()) return app.exit(CLI::RequiredError("data or --speed"));
    std::vector<std::pair<std::string, Method>> methods{{"harmonic", ours("harmonic", "")},
                                                        {"aotgan", ours("aotgan", weights)}};
#ifdef FASTSCENE_BENCH_OPENCV
    cv::setNumThreads(threads);
    for (const double radius : {3.0, 5.0}) {
        methods.emplace_back(fmt::format("OpenCV Telea, radius {}", radius), of_opencv(cv::INPAINT_TELEA, radius));
        methods.emplace_back(fmt::format("OpenCV Navier-Stokes, radius {}", radius), of_opencv(cv::INPAINT_NS, radius));
    }
#endif
    const HoleSet set = find_holes(data);
    InpaintTrainParams params;
    params.size = size;
    std::atomic<std::int64_t> broken{0};
    std::vector<double> psnr(methods.size()), edges(methods.size()), seconds(methods.size());
    Sheet sheet;
    double open = 0;
    for (int i = 0; i < count; ++i) {
        Random rng(1, "bench face", static_cast<std::uint64_t>(i));
        const InpaintExample example = draw_example(set, params, true, rng, broken);
        ImageRgb8 torn = example.truth;
        for (std::size_t k = 0; k < torn.size(); ++k)
            if (example.hole.pixels[k])
                torn.pixels[k] = {255, 255, 255}, open += 1.0 / static_cast<double>(torn.size());
        std::vector<ImageRgb8> row{torn};
        for (std::size_t m = 0; m < methods.size(); ++m) {
            const double begin = cpu_seconds();
            row.push_back(methods[m].second(torn, example.hole));
            seconds[m] += cpu_seconds() - begin;
            psnr[m] += psnr_in_holes(row.back(), example.truth, example.hole);
            edges[m] += gmsd(row.back(), example.truth);
        }
        row.push_back(example.truth);
        if (i < sheet_rows) sheet.add(row);
    }
    fmt::print("{} faces of {}, {:.1f} % holes\n", count, size, 100 * open / count);
    for (std::size_t m = 0; m < methods.size(); ++m)
        fmt::print("{:<32} PSNR {:.2f} dB  GMSD {:.4f}  {:.3f} CPU s a face\n", methods[m].first, psnr[m] / count,
                   edges[m] / count, seconds[m] / count);
    if (!sheet_path.empty()) save_png(sheet_path, sheet.all);
    return 0;
}
