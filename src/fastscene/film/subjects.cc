#include "fastscene/film/subjects.h"

#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/scene/pose_json.h"

namespace fastscene {
namespace {

struct Candidate {
    FilmSubject subject;
    bool requested = false, flat = false;  // flat: in or on a wall
    double pixels = 0;
    // Things before walls, what was asked for before the rest.
    int rank() const { return (requested ? 0 : 2) + (flat ? 1 : 0); }
};

Candidate candidate_of(const Json& object) {
    const Rigid pose = pose_from_json(object.at("world_from_object"));
    const Json& size = object.at("size_m");
    const float wide = size.at(0), high = size.at(1), deep = size.at(2);
    Candidate out;
    out.subject.name = object.value("name", object.value("class", ""));
    out.subject.center_m = pose * Vec3f{0, high / 2, 0};
    const Vec3f front = pose.rotation.column(2);
    if (std::hypot(front.x, front.z) > 0.5f) out.subject.front = normalize(Vec3f{front.x, 0, front.z});
    out.subject.radius_m = 0.5f * std::hypot(std::max(wide, deep), high);
    out.subject.door = object.value("class", "") == "door";
    out.requested = object.value("requested", false);
    constexpr float kFlat_m = 0.25f;
    out.flat = std::min(wide, deep) < kFlat_m;
    out.pixels = object.value("visible_pixels", 0.0);
    return out;
}

// Furniture worth a look although the sentence does not name it: neither small nor part of the walls.
bool is_furniture(const Json& object) {
    const Json& size = object.at("size_m");
    const float foot = size.at(0).get<float>() * size.at(2).get<float>(), high = size.at(1);
    return foot > 0.25f && foot < 6 && high > 0.3f && high < 2.6f;
}

}  // namespace

std::vector<FilmSubject> film_subjects(const Json& room, std::size_t most, const std::string& where) {
    std::vector<Candidate> found;
    std::vector<FilmSubject> doors;
    try {
        for (const Json& object : room.value("objects", Json::array())) {
            const Candidate one = candidate_of(object);
            if (one.subject.door) doors.push_back(one.subject);
            else if (one.pixels > 0 && (one.requested || is_furniture(object))) found.push_back(one);
        }
    } catch (const Json::exception& e) {
        throw Error("{}: expected objects with world_from_object and size_m: {}", where, e.what());
    }
    std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
        return a.rank() != b.rank() ? a.rank() < b.rank() : a.pixels > b.pixels;
    });
    std::vector<FilmSubject> out;
    for (const Candidate& one : found)
        if (out.size() < most) out.push_back(one.subject);
    out.insert(out.end(), doors.begin(), doors.end());
    return out;
}

}  // namespace fastscene
