// BRISQUE (Mittal, Moorthy, Bovik 2012): statistics of a picture, judged by a regression trained on people's scores.
// 0 (best) to about 100. Two variants give scores some points apart on the same picture, so each has a name:
//   authors: the authors' MATLAB features and their libsvm model (allmodel, allrange); zero border, antialiased half
//   size; opencv:  OpenCV's quality module and its own retrained model; single precision, clamped to 0..100.
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
// The variant is told by the files' content (libsvm text or OpenCV YAML). Throws Error naming the file.
BrisqueModel load_brisque_model(const std::filesystem::path& model, const std::filesystem::path& ranges);

// 18 numbers at each of two scales. Throws Error when they are not defined (a constant or tiny picture).
std::vector<double> brisque_features(const ImageRgb8& image, BrisqueVariant variant);
// The features as the regression sees them; "authors" rounds them as the text files in between do (6 decimals, then 6
// digits).
std::vector<double> brisque_scaled(const std::vector<double>& features, const BrisqueModel& model);
double brisque(const ImageRgb8& image, const BrisqueModel& model);

}  // namespace fastscene
