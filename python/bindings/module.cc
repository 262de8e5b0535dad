// The Python module fastscene._core.
#include "bind.h"
#include "fastscene/base/error.h"
#include "fastscene/base/parallel.h"
#include "fastscene/pipeline/build_info.h"

namespace py = pybind11;

PYBIND11_MODULE(_core, m) {
    using namespace fastscene;
    m.doc() = "From a sentence to a 3D indoor scene: rooms, pictures of them, Gaussian splats.";
    m.attr("__version__") = std::string(program_version());
    const auto error = py::register_exception<Error>(m, "Error", PyExc_RuntimeError);
    py::register_exception<UsageError>(m, "UsageError", error);
    py::register_exception<Stopped>(m, "Stopped", PyExc_RuntimeError);
    m.def("set_threads", &set_threads, py::arg("count"),
          "Sets the number of worker threads; 0 = all cores. Returns the number.");
    python::bind_cameras(m);
    python::bind_pictures(m);
    python::bind_rooms(m);
    python::bind_splats(m);
    python::bind_scenes(m);
}
