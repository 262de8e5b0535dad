#include "fastscene/pipeline/film_of_run.h"

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/film/subjects.h"
#include "fastscene/pipeline/request.h"
#include "fastscene/pipeline/room_of_run.h"

namespace fastscene {
namespace {

// A film shows a handful of things; more would be hurried past.
constexpr std::size_t kMostSubjects = 5;

// Rays into the run's room, if it has a known one that this program still makes.
FilmSight sight_in(const RunFolder& folder, const Run& run) {
    try {
        const auto room = unlit_room_of_run(folder, recorded_run(folder), {run.seed, nullptr, run.stop});
        return [room](Vec3f from, Vec3f direction) { return room->distance(from, direction); };
    } catch (const Error&) {
        return {};  // a scene from a picture: nothing is known of what hides what
    }
}

}  // namespace

CameraPath film_of_run(const RunFolder& folder, const WalkableArea& area, const FilmWish& wish, const Run& run) {
    std::vector<FilmSubject> subjects;
    if (std::filesystem::exists(folder.room_json()))
        subjects = film_subjects(read_json(folder.room_json()), kMostSubjects, folder.room_json().string());
    return plan_film(area, subjects, wish, sight_in(folder, run));
}

}  // namespace fastscene
