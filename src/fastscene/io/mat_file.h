// MATLAB's MAT files, version 5: as much of them as parameter files of published methods use.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fastscene {

// A real matrix; values row by row.
struct MatMatrix {
    int rows = 0, columns = 0;
    std::vector<double> values;
};
// All two-dimensional real double matrices of the file, by name; others are passed over.
// Throws Error naming the file and what is wrong with it.
std::map<std::string, MatMatrix> load_mat_file(const std::filesystem::path& path);

}  // namespace fastscene
