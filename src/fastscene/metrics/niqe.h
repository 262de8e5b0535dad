// NIQE (Mittal, Soundararajan, Bovik 2013): how far the statistics of a picture's blocks lie from those of
// undistorted photographs. Lower is better; about 3 to 4 for a good photograph. Follows the authors' MATLAB code.
#pragma once

#include <filesystem>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/metrics/naturalness.h"

namespace fastscene {

inline constexpr int kNiqeFeatures = 36;
inline constexpr int kNiqeBlock = 96;  // pixels; 48 at the second scale

// A Gaussian over the 36 features of a block of undistorted pictures.
struct NiqeModel {
    std::vector<double> mean;              // 36
    std::vector<double> covariance;        // 36 x 36
    std::size_t blocks = 0, pictures = 0;  // that it was fitted to; 0: not known
};

// The authors' modelparameters.mat, or a .json that save_niqe_model wrote; told by content.
// Throws Error naming the file, what was expected and what was found.
NiqeModel load_niqe_model(const std::filesystem::path& path);
void save_niqe_model(const std::filesystem::path& path, const NiqeModel& model);

// Which gray of a color picture is measured. The authors' code turns pictures gray as MATLAB's rgb2gray does; BasicSR,
// whose figures are much quoted, takes the Y of YCbCr with the same parameters, which moves a score by a few tenths.
enum class NiqeGray { authors, luma };

// Throws Error when the score is not defined: the picture has fewer than two 96 x 96 blocks with any structure.
double niqe(const ImageRgb8& image, const NiqeModel& model, NiqeGray gray = NiqeGray::authors);

// One row of 36 features for each whole 96 x 96 block, and the mean local contrast of each block.
struct NiqeBlocks {
    std::vector<std::vector<double>> features;
    std::vector<double> sharpness;
};
NiqeBlocks niqe_blocks(const Plane& gray);

// A model of one's own pictures: of each picture the blocks that are sharper than 0.75 of its sharpest, as the authors
// did. Throws Error when `pictures` give fewer than kLeastNiqeBlocks: 36 features need more than that to have a
// covariance. Warns below kGoodNiqeBlocks, where a covariance of 36 features is known to sqrt(36 / 1000), a fifth, of
// pictures that give no block, and of those that cannot be read.
inline constexpr std::size_t kLeastNiqeBlocks = 100, kGoodNiqeBlocks = 1000;
NiqeModel fit_niqe(const std::vector<std::filesystem::path>& pictures, const Run& run);

}  // namespace fastscene
