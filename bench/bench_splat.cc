// Benchmark of a training step: CPU milliseconds per step and part, on synthetic data.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>
#include <vector>

#include "bench/textured_room.h"
#include "cpu_clock.h"
#include "fastscene/base/json.h"
#include "fastscene/splat/engine.h"
#include "fastscene/splat/splat.h"
#include "fastscene/splat/vulkan/engine.h"

namespace {

double cpu_ms() { return 1e3 * cpu_seconds(); }
double wall_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
double median(std::vector<double> v) {
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
}

// The core's current peak rate, under whatever else is running: independent multiply-adds in registers, with the
// instruction set of the measured kernel, whatever this file is compiled for. Twelve chains hide the latency and leave
// registers for the factors, which differ so that the compiler cannot merge them. (A macro, because GCC does not inline
// a template into a function with fewer instructions.)
#define FASTSCENE_PEAK(name, instructions, floats)                                                                   \
    instructions [[gnu::noinline]] double name() {                                                                   \
        typedef float Vector __attribute__((vector_size(4 * (floats))));                                             \
        constexpr int kChains = 12, kRounds = 2000000;                                                               \
        Vector sum[kChains], a, b;                                                                                   \
        for (int i = 0; i < (floats); ++i) a[i] = 0.999f, b[i] = 1e-3f;                                              \
        for (int i = 0; i < kChains; ++i) sum[i] = b * static_cast<float>(i);                                        \
        const double before = cpu_ms();                                                                              \
        for (int round = 0; round < kRounds; ++round) _Pragma("GCC unroll 12") for (Vector & s : sum) s = s * a + b; \
        const double ms = cpu_ms() - before;                                                                         \
        float kept = 0;                                                                                              \
        for (const Vector& s : sum) kept += s[0];                                                                    \
        return kept > 0 ? 2.0 * (floats)*kChains * kRounds / ms * 1e-6 : 0;                                          \
    }
#if defined(__x86_64__)
FASTSCENE_PEAK(avx512_gflops, [[gnu::target("arch=x86-64-v4")]], 16)
FASTSCENE_PEAK(avx2_gflops, [[gnu::target("arch=x86-64-v3")]], 8)
FASTSCENE_PEAK(baseline_gflops, [[gnu::target("no-avx")]], 4)
#else
FASTSCENE_PEAK(baseline_gflops, , 4)
#endif
double peak_gflops(std::string_view kernel) {
#if defined(__x86_64__)
    if (kernel == "avx512") return avx512_gflops();
    if (kernel == "avx2") return avx2_gflops();
#endif
    return kernel == "baseline" ? baseline_gflops() : 0;
}

// Operations of a step, counted in the source: a multiply-add is two. Blending processes 16 pixels at once.
double step_gflop(int size, double visits, double visible, double count, double functions) {
    constexpr double kForward = 31, kBackward = 54, kLossValue = 350, kSplat = 1200, kAdam = 12;
    return 1e-9 * (visits * 16 * (kForward + kBackward) + 3.0 * size * size * kLossValue + visible * kSplat +
                   count * functions * kAdam);
}

constexpr std::array<float, fastscene::splat::kParameters> kRates{5e-4f, 5e-4f, 5e-4f, 5e-3f, 5e-3f, 5e-3f, 2e-3f,
                                                                  2e-3f, 2e-3f, 2e-3f, 5e-2f, 5e-3f, 5e-3f, 5e-3f};

// Steps recorded ahead, as in training; then as many with each kernel timed on the card.
fastscene::Json on_card(const std::string& device, const fastscene::bench::RoomSet& set,
                        const fastscene::splat::Cloud& cloud, int warm, int steps) {
    using namespace fastscene;
    splat::vulkan::VulkanEngine engine(device, "--device");
    engine.load(cloud);
    std::vector<const View*> views;
    for (const View& v : set.train.views) views.push_back(&v);
    engine.set_views(views);
    int step = 0;
    const auto run = [&](int count) {
        for (const int end = step + count; step < end;) {
            splat::StepPlan plan;
            plan.rates.rates = kRates, plan.rates.adam_step = ++step, plan.judge = true;
            engine.step(static_cast<std::size_t>(step) % views.size(), plan);
        }
        double loss = 0;
        for (const auto& l : engine.finish()) loss += l.loss;
        return loss / count;
    };
    run(warm);
    const double wall_before = wall_ms(), cpu_before = cpu_ms(), loss = run(steps);
    const double wall = wall_ms() - wall_before, cpu = cpu_ms() - cpu_before;
    engine.device().kernel_times();
    run(steps);
    Json kernels = Json::object();
    double sum = 0;
    for (const auto& [name, ms] : engine.device().kernel_times()) kernels[name] = ms / steps, sum += ms / steps;
    return {{"device", engine.device().info().name},
            {"wall_ms_per_step", wall / steps},
            {"cpu_ms_per_step", cpu / steps},
            {"kernel_ms_per_step", sum},
            {"kernel_ms", kernels},
            {"tile_entries", engine.pairs()},
            {"loss", loss}};
}

}  // namespace

int main(int argc, char** argv) try {
    using namespace fastscene;
    int size = 512, count = 50000, threads = 1, steps = 40, warm = 15;
    std::string kernel, device;
    bool json = false;
    CLI::App app{"Cost of one splat training step"};
    app.add_option("--size", size, "Width and height of the views, pixels")->check(CLI::Range(16, 4096));
    app.add_option("--count", count, "Number of Gaussians")->check(CLI::Range(1, 20000000));
    app.add_option("--threads", threads, "Worker threads")->check(CLI::Range(1, 1024));
    app.add_option("--steps", steps, "Steps measured")->check(CLI::Range(1, 100000));
    app.add_option("--warm", warm, "Steps before measuring")->check(CLI::Range(0, 100000));
    app.add_option("--kernel", kernel, "avx512, avx2 or baseline; default: the best one here");
    app.add_option("--device", device, "A graphics card, by number or part of its name, or auto, instead of the CPU");
    app.add_flag("--json", json, "One JSON line");
    CLI11_PARSE(app, argc, argv);

    set_threads(threads);
    const bench::RoomSet set = bench::room_set(size, 1, count, 0, 1);
    splat::Cloud cloud(initial_splats(set.train.points, count, Run{}), true);
    const splat::Kernel& chosen = splat::choose_kernel(kernel.empty() ? nullptr : kernel.c_str());
    splat::Engine engine(chosen);
    if (!device.empty()) {
        Json out = on_card(device, set, cloud, warm, steps);
        out["size"] = size, out["count"] = count, out["steps"] = steps;
        fmt::print("{}\n", json ? out.dump() : out.dump(2));
        return 0;
    }
    double loss = 0;
    std::vector<double> cpu, wall;
    std::int64_t visible = 0, entries = 0, visits = 0;
    for (int step = 1; step <= warm + steps; ++step) {
        if (step == warm + 1) engine.times = {}, loss = 0, visible = 0, entries = 0, visits = 0;
        const double cpu_before = cpu_ms(), wall_before = wall_ms();
        const View& view = set.train.views[static_cast<std::size_t>(step) % set.train.views.size()];
        engine.render(cloud, view.camera, view.world_from_camera, {}, false);
        loss += engine.differentiate(view, 0.2f).loss;
        engine.step(cloud, kRates, step);
        visible += engine.visible(), entries += engine.entries(), visits += engine.block_visits();
        if (step > warm) cpu.push_back(cpu_ms() - cpu_before), wall.push_back(wall_ms() - wall_before);
    }
    const double n = steps;
    const splat::StepTimes& t = engine.times;
    const double gflop = step_gflop(size, static_cast<double>(visits) / n, static_cast<double>(visible) / n, count,
                                    splat::kParameters);
    const double peak = std::max(peak_gflops(chosen.name), peak_gflops(chosen.name));
    Json out = {{"size", size},
                {"count", count},
                {"threads", threads},
                {"steps", steps},
                {"kernel", chosen.name},
                {"cpu_ms_per_step", median(cpu)},
                {"wall_ms_per_step", median(wall)},
                {"cpu_ms",
                 {{"project", t.project / n},
                  {"sort", t.sort / n},
                  {"bin", t.bin / n},
                  {"forward", t.forward / n},
                  {"loss", t.loss / n},
                  {"backward", t.backward / n},
                  {"update", t.update / n}}},
                {"visible", visible / steps},
                {"tile_entries", entries / steps},
                {"block_visits", visits / steps},
                {"loss", loss / n},
                {"gflop_per_step", gflop},
                {"peak_gflops", peak},
                {"share_of_peak", gflop / median(cpu) * 1e3 / peak}};
    fmt::print("{}\n", json ? out.dump() : out.dump(2));
    return 0;
} catch (const std::exception& e) {
    fmt::print(stderr, "bench_splat: {}\n", e.what());
    return 1;
}
