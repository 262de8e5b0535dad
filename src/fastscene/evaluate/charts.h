// Charts for the report: SVG that stands in a page and takes its colors (report.css). Text is escaped here.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fastscene {

struct Bar {
    std::string label, kind;  // kind: ours, source, peer, published: its color
    double value = 0;
    std::string text;  // the value as it is written
};
// Horizontal bars from zero, one below the other, each under its label; `hint` says which way is better.
std::string bar_chart(const std::string& title, const std::string& hint, const std::vector<Bar>& bars);

struct Curve {
    std::string name;
    std::vector<std::pair<double, double>> points;  // left to right
    bool dashed = false;
};
// Curves with their names at the end of a legend below; the value axis starts at zero where that costs little.
std::string line_chart(const std::string& title, const std::string& x_label, const std::string& y_label,
                       const std::vector<Curve>& curves);

std::string html_escaped(const std::string& text);

}  // namespace fastscene
