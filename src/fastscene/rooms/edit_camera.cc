// The camera is no furniture: where an edit needs its place, or the way to it, it stands elsewhere.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/validate.h"

namespace fastscene::editing {
namespace {

constexpr float kEyeAir_m = 0.6f;   // about the eyes: closer by, one thing fills the picture
constexpr float kFeetAir_m = 0.2f;  // about the feet: nobody stands in a bed

// How much room there is about the eyes; 0: something stands where the feet are.
float air_about(const FurnishedRoom& room, Vec3f eye) {
    float air = std::min(room.plan.air_around(eye), room.plan.wall_distance(flat(eye)));
    for (const Placed& p : room.placed) {
        if (p.flat) continue;
        const Footprint whole = footprint_of(p);
        if (whole.y0 < eye.y && distance_to(whole, flat(eye)) < kFeetAir_m) return 0;
        if (whole.y0 > eye.y + kEyeAir_m) continue;
        if (const auto high = part_above(p, eye.y - kEyeAir_m)) air = std::min(air, distance_to(*high, flat(eye)));
    }
    return air;
}

}  // namespace

// The nearest place with air about it to which a way leads from the door.
std::optional<Vec3f> Editor::free_viewpoint(const FurnishedRoom& room) const {
    constexpr float kStep_m = 0.1f;
    constexpr float kAirWorth = 0.5f, kEnoughAir_m = 1.f;  // metres of way for a metre of air, up to this much
    const Vec2f from = flat(result_.document.camera ? result_.document.camera->position : room.camera);
    Ways ways(room.plan);
    for (const Placed& p : room.placed) ways.add(p);
    std::optional<Vec3f> best;
    float least = 1e9f;
    const float wide = room.plan.width / 2, deep = room.plan.depth / 2;
    for (float x = -wide; x <= wide; x += kStep_m)
        for (float z = -deep; z <= deep; z += kStep_m) {
            const float far = length(Vec2f{x, z} - from);
            if (far - kAirWorth * kEnoughAir_m >= least) continue;
            const Vec3f eye{x, room.plan.floor_at({x, z}) + kEyeHeight, z};
            const float air = air_about(room, eye);
            const float cost = far - kAirWorth * std::min(air, kEnoughAir_m);
            if (air < kEyeAir_m || cost >= least || !ways.reaches({x, z})) continue;
            least = cost, best = eye;
        }
    return best;
}

// Whether it stands in a thing's outline, too near to one, or where no way leads.
bool Editor::camera_blocked() const {
    const FurnishedRoom& room = room_.furnished;
    const bool inside = std::any_of(room.placed.begin(), room.placed.end(), [&](const Placed& p) {
        const Footprint box = footprint_of(p);
        return !p.flat && box.y0 < room.camera.y && distance_to(box, flat(room.camera)) == 0.f;
    });
    if (inside) return true;
    for (const Fault& f : room_faults(plan(), room.placed, room.camera))
        if (is_of_camera(f.text)) return true;
    return false;
}

// Where a step leaves it in the way, it stands as near as may be; wherever it went, that is told.
void Editor::settle_camera(Vec3f was, bool blocked_before) {
    constexpr float kSame_m = 0.01f;
    if (!result_.document.camera) return;
    if (!blocked_before && camera_blocked())
        if (const auto eye = free_viewpoint(room_.furnished)) {
            result_.document.camera->position = *eye;
            build();
        }
    const Vec3f now = result_.document.camera->position;
    if (length(now - was) > kSame_m) note("room", fmt::format("the camera moved to x {:.2f}, z {:.2f}", now.x, now.z));
}

}  // namespace fastscene::editing
