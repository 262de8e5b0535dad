#include "fastscene/dataset/export_folder.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"

namespace fastscene::dataset {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExportFormat = "fastscene dataset export 1";
constexpr const char *kExportJson = "export.json", *kFilesList = "files.tsv";

// Left by a process that was killed; the folder is locked, so no other one is writing.
bool is_left_behind(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.starts_with(".") && name.ends_with(".part");
}

bool has_foreign_files(const fs::path& folder) {
    return std::any_of(fs::directory_iterator(folder), fs::directory_iterator(),
                       [](const fs::directory_entry& entry) { return !is_left_behind(entry.path()); });
}

void tidy(const fs::path& folder) {
    std::vector<fs::path> left;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && is_left_behind(entry.path())) left.push_back(entry.path());
    for (const fs::path& file : left) fs::remove(file);
}

Json export_json(const fs::path& folder) {
    Json found = read_json(folder / kExportJson);
    if (!found.is_object() || found.value("format", "") != kExportFormat)
        throw Error("{}: expected \"{}\", found another file", (folder / kExportJson).string(), kExportFormat);
    return found;
}

}  // namespace

ExportFolder::ExportFolder(fs::path folder, Json about) : folder_(std::move(folder)), about_(std::move(about)) {
    if (fs::exists(folder_) && !fs::is_directory(folder_))
        throw UsageError("{}: expected a folder, found a file", folder_.string());
    if (is_export(folder_)) {
        const Json found = export_json(folder_);
        for (const auto& [name, value] : about_.items())
            if (found.value(name, Json()) != value)
                throw UsageError("{}: expected an export with {} = {}, found {}: use another folder", folder_.string(),
                                 name, value.dump(), found.value(name, Json()).dump());
    } else if (fs::exists(folder_) && has_foreign_files(folder_)) {
        throw UsageError("{}: expected an empty folder or an export to make again, found other files",
                         folder_.string());
    }
    make_directories(folder_);
    lock_.emplace(folder_);
    tidy(folder_);
    Json unfinished{{"format", kExportFormat}};
    unfinished.update(about_);
    unfinished["finished"] = false;
    fastscene::write_json(folder_ / kExportJson, unfinished);
}

fs::path ExportFolder::place(const std::string& name) {
    const fs::path path = folder_ / name;
    make_directories(path.parent_path());
    return path;
}

void ExportFolder::keep(const std::string& name, Checksum sum) {
    const std::lock_guard lock(mutex_);
    files_.push_back({name, std::move(sum)});
}

void ExportFolder::write(const std::string& name, std::string_view bytes) {
    write_file(place(name), bytes);
    keep(name, checksum_of_bytes(bytes));
}

void ExportFolder::write_json(const std::string& name, const Json& json) { write(name, json.dump(2) + "\n"); }

void ExportFolder::write_by(const std::string& name, const std::function<void(const fs::path&)>& write) {
    write(place(name));
    add_written(name);
}

void ExportFolder::add_written(const std::string& name) { keep(name, checksum_of(folder_ / name)); }

std::uint64_t ExportFolder::bytes() const {
    std::uint64_t sum = 0;
    for (const ExportedFile& file : files_) sum += file.sum.bytes;
    return sum;
}

void ExportFolder::finish(const Json& summary) {
    std::sort(files_.begin(), files_.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    std::string list;
    for (const ExportedFile& file : files_)
        list += fmt::format("{}\t{}\t{}\n", file.name, file.sum.bytes, file.sum.hash);
    write_file(folder_ / kFilesList, list);
    Json out{{"format", kExportFormat}};
    out.update(about_);
    out.update(summary);
    out["files"] = files_.size();
    out["bytes"] = bytes();
    out["list"] = to_json(checksum_of_bytes(list));
    out["finished"] = true;
    fastscene::write_json(folder_ / kExportJson, out);
}

bool is_export(const fs::path& folder) { return fs::exists(folder / kExportJson); }

std::vector<ExportedFile> exported_files(const fs::path& folder) {
    const Json about = export_json(folder);
    if (!about.value("finished", false))
        throw Error("{}: the export was not finished: run the same `fastscene dataset export` again", folder.string());
    const std::string list = read_file(folder / kFilesList);
    if (!about.contains("list") || checksum_of_bytes(list) != checksum_from_json(about["list"]))
        throw Error("{}: damaged: run the same `fastscene dataset export` again", (folder / kFilesList).string());
    std::vector<ExportedFile> out;
    std::istringstream lines(list);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find('\t'), second = line.find('\t', first + 1);
        ExportedFile file{line.substr(0, first), {0, line.substr(second + 1)}};
        std::from_chars(line.data() + first + 1, line.data() + second, file.sum.bytes);
        out.push_back(std::move(file));
    }
    return out;
}

}  // namespace fastscene::dataset
