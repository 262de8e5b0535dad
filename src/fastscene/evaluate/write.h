// Results as files: for programs (results.json, scenes.csv), for documents (table.md .csv .tex), for people
// (report.html).
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/base/json.h"

namespace fastscene {

void write_results(const std::filesystem::path& out, const Json& results);

// The parts, of results.json's content.
std::string table_markdown(const Json& results);
std::string table_csv(const Json& results);    // for each column its mean, _sd (between scenes) and _n (of how many)
std::string table_latex(const Json& results);  // rows of a tabular; what each column is stands in a comment
std::string scenes_csv(const Json& results);   // a line a scene, row and column
// `out`: where the pictures' paths start. They go into the page, reduced.
std::string report_html(const Json& results, const std::filesystem::path& out);

}  // namespace fastscene
