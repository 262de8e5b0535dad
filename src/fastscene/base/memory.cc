#include "fastscene/base/memory.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

namespace fastscene {
namespace fs = std::filesystem;
namespace {

// The number behind `word` in a file of words.
std::optional<std::int64_t> number_behind(const fs::path& file, const std::string& word) {
    std::ifstream in(file);
    for (std::string found; in >> found;)
        if (std::int64_t value = 0; found == word && in >> value) return value;
    return std::nullopt;
}
std::optional<std::int64_t> number_in(const fs::path& file) {
    std::ifstream in(file);
    std::int64_t value = 0;
    return in >> value ? std::optional(value) : std::nullopt;  // "max" is no number
}

// What a control group (version 2) and those around it leave. Pages of files that were read count as used there, but are given back.
std::optional<std::int64_t> left_by_groups(const fs::path& system) {
    std::ifstream in(system / "proc/self/cgroup");
    std::string line;
    while (std::getline(in, line) && !line.starts_with("0::/")) {}
    if (!line.starts_with("0::/")) return std::nullopt;
    const fs::path mount = system / "sys/fs/cgroup";
    std::optional<std::int64_t> least;
    for (fs::path group = (mount / line.substr(4)).lexically_normal();; group = group.parent_path()) {
        const auto limit = number_in(group / "memory.max"), used = number_in(group / "memory.current");
        if (limit && used) {
            const std::int64_t left = std::max<std::int64_t>(0, *limit - *used + number_behind(group / "memory.stat", "inactive_file").value_or(0));
            least = std::min(least.value_or(left), left);
        }
        if (group == mount || group.native().size() <= mount.native().size()) return least;
    }
}

}  // namespace

std::int64_t available_memory(const fs::path& system) {
    const auto machine = number_behind(system / "proc/meminfo", "MemAvailable:");
    const auto group = left_by_groups(system);
    if (!machine) return group.value_or(0);
    return std::min(*machine * 1024, group.value_or(*machine * 1024));
}

}  // namespace fastscene
