// Data files installed with the program, such as the viewer page. Install and build trees have the same layout, so one
// rule finds them, and no absolute path of the build machine is compiled in.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace fastscene {

// Folders searched for data files, in order:
// - $FASTSCENE_DATA_DIR
// - ../share/fastscene relative to the executable's folder
// - fastscene/ in each folder of $XDG_DATA_DIRS (default: /usr/local/share and /usr/share), for programs that link the
// library
// Folders need not exist.
std::vector<std::filesystem::path> data_folders();

// The first existing path of `relative` in these folders; empty if there is none.
std::optional<std::filesystem::path> find_data(const std::filesystem::path& relative);

}  // namespace fastscene
