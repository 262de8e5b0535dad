// Contents of table cells, independent of the output format: figures, what they omit, which is best, and footnotes.
// `results`: the content of results.json (rows.h describes the rows), including that of earlier versions.
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/json.h"

namespace fastscene {

// "3.91", "inf", or "–" if nothing was measured.
std::string cell_text(const Json& cell, int digits);
// Standard deviation between scenes; empty: none.
std::string deviation_text(const Json& cell, int digits);
// "4 of 5" if a mean does not cover all scenes of its row; else empty.
std::string share_text(const Json& cell);

std::string row_title(const Json& row);
// "Them (published)", "FastScene (the paper, published)".
std::string published_title(const Json& row);
// "4" or "4 of 5": the number of scenes that a row's means cover.
std::string row_scenes(const Json& row);
// Whether rows were asked for different numbers of scenes, so that the table must state them.
bool scene_counts_differ(const Json& results);

// Whether this cell is the best of the measured rows: at least two, all over the same scenes, and not equal in the
// displayed digits. Published rows are excluded.
bool is_best(const Json& results, const Json& row, const Json& column);

// Reasons for empty cells and omissions, each listed once and marked a, b, c …
struct Footnote {
    std::string mark, columns, text;  // columns: labels of the columns in which it occurs
};
class Footnotes {
  public:
    explicit Footnotes(const Json& results);
    const std::vector<Footnote>& all() const { return list_; }
    std::string marks(const Json& cell) const;  // "a, c"; empty: none

  private:
    std::vector<Footnote> list_;
};
std::vector<std::string> cell_notes(const Json& cell);

// A line per failed scene; `variant` (if not empty): only of this row.
std::vector<std::string> failures_of(const Json& results, const std::string& variant = "");
// Which parameter files the measures used, by column; states if they differ between scenes.
struct ParameterNote {
    std::string column, text;
    bool mixed = false;
};
std::vector<ParameterNote> parameter_notes(const Json& results);

}  // namespace fastscene
