// Table rows: means over scenes and seeds, with published figures and other systems' results.
#pragma once

#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/evaluate/suite.h"

namespace fastscene {

// [{"name", "group", "kind": ours|source|peer|published, "scenes", "of", "cells"}], published ones first; points of a
// curve also have "series" and "at". "scenes": how many were measured, "of" how many the suite asks for. A cell is
// {"value", "sd", "count", "of", "scenes", "notes", "pictures"}, without entries that do not apply:
// value: mean over the scenes that have a figure, `count` of `of`, listed in "scenes"; infinite ones are excluded,
// "inf" if all are infinite;
// sd: standard deviation between scenes, for two or more;
// notes: why the value is missing, or what it omits; prefixed by scene names if they do not hold for the whole row;
// pictures: {"counted", "of"} if means over pictures omit some.
// `records`: evaluate's records of the scenes of `suite`.
Json table_rows(const Suite& suite, const std::vector<Json>& records);

// {column: [{"files", "identity", "scenes"}]}: the parameters that measures used. With more than one entry a column's
// figures are not comparable.
Json parameters_used(const Suite& suite, const std::vector<Json>& records);

}  // namespace fastscene
