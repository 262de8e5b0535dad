// The data card: README.md in the folder of a set. What is in it, how it was made, and under which terms.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/dataset/statistics.h"

namespace fastscene::dataset {

std::string card_of(const DataSet& set, const Statistics& statistics);
// Writes README.md of a complete set, and returns its path.
std::filesystem::path write_card(const std::filesystem::path& folder);
// Records in dataset.json the licence chosen by the publisher of the dataset.
void choose_license(const std::filesystem::path& folder, const std::string& license);

}  // namespace fastscene::dataset
