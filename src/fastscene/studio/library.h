// Library: the scenes in a folder, as the studio shows them. The studio's own files are in .studio, deleted
// scenes in .trash.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/pipeline/run_folder.h"

namespace fastscene::studio {

class Library {
  public:
    // Makes the folder. Throws Error if another studio works on it.
    explicit Library(const std::filesystem::path& root);

    const std::filesystem::path& root() const { return root_; }
    // A folder of the studio's own, made if need be: own("jobs").
    std::filesystem::path own(std::string_view name) const;

    // Of each scene what the gallery shows: name, title, seed, quality, finished, made (seconds since 1970), seconds,
    // peak_memory_bytes, has_room, from, changes, psnr. The newest first.
    Json scenes();
    // The same of one scene. Throws Refusal 404 if there is none of this name.
    Json scene(const std::string& name);
    RunFolder folder(const std::string& name) const;
    // A folder's name for a new scene, reserved by making it. No name is given twice.
    std::string reserve(const std::string& title);

    // Where a scene comes from, for those made by an edit: studio.json in its folder.
    void note_origin(const std::string& name, const std::string& from, const Json& changes) const;

    // Moves a scene to the trash; returns its name there. What is in the trash can be put back.
    std::string remove(const std::string& name);
    std::string restore(const std::string& trashed);
    Json trash() const;

    // A file below a scene's folder, with no symbolic link in its path. Empty: there is none, or it is not the scene's.
    std::optional<std::filesystem::path> file(const std::string& name, const std::string& relative) const;

  private:
    Json summary(const std::string& name) const;

    std::filesystem::path root_;
    std::optional<FolderLock> lock_;
    struct Known {
        std::string stamp;
        Json summary;
    };
    std::mutex mutex_;
    std::map<std::string, Known> known_;  // summaries by name, read again when a file has changed
};

// Whether a name is one folder below the library: no separators, not hidden, not too long.
bool is_scene_name(std::string_view name);

}  // namespace fastscene::studio
