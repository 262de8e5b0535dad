#include "fastscene/pipeline/run_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "fastscene/base/error.h"

namespace fastscene {

std::vector<std::string> RunFolder::owned() {
    std::vector<std::string> names{"run.json",     "report.json", "viewer.html", "preview.jpg",
                                   "painting.png", "painting",    "credits.txt", "metrics"};
    for (const std::string_view stage : kStages) names.emplace_back(stage);
    return names;
}

std::string slug_of(std::string_view text) {
    constexpr std::size_t kLongest = 60;
    std::string slug;
    for (const char c : text) {
        const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        const bool plain = (lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9');
        if (plain) slug += lower;
        else if (!slug.empty() && slug.back() != '-') slug += '-';
        if (slug.size() >= kLongest) break;
    }
    while (!slug.empty() && slug.back() == '-') slug.pop_back();
    return slug.empty() ? "scene" : slug;
}

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0) throw Error("{}: cannot be opened: {}", folder.string(), std::strerror(errno));
    // Some network file systems do not support locks; there the user is responsible.
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        ::close(descriptor_);
        throw Error("{}: another fastscene is working on this folder", folder.string());
    }
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace fastscene
