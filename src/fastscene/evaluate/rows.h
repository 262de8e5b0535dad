// Rows of the table: means over scenes and seeds, published figures and other systems' beside them.
#pragma once

#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/evaluate/suite.h"

namespace fastscene {

// [{"name", "group", "kind": ours|source|peer|published, "scenes", "of", "cells"}], published ones first; points of a
// curve also have "series" and "at". "scenes": how many were measured, "of" how many the suite asks for. A cell:
// {"value", "sd", "count", "of", "scenes", "notes", "pictures"}, what does not apply is not there.
//   value     the mean over the scenes that have a figure, `count` of `of`; "scenes" says which. Infinite ones do not
//   count; "inf" where all are sd        the deviation between scenes, of two and more notes     why it has no value,
//   or what the value leaves out; those that do not hold for the whole row begin with their scenes pictures {"counted",
//   "of"} where means over pictures left some out
// `records`: what evaluate keeps of each scene of `suite`.
Json table_rows(const Suite& suite, const std::vector<Json>& records);

// {column: [{"files", "identity", "scenes"}]}: what the measures were given. More than one for a column: its figures do
// not compare.
Json parameters_used(const Suite& suite, const std::vector<Json>& records);

}  // namespace fastscene
