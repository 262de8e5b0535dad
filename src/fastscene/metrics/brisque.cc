#include "fastscene/metrics/brisque.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/leading_number.h"
#include "fastscene/metrics/brisque_opencv.h"
#include "fastscene/metrics/naturalness.h"

namespace fastscene {
namespace {

constexpr int kScales = 2;

std::vector<double> authors_features(const ImageRgb8& image) {
    std::vector<double> out;
    Plane plane = matlab_gray(image);
    for (int scale = 0; scale < kScales; ++scale) {
        const Plane structure = normalized(plane, Border::zero).structure;
        const Block all{0, 0, plane.width, plane.height};
        const Ggd own = fit_ggd(structure.pixels);
        out.insert(out.end(), {own.alpha, own.variance});
        constexpr int shifts[4][2] = {{0, 1}, {1, 0}, {1, 1}, {-1, 1}};  // rows, columns
        for (const auto& [dy, dx] : shifts) {
            const Aggd pair = fit_aggd(neighbor_products(structure, all, dy, dx));
            const double mean = (pair.right_std - pair.left_std) * pair.ratio() * pair.scale();
            out.insert(out.end(), {pair.alpha, mean, pair.left_std * pair.left_std, pair.right_std * pair.right_std});
        }
        plane = matlab_half(plane);
    }
    return out;
}

}  // namespace

BrisqueModel load_brisque_model(const std::filesystem::path& model, const std::filesystem::path& ranges) {
    const bool opencv = read_file(model).starts_with("%YAML");
    BrisqueModel out{opencv ? BrisqueVariant::opencv : BrisqueVariant::authors,
                     opencv ? load_opencv_svr(model) : load_libsvm_model(model),
                     opencv ? load_opencv_ranges(ranges) : load_libsvm_ranges(ranges)};
    if (out.regression.features != kBrisqueFeatures)
        throw Error("{}: expected a regression over {} features, found {}", model.string(), kBrisqueFeatures,
                    out.regression.features);
    if (out.ranges.low.size() != kBrisqueFeatures)
        throw Error("{}: expected ranges of {} features, found {}", ranges.string(), kBrisqueFeatures,
                    out.ranges.low.size());
    return out;
}

std::vector<double> brisque_features(const ImageRgb8& image, BrisqueVariant variant) {
    constexpr int least = 4;  // minimum side: below it the second scale has no usable neighbours
    if (image.width < least || image.height < least)
        throw Error("BRISQUE: expected a picture of at least {0} x {0} pixels, found {1} x {2}", least, image.width,
                    image.height);
    if (is_constant(image))
        throw Error("BRISQUE: expected a picture with structure, found one constant color ({} x {})", image.width,
                    image.height);
    std::vector<double> out = variant == BrisqueVariant::opencv ? opencv_brisque_features(image)
                                                                : authors_features(image);
    if (!std::all_of(out.begin(), out.end(), [](double v) { return std::isfinite(v); }))
        throw Error(
            "BRISQUE: expected a picture with structure, found one too even, too regular or too small for its "
            "statistics ({} x {})",
            image.width, image.height);
    return out;
}

std::vector<double> brisque_scaled(const std::vector<double>& features, const BrisqueModel& model) {
    if (model.variant == BrisqueVariant::opencv) return model.ranges.scaled(features);
    std::vector<double> out = features;
    for (double& v : out) v = *number_in(fmt::format("{:.6f}", v));
    out = model.ranges.scaled(out);
    for (double& v : out) v = *number_in(fmt::format("{:.6g}", v));
    return out;
}

double brisque(const ImageRgb8& image, const BrisqueModel& model) {
    const double score = model.regression.value(brisque_scaled(brisque_features(image, model.variant), model));
    return model.variant == BrisqueVariant::opencv ? std::clamp(score, 0.0, 100.0) : score;
}

}  // namespace fastscene
