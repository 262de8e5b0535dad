// The written story of a training: curves.csv and its plots. Private to nn/training.cc.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fastscene::nn {

// Columns of what held-out data say begin so.
inline constexpr std::string_view kHeldOut = "held-out ";

class TrainingLog {
  public:
    // Goes on with the file that is there, as far as `step`: later rows belong to steps that will be done again.
    TrainingLog(std::filesystem::path folder, std::int64_t step);
    // Values by column; a new name opens a column. NaN: nothing to say.
    void add(std::int64_t step, double minutes, const std::vector<std::pair<std::string, double>>& values);
    // Writes curves.csv and a curve-NAME.svg for each column; names that start with kHeldOut are drawn over those
    // without it.
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
