#include "fastscene/io/colmap.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/ply.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

constexpr std::int32_t kPinholeModel = 1;

// COLMAP counts from 1. Equal cameras are one camera.
struct Cameras {
    std::vector<Pinhole> list;
    std::vector<int> id_of_view;
    explicit Cameras(const std::vector<View>& views) {
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
    return inverse(Rigidd{{to_double(r.row0), to_double(r.row1), to_double(r.row2)}, to_double(view.world_from_camera.translation)});
}

std::string cameras_text(const Cameras& cameras) {
    std::string out = "# CAMERA_ID, MODEL, WIDTH, HEIGHT, FX, FY, CX, CY\n";
    for (std::size_t i = 0; i < cameras.list.size(); ++i) {
        const Pinhole& c = cameras.list[i];
        out += fmt::format("{} PINHOLE {} {} {} {} {} {}\n", i + 1, c.width, c.height, c.fx, c.fy, c.cx, c.cy);
    }
    return out;
}
std::string cameras_binary(const Cameras& cameras) {
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

std::string images_text(const std::vector<View>& views, const Cameras& cameras) {
    std::string out = "# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME; then a line of 2D points (none)\n";
    for (std::size_t i = 0; i < views.size(); ++i) {
        const Rigidd pose = camera_from_world(views[i]);
        const Quatd q = quaternion_of(pose.rotation);
        out += fmt::format("{} {} {} {} {} {} {} {} {} {}\n\n", i + 1, q.w, q.x, q.y, q.z, pose.translation.x, pose.translation.y,
                           pose.translation.z, cameras.id_of_view[i], views[i].name);
    }
    return out;
}
std::string images_binary(const std::vector<View>& views, const Cameras& cameras) {
    std::string out;
    append(out, std::uint64_t{views.size()});
    for (std::size_t i = 0; i < views.size(); ++i) {
        const Rigidd pose = camera_from_world(views[i]);
        const Quatd q = quaternion_of(pose.rotation);
        append(out, static_cast<std::int32_t>(i + 1));
        for (const double v : {q.w, q.x, q.y, q.z, pose.translation.x, pose.translation.y, pose.translation.z}) append(out, v);
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
        fmt::format_to(std::back_inserter(out), "{} {} {} {} {} {} {} 0\n", i + 1, p.position_m.x, p.position_m.y, p.position_m.z, p.color.r, p.color.g, p.color.b);
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

// Reads numbers from a buffer and knows where it is when the buffer ends too early.
class Reader {
  public:
    explicit Reader(fs::path path) : path_(std::move(path)), bytes_(read_file(path_)) {}
    template <class T>
    T get() {
        if (bytes_.size() - at_ < sizeof(T)) too_short(sizeof(T));
        T value;
        std::memcpy(&value, bytes_.data() + at_, sizeof value);
        at_ += sizeof value;
        return value;
    }
    std::string text() {
        const std::size_t end = bytes_.find('\0', at_);
        if (end == std::string::npos) too_short(1);
        std::string out = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        return out;
    }
    // A count of things that take at least `least` bytes each.
    std::size_t count(std::size_t least) {
        const auto n = get<std::uint64_t>();
        if (n > (bytes_.size() - at_) / least) throw Error("{}: byte {}: expected fewer than {} entries in {} bytes", path_.string(), at_, n, bytes_.size());
        return static_cast<std::size_t>(n);
    }
    void skip(std::size_t bytes) {
        if (bytes_.size() - at_ < bytes) too_short(bytes);
        at_ += bytes;
    }
    [[noreturn]] void refuse(const std::string& what) const { throw Error("{}: byte {}: {}", path_.string(), at_, what); }

  private:
    [[noreturn]] void too_short(std::size_t wanted) const {
        throw Error("{}: byte {}: expected {} more bytes, found {}", path_.string(), at_, wanted, bytes_.size() - at_);
    }
    fs::path path_;
    std::string bytes_;
    std::size_t at_ = 0;
};

std::vector<std::pair<std::int32_t, Pinhole>> load_cameras(const fs::path& path) {
    Reader in(path);
    std::vector<std::pair<std::int32_t, Pinhole>> cameras(in.count(24));
    for (auto& [id, camera] : cameras) {
        id = in.get<std::int32_t>();
        const auto model = in.get<std::int32_t>();
        const auto width = in.get<std::uint64_t>(), height = in.get<std::uint64_t>();
        if (model != 0 && model != kPinholeModel) in.refuse(fmt::format("expected a SIMPLE_PINHOLE or PINHOLE camera, found model {}", model));
        if (width < 1 || height < 1 || width > 65536 || height > 65536) in.refuse(fmt::format("expected a picture size, found {} x {}", width, height));
        camera.width = static_cast<int>(width);
        camera.height = static_cast<int>(height);
        camera.fx = static_cast<float>(in.get<double>());
        camera.fy = model == kPinholeModel ? static_cast<float>(in.get<double>()) : camera.fx;
        camera.cx = static_cast<float>(in.get<double>());
        camera.cy = static_cast<float>(in.get<double>());
        if (!(camera.fx > 0 && camera.fy > 0)) in.refuse(fmt::format("expected a positive focal length, found {}", camera.fx));
    }
    return cameras;
}

}  // namespace

void save_colmap(const fs::path& dir, const ViewSet& set) {
    make_directories(dir);
    const Cameras cameras(set.views);
    write_file(dir / "cameras.txt", cameras_text(cameras));
    write_file(dir / "cameras.bin", cameras_binary(cameras));
    write_file(dir / "images.txt", images_text(set.views, cameras));
    write_file(dir / "images.bin", images_binary(set.views, cameras));
    write_file(dir / "points3D.txt", points_text(set.points));
    write_file(dir / "points3D.bin", points_binary(set.points));
}

std::vector<View> load_colmap_views(const fs::path& dir) {
    const auto cameras = load_cameras(dir / "cameras.bin");
    Reader in(dir / "images.bin");
    std::vector<View> views(in.count(4 + 7 * 8 + 4 + 1 + 8));
    for (View& view : views) {
        in.get<std::int32_t>();
        Quatd q;
        q.w = in.get<double>(), q.x = in.get<double>(), q.y = in.get<double>(), q.z = in.get<double>();
        Vec3d t;
        t.x = in.get<double>(), t.y = in.get<double>(), t.z = in.get<double>();
        if (!(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z > 0.1)) in.refuse("expected a unit quaternion, found zero");
        if (!(std::isfinite(t.x) && std::isfinite(t.y) && std::isfinite(t.z))) in.refuse("expected a finite translation, found another");
        const Rigidd world_from_camera = inverse(Rigidd{matrix_of(q), t});
        const auto to_float = [](Vec3d v) { return Vec3f{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; };
        const Mat3d& r = world_from_camera.rotation;
        view.world_from_camera = {{to_float(r.row0), to_float(r.row1), to_float(r.row2)}, to_float(world_from_camera.translation)};
        const auto camera_id = in.get<std::int32_t>();
        view.name = in.text();
        in.skip(in.count(24) * 24);
        bool found = false;
        for (const auto& [id, camera] : cameras)
            if (id == camera_id) view.camera = camera, found = true;
        if (!found) in.refuse(fmt::format("expected a camera {} in cameras.bin, found none", camera_id));
        if (view.name.find("..") != std::string::npos || view.name.empty() || view.name[0] == '/') in.refuse("expected a picture's name below images/, found \"" + view.name + "\"");
    }
    return views;
}

}  // namespace fastscene
