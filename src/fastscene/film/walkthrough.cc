#include <algorithm>
#include <cmath>

#include "fastscene/film/plan_parts.h"

namespace fastscene {
namespace {

constexpr float kAhead_m = 1.1f;    // the look is that far along the way
constexpr float kGlanceDeg = 50;    // largest turn to the side
constexpr float kNoticed_m = 3.2f;  // things farther away get no glance
constexpr float kLastShare = 0.3f;  // of the way, on which the look settles on the main subject

// The longest way through the room: from the door if there is one, else between the two places farthest apart.
std::vector<Vec2f> longest_way(const FilmSet& set) {
    const auto farthest = [&](const FloorGrid::Ways& ways) {
        // Tight corners are no goals.
        constexpr float kStepAside_m = 0.15f;
        std::size_t best = 0;
        float most = -1;
        for (std::size_t i = 0; i < ways.cost.size(); ++i) {
            const float worth = ways.cost[i] * (set.grid.clearance_at(i) < kStepAside_m ? 0.5f : 1.f);
            if (worth > most) most = worth, best = i;
        }
        return best;
    };
    const std::size_t middle = set.grid.nearest({set.middle.x, set.middle.z});
    const std::size_t from = set.doors.empty() ? farthest(set.grid.ways_from(middle))
                                               : set.grid.nearest(set.doors.front());
    const FloorGrid::Ways ways = set.grid.ways_from(from);
    return set.grid.way(ways, farthest(ways));
}

// How far to turn from the way's direction towards what stands beside it.
float glance(const FilmSet& set, Vec3f eye, float heading_deg) {
    float sum = 0, weights = 0.6f;  // of looking ahead
    for (const FilmSubject& subject : set.subjects) {
        const Vec3f way = subject.center_m - eye;
        const float far = std::hypot(way.x, way.z);
        const float turn = turn_between(heading_deg, aim_at(eye, subject.center_m).yaw_deg);
        constexpr float kWidestDeg = 85;
        if (far > kNoticed_m || std::fabs(turn) > kWidestDeg || !is_seen(set, eye, subject)) continue;
        const float weight = (1 - far / kNoticed_m) * std::pow(std::cos(turn / kWidestDeg * kPi / 2), 2.f);
        sum += weight * turn, weights += weight;
    }
    return std::clamp(sum / weights, -kGlanceDeg, kGlanceDeg);
}

// A mean over some steps on both sides, twice: a head turns slowly.
std::vector<float> calmed(std::vector<float> angles) {
    constexpr float kReach_m = 0.5f;
    const auto reach = static_cast<std::ptrdiff_t>(kReach_m / kCurveStep_m);
    for (int pass = 0; pass < 2; ++pass) {
        std::vector<float> mean;
        for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(angles.size()); ++i) {
            float sum = 0;
            for (std::ptrdiff_t k = i - reach; k <= i + reach; ++k)
                sum += angles[static_cast<std::size_t>(
                    std::clamp<std::ptrdiff_t>(k, 0, static_cast<std::ptrdiff_t>(angles.size()) - 1))];
            mean.push_back(sum / static_cast<float>(2 * reach + 1));
        }
        angles = std::move(mean);
    }
    return angles;
}

// Directions along the way, some distance ahead, unwrapped.
std::vector<float> headings(const std::vector<Vec2f>& curve) {
    const auto ahead = static_cast<std::size_t>(kAhead_m / kCurveStep_m);
    std::vector<float> out;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const Vec2f to = curve[std::min(i + ahead, curve.size() - 1)] - curve[i];
        constexpr float kLeast_m = 0.5f;  // near the end there is no way ahead: the last direction is kept
        const float last = out.empty() ? 0 : out.back();
        const bool known = out.empty() || std::hypot(to.x, to.y) > kLeast_m;
        out.push_back(known ? last + turn_between(last, std::atan2(to.x, to.y) * kDegreesPerRadian) : last);
    }
    return calmed(std::move(out));
}

// What the walk ends with: a subject that needs little turning and fills the picture, preferably a main one.
Vec3f last_look(const FilmSet& set, Vec3f eye, float heading_deg) {
    constexpr float kTurn_deg = 60, kDistance_m = 2.5f, kRank = 0.2f;  // what costs as much as one another
    const auto turn = [&](Vec3f target) { return std::fabs(turn_between(heading_deg, aim_at(eye, target).yaw_deg)); };
    Vec3f best = set.middle;
    float least = turn(best) / kTurn_deg + 1, rank = 0;
    for (const FilmSubject& subject : set.subjects) {
        const Vec3f way = subject.center_m - eye;
        const float off = std::fabs(std::hypot(way.x, way.z) - kDistance_m) / kDistance_m;
        const float cost = turn(subject.center_m) / kTurn_deg + 2 * off + rank;
        rank += kRank;
        if (cost < least && is_seen(set, eye, subject)) least = cost, best = subject.center_m;
    }
    return best;
}

}  // namespace

std::vector<FilmStep> walkthrough_steps(const FilmSet& set) {
    const std::vector<Vec2f> curve = smooth_curve(set.area, longest_way(set));
    const std::vector<float> heading = headings(curve);
    std::vector<float> aside;
    for (std::size_t i = 0; i < curve.size(); ++i) aside.push_back(glance(set, set.eye(curve[i]), heading[i]));
    aside = calmed(std::move(aside));
    const Vec3f goal = last_look(set, set.eye(curve.back()), heading.back());
    std::vector<FilmStep> steps;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const Aim last = aim_at(set.eye(curve[i]), goal);
        const float share = curve.size() > 1 ? static_cast<float>(i) / static_cast<float>(curve.size() - 1) : 1.f;
        const float settle = smoothed(std::clamp((share - (1 - kLastShare)) / kLastShare, 0.f, 1.f));
        const float yaw = heading[i] + aside[i];
        constexpr float kWalkingPitchDeg = -6;  // as people look, a little down
        steps.push_back({curve[i], yaw + turn_between(yaw, last.yaw_deg) * settle,
                         kWalkingPitchDeg + (last.pitch_deg - kWalkingPitchDeg) * settle, 0});
    }
    constexpr float kEnding_s = 1.4f;
    steps.back().rest_s = kEnding_s;
    return steps;
}

}  // namespace fastscene
