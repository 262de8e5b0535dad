#include "fastscene/studio/costs.h"

#include <algorithm>
#include <vector>

#include "fastscene/pipeline/quality.h"
#include "fastscene/pipeline/scene_cost.h"

namespace fastscene::studio {
namespace {

constexpr std::size_t kLatest = 9;      // finished scenes that count: rooms differ, and so does the machine's load
constexpr double kBusyShare = 0.92;     // of two cores' time, over a whole run
constexpr int kMostUsefulThreads = 16;  // more were not measured

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

struct Measured {
    std::vector<double> seconds, bytes;
};

Measured measured(const Json& scenes, const std::string& quality) {
    Measured out;
    for (const Json& scene : scenes) {
        if (scene.at("quality") != quality || !scene.at("finished") || !scene.at("has_room")) continue;
        if (scene.at("seconds") <= 0 || out.seconds.size() == kLatest) continue;
        out.seconds.push_back(scene.at("seconds"));
        out.bytes.push_back(scene.at("peak_memory_bytes"));
    }
    return out;
}

}  // namespace

Json costs(const Json& scenes, int threads) {
    const double cores = kBusyShare * std::clamp(threads, 1, kMostUsefulThreads);
    const auto expected = [&](const std::string& quality) { return scene_cost(quality).core_seconds / cores; };
    // How much slower than expected this machine is; measured scenes of one quality serve for the others, too.
    std::vector<double> slower;
    for (const std::string& quality : qualities())
        for (const double seconds : measured(scenes, quality).seconds) slower.push_back(seconds / expected(quality));
    const double factor = slower.empty() ? 1 : median(slower);
    Json out = Json::array();
    for (const std::string& quality : qualities()) {
        const Measured here = measured(scenes, quality);
        out.push_back({{"quality", quality},
                       {"seconds", here.seconds.empty() ? factor * expected(quality) : median(here.seconds)},
                       {"gib", here.bytes.empty() ? scene_cost(quality).gib : median(here.bytes) / (1 << 30)},
                       {"measured", here.seconds.size()}});
    }
    return out;
}

}  // namespace fastscene::studio
