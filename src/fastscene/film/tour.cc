#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "fastscene/film/plan_parts.h"

namespace fastscene {
namespace {

// More than this is a list, not a film.
constexpr std::size_t kMostStops = 4;
constexpr float kOpening_s = 1.2f, kLook_s = 0.8f, kEnding_s = 1.6f;

// Something to look at, and the places to do it from.
struct Sight {
    Vec3f target;
    std::vector<Lookout> from;
    float rest_s;
};
struct Stop {
    std::size_t place;
    Vec3f target;
    float rest_s;
};

// The stops of a tour, in the order and at the places that together show most on the shortest way with the least
// turning. The first and the last sight keep their positions.
class TourOrder {
  public:
    TourOrder(const FilmSet& set, std::vector<Sight> sights) : set_(set), sights_(std::move(sights)) {
        for (const Sight& sight : sights_)
            for (const Lookout& at : sight.from)
                if (!ways_.contains(at.place)) ways_.emplace(at.place, set.grid.ways_from(at.place));
    }
    std::vector<Stop> stops() const {
        std::vector<std::size_t> order(sights_.size());
        std::iota(order.begin(), order.end(), 0);
        float least = 1e9f;
        std::vector<Stop> best;
        do {
            const auto [cost, stops] = along(order);
            if (cost < least) least = cost, best = stops;
        } while (order.size() > 3 && std::next_permutation(order.begin() + 1, order.end() - 1));
        return best;
    }

  private:
    float cost(const Sight& a, const Lookout& from, const Sight& b, const Lookout& to) const {
        constexpr float kMetresPerDegree = 0.015f;  // turning takes time as well, and blurs
        const float turn = turn_between(aim_at(eye(from), a.target).yaw_deg, aim_at(eye(to), b.target).yaw_deg);
        return ways_.at(from.place).cost[to.place] + kMetresPerDegree * std::fabs(turn);
    }
    // Dynamic programming over the places of each sight.
    std::pair<float, std::vector<Stop>> along(const std::vector<std::size_t>& order) const {
        constexpr float kMetresPerScore = 2.5f;  // of way for a place that shows the thing one point better
        std::vector<std::vector<float>> sums;
        std::vector<std::vector<std::size_t>> before;
        for (std::size_t k = 0; k < order.size(); ++k) {
            const Sight& sight = sights_[order[k]];
            std::vector<float>& sum = sums.emplace_back();
            std::vector<std::size_t>& came = before.emplace_back();
            for (const Lookout& to : sight.from) {
                float least = k == 0 ? 0.f : 1e9f;
                std::size_t best = 0;
                for (std::size_t i = 0; k > 0 && i < sums[k - 1].size(); ++i) {
                    const Sight& last = sights_[order[k - 1]];
                    const float all = sums[k - 1][i] + cost(last, last.from[i], sight, to);
                    if (all < least) least = all, best = i;
                }
                sum.push_back(least - kMetresPerScore * to.score);
                came.push_back(best);
            }
        }
        auto at = static_cast<std::size_t>(std::min_element(sums.back().begin(), sums.back().end()) -
                                           sums.back().begin());
        const float cost = sums.back()[at];
        std::vector<Stop> stops(order.size());
        for (std::size_t k = order.size(); k-- > 0; at = before[k][at]) {
            const Sight& sight = sights_[order[k]];
            stops[k] = {sight.from[at].place, sight.target, sight.rest_s};
        }
        return {cost, stops};
    }
    Vec3f eye(const Lookout& at) const { return set_.eye(set_.grid.places()[at.place]); }

    const FilmSet& set_;
    std::vector<Sight> sights_;
    std::map<std::size_t, FloorGrid::Ways> ways_;
};

// From one stop to the next: the look swings from the one thing to the other on the way.
void add_leg(const FilmSet& set, const Stop& from, const Stop& to, std::vector<FilmStep>& steps) {
    const std::vector<Vec2f> curve = smooth_curve(set.area, set.grid.way(set.grid.ways_from(from.place), to.place));
    const auto look = [&](Vec2f place, Vec3f target) { return aim_at(set.eye(place), target); };
    const Aim first = look(curve.front(), from.target), last = look(curve.back(), to.target);
    constexpr float kStepDeg = 1.5f;
    const auto turns = static_cast<std::size_t>(std::fabs(turn_between(first.yaw_deg, last.yaw_deg)) / kStepDeg);
    const std::size_t count = std::max({curve.size(), turns, std::size_t{2}});
    for (std::size_t k = 1; k < count; ++k) {
        const float t = static_cast<float>(k) / static_cast<float>(count - 1);
        const float at = t * static_cast<float>(curve.size() - 1);
        const auto i = std::min(static_cast<std::size_t>(at), curve.size() - 1);
        const Vec2f place = i + 1 < curve.size() ? curve[i] + (curve[i + 1] - curve[i]) * (at - static_cast<float>(i))
                                                 : curve[i];
        const Aim a = look(place, from.target), b = look(place, to.target);
        const float w = smoothed(t);
        steps.push_back({place, a.yaw_deg + turn_between(a.yaw_deg, b.yaw_deg) * w,
                         a.pitch_deg + (b.pitch_deg - a.pitch_deg) * w, 0});
    }
    steps.back().rest_s = to.rest_s;
}

// The view of the whole first, the main subject last.
std::vector<Sight> sights_of(const FilmSet& set, std::size_t most_stops) {
    constexpr std::size_t kPlaces = 6;
    const std::size_t widest = widest_place(set);
    std::vector<Sight> sights{{set.middle, {{widest, 0}}, kOpening_s}};
    const std::size_t count = std::min({set.subjects.size(), kMostStops, most_stops});
    for (std::size_t i = count; i-- > 0;)
        sights.push_back(
            {set.subjects[i].center_m, lookouts_for(set, set.subjects[i], kPlaces), i == 0 ? kEnding_s : kLook_s});
    if (sights.size() > 1) return sights;
    // Without anything to show, the view of the whole from another side.
    const FloorGrid::Ways ways = set.grid.ways_from(widest);
    const auto far = std::max_element(ways.cost.begin(), ways.cost.end());
    sights.push_back({set.middle, {{static_cast<std::size_t>(far - ways.cost.begin()), 0}}, kEnding_s});
    return sights;
}

}  // namespace

std::vector<FilmStep> tour_steps(const FilmSet& set, std::size_t most_stops) {
    const std::vector<Stop> stops = TourOrder(set, sights_of(set, most_stops)).stops();
    const Vec2f start = set.grid.places()[stops.front().place];
    const Aim first = aim_at(set.eye(start), stops.front().target);
    std::vector<FilmStep> steps{{start, first.yaw_deg, first.pitch_deg, stops.front().rest_s}};
    for (std::size_t i = 1; i < stops.size(); ++i) add_leg(set, stops[i - 1], stops[i], steps);
    return steps;
}

}  // namespace fastscene
