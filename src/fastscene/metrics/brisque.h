// BRISQUE (Mittal, Moorthy, Bovik 2012): a no-reference score by regression from picture statistics, trained on human
// opinion scores. 0 (best) to about 100. Two variants differ by some points on the same picture:
// authors: the authors' MATLAB features and libsvm model (allmodel, allrange); zero padding, antialiased half size;
// opencv: OpenCV's quality module with its own retrained model; single precision, clamped to 0..100.
#pragma once

#include <filesystem>
#include <vector>

#include "fastscene/image/image.h"
#include "fastscene/io/svr_file.h"

namespace fastscene {

inline constexpr int kBrisqueFeatures = 36;

enum class BrisqueVariant { authors, opencv };

struct BrisqueModel {
    BrisqueVariant variant = BrisqueVariant::authors;
    SvrModel regression;
    FeatureRanges ranges;
};
// The variant is recognized by the files' content (libsvm text or OpenCV YAML). Throws Error naming the file.
BrisqueModel load_brisque_model(const std::filesystem::path& model, const std::filesystem::path& ranges);

// 18 features at each of two scales. Throws Error if they are undefined (a constant or tiny picture).
std::vector<double> brisque_features(const ImageRgb8& image, BrisqueVariant variant);
// Normalized features as input of the regression; "authors" rounds them like the intermediate text files (6 decimals,
// then 6 digits).
std::vector<double> brisque_scaled(const std::vector<double>& features, const BrisqueModel& model);
double brisque(const ImageRgb8& image, const BrisqueModel& model);

}  // namespace fastscene
