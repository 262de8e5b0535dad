#include "fastscene/export/splat_labels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/export/instances.h"

namespace fastscene {
namespace {

// A splat lies on the surface that a camera sees there if no more than this, and its own radius, is between them.
constexpr float kOnSurface_m = 0.03f, kLargestRadius_m = 0.1f;
// Votes of cameras for which it floats before the surface that they see, or hides behind it. They decide only where no
// camera sees it on a surface: what a mirror shows is behind it for all of them.
constexpr float kBefore = 1e-2f, kBehind = 1e-3f;
// What a camera sees through a window is placed 400 m away (views/points.h). Nearer splats may show a mirror's room.
constexpr float kOutside_m = 50;
constexpr float kNearest_m = 0.3f;  // a camera's vote grows with the size that a splat has in its picture, up to here

struct Votes {
    std::vector<std::pair<std::uint16_t, float>> given;
    void add(std::uint16_t label, float weight) {
        for (auto& [known, sum] : given)
            if (known == label) return void(sum += weight);
        given.emplace_back(label, weight);
    }
    std::uint16_t winner() const {
        if (given.empty()) return 0;
        return std::max_element(given.begin(), given.end(),
                                [](const auto& a, const auto& b) { return a.second < b.second; })
            ->first;
    }
};

// How much a camera's vote counts for a splat `way` metres away, if it sees a surface at `seen` metres there.
float weight_of(float way, float seen, float radius) {
    const float size = 1 / std::max(way * way, kNearest_m * kNearest_m), on = kOnSurface_m + radius;
    const bool outside = std::isinf(seen);
    if (outside ? way > kOutside_m : std::fabs(way - seen) <= on) return size;
    return size * (way < seen && !outside ? kBefore : kBehind);
}

// Where cameras look for a splat: its middle, and points that share its area evenly.
std::array<Vec3f, 5> places_of(const Splats& splats, std::size_t i) {
    constexpr float kOut = 0.8f;  // standard deviations
    const Mat3f turn = matrix_of(splats.rotation[i]);
    const Vec3f scale = splats.log_scale[i], mean = splats.mean_m[i];
    const std::size_t thin = scale.x <= scale.y && scale.x <= scale.z ? 0 : scale.y <= scale.z ? 1 : 2;
    const std::size_t u = (thin + 1) % 3, v = (thin + 2) % 3;
    const Vec3f along = turn.column(u) * (kOut * std::exp(scale[u])),
                across = turn.column(v) * (kOut * std::exp(scale[v]));
    return {mean, mean + along, mean - along, mean + across, mean - across};
}

}  // namespace

std::vector<std::uint16_t> splat_labels(const Splats& splats, const TracedRoom& room,
                                        const std::vector<Vec3f>& viewpoints, const Run& run) {
    const std::vector<std::uint16_t> by_mesh = instance_by_mesh(room.room());
    std::vector<std::uint16_t> labels(splats.size());
    Progress progress(run, "labels", static_cast<std::int64_t>(splats.size()));
    parallel_for(static_cast<std::int64_t>(splats.size()), 4096, [&](std::int64_t begin, std::int64_t end) {
        run.check_stop();
        Votes votes;
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            votes.given.clear();
            const float radius = std::min(std::exp(max_component(splats.log_scale[i])), kLargestRadius_m);
            for (const Vec3f place : places_of(splats, i))
                for (const Vec3f eye : viewpoints) {
                    const float way = length(place - eye);
                    if (!(way > 1e-3f)) continue;
                    const TracedRoom::Surface seen = room.surface(eye, (place - eye) / way);
                    votes.add(seen.mesh < 0 ? std::uint16_t{0} : by_mesh[static_cast<std::size_t>(seen.mesh)],
                              weight_of(way, seen.distance, radius));
                }
            labels[i] = votes.winner();
        }
        progress.advance(end - begin);
    });
    return labels;
}

}  // namespace fastscene
