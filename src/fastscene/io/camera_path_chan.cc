// .chan, as Blender's add-on "Nuke Animation Format" reads and writes it with its defaults: a line a frame with the
// frame's number, place, Euler angles in degrees (order XYZ: turned about x first) and the vertical angle of view; y
// up, the camera looks along -z. The file has neither a rate nor a picture size.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include <fmt/format.h>

#include "fastscene/base/error.h"
#include "fastscene/io/camera_path_parts.h"
#include "fastscene/io/splat_frames.h"

namespace fastscene {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

// World to the frame of our GLB files, and camera axes to OpenGL's; both are half turns, so the way back is the same.
Rigidd turned(const Rigidd& pose) {
    Mat3d r = kGltfFromWorld * pose.rotation;
    for (Vec3d* row : {&r.row0, &r.row1, &r.row2}) *row = {row->x, -row->y, -row->z};
    return {r, kGltfFromWorld * pose.translation};
}

Mat3d rotation_of_euler(double x, double y, double z) {
    const auto about = [](Vec3d axis, double degrees) { return rotation_about(axis, degrees / kDegrees); };
    return about({0, 0, 1}, z) * (about({0, 1, 0}, y) * about({1, 0, 0}, x));
}

// Angles x, y, z of such a rotation.
Vec3d euler_of(const Mat3d& m) {
    const double level = std::hypot(m.row0.x, m.row1.x);
    constexpr double kLocked = 1e-7;  // y = ±90 degrees: x and z turn about one axis, z is left at 0
    if (level < kLocked) return Vec3d{std::atan2(-m.row1.z, m.row1.y), std::atan2(-m.row2.x, level), 0} * kDegrees;
    return Vec3d{std::atan2(m.row2.y, m.row2.z), std::atan2(-m.row2.x, level), std::atan2(m.row1.x, m.row0.x)} *
           kDegrees;
}

double around(double degrees) { return std::remainder(degrees, 360); }

// Every rotation has two triples of angles: the one nearer to the frame before, without a jump by a full turn, as
// Blender interpolates the three one by one. For the first frame, the one that is least turned about x and z.
Vec3d nearest_euler(const Mat3d& m, const Vec3d* before) {
    const Vec3d a = euler_of(m), b{around(a.x + 180), around(180 - a.y), around(a.z + 180)};
    if (!before) return std::fabs(b.x) + std::fabs(b.z) < std::fabs(a.x) + std::fabs(a.z) ? b : a;
    const auto near = [&](Vec3d v) {
        for (std::size_t i = 0; i < 3; ++i) v[i] = (*before)[i] + around(v[i] - (*before)[i]);
        return v;
    };
    return length(near(b) - *before) < length(near(a) - *before) ? near(b) : near(a);
}

Rigidd as_double(const Rigid& pose) {
    const auto row = [](Vec3f v) { return Vec3d{v.x, v.y, v.z}; };
    return {{row(pose.rotation.row0), row(pose.rotation.row1), row(pose.rotation.row2)}, row(pose.translation)};
}

Rigid as_float(const Rigidd& pose) {
    const auto row = [](Vec3d v) {
        return Vec3f{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    };
    return {{row(pose.rotation.row0), row(pose.rotation.row1), row(pose.rotation.row2)}, row(pose.translation)};
}

}  // namespace

CameraPath path_from_chan(const std::string& text, const CameraPath& otherwise, const std::string& where) {
    CameraPath camera = otherwise;
    camera.keys.clear();
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::istringstream words(line);
        std::vector<double> v;
        for (double word = 0; words >> word;) v.push_back(word);
        if (v.empty() && words.eof()) continue;
        const bool finite = std::all_of(v.begin(), v.end(), [](double x) { return std::fabs(x) < 1e6; });
        if (!words.eof() || !finite || (v.size() != 7 && v.size() != 8))
            throw Error("{}: line {}: expected frame, place, three angles and an angle of view, found \"{}\"", where,
                        number, line.substr(0, 60));
        const Rigidd pose = turned({rotation_of_euler(v[4], v[5], v[6]), {v[1], v[2], v[3]}});
        CameraKey key = key_of_pose(static_cast<float>(v[0] / static_cast<double>(camera.fps)), as_float(pose));
        if (v.size() == 8) key.fov_deg = horizontal_fov_deg(static_cast<float>(v[7]), camera.width, camera.height);
        camera.keys.push_back(key);
    }
    if (!camera.keys.empty() && camera.keys.front().fov_deg != 0) camera.fov_deg = camera.keys.front().fov_deg;
    return camera;
}

std::string chan_from_path(const CameraPath& camera) {
    std::string text;
    Vec3d last{};
    for (int i = 0; i < camera.frames(); ++i) {
        const CameraKey key = camera.at(camera.time_of(i));
        const Rigidd pose = turned(as_double(world_from_camera(key)));
        const Vec3d angles = nearest_euler(pose.rotation, i > 0 ? &last : nullptr);
        last = angles;
        const Vec3d t = pose.translation;
        text += fmt::format("{}\t{:.6f}\t{:.6f}\t{:.6f}\t{:.6f}\t{:.6f}\t{:.6f}\t{:.6f}\n", i + 1, t.x, t.y, t.z,
                            angles.x, angles.y, angles.z, vertical_fov_deg(key.fov_deg, camera.width, camera.height));
    }
    return text;
}

}  // namespace fastscene
