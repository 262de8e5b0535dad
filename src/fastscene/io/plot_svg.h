// Plots: curves as a self-contained SVG file, for reports.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/math/vec.h"

namespace fastscene {

struct PlotCurve {
    std::string name;
    std::vector<Vec2d> points;  // left to right
    bool dashed = false;
};
struct Plot {
    std::string title, x_label, y_label;
    std::vector<PlotCurve> curves;
};
// Plots side by side with common scales; equal names have equal colors. Throws Error if the file cannot be written.
void save_plots_svg(const std::filesystem::path& path, const std::vector<Plot>& plots);

}  // namespace fastscene
