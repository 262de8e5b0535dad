// The hole table of a run, or of a panorama with range, for people and programs.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/walk/hole_table.h"

namespace fastscene {

// Rows for a run that has finished its depth stage. `truth`: also compares with the prompt's room; UsageError if there
// is none.
std::vector<HoleRow> hole_table_of_run(const std::filesystem::path& run_dir, bool truth, const Run& run);
// Rows for a user's panorama (only its size matters) and range map.
std::vector<HoleRow> hole_table_of_picture(const std::filesystem::path& picture, const std::filesystem::path& range_map,
                                           const Run& run);
// Writes hole_table.txt, .json and .svg into a folder, which is created if necessary.
void save_hole_table(const std::filesystem::path& folder, const std::vector<HoleRow>& rows);

}  // namespace fastscene
