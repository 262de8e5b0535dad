// Plans a film's camera path: over the walkable floor, at eye height, looking at what the scene is about.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/scene/camera_path.h"
#include "fastscene/scene/walkable.h"

namespace fastscene {

// tour: opens with a view of the whole, goes from thing to thing and ends at the first subject.
// orbit: around the first subject, as far as the floor leads.
// walkthrough: from the door, or the far end, through the room, looking ahead and aside.
inline constexpr std::array<std::string_view, 3> kPathKinds{"tour", "orbit", "walkthrough"};

// Something to look at. World frame.
struct FilmSubject {
    std::string name;
    Vec3f center_m;
    float radius_m = 0.5f;
    Vec3f front{};      // unit, level: the side to look at it from; zero: any
    bool door = false;  // not looked at: where a walkthrough comes in
};

struct FilmWish {
    std::string kind = "tour";
    float seconds = 0;  // 0: as long as it takes at a walking camera's pace
    float fps = 30, fov_deg = 75;
    int width = 1280, height = 720;
};

// Limits of every planned path, also where `seconds` asks for more.
struct FilmPace {
    float metres_per_s = 0.55f;  // a slow walk: faster makes a room seem small and viewers unwell
    float degrees_per_s = 26;    // of yaw; above 30 a pan at 30 frames a second visibly judders
    float tilt_degrees_per_s = 12;
    float sideways_m_per_s2 = 0.35f;  // acceleration in bends
};

// Metres along a ray to the first surface; empty: nothing hides anything.
using FilmSight = std::function<float(Vec3f from, Vec3f direction)>;

// Subjects in order of importance. Throws UsageError for an unknown kind, or seconds that the pace does not allow,
// naming the shortest film; Error if there is no floor.
CameraPath plan_film(const WalkableArea& area, const std::vector<FilmSubject>& subjects, const FilmWish& wish,
                     const FilmSight& sight = {});

}  // namespace fastscene
