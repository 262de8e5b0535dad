// The log of a training: curves.csv and its plots. Private to nn/training.cc.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fastscene::nn {

// Prefix of the columns measured on held-out data.
inline constexpr std::string_view kHeldOut = "held-out ";

class TrainingLog {
  public:
    // Continues an existing file up to `step`: later rows belong to steps that will be repeated.
    TrainingLog(std::filesystem::path folder, std::int64_t step);
    // Values by column; a new name adds a column. NaN: no value.
    void add(std::int64_t step, double minutes, const std::vector<std::pair<std::string, double>>& values);
    // Writes curves.csv and a curve-NAME.svg per column; kHeldOut columns are drawn over those of the same name without
    // the prefix.
    void save() const;
    double minutes() const { return rows_.empty() ? 0 : rows_.back().minutes; }

  private:
    struct Row {
        std::int64_t step;
        double minutes;
        std::vector<double> values;
    };
    void save_plots() const;

    std::filesystem::path folder_;
    std::vector<std::string> columns_;
    std::vector<Row> rows_;
};

}  // namespace fastscene::nn
