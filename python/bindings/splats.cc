#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "bind.h"
#include "calls.h"
#include "fastscene/image/color.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/scene/splat_edit.h"
#include "fastscene/splat/splat.h"
#include "fastscene/views/views.h"
#include "settings.h"

namespace fastscene::python {
namespace {

View view_from(const Pinhole& camera, const py::object& pose, const py::array& color, const py::object& weight,
               const std::string& name) {
    View view{name, camera, pose_from(pose), rgb_from(color, "color"), mask_from(weight, "weight")};
    if (view.color.width != camera.width || view.color.height != camera.height)
        throw UsageError("color: expected the camera's {} x {} pixels, found {} x {}", camera.width, camera.height,
                         view.color.width, view.color.height);
    return view;
}

ViewSet view_set_from(std::vector<View> views, const py::array& positions, const py::array& colors,
                      const py::object& normals, const py::object& radii) {
    const std::vector<Vec3f> p = list_from<Vec3f>(positions, "positions");
    const std::vector<Rgb8> c = list_from<Rgb8>(colors, "colors");
    const std::vector<Vec3f> n = normals.is_none() ? std::vector<Vec3f>(p.size())
                                                   : list_from<Vec3f>(py::array(normals), "normals");
    const std::vector<float> r = radii.is_none() ? std::vector<float>(p.size(), 0.05f)
                                                 : list_from<float>(py::array(radii), "radii");
    if (c.size() != p.size() || n.size() != p.size() || r.size() != p.size())
        throw UsageError("expected as many colors, normals and radii as positions, found {}, {}, {} and {}", c.size(),
                         n.size(), r.size(), p.size());
    ViewSet set{std::move(views), {}};
    for (std::size_t i = 0; i < p.size(); ++i) set.points.push_back({p[i], n[i], c[i], r[i]});
    return set;
}

ViewSet project(std::vector<Panorama> panoramas, std::uint64_t seed, const py::kwargs& given) {
    ViewsParams params;
    Settings settings(given);
    settings.take(params);
    settings.finish();
    check_fields("", params);
    return long_call(seed, py::none(),
                     [&](const Run& run, Caller&) { return project_views(std::move(panoramas), params, run); });
}

FittedSplats fit(const ViewSet& views, std::uint64_t seed, py::object on_step, py::object on_progress,
                 const py::kwargs& given) {
    SplatParams params;
    Settings settings(given);
    settings.take(params);
    settings.finish();
    return long_call(seed, std::move(on_progress), [&](const Run& run, Caller& caller) {
        StepListener listener;
        if (!on_step.is_none())
            listener = [&](const StepReport& r) { caller.call([&] { on_step(r.step, r.steps, r.loss, r.psnr); }); };
        return fit_splats(views, params, run, listener);
    });
}

// A renderer with the splats that it draws.
struct Renderer {
    std::shared_ptr<const Splats> splats;
    std::unique_ptr<SplatRenderer> renderer;
    Vec3f background;
};

void bind_views(py::module_& m) {
    py::class_<View>(m, "View", "A picture with its camera, to train on.")
        .def(py::init(&view_from), py::arg("camera"), py::arg("world_from_camera"), py::arg("color"),
             py::arg("weight") = py::none(), py::arg("name") = "")
        .def_readonly("name", &View::name)
        .def_readonly("camera", &View::camera)
        .def_property_readonly("world_from_camera", [](const View& v) { return matrix_of_pose(v.world_from_camera); })
        .def_property_readonly(
            "color", [](py::object self) { return shown(self.cast<View&>().color, self); }, "sRGB of uint8.");
    py::class_<ViewSet>(m, "ViewSet", "Views, and points on the surfaces that they show, from which training starts.")
        .def(py::init(&view_set_from), py::arg("views"), py::arg("positions"), py::arg("colors"),
             py::arg("normals") = py::none(), py::arg("radii") = py::none())
        .def_property_readonly("views", [](const ViewSet& s) { return s.views; })
        .def_property_readonly("positions",
                               [](const ViewSet& s) {
                                   auto* p = new std::vector<Vec3f>;
                                   for (const SurfacePoint& point : s.points) p->push_back(point.position_m);
                                   const py::capsule owner(
                                       p, [](void* list) { delete static_cast<std::vector<Vec3f>*>(list); });
                                   return shown(*p, owner);
                               })
        .def("__len__", [](const ViewSet& s) { return s.views.size(); });
    m.def("project_views", &project, py::arg("panoramas"), py::arg("seed") = 0,
          "Cuts panoramas with range into views and points. Settings: those of --views, as size, fov, points.");
}

void bind_splat_data(py::module_& m) {
    py::class_<Splats, std::shared_ptr<Splats>>(
        m, "Splats", "3D Gaussians. The arrays show the memory of the splats: writing into them changes the splats.")
        .def(py::init([](std::size_t count, int sh_degree) {
                 if (sh_degree < 0 || sh_degree > 3)
                     throw UsageError("sh_degree: expected 0 to 3, found {}", sh_degree);
                 Splats s;
                 s.sh_degree = sh_degree;
                 s.resize(count);
                 return s;
             }),
             py::arg("count"), py::arg("sh_degree") = 0)
        .def("__len__", &Splats::size)
        .def_readonly("sh_degree", &Splats::sh_degree)
        .def_property(
            "antialias", [](const Splats& s) { return s.filter.antialias; },
            [](Splats& s, bool on) { s.filter.antialias = on; })
        .def_property(
            "low_pass_px2", [](const Splats& s) { return s.filter.low_pass_px2; },
            [](Splats& s, float px2) {
                if (!(px2 >= static_cast<float>(kLeastLowPassPx2) && px2 <= kMostLowPassPx2))
                    throw UsageError("low_pass_px2: expected {} to {}, found {}", kLeastLowPassPx2, kMostLowPassPx2,
                                     px2);
                s.filter.low_pass_px2 = px2;
            },
            "Variance in square pixels that is added to every footprint.")
        .def_property(
            "mean_m", [](py::object self) { return shown(self.cast<Splats&>().mean_m, self); },
            [](Splats& s, const py::array& a) { assign(s.mean_m, a, "mean_m"); }, "N x 3, world.")
        .def_property(
            "log_scale", [](py::object self) { return shown(self.cast<Splats&>().log_scale, self); },
            [](Splats& s, const py::array& a) { assign(s.log_scale, a, "log_scale"); },
            "N x 3, natural logarithm of the standard deviations in metres.")
        .def_property(
            "rotation", [](py::object self) { return shown(self.cast<Splats&>().rotation, self); },
            [](Splats& s, const py::array& a) { assign(s.rotation, a, "rotation"); }, "N x 4, quaternions, w first.")
        .def_property(
            "opacity_logit", [](py::object self) { return shown(self.cast<Splats&>().opacity_logit, self); },
            [](Splats& s, const py::array& a) { assign(s.opacity_logit, a, "opacity_logit"); },
            "N; opacity = 1 / (1 + exp(-x)).")
        .def_property(
            "sh0", [](py::object self) { return shown(self.cast<Splats&>().sh0, self); },
            [](Splats& s, const py::array& a) { assign(s.sh0, a, "sh0"); }, "N x 3: color = 0.5 + 0.28209479 sh0.")
        .def_property_readonly(
            "sh_rest",
            [](py::object self) {
                const Splats& s = self.cast<Splats&>();
                return shown(s.sh_rest.data(), {static_cast<Index>(s.size()), 3, s.rest_coefficients()}, self);
            },
            "N x 3 x K, K = (degree + 1)^2 - 1.");
}

void bind_splat_files(py::module_& m) {
    m.def(
        "load_splats",
        [](const std::filesystem::path& path) {
            return std::make_shared<Splats>(
                long_call(0, py::none(), [&](const Run&, Caller&) { return load_splats(path).splats; }));
        },
        py::arg("path"), "A splat file of any format.");
    m.def(
        "save_splats",
        [](const std::filesystem::path& path, const Splats& splats) {
            const py::gil_scoped_release unlocked;
            save_splats(path, splats);
        },
        py::arg("path"), py::arg("splats"), "The ending chooses the format: .ply, .compressed.ply, .spz, .sog, …");
    m.def("strongest", &strongest, py::arg("splats"), py::arg("count"), "Those that cover most.");
    m.def(
        "cropped",
        [](const Splats& s, std::array<float, 3> low, std::array<float, 3> high) {
            return cropped(s, {low[0], low[1], low[2]}, {high[0], high[1], high[2]});
        },
        py::arg("splats"), py::arg("low_m"), py::arg("high_m"), "Those inside a box.");
}

void bind_training(py::module_& m) {
    py::class_<FittedSplats>(m, "FittedSplats")
        .def_property_readonly("splats", [](FittedSplats& f) { return std::make_shared<Splats>(f.splats); })
        .def_readonly("steps", &FittedSplats::steps)
        .def_readonly("device", &FittedSplats::device)
        .def_property_readonly(
            "curve",
            [](const FittedSplats& f) {
                py::list out;
                for (const CurvePoint& p : f.curve) out.append(py::make_tuple(p.step, p.loss, p.psnr));
                return out;
            },
            "Tuples of step, mean loss and mean PSNR since the one before.");
    m.def("fit_splats", &fit, py::arg("views"), py::arg("seed") = 0, py::arg("on_step") = py::none(),
          py::arg("on_progress") = py::none(),
          "Trains. on_step(step, steps, loss, psnr) is called after every step; what it raises stops the training. "
          "Settings: those of --splat, as count, steps, sh_degree, backend.");
}

void bind_rendering(py::module_& m) {
    py::class_<SplatPicture>(m, "SplatPicture")
        .def_property_readonly(
            "color", [](py::object self) { return shown(self.cast<SplatPicture&>().color, self); },
            "Height x width x 3, sRGB from 0 to 1.")
        .def_property_readonly(
            "alpha", [](py::object self) { return shown(self.cast<SplatPicture&>().alpha, self); }, "Opacity.")
        .def_property_readonly(
            "depth_z", [](py::object self) { return shown(self.cast<SplatPicture&>().depth_z, self); },
            "Metres along the optical axis; 0: empty.")
        .def(
            "rgb8", [](const SplatPicture& p) { return array_of(srgb8_from_unit(p.color)); }, "As sRGB of uint8.");
    py::class_<Renderer>(m, "SplatRenderer", "Renders pictures of the same splats.")
        .def(py::init([](std::shared_ptr<Splats> splats, std::array<float, 3> background, const std::string& backend,
                         const std::string& device) {
                 return Renderer{splats,
                                 std::make_unique<SplatRenderer>(*splats, SplatBackend{backend, device}),
                                 {background[0], background[1], background[2]}};
             }),
             py::arg("splats"), py::arg("background") = std::array<float, 3>{0, 0, 0}, py::arg("backend") = "cpu",
             py::arg("device") = "auto")
        .def(
            "picture",
            [](const Renderer& r, const Pinhole& camera, const py::object& pose) {
                const Rigid at = pose_from(pose);
                return long_call(0, py::none(),
                                 [&](const Run&, Caller&) { return r.renderer->picture(camera, at, r.background); });
            },
            py::arg("camera"), py::arg("world_from_camera") = py::none())
        .def(
            "sphere",
            [](const Renderer& r, int width, const py::object& pose) {
                if (width < 16 || width > 16384 || width % 2 != 0)
                    throw UsageError("width: expected an even number from 16 to 16384, found {}", width);
                const Rigid at = pose_from(pose, "world_from_pano");
                return array_of(long_call(0, py::none(), [&](const Run&, Caller&) {
                    return sphere_of(*r.renderer, width, at, r.background).color;
                }));
            },
            py::arg("width") = 1024, py::arg("world_from_pano") = py::none(),
            "Equirectangular, width / 2 x width x 3, sRGB of uint8.");
    m.def(
        "render_splats",
        [](const Splats& splats, const Pinhole& camera, const py::object& pose, std::array<float, 3> background) {
            const Rigid at = pose_from(pose);
            return long_call(0, py::none(), [&](const Run&, Caller&) {
                return render_splats(splats, camera, at, {background[0], background[1], background[2]});
            });
        },
        py::arg("splats"), py::arg("camera"), py::arg("world_from_camera") = py::none(),
        py::arg("background") = std::array<float, 3>{0, 0, 0}, "One picture; for many, SplatRenderer.");
}

}  // namespace

void bind_splats(py::module_& m) {
    bind_views(m);
    bind_splat_data(m);
    bind_splat_files(m);
    bind_training(m);
    bind_rendering(m);
}

}  // namespace fastscene::python
