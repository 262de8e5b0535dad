#include "fastscene/metrics/images.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <tuple>

#include "fastscene/base/error.h"
#include "fastscene/io/image_io.h"
#include "fastscene/metrics/measure_kinds.h"
#include "fastscene/models/sha256.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

// Without names: the default measures, except those whose optional files are missing.
bool is_wanted(const MeasureKind& kind, const std::vector<std::string>& wanted, const fs::path& weights) {
    if (!wanted.empty()) return std::find(wanted.begin(), wanted.end(), kind.name) != wanted.end();
    if (kind.unasked == Unasked::measured_if_there) return look_for(kind, weights).absent.empty();
    return kind.unasked == Unasked::measured;
}

fs::path partner_of(const fs::path& picture, const fs::path& reference) {
    return fs::is_directory(reference) ? reference / picture.filename() : reference;
}

std::optional<PictureInfo> head_of(const fs::path& picture) try { return picture_info(picture); } catch (const Error&) {
    return {};  // damaged: skipped later, with a reason
}

// Checks sizes from the file headers, to fail before the first picture instead of after an hour.
void check_partners(const std::vector<fs::path>& pictures, const fs::path& reference) {
    if (!fs::exists(reference))
        throw Error("--reference {}: expected a picture or a folder, found none", reference.string());
    for (const fs::path& picture : pictures) {
        const fs::path partner = partner_of(picture, reference);
        if (!fs::exists(partner))
            throw Error("--reference {}: expected the partner of {}, found none", reference.string(),
                        picture.filename().string());
        const auto head = head_of(picture), its = head_of(partner);
        if (!head || !its) continue;
        const PictureInfo &a = *head, &b = *its;
        if (a.width != b.width || a.height != b.height)
            throw Error("{}: expected {} x {} as {} is, found {} x {}", partner.string(), a.width, a.height,
                        picture.string(), b.width, b.height);
    }
}

// JSON has no infinity: for equal pictures it is a string.
Json number(double v) { return std::isinf(v) ? Json(v > 0 ? "inf" : "-inf") : Json(v); }

// Cached, since a suite measures many folders with the same files, some of them a gigabyte long.
std::string sha256_once(const fs::path& file) {
    static std::mutex mutex;
    static std::map<fs::path, std::tuple<std::uintmax_t, fs::file_time_type, std::string>> known;
    const std::lock_guard lock(mutex);
    auto& [size, time, sha256] = known[file];
    if (sha256.empty() || size != fs::file_size(file) || time != fs::last_write_time(file)) {
        sha256 = sha256_of_file(file);
        size = fs::file_size(file), time = fs::last_write_time(file);
    }
    return sha256;
}

// Loads measures individually: a broken file affects only its own measure.
class Readied {
  public:
    std::vector<ReadyMeasure> measures;
    Json missing = Json::object(), models = Json::object();

    Readied(const ImageMeasures& inputs, const Run& run) {
        LoadedClips clips;
        for (const MeasureKind& kind : measure_kinds())
            if (is_wanted(kind, inputs.wanted, inputs.weights) && is_possible(kind, inputs)) {
                run.check_stop();
                add(kind, inputs, clips);
            }
        for (const auto& [name, why] : missing.items())
            run.warn(fmt::format("{} is not measured: {}", name, why.get<std::string>()));
    }

  private:
    static bool is_possible(const MeasureKind& kind, const ImageMeasures& inputs) {
        if (kind.needs == Needs::nothing ||
            (kind.needs == Needs::reference ? !inputs.reference.empty() : !inputs.prompt.empty()))
            return true;
        if (!inputs.wanted.empty())
            throw UsageError("--measure {}: expected {}, found none", kind.name,
                             kind.needs == Needs::reference ? "--reference DIR" : "--prompt TEXT");
        return false;
    }
    void add(const MeasureKind& kind, const ImageMeasures& inputs, LoadedClips& clips) try {
        const MeasureFiles found = look_for(kind, inputs.weights);
        if (!found.absent.empty()) {
            missing[kind.name] = found.absent;
            return;
        }
        ReadyMeasure ready = ready_measure(kind, found.files, inputs.prompt, clips);
        Json files = Json::array();
        for (const fs::path& file : ready.files)
            files.push_back({{"file", file.string()}, {"sha256", sha256_once(file)}});
        if (!files.empty()) models[kind.name] = std::move(files);
        measures.push_back(std::move(ready));
    } catch (const Error& e) {
        missing[kind.name] = e.what();
    }
};

// Number of reference pictures without a counterpart.
int without_picture(const std::vector<fs::path>& pictures, const fs::path& reference, const Run& run) {
    if (!fs::is_directory(reference)) return 0;
    std::vector<std::string> alone;
    std::set<std::string> names;  // a set, for folders with thousands
    for (const fs::path& picture : pictures) names.insert(picture.filename().string());
    for (const fs::path& file : pictures_in(reference, "--reference"))
        if (!names.contains(file.filename().string())) alone.push_back(file.filename().string());
    if (!alone.empty())
        run.note(
            fmt::format("--reference {}: {} of its pictures have no picture of the same name and are left out ({}{})",
                        reference.string(), alone.size(), alone[0], alone.size() > 1 ? " …" : ""));
    return static_cast<int>(alone.size());
}

// Transparent parts count as black in every measure.
void note_alpha(const fs::path& file, Json& transparent, const Run& run) {
    const Json name = file.string();
    if (std::find(transparent.begin(), transparent.end(), name) != transparent.end() || load_alpha(file).empty())
        return;
    transparent.push_back(name);
    run.note(fmt::format("{}: transparent in parts, measured over black", file.string()));
}

struct PicturePair {
    ImageRgb8 picture, reference;  // the reference may be empty
};
PicturePair load_pair(const fs::path& picture, const fs::path& partner) {
    PicturePair pair{load_rgb8(picture), partner.empty() ? ImageRgb8{} : load_rgb8(partner)};
    // Sizes may differ here only if a damaged header was skipped by check_partners.
    if (!partner.empty() && !pair.picture.same_size(pair.reference))
        throw Error("{}: expected {} x {} as {} is, found {} x {}", partner.string(), pair.picture.width,
                    pair.picture.height, picture.string(), pair.reference.width, pair.reference.height);
    return pair;
}

// Pictures are measured in batches, which networks process faster; large pictures in smaller batches, to bound memory.
// Six at a time gain nothing over four.
struct Loaded {
    fs::path path;
    PicturePair pair;
};
constexpr std::size_t kMostTogether = 4, kMostPixelsTogether = 8'000'000;
bool is_full(const std::vector<Loaded>& group) {
    std::size_t pixels = 0;
    for (const Loaded& one : group) pixels += one.pair.picture.pixels.size();
    return group.size() >= kMostTogether || pixels >= kMostPixelsTogether;
}

// Files in a folder that look like pictures but are not measured: "3 .exr, 1 .gif"; empty: none.
std::string other_pictures(const fs::path& folder) {
    std::map<std::string, int> counts;
    if (fs::is_directory(folder))
        for (const auto& entry : fs::directory_iterator(folder)) {
            std::string ending = entry.path().extension().string();
            for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
            for (const std::string_view other :
                 {".exr", ".hdr", ".pfm", ".gif", ".bmp", ".ppm", ".avif", ".heic", ".jxl", ".jp2"})
                if (ending == other) ++counts[ending];
        }
    std::string out;
    for (const auto& [ending, count] : counts) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, ending);
    return out;
}

}  // namespace

const std::vector<std::string>& image_measure_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out;
        for (const MeasureKind& kind : measure_kinds()) out.push_back(kind.name);
        return out;
    }();
    return names;
}

std::vector<fs::path> pictures_in(const fs::path& place, const std::string& flag) {
    if (fs::is_regular_file(place)) return {place};
    std::vector<fs::path> out;
    if (fs::is_directory(place))
        for (const auto& entry : fs::directory_iterator(place))
            if (has_picture_ending(entry.path())) out.push_back(entry.path());
    if (out.empty()) {
        const std::string others = other_pictures(place);
        throw Error("{} {}: expected a picture or a folder of .png, .jpg, .webp or .tif, found {}", flag,
                    place.string(), others.empty() ? "none" : "only " + others);
    }
    std::sort(out.begin(), out.end());
    return out;
}

Json measure_images(const ImageMeasures& inputs, const Run& run) {
    const std::vector<fs::path> pictures = pictures_in(inputs.pictures, "metrics images");
    if (const std::string others = other_pictures(inputs.pictures); !others.empty())
        run.note(fmt::format("{}: {} are not measured, which takes .png, .jpg, .webp or .tif", inputs.pictures.string(),
                             others));
    if (!inputs.reference.empty()) check_partners(pictures, inputs.reference);
    const int alone = without_picture(pictures, inputs.reference, run);
    const Readied ready(inputs, run);

    Json rows = Json::array(), undefined = Json::object(), transparent = Json::array(), left_out = Json::object();
    std::map<std::string, std::pair<double, int>> sums;
    Progress progress(run, "metrics", static_cast<std::int64_t>(pictures.size()));
    std::vector<Loaded> group;
    const auto measure_group = [&] {
        run.check_stop();
        std::vector<Subject> subjects;
        for (const Loaded& one : group) subjects.push_back({one.pair.picture, one.pair.reference});
        look_together(subjects, ready.measures);
        for (std::size_t i = 0; i < group.size(); ++i) {
            const fs::path& path = group[i].path;
            Json row = {{"name", path.filename().string()}};
            for (const auto& [name, measure, files, clip] : ready.measures) try {
                    const double v = measure(subjects[i]);
                    if (std::isnan(v)) throw Error("{}: expected a number, found none (damaged weights?)", name);
                    row[name] = number(v);
                    if (std::isfinite(v)) sums[name].first += v, ++sums[name].second;
                } catch (const Error& e) {
                    row[name] = nullptr;
                    undefined[path.filename().string()][name] = e.what();
                    run.warn(fmt::format("{}: {}", path.string(), e.what()));
                }
            rows.push_back(std::move(row));
            progress.advance();
        }
        group.clear();
    };
    for (const fs::path& path : pictures) {
        run.check_stop();
        const fs::path partner = inputs.reference.empty() ? fs::path() : partner_of(path, inputs.reference);
        PicturePair pair;
        try {
            pair = load_pair(path, partner);
            note_alpha(path, transparent, run);
            if (!partner.empty()) note_alpha(partner, transparent, run);
        } catch (const Error& e) {
            left_out[path.filename().string()] = e.what();
            run.warn(fmt::format("left out: {}", e.what()));
            progress.advance();
            continue;
        }
        group.push_back({path, std::move(pair)});
        if (is_full(group)) measure_group();
    }
    measure_group();
    if (rows.empty())
        throw Error("{}{}",
                    left_out.size() == 1
                        ? ""
                        : fmt::format("{}: expected pictures, found none of {} that can be read; the first: ",
                                      inputs.pictures.string(), left_out.size()),
                    left_out.front().get<std::string>());
    Json mean = Json::object(), mean_of = Json::object();
    for (const auto& [name, measure, files, clip] : ready.measures) {
        const auto& [sum, count] = sums[name];
        mean[name] = count ? Json(sum / count) : Json();
        mean_of[name] = count;
    }
    return {
        {"count", rows.size()},       {"pictures", rows},         {"left_out", left_out},   {"mean", mean},
        {"mean_of", mean_of},         {"missing", ready.missing}, {"undefined", undefined}, {"models", ready.models},
        {"transparent", transparent}, {"without_picture", alone}};
}

Json missing_measures(const fs::path& weights, const std::vector<std::string>& wanted) {
    Json missing = Json::object();
    for (const MeasureKind& kind : measure_kinds())
        if (is_wanted(kind, wanted, weights))
            if (const MeasureFiles found = look_for(kind, weights); !found.absent.empty())
                missing[kind.name] = found.absent;
    return missing;
}

std::vector<fs::path> measure_files(const fs::path& weights, const std::string& measure) {
    std::vector<fs::path> files;
    for (const MeasureKind& kind : measure_kinds())
        if (kind.name == measure) files = look_for(kind, weights).files;
    return files;
}

std::vector<std::string> not_measured(const Json& report, const std::vector<std::string>& wanted) {
    std::vector<std::string> out;
    const Json& rows = report.at("pictures");
    std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(out), [&](const std::string& name) {
        return std::all_of(rows.begin(), rows.end(),
                           [&](const Json& row) { return row.value(name, Json()).is_null(); });
    });
    return out;
}

std::string image_table(const Json& report) {
    const Json& rows = report.at("pictures");
    std::string out = fmt::format("{:<28}", "picture");
    for (const auto& [name, value] : report.at("mean").items()) out += fmt::format(" {:>14}", name);
    const auto line = [&](const std::string& title, const Json& row) {
        out += fmt::format("\n{:<28}", title);
        for (const auto& [name, value] : report.at("mean").items()) {
            const Json& v = row.at(name);
            out += fmt::format(" {:>14}", v.is_null()     ? "-"
                                          : v.is_string() ? v.get<std::string>()
                                                          : fmt::format("{:.4f}", v.get<double>()));
        }
    };
    for (const Json& row : rows) line(row.at("name"), row);
    if (rows.size() > 1) line("mean", report.at("mean"));
    for (const auto& [name, count] : report.at("mean_of").items()) {
        if (count == rows.size()) continue;
        const auto infinite = std::count_if(rows.begin(), rows.end(),
                                            [&, key = name](const Json& row) { return row.at(key).is_string(); });
        const auto undefined = std::count_if(rows.begin(), rows.end(),
                                             [&, key = name](const Json& row) { return row.at(key).is_null(); });
        const auto first = std::find_if(rows.begin(), rows.end(),
                                        [&, key = name](const Json& row) { return row.at(key).is_null(); });
        out += fmt::format("\n{}: the mean is over {} of {} pictures", name, count.get<int>(), rows.size());
        if (undefined) {
            const std::string picture = first->at("name"), why = report.at("undefined").at(picture).at(name);
            out += fmt::format("; not defined for {} ({}{})", undefined, undefined > 1 ? picture + ": " : "", why);
        }
        if (infinite) out += fmt::format("; infinite for {}", infinite);
    }
    if (const Json& left_out = report.at("left_out"); !left_out.empty()) {
        out += fmt::format("\n{} of {} pictures cannot be read and are left out:", left_out.size(),
                           left_out.size() + rows.size());
        for (const auto& [name, why] : left_out.items()) out += fmt::format("\n  {}", why.get<std::string>());
    }
    for (const auto& [name, files] : report.at("models").items()) {
        out += fmt::format("\n{} by", name);
        for (const Json& file : files)
            out += fmt::format("{} {} (sha256 {:.12})", &file == &files[0] ? "" : ",",
                               file.at("file").get<std::string>(), file.at("sha256").get<std::string>());
    }
    for (const auto& [name, why] : report.at("missing").items())
        out += fmt::format("\n{} is not measured: {}", name, why.get<std::string>());
    return out;
}

fs::path metrics_weights(const fs::path& given) {
    if (!given.empty() && !fs::is_directory(given))
        throw Error("--weights {}: expected a folder, found {}", given.string(), fs::exists(given) ? "a file" : "none");
    if (!given.empty()) return given;
    if (const char* own = std::getenv("FASTSCENE_WEIGHTS"); own && *own) return own;
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache)
        return fs::path(cache) / "fastscene/metrics";
    const char* home = std::getenv("HOME");
    return fs::path(home ? home : ".") / ".cache/fastscene/metrics";
}

std::string metrics_weights_text() {
    std::string out = "Measures:\n";
    for (const MeasureKind& kind : measure_kinds())
        out += fmt::format("  {:<15} {}{}\n", kind.name, kind.about,
                           kind.unasked == Unasked::left_out ? "; only when asked for" : "");
    out += "Files of --weights:\n";
    for (const MeasureKind& kind : measure_kinds())
        if (!kind.files.empty())
            out += fmt::format("  {:<15} {}  ({})\n", kind.name, fmt::join(kind.files, ", "), kind.source);
    return out;
}

}  // namespace fastscene
