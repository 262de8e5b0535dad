// Pictures, poses and points as numpy arrays. Arrays of objects that live on show their memory; others own theirs.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <utility>
#include <vector>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/image/image.h"
#include "fastscene/math/rigid.h"

namespace fastscene::python {

namespace py = pybind11;
using Index = py::ssize_t;

static_assert(sizeof(Vec3f) == 3 * sizeof(float) && sizeof(Rgb8) == 3 && sizeof(Quatf) == 4 * sizeof(float));

// Numbers of a type of ours: a Vec3f is three floats.
template <class T>
struct Scalars {
    using Type = T;
    static constexpr Index count = 1;
};
template <>
struct Scalars<Vec3f> {
    using Type = float;
    static constexpr Index count = 3;
};
template <>
struct Scalars<Quatf> {
    using Type = float;
    static constexpr Index count = 4;
};
template <>
struct Scalars<Rgb8> {
    using Type = std::uint8_t;
    static constexpr Index count = 3;
};

// `owner` keeps the memory.
template <class T>
py::array shown(const T* data, std::vector<Index> shape, py::handle owner) {
    using S = Scalars<T>;
    if (S::count > 1) shape.push_back(S::count);
    return py::array_t<typename S::Type>(std::move(shape), reinterpret_cast<const typename S::Type*>(data), owner);
}
template <class T>
py::array shown(const Image<T>& image, py::handle owner) {
    return shown(image.pixels.data(), {image.height, image.width}, owner);
}
template <class T>
py::array shown(const std::vector<T>& list, py::handle owner) {
    return shown(list.data(), {static_cast<Index>(list.size())}, owner);
}
// Moves the picture into the array.
template <class T>
py::array array_of(Image<T> image) {
    auto* kept = new Image<T>(std::move(image));
    const py::capsule owner(kept, [](void* p) { delete static_cast<Image<T>*>(p); });
    return shown(*kept, owner);
}

std::string shape_text(const py::array& array);

// A list of `name` from an array of N x count numbers.
template <class T>
std::vector<T> list_from(const py::array& array, const char* name) {
    using S = Scalars<T>;
    const py::array_t<typename S::Type, py::array::c_style | py::array::forcecast> a(array);
    const bool fits = S::count > 1 ? a.ndim() == 2 && a.shape(1) == S::count : a.ndim() == 1;
    if (!fits)
        throw UsageError("{}: expected an array of N{}, found {}", name,
                         S::count > 1 ? fmt::format(" x {}", S::count) : "", shape_text(array));
    const auto* data = reinterpret_cast<const T*>(a.data());
    return {data, data + a.shape(0)};
}
// The same into a list of known length.
template <class T>
void assign(std::vector<T>& list, const py::array& array, const char* name) {
    std::vector<T> given = list_from<T>(array, name);
    if (given.size() != list.size())
        throw UsageError("{}: expected {} rows, found {}", name, list.size(), given.size());
    list = std::move(given);
}

// Height x width x 3 of uint8.
ImageRgb8 rgb_from(const py::array& array, const char* name);
// Height x width of uint8; none: empty.
ImageMask mask_from(const py::object& array, const char* name);
ImageColor color_from(const py::array& array, const char* name);
ImageF floats_from(const py::array& array, const char* name);

// 4 x 4, or 3 x 4; none: the identity.
Rigid pose_from(const py::object& matrix, const char* name = "world_from_camera");
py::array_t<float> matrix_of_pose(const Rigid& pose);

// JSON as Python's dicts and lists, and back.
py::object python_of(const Json& json);
std::string json_text(const py::object& value);

}  // namespace fastscene::python
