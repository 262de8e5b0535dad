// Results as files: for programs (results.json, scenes.csv), for documents (table.md .csv .tex), for people (report.html).
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/json.h"

namespace fastscene {

void write_results(const std::filesystem::path& out, const Json& results);

// The parts, of results.json's content.
std::string table_markdown(const Json& results);
std::string table_csv(const Json& results);
std::string table_latex(const Json& results);     // rows of a tabular; what each column is stands in a comment
std::string scenes_csv(const Json& results);      // a line a scene, row and column
// `out`: where the pictures' paths start. They go into the page, reduced.
std::string report_html(const Json& results, const std::filesystem::path& out);

// A cell as it is written: "3.91", "inf", or "–" with nothing measured.
std::string cell_text(const Json& cell, int digits);
std::string row_title(const Json& row);
// Whether this cell is the best of the measured rows (at least two of them, published ones not among them).
bool is_best(const Json& results, const Json& row, const Json& column);
// Why cells of a column are empty, each reason once.
std::vector<std::string> reasons_of(const Json& results, const std::string& column);

}  // namespace fastscene
