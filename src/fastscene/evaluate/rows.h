// Rows of the table: means over scenes and seeds, published figures and other systems' beside them.
#pragma once

#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/evaluate/suite.h"

namespace fastscene {

// [{"name", "group", "kind": ours|source|peer|published, "scenes", "cells": {column: {"value", "sd", "count"} or {"note"}}}], published ones first;
// points of a curve also have "series" and "at".
// `records`: what evaluate keeps of each scene. A cell is the mean over the scenes that have a figure; infinite ones do not count. Its
// note says why it has none.
Json table_rows(const Suite& suite, const std::vector<Json>& records);

}  // namespace fastscene
