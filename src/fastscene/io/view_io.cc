#include "fastscene/io/view_io.h"

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/json.h"
#include "fastscene/base/parallel.h"
#include "fastscene/base/shortest.h"
#include "fastscene/io/colmap.h"
#include "fastscene/io/image_io.h"
#include "fastscene/io/ply.h"
#include "fastscene/scene/pose_json.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// 3DGS loaders read this file if it exists; ours also stores radii and edges, in an element after the vertices: some
// loaders assume fixed record sizes and would misread an additional vertex column.
void save_points_ply(const fs::path& path, const std::vector<SurfacePoint>& points) {
    std::string out = fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", points.size());
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) out += fmt::format("property float {}\n", name);
    for (const char* name : {"red", "green", "blue"}) out += fmt::format("property uchar {}\n", name);
    out += fmt::format("element spacing {}\n", points.size());
    for (const char* name : {"radius", "edge_x", "edge_y", "edge_z"}) out += fmt::format("property float {}\n", name);
    out += "end_header\n";
    for (const SurfacePoint& p : points) {
        for (const float v : {p.position_m.x, p.position_m.y, p.position_m.z, p.normal.x, p.normal.y, p.normal.z})
            append(out, v);
        for (const std::uint8_t v : {p.color.r, p.color.g, p.color.b}) append(out, v);
    }
    for (const SurfacePoint& p : points)
        for (const float v : {p.radius_m, p.edge.x, p.edge.y, p.edge.z}) append(out, v);
    write_file(path, out);
}

std::vector<SurfacePoint> load_points_ply(const fs::path& path) {
    const Ply ply(path);
    const PlyElement& v = ply.element("vertex");
    const int x = ply.property(v, "x"), y = ply.property(v, "y"), z = ply.property(v, "z");
    const int r = ply.property(v, "red"), g = ply.property(v, "green"), b = ply.property(v, "blue");
    const int nx = Ply::find(v, "nx"), ny = Ply::find(v, "ny"), nz = Ply::find(v, "nz");
    const PlyElement& spacing = ply.has("spacing") && ply.element("spacing").count == v.count
                                    ? ply.element("spacing")
                                    : v;  // v: the name in older files
    const int radius = Ply::find(spacing, "radius");
    const int ex = Ply::find(spacing, "edge_x"), ey = Ply::find(spacing, "edge_y"), ez = Ply::find(spacing, "edge_z");
    std::vector<SurfacePoint> points(v.count);
    for (std::size_t i = 0; i < v.count; ++i) {
        SurfacePoint& p = points[i];
        p.position_m = {ply.number(v, i, x), ply.number(v, i, y), ply.number(v, i, z)};
        if (nx >= 0 && ny >= 0 && nz >= 0)
            p.normal = {ply.number(v, i, nx), ply.number(v, i, ny), ply.number(v, i, nz)};
        const auto byte = [&](int property) {
            return static_cast<std::uint8_t>(std::min(std::max(0.0, ply.value(v, i, property)), 255.0));
        };
        p.color = {byte(r), byte(g), byte(b)};
        if (radius >= 0) p.radius_m = ply.number(spacing, i, radius);
        if (ex >= 0 && ey >= 0 && ez >= 0)
            p.edge = {ply.number(spacing, i, ex), ply.number(spacing, i, ey), ply.number(spacing, i, ez)};
    }
    return points;
}

// nerfstudio: camera-to-world in OpenGL's axes (y up, z back): the second and third columns change sign.
Json transforms_json(const std::vector<View>& views) {
    Json frames = Json::array();
    for (const View& view : views) {
        Rigid pose = view.world_from_camera;
        for (Vec3f* row : {&pose.rotation.row0, &pose.rotation.row1, &pose.rotation.row2})
            *row = {row->x, -row->y, -row->z};
        const Pinhole& c = view.camera;
        frames.push_back({{"file_path", "images/" + view.name},
                          {"w", c.width},
                          {"h", c.height},
                          {"fl_x", shortest(c.fx)},
                          {"fl_y", shortest(c.fy)},
                          {"cx", shortest(c.cx)},
                          {"cy", shortest(c.cy)},
                          {"transform_matrix", json_from_pose(pose)}});
    }
    return {{"camera_model", "OPENCV"}, {"ply_file_path", "sparse/0/points3D.ply"}, {"frames", std::move(frames)}};
}

}  // namespace

void save_views(const fs::path& dir, const ViewSet& set) {
    make_directories(dir / "images");
    bool weights = false;
    for (const View& view : set.views) weights = weights || !view.weight.empty();
    if (weights) make_directories(dir / "weights");
    parallel_for(static_cast<std::int64_t>(set.views.size()), 1, [&](std::int64_t begin, std::int64_t) {
        const View& view = set.views[static_cast<std::size_t>(begin)];
        save_png(dir / "images" / view.name, view.color);
        if (!view.weight.empty()) save_png(dir / "weights" / view.name, view.weight);
    });
    save_colmap(dir / "sparse" / "0", set);
    save_points_ply(dir / "sparse" / "0" / "points3D.ply", set.points);
    write_json(dir / "transforms.json", transforms_json(set.views));
}

void save_views_model(const fs::path& dir, const ViewSet& set) { save_colmap(dir, set); }

ViewSet load_views(const fs::path& dir) {
    ViewSet set{load_colmap_views(dir / "sparse" / "0"), load_points_ply(dir / "sparse" / "0" / "points3D.ply")};
    parallel_for(static_cast<std::int64_t>(set.views.size()), 1, [&](std::int64_t begin, std::int64_t) {
        View& view = set.views[static_cast<std::size_t>(begin)];
        view.color = load_rgb8(dir / "images" / view.name);
        if (view.color.width != view.camera.width || view.color.height != view.camera.height)
            throw Error("{}: expected {} x {} pixels as its camera says, found {} x {}",
                        (dir / "images" / view.name).string(), view.camera.width, view.camera.height, view.color.width,
                        view.color.height);
        if (const fs::path weight = dir / "weights" / view.name; fs::exists(weight)) {
            view.weight = load_mask_png(weight);
            if (!view.weight.same_size(view.color))
                throw Error("{}: expected the size of its picture, found {} x {}", weight.string(), view.weight.width,
                            view.weight.height);
        }
    });
    return set;
}

}  // namespace fastscene
