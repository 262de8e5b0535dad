// Support vector regression with a Gaussian kernel, in libsvm's and OpenCV's file formats: the trained part of BRISQUE.
#pragma once

#include <filesystem>
#include <vector>

namespace fastscene {

// value(x) = sum_i weight_i exp(-gamma |x - vector_i|^2) - rho
struct SvrModel {
    int features = 0;
    double gamma = 0, rho = 0;
    std::vector<double> weights;
    std::vector<double> vectors;  // weights.size() x features
    double value(const std::vector<double>& x) const;
};
// Maps each feature linearly from [low, high] to [-1, 1], extrapolating outside.
struct FeatureRanges {
    std::vector<double> low, high;
    std::vector<double> scaled(const std::vector<double>& x) const;
};

// libsvm's text formats: models of svm-train (epsilon_svr, rbf) and ranges of svm-scale -s (to -1 … 1).
SvrModel load_libsvm_model(const std::filesystem::path& path);
FeatureRanges load_libsvm_ranges(const std::filesystem::path& path);
// OpenCV's YAML formats: cv::ml::SVM (EPS_SVR, RBF) and a 2-row matrix "range" (low, high).
SvrModel load_opencv_svr(const std::filesystem::path& path);
FeatureRanges load_opencv_ranges(const std::filesystem::path& path);

}  // namespace fastscene
