#include "fastscene/studio/library.h"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>

#include "fastscene/base/file.h"
#include "fastscene/pipeline/request.h"
#include "fastscene/studio/refusal.h"
#include "fastscene/studio/send_file.h"

namespace fastscene::studio {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kLongestName = 200;  // bytes; file systems take 255, and the trash adds a number
constexpr const char* kOwn = ".studio";
constexpr const char* kTrash = ".trash";
constexpr const char* kOrigin = "studio.json";

bool is_plain_folder(const fs::path& path) {
    std::error_code none;
    return fs::symlink_status(path, none).type() == fs::file_type::directory;
}

double seconds_since_1970(const fs::path& file) {
    struct stat status {};
    return ::stat(file.c_str(), &status) == 0 ? static_cast<double>(status.st_mtim.tv_sec) : 0;
}

// Changes when one of the files that a summary is read from does.
std::string stamp_of(const RunFolder& folder) {
    std::string stamp;
    for (const fs::path& file : {folder.run_json(), folder.report_json(), folder.root / kOrigin, folder.preview_jpg(),
                                 folder.metrics() / "report.json", folder.panorama_color(), folder.viewer_html()}) {
        struct stat status {};
        const bool there = ::stat(file.c_str(), &status) == 0;
        stamp += there ? fmt::format("{}.{}.{} ", status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_size) : "- ";
    }
    return stamp;
}

// Damaged files do not hide the other scenes.
Json json_or_nothing(const fs::path& file) {
    try {
        if (fs::exists(file))
            if (Json json = read_json(file); json.is_object()) return json;
    } catch (const std::exception&) {
    }
    return Json::object();
}

template <class T>
T value_or(const Json& json, const char* key, T usual) {
    const auto found = json.find(key);
    try {
        return found == json.end() ? usual : found->get<T>();
    } catch (const Json::exception&) {
        return usual;
    }
}

}  // namespace

bool is_scene_name(std::string_view name) {
    return !name.empty() && name.size() <= kLongestName && name.front() != '.' &&
           std::none_of(name.begin(), name.end(), [](char c) { return c == '/' || c == '\\' || c == '\0'; });
}

Library::Library(const fs::path& root) {
    make_directories(root);
    root_ = fs::canonical(root);
    try {
        lock_.emplace(own(""));
    } catch (const Error&) {
        throw Error("{}: another studio works on this folder: use its page, or name another folder", root.string());
    }
}

fs::path Library::own(std::string_view name) const {
    const fs::path folder = name.empty() ? root_ / kOwn : root_ / kOwn / name;
    make_directories(folder);
    return folder;
}

RunFolder Library::folder(const std::string& name) const {
    if (!is_scene_name(name) || !is_plain_folder(root_ / name) || !fs::exists(root_ / name / "run.json"))
        throw Refusal(404, "there is no scene named \"{}\" here", name);
    return {root_ / name};
}

Json Library::summary(const std::string& name) const {
    const RunFolder folder{root_ / name};
    const Json run = json_or_nothing(folder.run_json()), report = json_or_nothing(folder.report_json());
    Json out{{"name", name}, {"title", name}, {"kind", "prompt"}, {"has_room", false}};
    try {
        if (run.contains("capture")) {
            out["kind"] = "capture";
        } else {
            const SceneSource source = source_from_json(run);
            out["has_room"] = has_room(source);
            if (!picture_of(source).empty()) out["kind"] = "panorama";
            out["title"] = title_of(source);
        }
    } catch (const std::exception&) {
        out["kind"] = "unknown";  // of a newer version, or damaged
    }
    out["seed"] = value_or<std::uint64_t>(run, "seed", 0);
    out["quality"] = value_or<std::string>(run, "quality", "");
    out["finished"] = fs::exists(folder.report_json()) && fs::exists(folder.scene_compressed_ply());
    out["has_walk"] = fs::exists(folder.viewer_html());
    out["has_panorama"] = fs::exists(folder.panorama_color());
    out["picture"] = fs::exists(folder.preview_jpg())      ? "preview.jpg"
                     : fs::exists(folder.panorama_color()) ? "panorama/color.png"
                                                           : "";
    out["made"] = seconds_since_1970(fs::exists(folder.report_json()) ? folder.report_json() : folder.run_json());
    out["seconds"] = value_or<double>(report, "seconds", 0);
    out["peak_memory_bytes"] = value_or<std::int64_t>(report, "peak_memory_bytes", 0);
    const Json origin = json_or_nothing(folder.root / kOrigin);
    out["from"] = value_or<std::string>(origin, "from", "");
    out["changes"] = origin.value("changes", Json::array());
    const Json metrics = json_or_nothing(folder.metrics() / "report.json");
    if (const auto truth = metrics.find("truth"); truth != metrics.end() && truth->is_object())
        if (const auto psnr = truth->find("psnr_mean"); psnr != truth->end() && psnr->is_number()) out["psnr"] = *psnr;
    return out;
}

Json Library::scene(const std::string& name) {
    const std::string stamp = stamp_of(folder(name));
    const std::lock_guard lock(mutex_);
    Known& known = known_[name];
    if (known.stamp != stamp) known = {stamp, summary(name)};
    return known.summary;
}

Json Library::scenes() {
    std::vector<Json> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(root_, none)) {
        const std::string name = entry.path().filename().string();
        if (!is_scene_name(name) || !is_plain_folder(entry.path()) || !fs::exists(entry.path() / "run.json")) continue;
        found.push_back(scene(name));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Json& a, const Json& b) { return a["made"].get<double>() > b["made"].get<double>(); });
    Json out = Json::array();
    for (Json& scene : found) out.push_back(std::move(scene));
    return out;
}

std::string Library::reserve(const std::string& title) {
    const std::string slug = slug_of(title);
    for (int n = 1;; ++n) {
        const std::string name = n == 1 ? slug : fmt::format("{}-{}", slug, n);
        std::error_code code;
        // Deleted scenes keep their names, to come back to.
        if (fs::exists(fs::symlink_status(root_ / kTrash / name, code))) continue;
        if (::mkdir((root_ / name).c_str(), 0777) == 0) return name;
        if (errno != EEXIST) throw Error("{}: cannot be made: {}", (root_ / name).string(), std::strerror(errno));
    }
}

void Library::note_origin(const std::string& name, const std::string& from, const Json& changes) const {
    write_json(root_ / name / kOrigin, {{"from", from}, {"changes", changes}});
}

std::string Library::remove(const std::string& name) {
    const fs::path from = folder(name).root;
    make_directories(root_ / kTrash);
    std::string to = name;
    for (int n = 2; fs::exists(fs::symlink_status(root_ / kTrash / to)); ++n) to = fmt::format("{}~{}", name, n);
    std::error_code code;
    fs::rename(from, root_ / kTrash / to, code);
    if (code) throw Error("{}: cannot be moved to the trash: {}", from.string(), code.message());
    return to;
}

std::string Library::restore(const std::string& trashed) {
    if (!is_scene_name(trashed) || !is_plain_folder(root_ / kTrash / trashed))
        throw Refusal(404, "there is no scene named \"{}\" in the trash", trashed);
    const std::string wanted = trashed.substr(0, trashed.find('~'));
    std::string to = wanted;
    for (int n = 2; fs::exists(fs::symlink_status(root_ / to)); ++n) to = fmt::format("{}-{}", wanted, n);
    std::error_code code;
    fs::rename(root_ / kTrash / trashed, root_ / to, code);
    if (code) throw Error("{}: cannot be put back: {}", trashed, code.message());
    return to;
}

Json Library::trash() const {
    Json out = Json::array();
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(root_ / kTrash, none))
        if (is_plain_folder(entry.path())) out.push_back(entry.path().filename().string());
    return out;
}

std::optional<fs::path> Library::file(const std::string& name, const std::string& relative) const {
    if (!is_scene_name(name) || !is_plain_folder(root_ / name)) return {};
    return file_below(root_ / name, relative);
}

}  // namespace fastscene::studio
