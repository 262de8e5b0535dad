// Writes results for programs (results.json, scenes.csv), documents (table.md .csv .tex) and people (report.html).
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/json.h"

namespace fastscene {

void write_results(const std::filesystem::path& out, const Json& results);

// The individual files, from the content of results.json.
std::string table_markdown(const Json& results);
std::string table_csv(const Json& results);  // for each column its mean, _sd (between scenes) and _n (number of scenes)
std::string table_latex(const Json& results);  // rows of a tabular; a comment explains the columns
std::string scenes_csv(const Json& results);   // one line per scene, row and column
// `out`: base of the pictures' paths; they are embedded, downsampled.
std::string report_html(const Json& results, const std::filesystem::path& out);

}  // namespace fastscene
