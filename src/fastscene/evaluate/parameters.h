// Identity of a measure's parameter files and networks, by content: cached scores are reused only if it matches.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fastscene {

struct ParameterFiles {
    std::vector<std::filesystem::path> files;  // as in measure_files() (metrics/images.h)
    std::string identity;                      // hash of their content, 32 digits; empty: the measure needs none
};
ParameterFiles parameters_of(const std::filesystem::path& weights, const std::string& image_measure);

}  // namespace fastscene
