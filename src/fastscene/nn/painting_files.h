// Which files of a folder of weights a painting opens: those, and no others, make it what it is.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fastscene {

// `weights` and `from_photo` as Diffusion360 takes them, `to` as Upscale360Settings has it. In a fixed order; headers
// of the weights are read, to see which of their forms is there. Throws Error when a component is missing.
std::vector<std::filesystem::path> painting_files(const std::filesystem::path& weights, bool from_photo);
std::vector<std::filesystem::path> enlarging_files(const std::filesystem::path& weights, const std::string& to);

}  // namespace fastscene
