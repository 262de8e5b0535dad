// Where a camera stands to show a thing, and to show everything.
#include <algorithm>
#include <cmath>

#include "fastscene/film/plan_parts.h"

namespace fastscene {
namespace {

// Steeper than this, verticals converge.
constexpr float kLowestPitchDeg = -15, kHighestPitchDeg = 5;
// A camera nearer than this to furniture shows it blurred and huge.
constexpr float kRoomy_m = 0.35f;

// How well a subject at this distance fills the picture: 0 is best, falls with the logarithm.
float framing(float distance_m, const FilmSubject& subject, float fov_deg) {
    constexpr float kShareOfPicture = 0.42f;  // of the picture's width
    constexpr float kNearest_m = 1.4f, kFarthest_m = 4.f;
    const float best = std::clamp(subject.radius_m / std::tan(kShareOfPicture * fov_deg / 2 / kDegreesPerRadian),
                                  kNearest_m, kFarthest_m);
    return -std::fabs(std::log(std::max(distance_m, 0.05f) / best));
}

// A three-quarter view shows two sides: 1 there, less from straight ahead, least from behind.
float side_shown(Vec3f eye, const FilmSubject& subject) {
    if (subject.front == Vec3f{}) return 0;
    const Vec3f way = eye - subject.center_m;
    const float level = std::hypot(way.x, way.z);
    if (!(level > 1e-3f)) return 0;
    const float off = std::acos(std::clamp((way.x * subject.front.x + way.z * subject.front.z) / level, -1.f, 1.f)) *
                      kDegreesPerRadian;
    constexpr float kThreeQuarterDeg = 32;
    return 1 - std::fabs(off - kThreeQuarterDeg) / 90;
}

// The share of a picture that shows things right before the camera: a lampshade, the side of a cupboard.
float crowded(const FilmSet& set, Vec3f eye, Aim aim) {
    if (!set.sight) return 0;
    constexpr float kNear_m = 0.9f;
    const Rigid pose = world_from_camera_at({}, aim.yaw_deg, aim.pitch_deg);
    const float wide = std::tan(set.fov_deg / 2 / kDegreesPerRadian);
    int near = 0, all = 0;
    for (const float x : {-0.9f, -0.45f, 0.f, 0.45f, 0.9f})
        for (const float y : {-0.45f, 0.f, 0.45f}) {
            near += set.sight(eye, normalize(pose.rotation * Vec3f{x * wide, y * wide, 1})) < kNear_m;
            ++all;
        }
    return static_cast<float>(near) / static_cast<float>(all);
}
constexpr float kCrowded = 0.07f;  // one of the rays

}  // namespace

Aim aim_at(Vec3f eye, Vec3f target) {
    const Vec3f way = target - eye;
    const float level = std::hypot(way.x, way.z);
    return {
        std::atan2(way.x, way.z) * kDegreesPerRadian,
        std::clamp(std::atan2(-way.y, std::max(level, 1e-3f)) * kDegreesPerRadian, kLowestPitchDeg, kHighestPitchDeg)};
}

float turn_between(float from_deg, float to_deg) { return std::remainder(to_deg - from_deg, 360.f); }

bool is_seen(const FilmSet& set, Vec3f eye, const FilmSubject& subject) {
    if (!set.sight) return true;
    const Vec3f way = subject.center_m - eye;
    const float far = length(way);
    if (far < subject.radius_m) return true;
    // A ray to the center ends at the thing's own surface, at most its radius before.
    int seen = 0;
    for (const float up : {0.f, 0.4f}) {
        const Vec3f to = normalize(way - Vec3f{0, up * subject.radius_m, 0});
        seen += set.sight(eye, to) > far - 1.15f * subject.radius_m;
    }
    return seen > 0;
}

std::vector<Lookout> lookouts_for(const FilmSet& set, const FilmSubject& subject, std::size_t most) {
    std::vector<Lookout> all;
    for (std::size_t i = 0; i < set.grid.places().size(); ++i) {
        const Vec3f eye = set.eye(set.grid.places()[i]);
        const Vec3f way = subject.center_m - eye;
        all.push_back({i, framing(std::hypot(way.x, way.z), subject, set.fov_deg) + 0.5f * side_shown(eye, subject) +
                              std::min(set.grid.clearance_at(i), kRoomy_m) / kRoomy_m * 0.4f});
    }
    std::sort(all.begin(), all.end(), [](Lookout a, Lookout b) { return a.score > b.score; });
    constexpr float kApart_m = 0.5f;
    std::vector<Lookout> best;
    for (const Lookout& one : all) {
        const bool apart = std::all_of(best.begin(), best.end(), [&](Lookout other) {
            const Vec2f gap = set.grid.places()[one.place] - set.grid.places()[other.place];
            return std::hypot(gap.x, gap.y) > kApart_m;
        });
        // Rays are expensive: only for places that would be chosen.
        const Vec3f eye = set.eye(set.grid.places()[one.place]);
        if (apart && is_seen(set, eye, subject) && crowded(set, eye, aim_at(eye, subject.center_m)) < kCrowded)
            best.push_back(one);
        if (best.size() == most) break;
    }
    if (best.empty()) best.push_back(all.front());
    return best;
}

std::size_t widest_place(const FilmSet& set) {
    std::size_t best = 0;
    float best_score = -1e9f;
    for (std::size_t i = 0; i < set.grid.places().size(); ++i) {
        const Vec3f eye = set.eye(set.grid.places()[i]);
        const Vec3f way = set.middle - eye;
        const float yaw = aim_at(eye, set.middle).yaw_deg;
        float score = 0.35f * std::min(std::hypot(way.x, way.z), 5.f) +
                      0.3f * std::min(set.grid.clearance_at(i), kRoomy_m) / kRoomy_m;
        for (const FilmSubject& subject : set.subjects) {
            const bool framed = std::fabs(turn_between(yaw, aim_at(eye, subject.center_m).yaw_deg)) <
                                0.42f * set.fov_deg;
            if (framed) score += 1.f / static_cast<float>(set.subjects.size());
        }
        if (score > best_score) score -= 4 * crowded(set, eye, aim_at(eye, set.middle));
        if (score > best_score) best_score = score, best = i;
    }
    return best;
}

}  // namespace fastscene
