#include "fastscene/export/labels.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "fastscene/base/shortest.h"
#include "fastscene/export/gltf.h"
#include "fastscene/export/identities.h"
#include "fastscene/export/instances.h"
#include "fastscene/export/object_boxes.h"
#include "fastscene/export/shell.h"
#include "fastscene/rooms/catalogue.h"
#include "fastscene/scene/raised_floor.h"
#include "fastscene/trace/standable.h"

namespace fastscene {
namespace {

// A thing stands on what is at most this far below it.
constexpr float kContact_m = 0.04f;
// … at its middle, or at its feet: this far out towards the corners of its base.
constexpr float kFeet = 0.9f;

// Where a vertical line downwards from p crosses the triangle: metres below p.
std::optional<float> below(Vec3f p, Vec3f a, Vec3f b, Vec3f c) {
    const auto cross2 = [](Vec3f o, Vec3f u, Vec3f v) { return (u.x - o.x) * (v.z - o.z) - (u.z - o.z) * (v.x - o.x); };
    const float all = cross2(a, b, c);
    if (!(std::fabs(all) > 1e-12f)) return std::nullopt;
    const float wa = cross2(p, b, c) / all, wb = cross2(p, c, a) / all, wc = 1 - wa - wb;
    if (wa < 0 || wb < 0 || wc < 0) return std::nullopt;
    return wa * a.y + wb * b.y + wc * c.y - p.y;  // y points down
}

std::string what_is_below(const Room& room, const std::vector<std::string>& ids, std::size_t object, Vec3f foot) {
    const Vec3f from = foot - Vec3f{0, kContact_m, 0};
    float nearest = 2 * kContact_m;
    std::string found;
    for (const Mesh& mesh : room.meshes) {
        if (mesh.object == static_cast<int>(object)) continue;
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
            const auto distance = below(from, mesh.positions[mesh.triangles[t]], mesh.positions[mesh.triangles[t + 1]],
                                        mesh.positions[mesh.triangles[t + 2]]);
            if (!distance || *distance < 0 || *distance > nearest) continue;
            nearest = *distance;
            found = mesh.object >= 0 ? ids[at(mesh.object)]
                                     : kShellNames[static_cast<std::size_t>(shell_of(room, mesh))];
        }
    }
    return found;
}

// The id of what it stands on; "" for what hangs.
std::string stands_on(const Room& room, const std::vector<std::string>& ids, std::size_t i, const ObjectBox& box) {
    const Vec3f half = box.size() * (0.5f * kFeet), middle = box.center();
    for (const Vec2f foot : {Vec2f{0, 0}, Vec2f{1, 1}, Vec2f{1, -1}, Vec2f{-1, 1}, Vec2f{-1, -1}}) {
        const Vec3f base{middle.x + foot.x * half.x, box.low.y, middle.z + foot.y * half.z};
        std::string found = what_is_below(room, ids, i, room.objects[i].world_from_object * base);
        if (!found.empty()) return found;
    }
    return "";
}

}  // namespace

Json labels_json(const TracedRoom& traced) {
    const Room& room = traced.room();
    const std::vector<std::string> ids = object_ids(room);
    const std::vector<ObjectBox> boxes = object_boxes(room);
    Json objects = Json::array();
    for (std::size_t i = 0; i < room.objects.size(); ++i) {
        const RoomObject& object = room.objects[i];
        const int label = nyu40_label(object.kind);
        Json entry{{"instance", i + 1},    {"id", ids[i]},   {"class", object.kind},
                   {"label", object.name}, {"nyu40", label}, {"nyu40_name", nyu40_labels()[at(label)]}};
        if (!boxes[i].empty) {
            const Rigid pose = Rigid{kGltfAxes, {}} * object.world_from_object;
            Json placed;
            set_pose(placed, pose);
            entry["box"] = {{"center_m", json_list(pose * boxes[i].center())},
                            {"size_m", json_list(boxes[i].size())},
                            {"rotation", placed.value("rotation", Json{0.f, 0.f, 0.f, 1.f})}};
            entry["area_m2"] = shortest(boxes[i].area_m2);
            std::set<std::string> names;
            for (const Mesh& mesh : room.meshes)
                if (mesh.object == static_cast<int>(i)) names.insert(room.materials[at(mesh.material)].name);
            entry["materials"] = names;
            const bool built_in = has_role(object.kind, Role::shell) || has_role(object.kind, Role::opening);
            const std::string support = built_in ? kShellNames[static_cast<std::size_t>(Shell::walls)]
                                                 : stands_on(room, ids, i, boxes[i]);
            entry["stands_on"] = support.empty() ? Json(nullptr) : Json(support);
        }
        objects.push_back(std::move(entry));
    }
    return {{"room", room.type},
            {"style", room.style},
            {"axes", "x left, y up, z forward; rotation x y z w"},
            {"objects", std::move(objects)},
            {"instances", instances_json(instances_of(room))}};
}

namespace {

Json polygons_of(const StandableFloor& floor) {
    Json polygons = Json::array();
    for (const std::vector<Vec2f>& ring : outlines(floor)) {
        Json points = Json::array();
        for (const Vec2f p : ring) points.push_back({shortest(-p.x), shortest(p.y)});
        polygons.push_back(std::move(points));
    }
    return polygons;
}

// Not before or on a step: who is set down there would stand with one foot on it.
bool stands_even(const StandableFloor& floor, FloorCell cell) {
    constexpr int kAround = 3;  // cells
    if (floor.level_y.empty()) return true;
    const float level = floor.level_at(cell.column, cell.row);
    for (int row = std::max(0, cell.row - kAround); row <= std::min(floor.rows - 1, cell.row + kAround); ++row)
        for (int column = std::max(0, cell.column - kAround);
             column <= std::min(floor.columns - 1, cell.column + kAround); ++column)
            if (floor.level_at(column, row) != level) return false;
    return true;
}

}  // namespace

Json walkable_floor_json(const TracedRoom& traced) {
    const Room& room = traced.room();
    const StandableFloor floor = passable_floor(traced), standing = standable_floor(traced);
    Json spawns = Json::array(), doors = Json::array();
    // The place nearest to the panorama's camera, then always the one farthest from all others.
    constexpr std::size_t kMostSpawns = 12;
    constexpr float kApart_m = 0.8f;
    std::vector<Vec2f> chosen, free;
    for (const FloorCell cell : standable_cells(standing))
        if (stands_even(standing, cell)) free.push_back(standing.center(cell.column, cell.row));
    while (chosen.size() < kMostSpawns && !free.empty()) {
        const auto clearance = [&](Vec2f p) {
            float nearest = chosen.empty() ? -length(p) : 1e9f;
            for (const Vec2f q : chosen) nearest = std::min(nearest, length(p - q));
            return nearest;
        };
        const Vec2f best = *std::max_element(free.begin(), free.end(),
                                             [&](Vec2f a, Vec2f b) { return clearance(a) < clearance(b); });
        if (!chosen.empty() && clearance(best) < kApart_m) break;
        chosen.push_back(best);
        spawns.push_back(json_list({-best.x, -floor_at(room, best), best.y}));
    }
    const std::vector<std::string> ids = object_ids(room);
    const std::vector<ObjectBox> boxes = object_boxes(room);
    for (std::size_t i = 0; i < room.objects.size(); ++i) {
        const RoomObject& object = room.objects[i];
        if (object.kind.find("door") == std::string::npos || boxes[i].empty) continue;
        doors.push_back({{"id", ids[i]},
                         {"center_m", json_list(kGltfAxes * (object.world_from_object * boxes[i].center()))},
                         {"facing", json_list(kGltfAxes * object.world_from_object.rotation.column(2))},
                         {"width_m", shortest(boxes[i].size().x)},
                         {"height_m", shortest(boxes[i].size().y)}});
    }
    Json out{{"axes", "x left, y up, z forward; polygons are [x, z], even-odd rule"},
             {"floor_y_m", shortest(-standing.floor_y)},
             {"area_m2", standable_area_m2(floor)},
             {"polygons_m", polygons_of(floor)},
             {"spawn_points_m", std::move(spawns)},
             {"doors", std::move(doors)}};
    if (!floor.level_y.empty())
        for (const float y : levels_of(floor))
            out["levels"].push_back({{"floor_y_m", shortest(-y)}, {"polygons_m", polygons_of(at_level(floor, y))}});
    return out;
}

}  // namespace fastscene
