#include "fastscene/models/pull.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/models/download.h"
#include "fastscene/models/sha256.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

fs::path licences_of(const fs::path& root) { return root / "licences.json"; }
fs::path record_of(const Model& model, const fs::path& root) {
    return root / model.folder / (model.name + ".record.json");
}

// The object stored in `file`, or an empty one.
Json read_or_empty(const fs::path& file) {
    const Json json = fs::exists(file) ? read_json(file) : Json::object();
    if (!json.is_object()) throw Error("{}: expected an object, found {}: remove it", file.string(), json.type_name());
    return json;
}
Json read_record(const Model& model, const fs::path& root) {
    const fs::path file = record_of(model, root);
    const Json json = read_or_empty(file), files = json.value("files", Json::object());
    const bool good = files.is_object() && std::all_of(files.begin(), files.end(), [](const Json& one) {
                          return one.is_object() && (!one.contains("sha256") || one["sha256"].is_string());
                      });
    if (!good)
        throw Error(
            "{}: expected \"files\" with the SHA-256 of each, found {}: remove it, the next verify writes another",
            file.string(), files.dump().substr(0, 80));
    return json;
}

// Lock: two pulls of one model would write to the same files.
class Lock {
  public:
    explicit Lock(const Model& model, const fs::path& root)
        : fd_(::open((root / model.folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
        if (fd_ < 0 || ::flock(fd_, LOCK_EX | LOCK_NB) != 0) {
            if (fd_ >= 0) ::close(fd_);
            throw Error("models pull {}: expected to be alone, found another pull at work in {}", model.name,
                        (root / model.folder).string());
        }
    }
    ~Lock() { ::close(fd_); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

  private:
    int fd_;
};

void accept_licence(const Model& model, const PullOptions& options) {
    if (is_accepted(model, options.root)) return;
    if (!options.accept)
        throw UsageError(
            "{}: {}\n  licence: {}\n  {}\n  from: {}\nRead it, then accept it once: fastscene models pull {} --accept",
            model.name, model.what, model.licence, model.licence_url, model.home, model.name);
    Json all = read_or_empty(licences_of(options.root));
    all[model.name] = model.licence;
    write_json(licences_of(options.root), all);
}

// RFC 3986: encodes all but unreserved characters and those in `keep`.
std::string percent_encoded(std::string_view text, std::string_view stays) {
    std::string out;
    for (const unsigned char c : text) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           std::string_view("-._~").find(static_cast<char>(c)) != std::string_view::npos;
        if (plain || stays.find(static_cast<char>(c)) != std::string_view::npos) out += static_cast<char>(c);
        else out += fmt::format("%{:02X}", c);
    }
    return out;
}

// A folder counts as a URL, too.
std::string mirror_base(const std::string& mirror) {
    constexpr std::string_view local = "file://";
    std::string base = mirror;
    if (mirror.find("://") == std::string::npos)
        base = std::string(local) + percent_encoded(fs::absolute(mirror).lexically_normal().string(), "/");
    // Also after a user's file://, but without encoding twice.
    else if (mirror.starts_with(local))
        base = std::string(local) + percent_encoded(std::string_view(mirror).substr(local.size()), "/%");
    while (base.ends_with('/')) base.pop_back();
    return base + "/";
}
// The local folder that a mirror refers to; none for network URLs.
std::optional<fs::path> mirror_folder(const std::string& mirror) {
    constexpr std::string_view local = "file://";
    if (!mirror.starts_with(local))
        return mirror.find("://") == std::string::npos ? std::optional<fs::path>(mirror) : std::nullopt;
    std::string path;
    for (std::size_t i = local.size(); i < mirror.size(); ++i) {
        unsigned byte = 0;
        const char* digits = mirror.data() + i + 1;
        const bool encoded = mirror[i] == '%' && i + 2 < mirror.size() &&
                             std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
        path += encoded ? static_cast<char>(byte) : mirror[i];
        i += encoded ? 2 : 0;
    }
    if (path.starts_with("localhost/")) path.erase(0, 9);
    return path;
}
void check_mirror(const std::string& mirror) {
    const auto folder = mirror_folder(mirror);
    if (folder && !fs::is_directory(*folder))
        throw Error("mirror {}: expected a folder that holds the files as `fastscene models list` has them, found {}",
                    mirror, fs::exists(*folder) ? "a file" : "none");
}
std::string address_of(const Model& model, const ModelFile& file, const std::string& name, const PullOptions& options) {
    if (!options.mirror.empty()) return mirror_base(options.mirror) + model.folder + "/" + name;
    return file.url.empty() ? model.base + name : file.url;
}

std::string hash_with_progress(const fs::path& file, const std::string& label, const Run& run) {
    const auto total = static_cast<std::int64_t>(fs::file_size(file));
    return sha256_of_file(file, [&](std::size_t done) {
        run.check_stop();
        if (run.events && total > 0)
            run.events->tell(ProgressEvent{"check " + label, static_cast<std::int64_t>(done), total});
    });
}

void record(const Model& model, const fs::path& root, const std::vector<FileReport>& files) {
    Json json = read_record(model, root);
    json["model"] = model.name;
    json["licence"] = model.licence;
    for (const FileReport& file : files)
        if (!file.sha256.empty()) json["files"][file.name] = {{"bytes", file.bytes}, {"sha256", file.sha256}};
    write_json(record_of(model, root), json);
}

// Records hashes of files seen for the first time.
void record_fresh(const Model& model, const fs::path& root, const std::vector<FileReport>& files) {
    std::vector<FileReport> fresh;
    for (const FileReport& file : files)
        if (file.state == FileState::recorded) fresh.push_back(file);
    if (!fresh.empty()) record(model, root, fresh);
}

std::string recorded_hash(const Json& record, const std::string& name) {
    const auto files = record.find("files");
    if (files == record.end() || !files->contains(name)) return "";
    return (*files)[name].value("sha256", "");
}

// The existing file, whatever its size.
std::optional<fs::path> any_file(const Model& model, const ModelFile& file, const fs::path& root) {
    for (const std::string& name : file.names())
        if (fs::is_regular_file(root / model.folder / name)) return root / model.folder / name;
    return std::nullopt;
}

FileReport verified(const Model& model, const ModelFile& file, const Json& record, const fs::path& root,
                    const Run& run) {
    auto path = file_in_cache(model, file, root);
    if (!path) path = any_file(model, file, root);
    if (!path) return {file.names().front(), FileState::missing, 0, {}, !file.sha256.empty(), "not there"};
    FileReport report{path->lexically_relative(root / model.folder).string(),
                      FileState::here,
                      static_cast<std::int64_t>(fs::file_size(*path)),
                      {},
                      !file.sha256.empty(),
                      {}};
    report.sha256 = hash_with_progress(*path, path->filename().string(), run);
    const std::string expected = file.sha256.empty() ? recorded_hash(record, report.name) : file.sha256;
    if (report.bytes == 0) {
        report.state = FileState::damaged;
        report.problem = "expected a file, found one of 0 bytes";
    } else if (file.bytes > 0 && report.bytes != file.bytes) {
        report.state = FileState::damaged;
        report.problem = fmt::format("expected {} bytes, found {}", file.bytes, report.bytes);
    } else if (expected.empty()) {
        report.state = FileState::recorded;
    } else if (report.sha256 != expected) {
        report.state = FileState::damaged;
        report.problem = fmt::format("expected SHA-256 {}, found {}", expected, report.sha256);
    }
    return report;
}

class Pull {
  public:
    Pull(const Model& model, const PullOptions& options, const Run& run)
        : model_(model), options_(options), run_(run), known_(read_record(model, options.root)) {}

    // The existing file, if valid. A damaged one is replaced only once a new one is complete.
    std::optional<FileReport> here(const ModelFile& file) const {
        FileReport report = verified(model_, file, known_, options_.root, run_);
        if (report.state == FileState::damaged)
            run_.note(fmt::format("{}/{}: {}; to be fetched again", model_.name, report.name, report.problem));
        if (report.state != FileState::here && report.state != FileState::recorded) return std::nullopt;
        return report;
    }
    FileReport file(const ModelFile& file) const {
        for (const std::string& name : file.names()) {
            const auto fetched = fetch(file, name);
            if (!fetched) continue;
            for (const std::string& other :
                 file.names())  // a damaged file under an alternative name would be found first
                if (other != name) fs::remove(options_.root / model_.folder / other);
            return *fetched;
        }
        throw Error("{}: expected {}, found no such file", model_.name,
                    address_of(model_, file, file.names().front(), options_));
    }

  private:
    std::optional<FileReport> fetch(const ModelFile& file, const std::string& name) const {
        const fs::path target = options_.root / model_.folder / name, part = target.string() + ".part";
        if (fs::is_directory(target)) throw Error("{}: expected a file or nothing, found a folder", target.string());
        make_directories(target.parent_path());
        Download wanted;
        wanted.url = address_of(model_, file, name, options_);
        wanted.part = part;
        wanted.bytes = file.bytes;
        wanted.first_wait = options_.first_wait;
        wanted.heard = [&](std::int64_t done, std::int64_t total) {
            if (run_.events && total > 0) run_.events->tell(ProgressEvent{label(name), std::min(done, total), total});
        };
        // Partial data of an earlier run may be corrupt: if the result's hash is wrong, the download restarts once.
        for (bool resumed = fs::exists(part);; resumed = false) {
            if (download(wanted, run_) == Fetched::absent) return std::nullopt;
            const std::string hash = hash_with_progress(part, label(name), run_);
            if (file.sha256.empty() || hash == file.sha256) {
                fs::rename(part, target);
                if (const std::string before = recorded_hash(known_, name);
                    file.sha256.empty() && !before.empty() && before != hash)
                    run_.warn(fmt::format(
                        "{}: SHA-256 {} is not the one recorded before, {}: its publisher may have changed it",
                        target.string(), hash, before));
                return FileReport{name, FileState::fetched,   static_cast<std::int64_t>(fs::file_size(target)),
                                  hash, !file.sha256.empty(), {}};
            }
            fs::remove(part);
            if (!resumed)
                throw Error("{}: expected SHA-256 {}, found {}; the bytes were thrown away", wanted.url, file.sha256,
                            hash);
            run_.note(fmt::format("{}: what was left of an earlier pull does not fit; from the beginning", wanted.url));
        }
    }
    std::string label(const std::string& name) const { return fs::path(name).filename().string(); }

    const Model& model_;
    const PullOptions& options_;
    const Run& run_;
    const Json known_;
};

}  // namespace

std::string default_mirror() {
    const char* mirror = std::getenv("FASTSCENE_MODELS_MIRROR");
    return mirror ? mirror : "";
}

std::string_view name_of(FileState state) {
    switch (state) {
        case FileState::fetched: return "fetched";
        case FileState::here: return "here";
        case FileState::recorded: return "recorded";
        case FileState::missing: return "missing";
        case FileState::damaged: return "damaged";
    }
    return "";
}

bool ModelReport::whole() const {
    return std::none_of(files.begin(), files.end(), [](const FileReport& file) {
        return file.state == FileState::missing || file.state == FileState::damaged;
    });
}

Json to_json(const ModelReport& report) {
    Json files = Json::array();
    for (const FileReport& file : report.files)
        files.push_back({{"name", file.name},
                         {"state", name_of(file.state)},
                         {"bytes", file.bytes},
                         {"sha256", file.sha256},
                         {"known", file.known},
                         {"problem", file.problem}});
    return {{"model", report.model}, {"folder", report.folder.string()}, {"whole", report.whole()}, {"files", files}};
}

bool is_accepted(const Model& model, const fs::path& root) {
    const Json all = read_or_empty(licences_of(root));
    const auto found = all.find(model.name);
    return found != all.end() && *found == model.licence;
}

ModelReport pull_model(const Model& model, const PullOptions& options, const Run& run) {
    ModelReport report{model.name, options.root / model.folder, {}};
    const Pull pull(model, options, run);
    std::vector<std::optional<FileReport>> here;
    for (const ModelFile& file : model.files) here.push_back(pull.here(file));
    if (std::all_of(here.begin(), here.end(), [](const auto& file) { return file.has_value(); })) {
        for (const auto& file : here) report.files.push_back(*file);
        record_fresh(model, options.root, report.files);
        return report;
    }
    if (model.by_hand() && options.mirror.empty())
        throw Error("{}: has no address to pull from. Fetch {} by hand at {} and put it into {}, or pull from a mirror",
                    model.name, model.files[0].name, model.home, report.folder.string());
    if (!options.mirror.empty()) check_mirror(options.mirror);
    make_directories(options.root);
    accept_licence(model, options);
    make_directories(report.folder);
    const Lock lock(model, options.root);
    for (std::size_t i = 0; i < model.files.size(); ++i) {
        report.files.push_back(here[i] ? *here[i] : pull.file(model.files[i]));
        record(model, options.root, report.files);  // record valid files, even if a later one fails
    }
    return report;
}

ModelReport verify_model(const Model& model, const fs::path& root, const Run& run) {
    ModelReport report{model.name, root / model.folder, {}};
    const Json known = read_record(model, root);
    for (const ModelFile& file : model.files) report.files.push_back(verified(model, file, known, root, run));
    record_fresh(model, root, report.files);
    return report;
}

}  // namespace fastscene
