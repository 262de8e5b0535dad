// NIQE (Mittal, Soundararajan, Bovik 2013): how far the statistics of a picture's blocks lie from those of
// undistorted photographs. Lower is better; about 3 to 4 for a good photograph. Follows the authors' MATLAB code.
#pragma once

#include <filesystem>
#include <vector>

#include "fastscene/base/run.h"
#include "fastscene/image/image.h"

namespace fastscene {

inline constexpr int kNiqeFeatures = 36;
inline constexpr int kNiqeBlock = 96;  // pixels; 48 at the second scale

// A Gaussian over the 36 features of a block of undistorted pictures.
struct NiqeModel {
    std::vector<double> mean;        // 36
    std::vector<double> covariance;  // 36 x 36
};

// The authors' modelparameters.mat, or a .json that save_niqe_model wrote; told by content.
// Throws Error naming the file, what was expected and what was found.
NiqeModel load_niqe_model(const std::filesystem::path& path);
void save_niqe_model(const std::filesystem::path& path, const NiqeModel& model);

// Throws Error when the score is not defined: the picture has fewer than two 96 x 96 blocks with any structure.
double niqe(const ImageRgb8& image, const NiqeModel& model);

// One row of 36 features for each whole 96 x 96 block, and the mean local contrast of each block.
struct NiqeBlocks {
    std::vector<std::vector<double>> features;
    std::vector<double> sharpness;
};
NiqeBlocks niqe_blocks(const ImageRgb8& image);

// A model of one's own pictures: of each picture the blocks that are sharper than 0.75 of its sharpest, as the authors did.
// Throws Error when `pictures` give fewer than 100 blocks: 36 features need more than that to have a covariance.
NiqeModel fit_niqe(const std::vector<std::filesystem::path>& pictures, const Run& run);

}  // namespace fastscene
