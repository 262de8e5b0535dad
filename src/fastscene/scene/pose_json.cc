#include "fastscene/scene/pose_json.h"

#include "fastscene/base/shortest.h"

namespace fastscene {

Json json_from_pose(const Rigid& pose, Decimals decimals) {
    const auto number = [&](float x) { return decimals == Decimals::shortest ? shortest(x) : static_cast<double>(x); };
    const Mat3f& r = pose.rotation;
    const Vec3f t = pose.translation;
    Json rows = Json::array();
    for (const auto& [row, offset] : {std::pair{r.row0, t.x}, {r.row1, t.y}, {r.row2, t.z}})
        rows.push_back({number(row.x), number(row.y), number(row.z), number(offset)});
    rows.push_back({0, 0, 0, 1});
    return rows;
}

Rigid pose_from_json(const Json& rows) {
    const auto row = [&](std::size_t i) { return Vec3f{rows.at(i).at(0), rows.at(i).at(1), rows.at(i).at(2)}; };
    return {{row(0), row(1), row(2)}, {rows.at(0).at(3), rows.at(1).at(3), rows.at(2).at(3)}};
}

}  // namespace fastscene
