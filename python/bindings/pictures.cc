#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.h"
#include "bind.h"
#include "calls.h"
#include "fastscene/image/color.h"
#include "fastscene/image/ssim.h"
#include "fastscene/io/gpano_mark.h"
#include "fastscene/io/image_io.h"
#include "fastscene/metrics/images.h"

namespace fastscene::python {
namespace {

void save_picture(const std::filesystem::path& path, const py::array& picture, bool panorama) {
    const ImageRgb8 image = rgb_from(picture, "picture");
    const std::string ending = path.extension().string();
    if (ending != ".png" && ending != ".jpg" && ending != ".jpeg")
        throw UsageError("{}: expected a name that ends in .png or .jpg", path.string());
    const py::gil_scoped_release unlocked;
    if (panorama) save_panorama(path, image);
    else if (ending == ".png") save_png(path, image);
    else save_jpeg(path, image);
}

Ssim ssim_named(const std::string& name) {
    if (name == "splats") return Ssim::splats;
    if (name == "valid") return Ssim::valid;
    if (name == "wang") return Ssim::wang;
    throw UsageError("kind: expected splats, valid or wang, found {}", name);
}

void check_same_size(const ImageRgb8& a, const ImageRgb8& b) {
    if (a.width != b.width || a.height != b.height)
        throw UsageError("expected pictures of one size, found {} x {} and {} x {}", a.width, a.height, b.width,
                         b.height);
}

}  // namespace

void bind_pictures(py::module_& m) {
    m.def(
        "load_rgb8",
        [](const std::filesystem::path& path) {
            ImageRgb8 image;
            {
                const py::gil_scoped_release unlocked;
                image = load_rgb8(path);
            }
            return array_of(std::move(image));
        },
        py::arg("path"), "A picture as height x width x 3 of uint8: .png, .jpg, .webp, .tif.");
    m.def("save_picture", &save_picture, py::arg("path"), py::arg("picture"), py::arg("panorama") = false,
          "Writes .png or .jpg; panorama=True marks it as a 360 degree picture.");
    m.def(
        "srgb8_from_linear",
        [](const py::array& color) { return array_of(srgb8_from_linear(color_from(color, "color"))); },
        py::arg("color"), "Linear float32 color as sRGB of uint8.");
    m.def(
        "psnr",
        [](const py::array& a, const py::array& b) {
            const ImageRgb8 x = rgb_from(a, "a"), y = rgb_from(b, "b");
            check_same_size(x, y);
            return psnr(x, y);
        },
        py::arg("a"), py::arg("b"), "Peak signal to noise ratio in dB of two pictures of uint8.");
    m.def(
        "ssim",
        [](const py::array& a, const py::array& b, const std::string& kind) {
            const ImageRgb8 x = rgb_from(a, "a"), y = rgb_from(b, "b");
            check_same_size(x, y);
            return ssim(x, y, ssim_named(kind));
        },
        py::arg("a"), py::arg("b"), py::arg("kind") = "splats",
        "Structural similarity: splats (as papers of 3D Gaussians), valid (scikit-image) or wang (the 2004 paper).");
    m.def(
        "measure_images",
        [](const std::filesystem::path& pictures, const std::filesystem::path& reference, const std::string& prompt,
           const std::vector<std::string>& wanted) {
            return python_of(long_call(0, py::none(), [&](const Run& run, Caller&) {
                return measure_images({pictures, reference, prompt, metrics_weights({}), wanted}, run);
            }));
        },
        py::arg("pictures"), py::arg("reference") = "", py::arg("prompt") = "",
        py::arg("wanted") = std::vector<std::string>{},
        "Measures a picture or a folder of pictures: psnr, ssim, lpips, niqe, brisque, clip, as far as inputs and "
        "models allow.");
}

}  // namespace fastscene::python
