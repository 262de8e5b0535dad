// The folder that an export writes. It remembers what was written, so that damage is found later: files.tsv has a line
// for each file, and export.json, which says what the export is, comes last.
#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fastscene/base/folder_lock.h"
#include "fastscene/base/json.h"
#include "fastscene/dataset/checksum.h"

namespace fastscene::dataset {

struct ExportedFile {
    std::string name;  // within the folder
    Checksum sum;
};

// Thread safe; a second process is turned away.
class ExportFolder {
  public:
    // `about`: what the export is made of. Throws UsageError if the folder has files that are not of an export, or of
    // another one.
    ExportFolder(std::filesystem::path folder, Json about);

    void write(const std::string& name, std::string_view bytes);
    void write_json(const std::string& name, const Json& json);
    // write(path): for writers that need a path.
    void write_by(const std::string& name, const std::function<void(const std::filesystem::path&)>& write);
    // For writers of several files: makes the folder of a file, and remembers one that is written.
    std::filesystem::path place(const std::string& name);
    void add_written(const std::string& name);
    // Writes files.tsv and export.json. `summary` is added to what the latter says.
    void finish(const Json& summary);

    const std::filesystem::path& path() const { return folder_; }
    std::size_t files() const { return files_.size(); }
    std::uint64_t bytes() const;

  private:
    void keep(const std::string& name, Checksum sum);
    std::filesystem::path folder_;
    Json about_;
    std::optional<FolderLock> lock_;
    std::mutex mutex_;
    std::vector<ExportedFile> files_;
};

bool is_export(const std::filesystem::path& folder);
// What a finished export wrote. Throws Error if it is not finished, or its list is damaged.
std::vector<ExportedFile> exported_files(const std::filesystem::path& folder);

}  // namespace fastscene::dataset
