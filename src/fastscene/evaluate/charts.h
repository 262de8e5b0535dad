// Charts for the report: inline SVG that uses the page's colors (report.css). Escapes text.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fastscene {

struct Bar {
    std::string label, kind;  // kind: ours, source, peer, published; selects the color
    double value = 0;
    std::string text;  // the value as displayed
};
// Horizontal bars from zero, stacked, each under its label; `hint` says which direction is better.
std::string bar_chart(const std::string& title, const std::string& hint, const std::vector<Bar>& bars);

struct Curve {
    std::string name;
    std::vector<std::pair<double, double>> points;  // left to right
    bool dashed = false;
};
// Curves with a legend below; the value axis includes zero if that costs little space.
std::string line_chart(const std::string& title, const std::string& x_label, const std::string& y_label,
                       const std::vector<Curve>& curves);

std::string html_escaped(const std::string& text);

}  // namespace fastscene
