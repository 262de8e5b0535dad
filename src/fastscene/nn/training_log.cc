#include "fastscene/nn/training_log.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/leading_number.h"
#include "fastscene/io/plot_svg.h"

namespace fastscene::nn {
namespace {

constexpr std::size_t kMostPoints = 150;  // of a curve; longer ones are downsampled

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> out;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) out.push_back(cell);
    return out;
}

double number(const std::string& cell) { return number_in(cell).value_or(std::nan("")); }

// Averages groups of consecutive points.
std::vector<Vec2d> thinned(const std::vector<Vec2d>& points) {
    const std::size_t together = (points.size() + kMostPoints - 1) / kMostPoints;
    std::vector<Vec2d> out;
    for (std::size_t i = 0; i < points.size(); i += together) {
        const std::size_t count = std::min(together, points.size() - i);
        Vec2d& mean = out.emplace_back();
        for (std::size_t k = i; k < i + count; ++k) {
            mean.x += points[k].x / static_cast<double>(count);
            mean.y += points[k].y / static_cast<double>(count);
        }
    }
    return out;
}

}  // namespace

TrainingLog::TrainingLog(std::filesystem::path folder, std::int64_t step) : folder_(std::move(folder)) {
    const auto path = folder_ / "curves.csv";
    if (step == 0 || !std::filesystem::exists(path)) return;
    std::istringstream in(read_file(path));
    std::string line;
    std::getline(in, line);
    columns_ = cells(line);
    if (columns_.size() < 2) throw Error("{}: expected columns step, minutes …, found \"{}\"", path.string(), line);
    columns_.erase(columns_.begin(), columns_.begin() + 2);
    while (std::getline(in, line)) {
        std::vector<std::string> row = cells(line);
        row.resize(columns_.size() + 2);
        if (number(row[0]) > static_cast<double>(step)) break;
        Row& read = rows_.emplace_back(Row{static_cast<std::int64_t>(number(row[0])), number(row[1]), {}});
        for (std::size_t i = 2; i < row.size(); ++i) read.values.push_back(number(row[i]));
    }
}

void TrainingLog::add(std::int64_t step, double minutes, const std::vector<std::pair<std::string, double>>& values) {
    if (rows_.empty() || rows_.back().step != step) rows_.push_back({step, minutes, {}});
    for (const auto& [name, value] : values) {
        auto at = std::find(columns_.begin(), columns_.end(), name);
        if (at == columns_.end()) at = columns_.insert(columns_.end(), name);
        const auto column = static_cast<std::size_t>(at - columns_.begin());
        auto& row = rows_.back().values;
        if (row.size() <= column) row.resize(column + 1, std::nan(""));
        row[column] = value;
    }
}

void TrainingLog::save() const {
    std::string text = "step,minutes";
    for (const std::string& name : columns_) text += "," + name;
    text += "\n";
    for (const Row& row : rows_) {
        text += fmt::format("{},{:.2f}", row.step, row.minutes);
        for (std::size_t i = 0; i < columns_.size(); ++i)
            text += i < row.values.size() && std::isfinite(row.values[i]) ? fmt::format(",{:.6g}", row.values[i]) : ",";
        text += "\n";
    }
    write_file(folder_ / "curves.csv", text);
    save_plots();
}

void TrainingLog::save_plots() const {
    const auto curve = [&](std::size_t column) {
        PlotCurve out{columns_[column].starts_with(kHeldOut) ? "held out" : "training", {}, false};
        for (const Row& row : rows_)
            if (column < row.values.size() && std::isfinite(row.values[column]))
                out.points.push_back({static_cast<double>(row.step), row.values[column]});
        out.points = thinned(out.points);
        return out;
    };
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const std::string name = columns_[i].starts_with(kHeldOut) ? columns_[i].substr(kHeldOut.size()) : columns_[i];
        if (name != columns_[i] && std::find(columns_.begin(), columns_.end(), name) != columns_.end())
            continue;  // drawn together with its counterpart
        Plot plot{name, "step", "", {curve(i)}};
        const auto brother = std::find(columns_.begin(), columns_.end(), std::string(kHeldOut) + name);
        if (brother != columns_.end() && name == columns_[i])
            plot.curves.push_back(curve(static_cast<std::size_t>(brother - columns_.begin())));
        std::string file = name;
        std::replace_if(
            file.begin(), file.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '-');
        save_plots_svg(folder_ / ("curve-" + file + ".svg"), {plot});
    }
}

}  // namespace fastscene::nn
