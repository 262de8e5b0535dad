// The parts of the module, one file each.
#pragma once

#include <pybind11/pybind11.h>

namespace fastscene::python {

void bind_cameras(pybind11::module_& m);  // before the others, whose signatures name its classes
void bind_pictures(pybind11::module_& m);
void bind_rooms(pybind11::module_& m);
void bind_splats(pybind11::module_& m);
void bind_scenes(pybind11::module_& m);

}  // namespace fastscene::python
