#include "fastscene/io/camera_path_io.h"

#include <algorithm>
#include <cmath>

#include <fmt/ranges.h>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/base/shortest.h"
#include "fastscene/base/suggest.h"
#include "fastscene/io/camera_path_parts.h"

namespace fastscene {
namespace {

// One JSON object of the file, with checked keys: a typo is an error.
class PathPart {
  public:
    PathPart(std::string where, const Json& json, const std::vector<std::string>& known)
        : where_(std::move(where)), json_(json) {
        if (!json.is_object()) fail(fmt::format("an object with {}", fmt::join(known, ", ")), text(json));
        for (const auto& [key, value] : json.items()) {
            if (std::find(known.begin(), known.end(), key) != known.end()) continue;
            const std::string guess = nearest_word(key, known);
            fail(fmt::format("{}", fmt::join(known, ", ")),
                 key + (guess.empty() ? "" : "; did you mean " + guess + "?"));
        }
    }
    float number(const char* key, float otherwise) const {
        return json_.contains(key) ? number_in(key, json_.at(key)) : otherwise;
    }
    std::vector<float> numbers(const char* key, std::size_t count) const {
        if (!json_.contains(key)) fail(fmt::format("{} with {} numbers", key, count), "none");
        const Json& list = json_.at(key);
        if (!list.is_array() || list.size() != count) fail(fmt::format("{} numbers as {}", count, key), text(list));
        std::vector<float> out;
        for (const Json& v : list) out.push_back(number_in(key, v));
        return out;
    }
    [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
        throw Error("{}: expected {}, found {}", where_, expected, found);
    }
    static std::string text(const Json& json) {
        return json.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 60);
    }

  private:
    float number_in(const char* key, const Json& v) const {
        constexpr double kMost = 1e6;
        if (!v.is_number() || !(std::abs(v.get<double>()) < kMost))
            fail(fmt::format("a number below a million as {}", key), text(v));
        return v.get<float>();
    }
    std::string where_;
    const Json& json_;
};

CameraKey key_from_json(const std::string& where, const Json& json) {
    const PathPart part(where, json, {"time_s", "position_m", "yaw_deg", "pitch_deg", "roll_deg", "fov_deg"});
    const std::vector<float> p = part.numbers("position_m", 3);
    return {part.number("time_s", 0),    {p[0], p[1], p[2]},         part.number("yaw_deg", 0),
            part.number("pitch_deg", 0), part.number("roll_deg", 0), part.number("fov_deg", 0)};
}

CameraPath path_from_own(const Json& json, CameraPath camera, const std::string& where) {
    const PathPart file(where, json, {"fps", "fov_deg", "size", "keys"});
    camera.fps = file.number("fps", camera.fps);
    camera.fov_deg = file.number("fov_deg", camera.fov_deg);
    if (json.contains("size")) {
        const std::vector<float> size = file.numbers("size", 2);
        camera.width = static_cast<int>(size[0]), camera.height = static_cast<int>(size[1]);
    }
    if (!json.contains("keys") || !json["keys"].is_array())
        file.fail("a list of keys with time_s, position_m, yaw_deg, pitch_deg",
                  json.contains("keys") ? PathPart::text(json["keys"]) : "none");
    camera.keys.clear();
    for (const Json& key : json["keys"])
        camera.keys.push_back(key_from_json(fmt::format("{}: key {}", where, camera.keys.size() + 1), key));
    return camera;
}

void check_path(const CameraPath& camera, const std::string& where) {
    if (camera.keys.empty()) throw Error("{}: expected at least one key, found none", where);
    for (std::size_t i = 1; i < camera.keys.size(); ++i)
        if (!(camera.keys[i].time_s > camera.keys[i - 1].time_s))
            throw Error("{}: expected times that grow, found {} after {}", where, camera.keys[i].time_s,
                        camera.keys[i - 1].time_s);
    if (!(camera.fps > 0.f && camera.fps <= 1000.f))
        throw Error("{}: expected fps above 0 and at most 1000, found {}", where, camera.fps);
    if (!(camera.fov_deg >= 1.f && camera.fov_deg <= 170.f))
        throw Error("{}: expected fov_deg from 1 to 170, found {}", where, camera.fov_deg);
    for (const CameraKey& key : camera.keys)
        if (key.fov_deg != 0 && !(key.fov_deg >= 1.f && key.fov_deg <= 170.f))
            throw Error("{}: expected fov_deg from 1 to 170, found {} at {} s", where, key.fov_deg, key.time_s);
    if (camera.width < 1 || camera.height < 1 || camera.width > 16384 || camera.height > 16384)
        throw Error("{}: expected a size from 1 to 16384, found {} x {}", where, camera.width, camera.height);
    constexpr double kMostFrames = 1e6;
    const double seconds = static_cast<double>(camera.keys.back().time_s) -
                           static_cast<double>(camera.keys.front().time_s);
    if (!(seconds * static_cast<double>(camera.fps) < kMostFrames))
        throw Error("{}: expected less than {} frames, found {} s of {} a second", where, kMostFrames, seconds,
                    camera.fps);
}

CameraPath path_from_json(const Json& json, const CameraPath& otherwise, const std::string& where) {
    const auto has = [&](const char* key) { return json.is_object() && json.contains(key); };
    try {
        if (has("camera_path") || has("keyframes")) return path_from_nerfstudio(json, otherwise, where);
        if (has("animTracks") || has("poseSets")) return path_from_supersplat(json, otherwise, where);
    } catch (const Json::exception& e) {
        throw Error("{}: {}", where, e.what());
    }
    return path_from_own(json, otherwise, where);
}

CameraPath checked(CameraPath camera, const std::string& where) {
    check_path(camera, where);
    unwrap_angles(camera.keys);
    return camera;
}

}  // namespace

Json camera_path_json(const CameraPath& camera) {
    Json keys = Json::array();
    for (const CameraKey& key : camera.keys) {
        const Vec3f p = key.position_m;
        Json json{{"time_s", shortest(key.time_s)},
                  {"position_m", {shortest(p.x), shortest(p.y), shortest(p.z)}},
                  {"yaw_deg", shortest(key.yaw_deg)},
                  {"pitch_deg", shortest(key.pitch_deg)}};
        if (key.roll_deg != 0) json["roll_deg"] = shortest(key.roll_deg);
        if (key.fov_deg != 0) json["fov_deg"] = shortest(key.fov_deg);
        keys.push_back(std::move(json));
    }
    return {{"fps", shortest(camera.fps)},
            {"fov_deg", shortest(camera.fov_deg)},
            {"size", {camera.width, camera.height}},
            {"keys", std::move(keys)}};
}

Mat3f rotation_from(Vec3d row0, Vec3d row1, Vec3d row2, const std::string& where) {
    const Mat3d m{row0, row1, row2};
    const Vec3d x = m.column(0), y = m.column(1), z = m.column(2);
    const double size = length(x);
    constexpr double kSlack = 0.02;  // written by hand or with few decimals
    const bool turn = size > 1e-9 && std::fabs(dot(x, y)) < kSlack * size * size &&
                      length(cross(x, y) * (1 / size) - z) < kSlack * size;
    if (!turn) throw Error("{}: expected a rotation, found another matrix", where);
    const Mat3d r = matrix_of(quaternion_of(Mat3d::from_columns(x * (1 / size), y * (1 / size), z * (1 / size))));
    const auto row = [](Vec3d v) {
        return Vec3f{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    };
    return {row(r.row0), row(r.row1), row(r.row2)};
}

PathFormat path_format_of(const std::filesystem::path& path) {
    return path.extension() == ".chan" ? PathFormat::blender : PathFormat::fastscene;
}

CameraPath load_camera_path(const std::filesystem::path& path, const CameraPath& otherwise) {
    const std::string where = path.string();
    return checked(path_format_of(path) == PathFormat::blender ? path_from_chan(read_file(path), otherwise, where)
                                                               : path_from_json(read_json(path), otherwise, where),
                   where);
}

CameraPath read_camera_path(const std::string& text, const CameraPath& otherwise, const std::string& where) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) throw Error("{}: expected a camera path, found an empty file", where);
    if (text[begin] != '{') return checked(path_from_chan(text, otherwise, where), where);
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) throw Error("{}: expected JSON, found a damaged file", where);
    return checked(path_from_json(json, otherwise, where), where);
}

void save_camera_path(const std::filesystem::path& path, const CameraPath& camera, PathFormat format) {
    switch (format) {
        case PathFormat::fastscene: return write_json(path, camera_path_json(camera));
        case PathFormat::nerfstudio: return write_json(path, nerfstudio_from_path(camera));
        case PathFormat::blender: return write_file(path, chan_from_path(camera));
        case PathFormat::supersplat: return write_json(path, supersplat_from_path(camera));
    }
}

}  // namespace fastscene
