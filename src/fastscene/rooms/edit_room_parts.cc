// Parts of a room as the camera sees them: "the far corner", "the left window", "the brick wall".
#include <algorithm>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/is_one_of.h"
#include "fastscene/rooms/edit_parts.h"
#include "fastscene/rooms/layout_relations.h"

namespace fastscene::editing {

std::optional<Vec3f> direction_said(const Editor& editor, const Part& part) {
    const Vec3f ahead = editor.room().furnished.looks, right = cross(ahead, Vec3f{0, 1, 0});
    Vec3f out{};
    if (part.says({"left"})) out += right * -1.f;
    if (part.says({"right"})) out += right;
    if (part.says({"far", "back"})) out += ahead;
    if (part.says({"near", "front"})) out += ahead * -1.f;
    return out == Vec3f{} ? std::nullopt : std::optional(out);
}

int wall_towards(const Plan& plan, Vec3f direction) {
    int best = 0;
    for (int w = 1; w < 4; ++w)
        if (dot(plan.wall(w).inward, direction) < dot(plan.wall(best).inward, direction)) best = w;
    return best;
}

std::vector<Vec2f> corners_of_room(const Plan& plan) {
    return {{plan.width / 2, plan.depth / 2},
            {-plan.width / 2, plan.depth / 2},
            {plan.width / 2, -plan.depth / 2},
            {-plan.width / 2, -plan.depth / 2}};
}

bool has_opening(const Plan& plan, const std::string& kind) {
    return std::any_of(plan.openings.begin(), plan.openings.end(),
                       [&](const Opening& o) { return is_opening_of(o, kind); });
}

std::string opening_there(const Plan& plan, const std::string& kind) {
    if (has_opening(plan, kind)) return kind;
    if (kind == "door" && has_opening(plan, "doorway")) return "doorway";
    throw UsageError("there is no {} in the room", kind);
}

std::optional<Vec2f> which_opening(const Editor& editor, const Part& part, const std::string& kind) {
    const auto direction = direction_said(editor, part);
    std::vector<Vec2f> points;
    for (const Opening& o : editor.plan().openings) {
        constexpr float kBefore = 0.4f;  // metres
        const WallFace face = editor.plan().wall(o.wall);
        if (is_opening_of(o, kind)) points.push_back(flat(face.point((o.u0 + o.u1) / 2, 0) + face.inward * kBefore));
    }
    if (!direction || points.size() < 2) return {};
    return *std::max_element(points.begin(), points.end(),
                             [&](Vec2f a, Vec2f b) { return dot(a, flat(*direction)) < dot(b, flat(*direction)); });
}

std::optional<Vec2f> before_opening(const Editor& editor, const std::string& kind, const std::string& mover) {
    const Placed& p = editor.placed(mover);
    if (p.piece.mount != Mount::floor || p.piece.against_wall || p.flat || p.on >= 0) return {};
    constexpr float kOffWall_m = 0.15f;
    std::optional<Vec2f> out;
    const Vec2f here = footprint_of(p).center;
    for (const Opening& o : editor.plan().openings) {
        if (!is_opening_of(o, kind)) continue;
        const WallFace face = editor.plan().wall(o.wall);
        const float deep = extent(footprint_of(p), flat(face.inward));
        const Vec2f before = flat(face.point((o.u0 + o.u1) / 2, 0) + face.inward * (deep + kOffWall_m));
        if (!out || length(before - here) < length(*out - here)) out = before;
    }
    return out;
}

std::optional<Vec2f> beyond_opening(const Editor& editor, const std::string& kind, const std::string& mover) {
    const Vec2f here = footprint_of(editor.placed(mover)).center;
    std::optional<Vec2f> out;
    float least = 1e9f;
    for (const Opening& o : editor.plan().openings) {
        if (!is_opening_of(o, kind)) continue;
        const WallFace face = editor.plan().wall(o.wall);
        const Vec2f along = flat(face.along), middle = flat(face.point((o.u0 + o.u1) / 2, 0));
        if (length(middle - here) >= least) continue;
        least = length(middle - here);
        out = here + along * (2 * dot(middle - here, along));
    }
    return out;
}

Vec2f freer_corner(const Editor& editor, Vec2f way, const std::string& mover) {
    std::vector<Vec2f> corners = corners_of_room(editor.plan());
    std::stable_sort(corners.begin(), corners.end(), [&](Vec2f a, Vec2f b) { return dot(a, way) > dot(b, way); });
    const auto free = [&](Vec2f corner) {
        constexpr float kInwards = 0.5f;  // metres into the room
        const Vec2f at = corner - Vec2f{std::copysign(kInwards, corner.x), std::copysign(kInwards, corner.y)};
        float least = 1e9f;
        for (const Placed& p : editor.room().furnished.placed)
            if (p.piece.mount == Mount::floor && !p.flat && p.id != mover)
                least = std::min(least, distance_to(footprint_of(p), at));
        for (const Opening& o : editor.plan().openings)
            if (o.kind != Opening::Kind::window)
                least = std::min(least, length(flat(editor.plan().wall(o.wall).point((o.u0 + o.u1) / 2, 0)) - at));
        return least;
    };
    return free(corners[0]) >= free(corners[1]) ? corners[0] : corners[1];
}

Vec2f freer_of_two_corners(const Editor& editor, Vec2f near, const std::string& mover) {
    constexpr float kAlike = 0.8f;  // metres
    std::vector<Vec2f> corners = corners_of_room(editor.plan());
    std::sort(corners.begin(), corners.end(), [&](Vec2f a, Vec2f b) { return length(a - near) < length(b - near); });
    if (corners.size() < 2 || length(corners[1] - near) - length(corners[0] - near) > kAlike) return near;
    return freer_corner(editor, corners[0] + corners[1], mover);
}

std::optional<int> wall_that_looks(const Plan& plan, const Part& part) {
    for (const std::string& word : part.modifiers) {
        const auto look = is_definite(word) ? std::nullopt : looks_of(word);
        if (!look || is_one_of(word, {"a", "an"})) continue;
        std::vector<int> walls;
        for (int w = 0; w < 4; ++w)
            if (plan.wall_material(w).name.find(word) != std::string::npos) walls.push_back(w);
        if (walls.empty()) throw UsageError("there is no {} wall in the room", word);
        if (walls.size() == 1) return walls.front();
    }
    return {};
}

}  // namespace fastscene::editing
