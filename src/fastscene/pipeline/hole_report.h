// The hole table of a run, or of a panorama with its range, as people and programs read it.
#pragma once

#include <filesystem>
#include <string>

#include "fastscene/walk/hole_table.h"

namespace fastscene {

// Rows of a run that has got as far as depth. `truth`: also against the room behind the prompt; UsageError where there
// is none.
std::vector<HoleRow> hole_table_of_run(const std::filesystem::path& run_dir, bool truth, const Run& run);
// Rows of a user's panorama (for its size) and range map.
std::vector<HoleRow> hole_table_of_picture(const std::filesystem::path& picture, const std::filesystem::path& range_map,
                                           const Run& run);
// Writes hole_table.txt, .json and .svg into a folder, made if need be.
void save_hole_table(const std::filesystem::path& folder, const std::vector<HoleRow>& rows);

}  // namespace fastscene
