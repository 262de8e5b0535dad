// The weight files that a panorama generation reads: exactly those determine its result, so they enter its cache key.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fastscene {

// `weights` and `from_photo` as in Diffusion360, `to` as in Upscale360Settings. In a fixed order; file headers are read
// to find out which variant exists. Throws Error if a component is missing.
std::vector<std::filesystem::path> painting_files(const std::filesystem::path& weights, bool from_photo);
std::vector<std::filesystem::path> enlarging_files(const std::filesystem::path& weights, const std::string& to);

}  // namespace fastscene
