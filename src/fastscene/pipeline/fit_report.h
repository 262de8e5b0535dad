// What training leaves beside the splats: its curves, and the held-out views as it shows them.
#pragma once

#include <filesystem>

#include "fastscene/splat/splat.h"

namespace fastscene {

// curve.json, curve.csv, curve.svg; with held-out views eval/NAME.png: the splats' picture on the left, the truth on
// the right.
void save_curves(const std::filesystem::path& out, const FittedSplats& fitted);

}  // namespace fastscene
