// What the three kinds of path share. Private to film/.
#pragma once

#include <vector>

#include "fastscene/film/plan.h"
#include "fastscene/film/route.h"

namespace fastscene {

inline constexpr float kDegreesPerRadian = 180.f / kPi;
// From 0 to 1 without a jump of speed.
inline float smoothed(float t) { return t * t * (3 - 2 * t); }

// A sample of the way, not timed yet: where the camera is, where it looks, and how long it rests there.
struct FilmStep {
    Vec2f place;
    float yaw_deg = 0, pitch_deg = 0;
    float rest_s = 0;
};

// Everything that a planner looks at.
struct FilmSet {
    const WalkableArea& area;
    const FloorGrid& grid;
    std::vector<FilmSubject> subjects;  // without doors
    std::vector<Vec2f> doors;
    float eye_y = 0, fov_deg = 75;  // above the lowest floor
    Vec3f middle;                   // what a view of the whole looks at
    const FilmSight& sight;

    Vec3f eye(Vec2f place) const { return {place.x, eye_y - raised_at(area, place), place.y}; }
};

struct Aim {
    float yaw_deg = 0, pitch_deg = 0;
};
// Towards a point; the pitch is held within limits that keep verticals nearly upright.
Aim aim_at(Vec3f eye, Vec3f target);
// The shorter turn from one yaw to another, in -180 to 180 degrees.
float turn_between(float from_deg, float to_deg);
// Whether the subject is seen from there.
bool is_seen(const FilmSet& set, Vec3f eye, const FilmSubject& subject);
// A place to show a subject from, and how well it shows there: at a distance that fills the picture well, from its
// front, aside, in the free, and in sight.
struct Lookout {
    std::size_t place;
    float score;
};
// The best places, some distance apart, best first; at least one.
std::vector<Lookout> lookouts_for(const FilmSet& set, const FilmSubject& subject, std::size_t most);
// The place from which most is seen, and what it looks at.
std::size_t widest_place(const FilmSet& set);

std::vector<FilmStep> tour_steps(const FilmSet& set, std::size_t most_stops);
std::vector<FilmStep> orbit_steps(const FilmSet& set);
std::vector<FilmStep> walkthrough_steps(const FilmSet& set);

}  // namespace fastscene
