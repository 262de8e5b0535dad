// Training outputs besides the splats: curves, and renderings of the held-out views.
#pragma once

#include <filesystem>

#include "fastscene/splat/splat.h"

namespace fastscene {

// curve.json, curve.csv, curve.svg; with held-out views eval/NAME.png: rendering on the left, photo on the right.
void save_curves(const std::filesystem::path& out, const FittedSplats& fitted);
// What trained the splats in `dir`, according to its curve.json; empty if that does not say.
std::string device_of_fit(const std::filesystem::path& dir);

}  // namespace fastscene
