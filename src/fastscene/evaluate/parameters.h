// What a measure's figures hang on besides the pictures: its parameter files and networks, by content. A score is used
// again only where they are the same.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fastscene {

struct ParameterFiles {
    std::vector<std::filesystem::path> files;  // as measure_files() has them (metrics/images.h)
    std::string identity;                      // of their content, 32 digits; empty: the measure needs none
};
ParameterFiles parameters_of(const std::filesystem::path& weights, const std::string& image_measure);

}  // namespace fastscene
