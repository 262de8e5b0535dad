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

const Json& member(const Json& json, const char* name, const std::string& where) {
    const auto found = json.find(name);
    if (found == json.end()) throw Error("{}: walkable: expected {}, found none", where, name);
    return *found;
}

}  // namespace

Json walkable_json(const WalkableArea& area) {
    Json rings = Json::array();
    for (const auto& ring : area.rings_m) rings.push_back(ring_json(ring));
    const Json polygon = area.rings_m.empty() ? Json::array() : rings[largest_ring(area)];
    return {{"polygon_m", polygon},
            {"eye_heights_m", {rounded(area.floor_y - area.high_y), rounded(area.floor_y - area.low_y)}},
            {"floor_y_m", rounded(area.floor_y)},
            {"rings_m", rings}};
}

WalkableArea walkable_from_json(const Json& json, const std::string& where) {
    if (!json.is_object()) throw Error("{}: walkable: expected an object, found {}", where, json.dump());
    WalkableArea area;
    if (const auto rings = json.find("rings_m"); rings != json.end()) {
        if (!rings->is_array()) throw Error("{}: rings_m: expected a list of polygons, found {}", where, rings->dump());
        for (const Json& ring : *rings) area.rings_m.push_back(ring_from(ring, "rings_m", where));
    } else {
        area.rings_m.push_back(ring_from(member(json, "polygon_m", where), "polygon_m", where));
    }
    const Vec2f heights = pair(member(json, "eye_heights_m", where), "eye_heights_m", where);
    if (heights.x > heights.y)
        throw Error("{}: eye_heights_m: expected [low, high], found {}", where, json["eye_heights_m"].dump());
    area.floor_y = number(member(json, "floor_y_m", where), "floor_y_m", where);
    area.low_y = area.floor_y - heights.y;
    area.high_y = area.floor_y - heights.x;
    return area;
}

}  // namespace fastscene
