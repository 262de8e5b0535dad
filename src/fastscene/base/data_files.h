// Data files that come with the program, such as the viewer's page. An installed tree and a build tree are laid out
// alike, so that one rule finds them and no path of the machine that built the program is compiled in.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace fastscene {

// Folders that may hold data files, in the order in which they are searched:
//   $FASTSCENE_DATA_DIR
//   ../share/fastscene beside the folder of the running executable
//   fastscene/ in each folder of $XDG_DATA_DIRS (/usr/local/share and /usr/share where that is not set)
// The last is for programs that link the library. Folders need not exist.
std::vector<std::filesystem::path> data_folders();

// The first of these folders that holds `relative`, joined with it; absent where none does.
std::optional<std::filesystem::path> find_data(const std::filesystem::path& relative);

}  // namespace fastscene
