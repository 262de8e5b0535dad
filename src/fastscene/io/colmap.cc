#include "fastscene/io/colmap.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/bytes.h"
#include "fastscene/io/capture_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

constexpr std::int32_t kPinholeModel = 1;

// COLMAP counts from 1. Equal cameras are shared.
struct CameraList {
    std::vector<Pinhole> list;
    std::vector<int> id_of_view;
    explicit CameraList(const std::vector<View>& views) {
        for (const View& view : views) {
            std::size_t i = 0;
            while (i < list.size() && !(list[i] == view.camera)) ++i;
            if (i == list.size()) list.push_back(view.camera);
            id_of_view.push_back(static_cast<int>(i) + 1);
        }
    }
};

Rigidd camera_from_world(const View& view) {
    const auto to_double = [](Vec3f v) { return Vec3d{v.x, v.y, v.z}; };
    const Mat3f& r = view.world_from_camera.rotation;
    return inverse(Rigidd{{to_double(r.row0), to_double(r.row1), to_double(r.row2)},
                          to_double(view.world_from_camera.translation)});
}

std::string cameras_text(const CameraList& cameras) {
    std::string out = "# CAMERA_ID, MODEL, WIDTH, HEIGHT, FX, FY, CX, CY\n";
    for (std::size_t i = 0; i < cameras.list.size(); ++i) {
        const Pinhole& c = cameras.list[i];
        out += fmt::format("{} PINHOLE {} {} {} {} {} {}\n", i + 1, c.width, c.height, c.fx, c.fy, c.cx, c.cy);
    }
    return out;
}
std::string cameras_binary(const CameraList& cameras) {
    std::string out;
    append(out, std::uint64_t{cameras.list.size()});
    for (std::size_t i = 0; i < cameras.list.size(); ++i) {
        const Pinhole& c = cameras.list[i];
        append(out, static_cast<std::int32_t>(i + 1));
        append(out, kPinholeModel);
        append(out, static_cast<std::uint64_t>(c.width));
        append(out, static_cast<std::uint64_t>(c.height));
        for (const float v : {c.fx, c.fy, c.cx, c.cy}) append(out, static_cast<double>(v));
    }
    return out;
}

std::string images_text(const std::vector<View>& views, const CameraList& cameras) {
    std::string out = "# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME; then a line of 2D points (none)\n";
    for (std::size_t i = 0; i < views.size(); ++i) {
        const Rigidd pose = camera_from_world(views[i]);
        const Quatd q = quaternion_of(pose.rotation);
        out += fmt::format("{} {} {} {} {} {} {} {} {} {}\n\n", i + 1, q.w, q.x, q.y, q.z, pose.translation.x,
                           pose.translation.y, pose.translation.z, cameras.id_of_view[i], views[i].name);
    }
    return out;
}
std::string images_binary(const std::vector<View>& views, const CameraList& cameras) {
    std::string out;
    append(out, std::uint64_t{views.size()});
    for (std::size_t i = 0; i < views.size(); ++i) {
        const Rigidd pose = camera_from_world(views[i]);
        const Quatd q = quaternion_of(pose.rotation);
        append(out, static_cast<std::int32_t>(i + 1));
        for (const double v : {q.w, q.x, q.y, q.z, pose.translation.x, pose.translation.y, pose.translation.z})
            append(out, v);
        append(out, static_cast<std::int32_t>(cameras.id_of_view[i]));
        out.append(views[i].name.c_str(), views[i].name.size() + 1);
        append(out, std::uint64_t{0});
    }
    return out;
}

std::string points_text(const std::vector<SurfacePoint>& points) {
    std::string out = "# POINT3D_ID, X, Y, Z, R, G, B, ERROR; no tracks: the points come from the range maps\n";
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SurfacePoint& p = points[i];
        fmt::format_to(std::back_inserter(out), "{} {} {} {} {} {} {} 0\n", i + 1, p.position_m.x, p.position_m.y,
                       p.position_m.z, p.color.r, p.color.g, p.color.b);
    }
    return out;
}
std::string points_binary(const std::vector<SurfacePoint>& points) {
    std::string out;
    append(out, std::uint64_t{points.size()});
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SurfacePoint& p = points[i];
        append(out, static_cast<std::uint64_t>(i + 1));
        for (const float v : {p.position_m.x, p.position_m.y, p.position_m.z}) append(out, static_cast<double>(v));
        for (const std::uint8_t v : {p.color.r, p.color.g, p.color.b}) append(out, v);
        append(out, 0.0);
        append(out, std::uint64_t{0});
    }
    return out;
}

}  // namespace

void save_colmap(const fs::path& dir, const ViewSet& set) {
    make_directories(dir);
    const CameraList cameras(set.views);
    write_file(dir / "cameras.txt", cameras_text(cameras));
    write_file(dir / "cameras.bin", cameras_binary(cameras));
    write_file(dir / "images.txt", images_text(set.views, cameras));
    write_file(dir / "images.bin", images_binary(set.views, cameras));
    write_file(dir / "points3D.txt", points_text(set.points));
    write_file(dir / "points3D.bin", points_binary(set.points));
}

std::vector<View> load_colmap_views(const fs::path& dir) {
    const auto to_float = [](Vec3d v) {
        return Vec3f{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    };
    std::vector<View> views;
    for (const Photo& photo : load_colmap_model(dir).photos) {
        if (!photo.lens.is_pinhole())
            throw Error("{}: {}: expected a camera without distortion, found another", dir.string(), photo.name);
        View view;
        view.name = photo.name;
        view.camera = photo.lens.pinhole();
        const Mat3d& r = photo.world_from_camera.rotation;
        view.world_from_camera = {{to_float(r.row0), to_float(r.row1), to_float(r.row2)},
                                  to_float(photo.world_from_camera.translation)};
        views.push_back(std::move(view));
    }
    return views;
}

}  // namespace fastscene
