#include "fastscene/scene/walkable_json.h"

#include <cmath>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

// Rounds to a tenth of a millimetre: finer than any grid, and short in the file.
double rounded(double metres) { return std::round(metres * 1e4) / 1e4; }

Json ring_json(const std::vector<Vec2f>& ring) {
    Json out = Json::array();
    for (const Vec2f p : ring) out.push_back({rounded(p.x), rounded(p.y)});
    return out;
}
Json rings_json(const std::vector<std::vector<Vec2f>>& rings) {
    Json out = Json::array();
    for (const auto& ring : rings) out.push_back(ring_json(ring));
    return out;
}

float number(const Json& json, const char* what, const std::string& where) {
    if (!json.is_number()) throw Error("{}: {}: expected a number, found {}", where, what, json.dump());
    return json.get<float>();
}

Vec2f pair(const Json& json, const char* what, const std::string& where) {
    if (!json.is_array() || json.size() != 2)
        throw Error("{}: {}: expected two numbers, found {}", where, what, json.dump());
    return {number(json[0], what, where), number(json[1], what, where)};
}

std::vector<Vec2f> ring_from(const Json& json, const char* what, const std::string& where) {
    if (!json.is_array() || json.size() < 3)
        throw Error("{}: {}: expected at least 3 points, found {}", where, what, json.dump());
    std::vector<Vec2f> ring;
    for (const Json& point : json) ring.push_back(pair(point, what, where));
    return ring;
}

std::vector<std::vector<Vec2f>> rings_from(const Json& json, const std::string& where) {
    if (!json.is_array()) throw Error("{}: rings_m: expected a list of polygons, found {}", where, json.dump());
    std::vector<std::vector<Vec2f>> rings;
    for (const Json& ring : json) rings.push_back(ring_from(ring, "rings_m", where));
    return rings;
}

const Json& member(const Json& json, const char* name, const std::string& where) {
    const auto found = json.find(name);
    if (found == json.end()) throw Error("{}: walkable: expected {}, found none", where, name);
    return *found;
}

}  // namespace

Json walkable_json(const WalkableArea& area) {
    const Json rings = rings_json(area.rings_m);
    const Json polygon = area.rings_m.empty() ? Json::array() : rings[largest_ring(area)];
    Json out{{"polygon_m", polygon},
             {"eye_heights_m", {rounded(area.floor_y - area.high_y), rounded(area.floor_y - area.low_y)}},
             {"floor_y_m", rounded(area.floor_y)},
             {"rings_m", rings}};
    for (const WalkableArea::Level& level : area.levels)
        out["levels"].push_back({{"floor_y_m", rounded(level.floor_y)}, {"rings_m", rings_json(level.rings_m)}});
    return out;
}

WalkableArea walkable_from_json(const Json& json, const std::string& where) {
    if (!json.is_object()) throw Error("{}: walkable: expected an object, found {}", where, json.dump());
    WalkableArea area;
    if (const auto rings = json.find("rings_m"); rings != json.end()) {
        area.rings_m = rings_from(*rings, where);
    } else {
        area.rings_m.push_back(ring_from(member(json, "polygon_m", where), "polygon_m", where));
    }
    const Vec2f heights = pair(member(json, "eye_heights_m", where), "eye_heights_m", where);
    if (heights.x > heights.y)
        throw Error("{}: eye_heights_m: expected [low, high], found {}", where, json["eye_heights_m"].dump());
    area.floor_y = number(member(json, "floor_y_m", where), "floor_y_m", where);
    area.low_y = area.floor_y - heights.y;
    area.high_y = area.floor_y - heights.x;
    if (const auto levels = json.find("levels"); levels != json.end()) {
        if (!levels->is_array()) throw Error("{}: levels: expected a list, found {}", where, levels->dump());
        for (const Json& level : *levels) {
            if (!level.is_object()) throw Error("{}: levels: expected an object, found {}", where, level.dump());
            area.levels.push_back({rings_from(member(level, "rings_m", where), where),
                                   number(member(level, "floor_y_m", where), "floor_y_m", where)});
        }
    }
    return area;
}

}  // namespace fastscene
