#include "fastscene/dataset/export.h"

#include "fastscene/base/error.h"
#include "fastscene/base/parallel.h"
#include "fastscene/dataset/card.h"

namespace fastscene::dataset {
namespace {

namespace fs = std::filesystem;

// What an export must have in common with an existing one in the folder.
Json export_description(const DataSet& set, const DatasetFormat& format, const ExportSettings& settings) {
    Json source = set.settings();
    for (const char* name : {"count", "classes", "license"}) source.erase(name);
    Json out{{"kind", format.name}, {"source", source}, {"splits", settings.splits}};
    if (format.sharded) {
        out["shard_samples"] = settings.shard_samples;
        out["shard_bytes"] = settings.shard_bytes;
    }
    return out;
}

void check_format(const DataSet& set, const DatasetFormat& format) {
    if (set.is_panorama() ? format.panoramas : format.perspective) return;
    std::vector<std::string> others;
    for (const DatasetFormat& other : registered<DatasetFormat>())
        if (set.is_panorama() ? other.panoramas : other.perspective) others.push_back(other.name);
    throw UsageError("--format {}: expected {}, found {}: {} can hold them", format.name,
                     set.is_panorama() ? "perspective pictures" : "panoramas",
                     set.is_panorama() ? "panoramas" : "perspective pictures", any_of(others));
}

}  // namespace

void ExportJob::for_each(const std::function<void(std::size_t, const SetPicture&)>& work) const {
    std::vector<std::pair<std::size_t, const SetPicture*>> all;
    for (std::size_t split = 0; split < splits.size(); ++split)
        for (const SetPicture* picture : splits[split]) all.emplace_back(split, picture);
    Progress progress(run, "pictures", static_cast<std::int64_t>(all.size()));
    parallel_for(static_cast<std::int64_t>(all.size()), 1, [&](std::int64_t begin, std::int64_t) {
        run.check_stop();
        const auto& [split, picture] = all[static_cast<std::size_t>(begin)];
        work(split, *picture);
        progress.advance();
    });
}

Json export_dataset(const fs::path& folder, const std::string& format_name, const ExportSettings& settings,
                    const fs::path& out, const Run& run) {
    const auto& format = registered_entry<DatasetFormat>("--format", format_name);
    const DataSet set(folder, true);
    check_format(set, format);
    const auto splits = split_pictures(set, settings.splits);
    Json counts = Json::object();
    for (std::size_t s = 0; s < kSplits.size(); ++s)
        if (!splits[s].empty()) counts[std::string(kSplits[s])] = splits[s].size();
    ExportFolder written(out, export_description(set, format, settings));
    format.write({set, settings, splits, written, run});
    Json summary{{"pictures", set.pictures().size()}, {"in_splits", counts}};
    written.finish(summary);
    return {{"folder", out.string()}, {"format", format.name},    {"pictures", set.pictures().size()},
            {"splits", counts},       {"files", written.files()}, {"bytes", written.bytes()}};
}

}  // namespace fastscene::dataset
