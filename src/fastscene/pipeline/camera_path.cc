#include "fastscene/pipeline/camera_path.h"

#include <algorithm>
#include <cmath>

#include <fmt/ranges.h>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/base/suggest.h"

namespace fastscene {
namespace {

// Unwraps angles, so that neighbouring keys differ by at most 180 degrees.
float nearest_turn(float angle_deg, float reference_deg) {
    return angle_deg - 360.f * std::round((angle_deg - reference_deg) / 360.f);
}

template <class T>
T catmull_rom(T a, T b, T c, T d, float t) {
    return (b * 2.f + (c - a) * t + (a * 2.f - b * 5.f + c * 4.f - d) * (t * t) +
            (b * 3.f - a - c * 3.f + d) * (t * t * t)) *
           0.5f;
}

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
    const PathPart part(where, json, {"time_s", "position_m", "yaw_deg", "pitch_deg"});
    const std::vector<float> p = part.numbers("position_m", 3);
    return {part.number("time_s", 0), {p[0], p[1], p[2]}, part.number("yaw_deg", 0), part.number("pitch_deg", 0)};
}

}  // namespace

int CameraPath::frames() const { return 1 + static_cast<int>((keys.back().time_s - keys.front().time_s) * fps + 0.5f); }

CameraKey CameraPath::at(float time_s) const {
    if (!(time_s > keys.front().time_s)) return keys.front();
    if (!(time_s < keys.back().time_s)) return keys.back();
    const auto next = std::upper_bound(keys.begin(), keys.end(), time_s,
                                       [](float t, const CameraKey& key) { return t < key.time_s; });
    const auto i = static_cast<std::size_t>(next - keys.begin());
    const CameraKey &b = keys[i - 1], &c = keys[i];
    const CameraKey &a = keys[i >= 2 ? i - 2 : i - 1], &d = keys[std::min(i + 1, keys.size() - 1)];
    const float t = (time_s - b.time_s) / (c.time_s - b.time_s);
    const float smooth = t * t * (3.f - 2.f * t);
    return {time_s, catmull_rom(a.position_m, b.position_m, c.position_m, d.position_m, t),
            b.yaw_deg + (nearest_turn(c.yaw_deg, b.yaw_deg) - b.yaw_deg) * smooth,
            b.pitch_deg + (c.pitch_deg - b.pitch_deg) * smooth};
}

CameraPath load_camera_path(const std::filesystem::path& path) {
    const Json json = read_json(path);
    CameraPath camera;
    const PathPart file(path.string(), json, {"fps", "fov_deg", "size", "keys"});
    camera.fps = file.number("fps", camera.fps);
    camera.fov_deg = file.number("fov_deg", camera.fov_deg);
    if (json.contains("size")) {
        const std::vector<float> size = file.numbers("size", 2);
        camera.width = static_cast<int>(size[0]), camera.height = static_cast<int>(size[1]);
    }
    if (!json.contains("keys") || !json["keys"].is_array())
        file.fail("a list of keys with time_s, position_m, yaw_deg, pitch_deg",
                  json.contains("keys") ? PathPart::text(json["keys"]) : "none");
    for (const Json& key : json["keys"])
        camera.keys.push_back(key_from_json(fmt::format("{}: key {}", path.string(), camera.keys.size() + 1), key));
    if (camera.keys.empty()) throw Error("{}: expected at least one key, found none", path.string());
    for (std::size_t i = 1; i < camera.keys.size(); ++i)
        if (!(camera.keys[i].time_s > camera.keys[i - 1].time_s))
            throw Error("{}: expected times that grow, found {} after {}", path.string(), camera.keys[i].time_s,
                        camera.keys[i - 1].time_s);
    if (!(camera.fps > 0.f && camera.fps <= 1000.f))
        throw Error("{}: expected fps above 0 and at most 1000, found {}", path.string(), camera.fps);
    if (!(camera.fov_deg >= 1.f && camera.fov_deg <= 170.f))
        throw Error("{}: expected fov_deg from 1 to 170, found {}", path.string(), camera.fov_deg);
    if (camera.width < 1 || camera.height < 1 || camera.width > 16384 || camera.height > 16384)
        throw Error("{}: expected a size from 1 to 16384, found {} x {}", path.string(), camera.width, camera.height);
    constexpr double kMostFrames = 1e6;
    const double seconds = static_cast<double>(camera.keys.back().time_s) -
                           static_cast<double>(camera.keys.front().time_s);
    if (!(seconds * static_cast<double>(camera.fps) < kMostFrames))
        throw Error("{}: expected less than {} frames, found {} s of {} a second", path.string(), kMostFrames, seconds,
                    camera.fps);
    return camera;
}

}  // namespace fastscene
