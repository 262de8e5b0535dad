// What the cells of a table say, whatever it is written in: figures, what they leave out, which is the best, and the
// notes below. `results`: results.json's content (rows.h has the rows'); those that earlier versions wrote are read
// too.
#pragma once

#include <string>
#include <vector>

#include "fastscene/base/json.h"

namespace fastscene {

// "3.91", "inf", or "–" with nothing measured.
std::string cell_text(const Json& cell, int digits);
// The deviation between scenes; empty: none.
std::string deviation_text(const Json& cell, int digits);
// "4 of 5" where a mean is not over all scenes of its row; else empty.
std::string share_text(const Json& cell);

std::string row_title(const Json& row);
// "Them (published)", "FastScene (the paper, published)".
std::string published_title(const Json& row);
// "4" or "4 of 5": what a row's means are over.
std::string row_scenes(const Json& row);
// Rows that were asked for other numbers of scenes: the table says how many.
bool scene_counts_differ(const Json& results);

// Whether this cell is the best of the measured rows: at least two of them, all over the same scenes, and not the same
// to the digits that are shown. Published rows are not among them.
bool is_best(const Json& results, const Json& row, const Json& column);

// Why cells are empty and what figures leave out: each reason once, marked a, b, c …
struct Footnote {
    std::string mark, columns, text;  // columns: labels of those it stands in
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

// A line for every scene that failed; `variant` (not empty): of this row alone.
std::vector<std::string> failures_of(const Json& results, const std::string& variant = "");
// Which parameter files the measures were given, by column; says so where scenes were given different ones.
struct ParameterNote {
    std::string column, text;
    bool mixed = false;
};
std::vector<ParameterNote> parameter_notes(const Json& results);

}  // namespace fastscene
