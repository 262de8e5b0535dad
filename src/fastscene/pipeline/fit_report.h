// Training outputs besides the splats: curves, and renderings of the held-out views.
#pragma once

#include <filesystem>

#include "fastscene/splat/splat.h"

namespace fastscene {

// curve.json, curve.csv, curve.svg; with held-out views eval/NAME.png: rendering on the left, photo on the right.
void save_curves(const std::filesystem::path& out, const FittedSplats& fitted);

}  // namespace fastscene
