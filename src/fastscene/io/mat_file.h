// MATLAB's MAT files, version 5, as far as published parameter files need it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fastscene {

// A real matrix in row-major order.
struct MatMatrix {
    int rows = 0, columns = 0;
    std::vector<double> values;
};
// All two-dimensional real double matrices of the file, by name; others are skipped. Throws Error naming the file and
// the problem.
std::map<std::string, MatMatrix> load_mat_file(const std::filesystem::path& path);

}  // namespace fastscene
