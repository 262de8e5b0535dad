#include "fastscene/base/data_files.h"

#include <cstdlib>
#include <sstream>
#include <string>

namespace fastscene {
namespace fs = std::filesystem;
namespace {

std::string environment(const char* name) {
    const char* const value = std::getenv(name);
    return value ? value : "";
}

}  // namespace

std::vector<fs::path> data_folders() {
    std::vector<fs::path> folders;
    if (const std::string folder = environment("FASTSCENE_DATA_DIR"); !folder.empty()) folders.emplace_back(folder);
    std::error_code no_proc;
    if (const fs::path program = fs::read_symlink("/proc/self/exe", no_proc); !no_proc)
        folders.push_back(program.parent_path().parent_path() / "share/fastscene");
    std::string system = environment("XDG_DATA_DIRS");
    if (system.empty()) system = "/usr/local/share:/usr/share";
    std::istringstream list(system);
    for (std::string folder; std::getline(list, folder, ':');)
        if (!folder.empty()) folders.push_back(fs::path(folder) / "fastscene");
    return folders;
}

std::optional<fs::path> find_data(const fs::path& relative) {
    std::error_code unreadable;  // treated as absent
    for (const fs::path& folder : data_folders())
        if (fs::exists(folder / relative, unreadable)) return folder / relative;
    return {};
}

}  // namespace fastscene
