#include "fastscene/film/plan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fastscene/base/error.h"
#include "fastscene/film/plan_parts.h"

namespace fastscene {
namespace {

// Ways, angles and the time at which each is reached at full speed.
struct Timeline {
    std::vector<Vec2f> places;      // of the way
    std::vector<float> way_m;       // from its beginning
    std::vector<float> yaw, pitch;  // degrees, unwrapped
    std::vector<float> time_s;
};

// Radius of the bend at a step; infinite on a straight.
float bend_radius(const std::vector<FilmStep>& steps, std::size_t i) {
    constexpr std::size_t kReach = 4;
    const Vec2f a = steps[i >= kReach ? i - kReach : 0].place, b = steps[i].place,
                c = steps[std::min(i + kReach, steps.size() - 1)].place;
    const Vec2f u = b - a, v = c - b, w = c - a;
    const float area = std::fabs(u.x * v.y - u.y * v.x);
    const float sides = std::hypot(u.x, u.y) * std::hypot(v.x, v.y) * std::hypot(w.x, w.y);
    return area > 1e-9f ? sides / (2 * area) : 1e9f;
}

Timeline timed(const std::vector<FilmStep>& steps, const FilmPace& pace) {
    Timeline out;
    const auto add = [&](Vec2f place, float way, float yaw, float pitch, float time) {
        out.places.push_back(place), out.way_m.push_back(way), out.yaw.push_back(yaw), out.pitch.push_back(pitch),
            out.time_s.push_back(time);
    };
    add(steps[0].place, 0, steps[0].yaw_deg, steps[0].pitch_deg, 0);
    const auto rest = [&](const FilmStep& step) {
        if (step.rest_s > 0)
            add(step.place, out.way_m.back(), out.yaw.back(), out.pitch.back(), out.time_s.back() + step.rest_s);
    };
    rest(steps[0]);
    for (std::size_t i = 1; i < steps.size(); ++i) {
        const Vec2f gap = steps[i].place - steps[i - 1].place;
        const float way = std::hypot(gap.x, gap.y);
        const float turn = turn_between(out.yaw.back(), steps[i].yaw_deg),
                    tilt = steps[i].pitch_deg - steps[i - 1].pitch_deg;
        const float speed = std::min(pace.metres_per_s, std::sqrt(pace.sideways_m_per_s2 * bend_radius(steps, i)));
        const float takes = std::max(
            {way / speed, std::fabs(turn) / pace.degrees_per_s, std::fabs(tilt) / pace.tilt_degrees_per_s, 1e-4f});
        add(steps[i].place, out.way_m.back() + way, out.yaw.back() + turn, out.pitch.back() + tilt,
            out.time_s.back() + takes);
        rest(steps[i]);
    }
    return out;
}

// Values over time, in steps of kStep_s, with time to start and stop at both ends.
constexpr float kStep_s = 1.f / 60;
constexpr float kEase_s = 0.9f;  // how long a change of speed takes
std::vector<float> sampled(const std::vector<float>& values, const std::vector<float>& times) {
    const float lead = 1.5f * kEase_s;
    const auto count = static_cast<std::size_t>((times.back() + 2 * lead) / kStep_s) + 2;
    std::vector<float> out;
    std::size_t i = 1;
    for (std::size_t k = 0; k < count; ++k) {
        const float t = std::clamp(static_cast<float>(k) * kStep_s - lead, 0.f, times.back());
        while (i + 1 < times.size() && times[i] < t) ++i;
        if (times.size() == 1) out.push_back(values[0]);
        else {
            const float u = std::clamp((t - times[i - 1]) / (times[i] - times[i - 1]), 0.f, 1.f);
            out.push_back(values[i - 1] + (values[i] - values[i - 1]) * u);
        }
    }
    return out;
}

// The moving average over `half` values on both sides; beyond the ends the value stays as it is.
std::vector<float> averaged(const std::vector<float>& values, std::ptrdiff_t half) {
    const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
    std::vector<double> sums{0};
    for (const float v : values) sums.push_back(sums.back() + static_cast<double>(v));
    std::vector<float> mean(values.size());
    for (std::ptrdiff_t i = 0; i <= last; ++i) {
        const std::ptrdiff_t from = std::max<std::ptrdiff_t>(0, i - half), to = std::min(last, i + half);
        const double sum = sums[static_cast<std::size_t>(to) + 1] - sums[static_cast<std::size_t>(from)] +
                           static_cast<double>(values.front()) * static_cast<double>(from - (i - half)) +
                           static_cast<double>(values.back()) * static_cast<double>(i + half - to);
        mean[static_cast<std::size_t>(i)] = static_cast<float>(sum / static_cast<double>(2 * half + 1));
    }
    return mean;
}

// Three moving averages: a mean of values keeps the limits of speed, and leaves no jerk.
std::vector<float> eased(std::vector<float> values) {
    for (int pass = 0; pass < 3; ++pass) values = averaged(values, static_cast<std::ptrdiff_t>(kEase_s / kStep_s / 2));
    return values;
}

Vec2f place_at(const Timeline& line, float way_m) {
    const auto next = std::upper_bound(line.way_m.begin(), line.way_m.end(), way_m);
    if (next == line.way_m.begin()) return line.places.front();
    if (next == line.way_m.end()) return line.places.back();
    const auto i = static_cast<std::size_t>(next - line.way_m.begin());
    const float t = (way_m - line.way_m[i - 1]) / (line.way_m[i] - line.way_m[i - 1]);
    return line.places[i - 1] + (line.places[i] - line.places[i - 1]) * t;
}

// The places over time. Corners of the floor leave small bends in the way; a mean over a moment rounds them, as far as
// the camera stays on the floor.
std::vector<Vec2f> places_of(const Timeline& line, const std::vector<float>& way, const WalkableArea& area) {
    std::vector<Vec2f> exact, mean;
    for (const float at : way) exact.push_back(place_at(line, at));
    mean = exact;
    constexpr float kMoment_s = 0.35f, kOnFloor_m = 0.02f;
    for (int pass = 0; pass < 2; ++pass)
        for (float Vec2f::*axis : {&Vec2f::x, &Vec2f::y}) {
            std::vector<float> values;
            for (const Vec2f p : mean) values.push_back(p.*axis);
            values = averaged(values, static_cast<std::ptrdiff_t>(kMoment_s / kStep_s / 2));
            for (std::size_t i = 0; i < mean.size(); ++i) mean[i].*axis = values[i];
        }
    const bool stays = std::all_of(mean.begin(), mean.end(), [&](Vec2f p) { return clearance(area, p) > kOnFloor_m; });
    return stays ? mean : exact;
}

// The eye's heights over time (world y). Up a flight of steps it rises evenly.
std::vector<float> heights_of(const std::vector<Vec2f>& places, const FilmSet& set) {
    std::vector<float> heights;
    for (const Vec2f p : places) heights.push_back(set.eye(p).y);
    if (set.area.levels.empty()) return heights;
    constexpr float kFlight_s = 0.8f;
    for (int pass = 0; pass < 2; ++pass)
        heights = averaged(heights, static_cast<std::ptrdiff_t>(kFlight_s / kStep_s / 2));
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const float raised = raised_at(set.area, places[i]);
        heights[i] = std::clamp(heights[i], set.area.low_y - raised, set.area.high_y - raised);
    }
    return heights;
}

std::vector<CameraKey> keys_of(const std::vector<FilmStep>& steps, const FilmSet& set) {
    const Timeline line = timed(steps, {});
    const std::vector<float> way = eased(sampled(line.way_m, line.time_s)), yaw = eased(sampled(line.yaw, line.time_s)),
                             pitch = eased(sampled(line.pitch, line.time_s));
    const std::vector<Vec2f> places = places_of(line, way, set.area);
    const std::vector<float> heights = heights_of(places, set);
    constexpr std::size_t kKeyEvery = 6;  // a key each tenth of a second
    std::vector<CameraKey> keys;
    const auto add = [&](std::size_t k) {
        const Vec3f eye{places[k].x, heights[k], places[k].y};
        keys.push_back({static_cast<float>(k) * kStep_s, eye, yaw[k], pitch[k]});
    };
    for (std::size_t k = 0; k < way.size(); k += kKeyEvery) add(k);
    if ((way.size() - 1) % kKeyEvery != 0) add(way.size() - 1);
    return keys;
}

FilmSet film_set(const WalkableArea& area, const FloorGrid& grid, const std::vector<FilmSubject>& subjects,
                 const FilmWish& wish, const FilmSight& sight) {
    // The first panorama's height, at which the room was planned to be seen.
    FilmSet set{area,         grid, {},   {}, std::clamp(raised_at(area, {0, 0}), area.low_y, area.high_y),
                wish.fov_deg, {},   sight};
    for (const FilmSubject& subject : subjects) {
        if (subject.door) set.doors.push_back({subject.center_m.x, subject.center_m.z});
        else set.subjects.push_back(subject);
    }
    Vec3f sum{};
    for (const FilmSubject& subject : set.subjects) sum += subject.center_m;
    if (!set.subjects.empty()) set.middle = sum / static_cast<float>(set.subjects.size());
    else {
        Vec2f mean{};
        for (const Vec2f p : grid.places()) mean = mean + p;
        mean = mean * (1.f / static_cast<float>(grid.places().size()));
        set.middle = {mean.x, set.eye(mean).y + 0.2f, mean.y};
    }
    return set;
}

// The keys of the wanted kind; a tour makes fewer stops until it fits in the seconds asked for.
std::vector<CameraKey> keys_for(const FilmSet& set, const FilmWish& wish) {
    const auto fits = [&](const std::vector<CameraKey>& keys) {
        return wish.seconds <= 0 || keys.back().time_s <= wish.seconds;
    };
    if (wish.kind == "orbit") return keys_of(orbit_steps(set), set);
    if (wish.kind == "walkthrough") return keys_of(walkthrough_steps(set), set);
    std::vector<CameraKey> keys;
    for (std::size_t stops = std::max<std::size_t>(1, set.subjects.size()); stops > 0; --stops) {
        keys = keys_of(tour_steps(set, stops), set);
        if (fits(keys)) break;
    }
    return keys;
}

}  // namespace

CameraPath plan_film(const WalkableArea& area, const std::vector<FilmSubject>& subjects, const FilmWish& wish,
                     const FilmSight& sight) {
    if (std::find(kPathKinds.begin(), kPathKinds.end(), wish.kind) == kPathKinds.end())
        throw UsageError("--path: expected tour, orbit or walkthrough, found {}", wish.kind);
    const FloorGrid grid(area, {0, 0});
    const FilmSet set = film_set(area, grid, subjects, wish, sight);
    CameraPath path{wish.fps, wish.fov_deg, wish.width, wish.height, keys_for(set, wish)};
    if (wish.seconds <= 0) return path;
    const float least = path.keys.back().time_s;
    if (least > wish.seconds)
        throw UsageError("--seconds: expected at least {:.1f} for this {}, found {}", std::ceil(least * 10) / 10,
                         wish.kind, wish.seconds);
    for (CameraKey& key : path.keys) key.time_s *= wish.seconds / least;
    return path;
}

}  // namespace fastscene
