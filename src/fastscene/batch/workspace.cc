#include "fastscene/batch/workspace.h"

#include <string>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/process_name.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

void copy_whole(const fs::path& from, const fs::path& to) {
    const fs::path part = to.parent_path() / fmt::format(".{}.{}.part", to.filename().string(), process_name());
    fs::remove_all(part);
    fs::copy(from, part, fs::copy_options::recursive);
    const fs::path old = part.string() + ".old";
    if (fs::exists(to)) fs::rename(to, old);
    fs::rename(part, to);
    fs::remove_all(old);
}

}  // namespace

Workspace::Workspace(fs::path home, const fs::path& scratch) : home_(std::move(home)), path_(home_) {
    if (scratch.empty()) return;
    // The name is the same for each attempt, so that one after a kill finds what is there.
    path_ = scratch / ("fastscene-" + Hash().add(fs::absolute(home_).string()).hex());
    make_directories(scratch);
    try {
        if (!fs::exists(path_) && fs::exists(home_)) copy_whole(home_, path_);
    } catch (const fs::filesystem_error& error) {
        throw Error("{}: cannot be copied to {}: {}", home_.string(), scratch.string(), error.code().message());
    }
}

void Workspace::bring_home() {
    if (path_ == home_ || !fs::exists(path_)) return;
    try {
        copy_whole(path_, home_);
        fs::remove_all(path_);
    } catch (const fs::filesystem_error& error) {
        throw Error("{}: cannot be moved to {}: {}", path_.string(), home_.string(), error.code().message());
    }
}

}  // namespace fastscene
