// cameras.json as written by INRIA's trainer and read by SuperSplat, SIBR and others: a list with, per picture, its
// size, focal lengths in pixels, position in the world, and the world-from-camera rotation (x right, y down, z
// forward), row by row.
#include <cmath>
#include <numbers>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/io/capture_io.h"
#include "fastscene/io/capture_parts.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

constexpr const char* kSphere = "EQUIRECTANGULAR";

Json json_of(const Photo& photo, std::size_t id) {
    const Rigidd& pose = photo.world_from_camera;
    Json rows = Json::array();
    for (const Vec3d& row : {pose.rotation.row0, pose.rotation.row1, pose.rotation.row2})
        rows.push_back({row.x, row.y, row.z});
    const Lens& lens = photo.lens;
    const bool sphere = lens.kind == LensKind::equirectangular;
    const double around = lens.width / (2 * std::numbers::pi);  // pixels per radian
    Json json{{"id", id},
              {"img_name", photo.name},
              {"width", lens.width},
              {"height", lens.height},
              {"position", {pose.translation.x, pose.translation.y, pose.translation.z}},
              {"rotation", rows},
              {"fx", sphere ? around : lens.fx},
              {"fy", sphere ? around : lens.fy}};
    if (sphere) json["camera_model"] = kSphere;
    return json;
}

Photo photo_of(const Json& json) {
    const auto row = [](const Json& v) { return Vec3d{v.at(0), v.at(1), v.at(2)}; };
    Photo photo;
    photo.name = json.at("img_name").get<std::string>();
    Lens& lens = photo.lens;
    const double width = json.at("width"), height = json.at("height");
    if (!(width >= 1 && height >= 1 && width <= 65536 && height <= 65536))
        throw Error("expected a picture size, found {} x {}", width, height);
    lens.width = static_cast<int>(width), lens.height = static_cast<int>(height);
    lens.fx = json.at("fx"), lens.fy = json.at("fy"), lens.cx = width / 2, lens.cy = height / 2;
    if (json.value("camera_model", "") == kSphere) lens.kind = LensKind::equirectangular;
    if (!(lens.fx > 0 && lens.fy > 0)) throw Error("expected a positive focal length, found {}", lens.fx);
    const Json& rows = json.at("rotation");
    photo.world_from_camera = {{row(rows.at(0)), row(rows.at(1)), row(rows.at(2))}, row(json.at("position"))};
    const Mat3d& r = photo.world_from_camera.rotation;
    if (!(std::fabs(length(r.row0) - 1) < 0.02 && length(cross(r.row0, r.row1) - r.row2) < 0.02))
        throw Error("expected a rotation, found another matrix");
    return photo;
}

}  // namespace

void save_cameras_json(const fs::path& path, const std::vector<Photo>& photos) {
    Json list = Json::array();
    for (const Photo& photo : photos) list.push_back(json_of(photo, list.size()));
    write_json(path, list);
}

Capture load_cameras_json(const fs::path& path) {
    const Json list = read_json(path);
    if (!list.is_array()) throw Error("{}: expected a list of cameras, found another kind of value", path.string());
    Capture capture;
    capture.source = path.string();
    for (std::size_t i = 0; i < list.size(); ++i) try {
            capture.photos.push_back(photo_of(list[i]));
        } catch (const Json::exception& e) {
            throw Error("{}: [{}]: expected img_name, width, height, position, rotation, fx and fy: {}", path.string(),
                        i, e.what());
        } catch (const Error& e) {
            throw Error("{}: [{}]: {}", path.string(), i, e.what());
        }
    return capture;
}

}  // namespace fastscene
