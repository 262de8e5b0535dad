#include "fastscene/panorama/more_panoramas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/geometry/resample.h"
#include "fastscene/scene/pose_json.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

constexpr float kFarthest_m = 1000;      // metres: positions beyond this indicate wrong units
constexpr float kRotationError = 1e-3f;  // tolerance for matrices written with few digits

// One entry of the list, with access by key.
class ListEntry {
  public:
    ListEntry(const fs::path& list, std::size_t index, const Json& json)
        : where_(fmt::format("{}: panorama {}", list.string(), index)), json_(json) {
        if (!json.is_object()) fail("an object with color and world_from_pano, or position", json.dump());
        static constexpr std::string_view kKnown[] = {"name",     "color",  "range", "world_from_pano",
                                                      "position", "yaw_deg"};
        for (const auto& [key, value] : json.items())
            if (std::find(std::begin(kKnown), std::end(kKnown), key) == std::end(kKnown))
                fail("color, range, world_from_pano, position or yaw_deg", key);
    }
    fs::path file(const char* key, const fs::path& folder) const {
        if (!json_.contains(key)) return {};
        if (!json_[key].is_string()) fail(fmt::format("the name of a file as {}", key), json_[key].dump());
        return folder / json_[key].get<std::string>();
    }
    Rigid pose() const {
        const bool matrix = json_.contains("world_from_pano"), place = json_.contains("position");
        if (matrix == place) fail("either world_from_pano or position", matrix ? "both" : "neither");
        if (matrix && json_.contains("yaw_deg")) fail("yaw_deg together with position", "it beside world_from_pano");
        return checked(matrix ? from_matrix() : from_place());
    }
    [[noreturn]] void fail(std::string_view expected, std::string_view found) const {
        throw Error("{}: expected {}, found {}", where_, expected, found);
    }

  private:
    std::vector<float> numbers(const Json& row, std::size_t count) const {
        if (!row.is_array() || row.size() != count) fail(fmt::format("{} numbers", count), row.dump());
        std::vector<float> out;
        for (const Json& x : row) {
            if (!x.is_number() || !std::isfinite(x.get<double>())) fail("a number", x.dump());
            out.push_back(x.get<float>());
        }
        return out;
    }
    Rigid from_matrix() const {
        const Json& rows = json_["world_from_pano"];
        if (!rows.is_array() || (rows.size() != 3 && rows.size() != 4))
            fail("world_from_pano with 3 or 4 rows of 4", rows.dump());
        for (std::size_t i = 0; i < 3; ++i) numbers(rows[i], 4);
        return pose_from_json(rows);
    }
    Rigid from_place() const {
        const auto p = numbers(json_["position"], 3);
        const float yaw = json_.contains("yaw_deg")
                              ? numbers(Json::array({json_["yaw_deg"]}), 1)[0] * std::numbers::pi_v<float> / 180
                              : 0;
        const float c = std::cos(yaw), s = std::sin(yaw);
        return {{{c, 0, s}, {0, 1, 0}, {-s, 0, c}},
                {p[0], p[1], p[2]}};  // its forward direction (z) is to the right (x) of the first panorama's
    }
    Rigid checked(const Rigid& pose) const {
        const Mat3f unit = pose.rotation * transpose(pose.rotation);
        const float off = std::max({length(unit.row0 - Vec3f{1, 0, 0}), length(unit.row1 - Vec3f{0, 1, 0}),
                                    length(unit.row2 - Vec3f{0, 0, 1})});
        const float turn = dot(cross(pose.rotation.row0, pose.rotation.row1), pose.rotation.row2);
        if (off > kRotationError || turn < 0)
            fail("a rotation in world_from_pano", turn < 0 ? "a mirror" : "other lengths or angles");
        if (!(length(pose.translation) < kFarthest_m))
            fail("a place within a kilometre, in metres", fmt::format("{} m", length(pose.translation)));
        return pose;
    }

    std::string where_;
    const Json& json_;
};

}  // namespace

std::vector<MorePanorama> read_more_panoramas(const fs::path& list) {
    const Json json = read_json(list);
    if (!json.is_object() || !json.contains("panoramas") || !json["panoramas"].is_array() || json["panoramas"].empty())
        throw Error("{}: expected {{\"panoramas\": [...]}} with one entry or more (docs/depth.md), found none",
                    list.string());
    std::vector<MorePanorama> out;
    for (const Json& one : json["panoramas"]) {
        const ListEntry entry(list, out.size() + 1, one);
        out.push_back({entry.file("color", list.parent_path()), entry.file("range", list.parent_path()), entry.pose()});
        if (out.back().color.empty()) entry.fail("color, the name of a picture", "none");
    }
    return out;
}

Panorama in_first_orientation(const Panorama& panorama, EquirectSize size) {
    const Mat3f& turn = panorama.world_from_pano.rotation;
    Panorama out;
    out.world_from_pano = {{}, panorama.world_from_pano.translation};
    const SpherePicture from = equirect_picture(panorama.size(), turn), to = equirect_picture(size);
    out.color = ResamplePlan(from, to, Filter::area).apply(panorama.color);
    if (panorama.range.empty()) return out;
    out.range = range_in_first_orientation(panorama.range, turn, size);
    return out;
}

ImageF range_in_first_orientation(const ImageF& range, const Mat3f& turn, EquirectSize size) {
    ImageF out(size.width, size.height);
    const EquirectSize source{range.width, range.height};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Vec2f at = pixel_of_direction(transpose(turn) * direction_of_pixel(x, y, size), source);
            out.at(x, y) = range.at(wrap_column(static_cast<int>(at.x), source.width),
                                    std::min(static_cast<int>(at.y), source.height - 1));
        }
    return out;
}

}  // namespace fastscene
