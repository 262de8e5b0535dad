#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "bind.h"
#include "fastscene/geometry/pinhole.h"
#include "fastscene/io/camera_path_io.h"

namespace fastscene::python {
namespace {

PathFormat format_named(const std::string& name, const std::filesystem::path& path) {
    if (name.empty()) return path_format_of(path);
    for (std::size_t i = 0; i < std::size(kPathFormats); ++i)
        if (name == kPathFormats[i]) return static_cast<PathFormat>(i);
    throw UsageError("format: expected {}, found {}", fmt::join(kPathFormats, ", "), name);
}

}  // namespace

void bind_cameras(py::module_& m) {
    py::class_<Pinhole>(m, "Pinhole", "Perspective camera: x right, y down, z forward; pixels.")
        .def(py::init([](int width, int height, float fx, float fy, float cx, float cy) {
                 return Pinhole{width, height, fx, fy, cx, cy};
             }),
             py::arg("width"), py::arg("height"), py::arg("fx"), py::arg("fy"), py::arg("cx"), py::arg("cy"))
        .def_static("with_fov", &Pinhole::with_fov, py::arg("width"), py::arg("height"), py::arg("fov_deg"),
                    "Square pixels, the principal point in the middle; fov_deg is the horizontal angle.")
        .def_readonly("width", &Pinhole::width)
        .def_readonly("height", &Pinhole::height)
        .def_readonly("fx", &Pinhole::fx)
        .def_readonly("fy", &Pinhole::fy)
        .def_readonly("cx", &Pinhole::cx)
        .def_readonly("cy", &Pinhole::cy)
        .def("__repr__", [](const Pinhole& c) {
            return fmt::format("Pinhole(width={}, height={}, fx={:.1f}, fy={:.1f}, cx={:.1f}, cy={:.1f})", c.width,
                               c.height, c.fx, c.fy, c.cx, c.cy);
        });
    m.def(
        "world_from_camera_at",
        [](std::array<float, 3> p, float yaw, float pitch, float roll) {
            return matrix_of_pose(world_from_camera_at({p[0], p[1], p[2]}, yaw, pitch, roll));
        },
        py::arg("position_m"), py::arg("yaw_deg") = 0.f, py::arg("pitch_deg") = 0.f, py::arg("roll_deg") = 0.f,
        "The pose of a camera, 4 x 4: yaw turns right, pitch up, roll clockwise.");

    py::class_<CameraPath>(m, "CameraPath", "The path of a film's camera.")
        .def_readonly("fps", &CameraPath::fps)
        .def_readonly("width", &CameraPath::width)
        .def_readonly("height", &CameraPath::height)
        .def_property_readonly("frames", &CameraPath::frames)
        .def(
            "world_from_camera",
            [](const CameraPath& p, int frame) { return matrix_of_pose(world_from_camera(p.at(p.time_of(frame)))); },
            py::arg("frame"), "The camera's pose at a frame.")
        .def(
            "camera",
            [](const CameraPath& p, int frame) {
                return Pinhole::with_fov(p.width, p.height, p.at(p.time_of(frame)).fov_deg);
            },
            py::arg("frame"))
        .def(
            "save",
            [](const CameraPath& p, const std::filesystem::path& file, const std::string& format) {
                save_camera_path(file, p, format_named(format, file));
            },
            py::arg("path"), py::arg("format") = "",
            "Writes it for fastscene, nerfstudio, blender (.chan) or supersplat.");
    m.def(
        "load_camera_path", [](const std::filesystem::path& file) { return load_camera_path(file); }, py::arg("path"),
        "A path of any of those programs.");
}

}  // namespace fastscene::python
