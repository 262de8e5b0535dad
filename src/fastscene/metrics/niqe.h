// NIQE (Mittal, Soundararajan, Bovik 2013): distance between the statistics of a picture's blocks and those of
// undistorted photographs. Lower is better; 3 to 4 for a good photograph. Follows the authors' MATLAB code.
#pragma once

#include <filesystem>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/metrics/naturalness.h"

namespace fastscene {

inline constexpr int kNiqeFeatures = 36;
inline constexpr int kNiqeBlock = 96;  // pixels; 48 at the second scale

// A Gaussian over the 36 features of blocks of pristine pictures.
struct NiqeModel {
    std::vector<double> mean;              // 36
    std::vector<double> covariance;        // 36 x 36
    std::size_t blocks = 0, pictures = 0;  // that it was fitted to; 0: unknown
};

// Loads the authors' modelparameters.mat, or a .json written by save_niqe_model, recognized by content. Throws Error
// naming the file, expected and actual.
NiqeModel load_niqe_model(const std::filesystem::path& path);
void save_niqe_model(const std::filesystem::path& path, const NiqeModel& model);

// Conversion to gray. The authors' code uses MATLAB's rgb2gray; BasicSR, whose figures are widely quoted, uses the Y of
// YCbCr with the same parameters, which changes scores by a few tenths.
enum class NiqeGray { authors, luma };

// Throws Error if the score is undefined: fewer than two 96 x 96 blocks with any structure.
double niqe(const ImageRgb8& image, const NiqeModel& model, NiqeGray gray = NiqeGray::authors);

// One row of 36 features per full 96 x 96 block, and each block's mean local contrast.
struct NiqeBlocks {
    std::vector<std::vector<double>> features;
    std::vector<double> sharpness;
};
NiqeBlocks niqe_blocks(const Plane& gray);

// Fits a model to one's own pictures, using blocks sharper than 0.75 of each picture's sharpest, like the authors.
// Throws Error if `pictures` give fewer than kLeastNiqeBlocks, too few for a covariance of 36 features. Warns below
// kGoodNiqeBlocks, where its relative error is sqrt(36 / 1000), a fifth, and about pictures that are unreadable or give
// no block.
inline constexpr std::size_t kLeastNiqeBlocks = 100, kGoodNiqeBlocks = 1000;
NiqeModel fit_niqe(const std::vector<std::filesystem::path>& pictures, const Run& run);

}  // namespace fastscene
