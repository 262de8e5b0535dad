#include "fastscene/base/memory.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace fastscene {
namespace fs = std::filesystem;
namespace {

// The number after `word` in a file of words.
std::optional<std::int64_t> number_behind(const fs::path& file, const std::string& word) {
    std::ifstream in(file);
    for (std::string found; in >> found;)
        if (std::int64_t value = 0; found == word && in >> value) return value;
    return std::nullopt;
}
std::optional<std::int64_t> number_in(const fs::path& file) {
    std::ifstream in(file);
    std::int64_t value = 0;
    return in >> value ? std::optional(value) : std::nullopt;  // "max" is not a number
}

// File names of the two cgroup versions.
struct GroupFiles {
    std::string line, mount, limit, used, inactive;
};
const GroupFiles kVersion2{"0::/", "sys/fs/cgroup", "memory.max", "memory.current", "inactive_file"};
const GroupFiles kVersion1{":memory:/", "sys/fs/cgroup/memory", "memory.limit_in_bytes", "memory.usage_in_bytes",
                           "total_inactive_file"};

// Memory left by a cgroup and its ancestors. The page cache counts as used there but is reclaimable.
std::optional<std::int64_t> left_by_groups(const fs::path& system, const GroupFiles& files) {
    std::ifstream in(system / "proc/self/cgroup");
    std::string line;
    std::size_t found = std::string::npos;
    while (found == std::string::npos && std::getline(in, line)) found = line.find(files.line);
    if (found == std::string::npos) return std::nullopt;
    const fs::path mount = system / files.mount;
    std::optional<std::int64_t> least;
    for (fs::path group = (mount / line.substr(found + files.line.size())).lexically_normal();;
         group = group.parent_path()) {
        const auto limit = number_in(group / files.limit), used = number_in(group / files.used);
        if (limit && used) {
            const std::int64_t left = std::max<std::int64_t>(
                0, *limit - *used + number_behind(group / "memory.stat", files.inactive).value_or(0));
            least = std::min(least.value_or(left), left);
        }
        if (group == mount || group.native().size() <= mount.native().size()) return least;
    }
}

// Address space left by the shell's limit (ulimit -v).
std::optional<std::int64_t> left_by_shell(const fs::path& system) {
    const std::string key = "Max address space";
    std::ifstream in(system / "proc/self/limits");
    std::string line;
    while (std::getline(in, line) && !line.starts_with(key)) {
    }
    const auto used = number_behind(system / "proc/self/status", "VmSize:");
    std::int64_t limit = 0;
    if (!line.starts_with(key) || !used || !(std::istringstream(line.substr(key.size())) >> limit))
        return std::nullopt;  // "unlimited" is not a number
    return std::max<std::int64_t>(0, limit - *used * 1024);
}

}  // namespace

std::int64_t available_memory(const fs::path& system) {
    auto least = number_behind(system / "proc/meminfo", "MemAvailable:");
    if (least) *least *= 1024;
    for (const auto& left :
         {left_by_groups(system, kVersion2), left_by_groups(system, kVersion1), left_by_shell(system)})
        if (left) least = std::min(least.value_or(*left), *left);
    return least.value_or(0);
}

}  // namespace fastscene
