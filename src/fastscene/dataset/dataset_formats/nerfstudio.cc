// nerfstudio's transforms.json for each room, with points from the range maps.
#include "fastscene/base/shortest.h"
#include "fastscene/dataset/format.h"
#include "fastscene/dataset/room_folders.h"
#include "fastscene/base/bytes.h"
#include "fastscene/scene/pose_json.h"

namespace fastscene::dataset_formats {
namespace {

using namespace dataset;

// nerfstudio measures panoramas by half their width and by their height, and divides by them.
Pinhole nerfstudio_lens(const Camera& camera) {
    if (!camera.panorama) return camera.pinhole;
    const int w = camera.pinhole.width, h = camera.pinhole.height;
    const auto half = static_cast<float>(w) / 2, high = static_cast<float>(h);
    return {w, h, half, high, half, high / 2};
}

// Camera to world in OpenGL's axes: x right, y up, z back.
Rigid opengl_pose(Rigid pose) {
    for (Vec3f* row : {&pose.rotation.row0, &pose.rotation.row1, &pose.rotation.row2})
        *row = {row->x, -row->y, -row->z};
    return pose;
}

std::string points_ply(const std::vector<SurfacePoint>& points) {
    std::string out = fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", points.size());
    for (const char* name : {"x", "y", "z"}) out += fmt::format("property float {}\n", name);
    for (const char* name : {"red", "green", "blue"}) out += fmt::format("property uchar {}\n", name);
    out += "end_header\n";
    for (const SurfacePoint& p : points) {
        for (const float v : {p.position_m.x, p.position_m.y, p.position_m.z}) append(out, v);
        for (const std::uint8_t v : {p.color.r, p.color.g, p.color.b}) append(out, v);
    }
    return out;
}

void write_nerfstudio(const ExportJob& job) {
    for_each_room(job, [&](const RoomFolder& room) {
        Json frames = Json::array();
        for (const SetPicture* picture : room.pictures) {
            const Camera camera = job.set.camera(*picture);
            const Pinhole lens = nerfstudio_lens(camera);
            frames.push_back({{"file_path", "images/" + write_room_color(job, room, *picture)},
                              {"depth_file_path", "depth/" + write_room_depth(job, room, *picture)},
                              {"w", lens.width},
                              {"h", lens.height},
                              {"fl_x", shortest(lens.fx)},
                              {"fl_y", shortest(lens.fy)},
                              {"cx", shortest(lens.cx)},
                              {"cy", shortest(lens.cy)},
                              {"transform_matrix", json_from_pose(opengl_pose(camera.world_from_camera))}});
        }
        job.out.write(room.name + "points.ply", points_ply(room_points(job, room)));
        job.out.write_json(room.name + "transforms.json",
                           Json{{"camera_model", job.set.is_panorama() ? "EQUIRECTANGULAR" : "OPENCV"},
                                {"ply_file_path", "points.ply"},
                                {"frames", std::move(frames)}});
    });
}

}  // namespace

DatasetFormat nerfstudio() {
    return {.name = "nerfstudio",
            .about = "transforms.json, pictures and depth for each room",
            .readers = "nerfstudio, gsplat, `fastscene splat --nerfstudio`",
            .write = write_nerfstudio};
}

}  // namespace fastscene::dataset_formats
