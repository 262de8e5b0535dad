#include "fastscene/studio/costs.h"

#include <algorithm>
#include <vector>

#include "fastscene/pipeline/quality.h"
#include "fastscene/pipeline/scene_cost.h"

namespace fastscene::studio {
namespace {

constexpr std::size_t kLatest = 9;     // finished scenes that count: rooms differ, and so does the machine's load
constexpr double kBusyShare = 0.92;    // of two cores' time, over a whole run
constexpr int kMostUsefulThreads = 16;  // more were not measured

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

Json costs(const Json& scenes, int threads) {
    Json out = Json::array();
    for (const std::string& quality : qualities()) {
        std::vector<double> seconds, bytes;
        for (const Json& scene : scenes) {
            if (scene.at("quality") != quality || !scene.at("finished") || !scene.at("has_room")) continue;
            if (scene.at("seconds") > 0 && seconds.size() < kLatest) {
                seconds.push_back(scene.at("seconds"));
                bytes.push_back(scene.at("peak_memory_bytes"));
            }
        }
        const SceneCost cost = scene_cost(quality);
        const double cores = kBusyShare * std::clamp(threads, 1, kMostUsefulThreads);
        out.push_back({{"quality", quality},
                       {"seconds", seconds.empty() ? 60 * cost.cpu_minutes / cores : median(seconds)},
                       {"gib", bytes.empty() ? cost.gib : median(bytes) / (1 << 30)},
                       {"measured", seconds.size()}});
    }
    return out;
}

}  // namespace fastscene::studio
