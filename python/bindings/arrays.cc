#include "arrays.h"

#include <fmt/ranges.h>

#include <cmath>

namespace fastscene::python {
namespace {

template <class T>
Image<T> image_from(const py::array& array, const char* name, const char* kind) {
    using S = Scalars<T>;
    const bool same = py::isinstance<py::array_t<typename S::Type>>(array);
    const bool fits = S::count > 1 ? array.ndim() == 3 && array.shape(2) == S::count : array.ndim() == 2;
    if (!same || !fits || array.size() == 0)
        throw UsageError("{}: expected height x width{} of {}, found {}", name,
                         S::count > 1 ? fmt::format(" x {}", S::count) : "", kind, shape_text(array));
    const py::array_t<typename S::Type, py::array::c_style> a(array);
    Image<T> image(static_cast<int>(a.shape(1)), static_cast<int>(a.shape(0)));
    const auto* data = reinterpret_cast<const T*>(a.data());
    std::copy(data, data + image.size(), image.pixels.begin());
    return image;
}

}  // namespace

std::string shape_text(const py::array& array) {
    return fmt::format("{} of {}", fmt::join(std::vector<Index>(array.shape(), array.shape() + array.ndim()), " x "),
                       py::str(array.dtype()).cast<std::string>());
}

ImageRgb8 rgb_from(const py::array& array, const char* name) { return image_from<Rgb8>(array, name, "uint8"); }
ImageMask mask_from(const py::object& array, const char* name) {
    return array.is_none() ? ImageMask{} : image_from<std::uint8_t>(py::array(array), name, "uint8");
}
ImageColor color_from(const py::array& array, const char* name) { return image_from<Vec3f>(array, name, "float32"); }
ImageF floats_from(const py::array& array, const char* name) { return image_from<float>(array, name, "float32"); }

Rigid pose_from(const py::object& matrix, const char* name) {
    if (matrix.is_none()) return {};
    const py::array_t<double, py::array::c_style | py::array::forcecast> m(matrix);
    if (m.ndim() != 2 || m.shape(1) != 4 || (m.shape(0) != 3 && m.shape(0) != 4))
        throw UsageError("{}: expected a matrix of 4 x 4, found {}", name, shape_text(m));
    const auto at = m.unchecked<2>();
    const auto row = [&](Index i) {
        return Vec3f{static_cast<float>(at(i, 0)), static_cast<float>(at(i, 1)), static_cast<float>(at(i, 2))};
    };
    const Rigid pose{{row(0), row(1), row(2)},
                     {static_cast<float>(at(0, 3)), static_cast<float>(at(1, 3)), static_cast<float>(at(2, 3))}};
    const Mat3f& r = pose.rotation;
    constexpr float kSlack = 1e-3f;
    if (!(std::fabs(length(r.row0) - 1) < kSlack && length(cross(r.row0, r.row1) - r.row2) < kSlack))
        throw UsageError("{}: expected a rotation and a place, found another matrix", name);
    return pose;
}

py::array_t<float> matrix_of_pose(const Rigid& pose) {
    py::array_t<float> out(std::vector<Index>{4, 4});
    auto m = out.mutable_unchecked<2>();
    const Vec3f rows[3] = {pose.rotation.row0, pose.rotation.row1, pose.rotation.row2};
    for (Index i = 0; i < 3; ++i) {
        for (Index j = 0; j < 3; ++j) m(i, j) = rows[i][static_cast<std::size_t>(j)];
        m(i, 3) = pose.translation[static_cast<std::size_t>(i)];
        m(3, i) = 0;
    }
    m(3, 3) = 1;
    return out;
}

py::object python_of(const Json& json) {
    return py::module_::import("json").attr("loads")(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}
std::string json_text(const py::object& value) {
    return py::module_::import("json").attr("dumps")(value, py::arg("ensure_ascii") = false).cast<std::string>();
}

}  // namespace fastscene::python
