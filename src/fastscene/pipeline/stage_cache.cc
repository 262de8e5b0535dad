#include "fastscene/pipeline/stage_cache.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/forced_exit.h"
#include "fastscene/base/hash.h"
#include "fastscene/pipeline/stage_code.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

double cpu_seconds_so_far() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Linux records the peak resident size of the process; writing 5 to clear_refs resets it.
void reset_peak_memory() { std::ofstream("/proc/self/clear_refs") << "5"; }

std::int64_t peak_memory_bytes() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (word == "VmHWM:") {
            std::int64_t kib = 0;
            status >> kib;
            return kib * 1024;
        }
    return 0;
}

// All files in a directory by name, with size and content hash, except stage.json.
Json list_files(const fs::path& directory) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::recursive_directory_iterator(directory))
        if (entry.is_regular_file()) paths.push_back(fs::relative(entry.path(), directory));
    std::sort(paths.begin(), paths.end());
    Json files = Json::array();
    for (const fs::path& path : paths) {
        const std::string bytes = read_file(directory / path);
        files.push_back({{"name", path.generic_string()}, {"bytes", bytes.size()}, {"hash", Hash().add(bytes).hex()}});
    }
    return files;
}

bool files_are_there(const fs::path& directory, const Json& files) {
    for (const Json& file : files) {
        std::error_code code;
        const auto size = fs::file_size(directory / file.at("name").get<std::string>(), code);
        if (code || size != file.at("bytes").get<std::uintmax_t>()) return false;
    }
    return true;
}

struct Stored {
    std::string key;
    StageRecord record;
};

std::optional<Stored> read_stored(const fs::path& root, std::string_view name) {
    const fs::path directory = root / name;
    if (!fs::exists(directory / "stage.json")) return {};
    try {
        const Json json = read_json(directory / "stage.json");
        if (!files_are_there(directory, json.at("files"))) return {};
        Stored stored{json.at("key"), {std::string(name), json.at("result"), {}, true}};
        stored.record.cost = {json.at("seconds"), json.at("cpu_seconds"), json.at("peak_memory_bytes")};
        return stored;
    } catch (const Json::exception&) {
        return {};  // foreign or outdated: the stage is made again
    } catch (const Error&) {
        return {};
    }
}

void replace_directory(const fs::path& from, const fs::path& to) {
    std::error_code code;
    const fs::path old = to.parent_path() / ("." + to.filename().string() + ".old.part");
    fs::remove_all(old, code);
    if (fs::exists(to)) fs::rename(to, old, code);
    if (!code) fs::rename(from, to, code);
    if (code) throw Error("{}: cannot be written: {}", to.string(), code.message());
    fs::remove_all(old, code);
}

}  // namespace

Cost measure_cost(const std::function<void()>& work) {
    reset_peak_memory();
    const auto begin = std::chrono::steady_clock::now();
    const double cpu = cpu_seconds_so_far();
    work();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    const auto to_ms = [](double s) { return std::round(s * 1000) / 1000; };
    return {to_ms(seconds.count()), to_ms(cpu_seconds_so_far() - cpu), peak_memory_bytes()};
}

std::string stage_key(std::string_view stage, const Json& params, const std::vector<std::string>& inputs,
                      std::uint64_t seed) {
    Hash hash;
    hash.add(stage).add(code_version(stage)).add(params.dump(-1, ' ', false, Json::error_handler_t::replace)).add(seed);
    for (const std::string& input : inputs) hash.add(input);
    return hash.hex();
}

std::optional<StageRecord> finished_stage(const fs::path& root, std::string_view name) {
    const auto stored = read_stored(root, name);
    if (!stored) return {};
    return stored->record;
}

StageRecord run_stage(const fs::path& root, std::string_view name, const std::string& key, const Run& run,
                      const std::function<void(const fs::path&)>& make) {
    run.check_stop();
    if (const auto stored = read_stored(root, name); stored && stored->key == key) return stored->record;

    const fs::path directory = root / name, unfinished = root / ("." + std::string(name) + ".part");
    const auto remove_unfinished = [unfinished] {
        std::error_code ignored;
        fs::remove_all(unfinished, ignored);
    };
    remove_unfinished();
    ExitDuty tidy([=] {
        // Whoever writes there does not know yet, and may put another file into it meanwhile.
        for (int i = 0; i < 5 && fs::exists(unfinished); ++i) remove_unfinished();
    });
    try {
        make_directories(unfinished);
        StageRecord record{std::string(name), "", {}, false};
        record.cost = measure_cost([&] { make(unfinished); });
        const Json files = list_files(unfinished);
        record.result = Hash().add(files.dump()).hex();
        Json json{{"stage", name},
                  {"key", key},
                  {"result", record.result},
                  {"seconds", record.cost.seconds},
                  {"cpu_seconds", record.cost.cpu_seconds},
                  {"peak_memory_bytes", record.cost.peak_memory_bytes},
                  {"files", files}};
        // A stage's notes about how it was made: fallbacks, clipped settings.
        if (fs::exists(unfinished / "about.json")) json["about"] = read_json(unfinished / "about.json");
        write_json(unfinished / "stage.json", json);
        tidy.dismiss();
        replace_directory(unfinished, directory);
        return record;
    } catch (const fs::filesystem_error& e) {
        remove_unfinished();
        throw Error("{}: cannot be written: {}", directory.string(), e.code().message());
    } catch (...) {
        remove_unfinished();
        throw;
    }
}

}  // namespace fastscene
