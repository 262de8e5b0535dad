#include "fastscene/dataset/set.h"

#include <algorithm>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/hash.h"
#include "fastscene/base/parallel.h"
#include "fastscene/base/shortest.h"
#include "fastscene/dataset/checksum.h"

namespace fastscene::dataset {
namespace {

namespace fs = std::filesystem;

constexpr int kRoomsOfFolder = 1000;  // documents in a folder: file systems slow down with many more

// Collects the settings that differ from the usual ones, as flags.
struct OtherThanUsual {
    const Json& usual;
    std::string out;
    template <class T, class... Rest>
    void operator()(std::string_view name, T& value, const Rest&...) {
        const Json as_json = detail_json(value);
        if (usual.at(std::string(name)) == as_json) return;
        if constexpr (std::is_same_v<T, bool>) out += fmt::format(" --{}", name);
        else out += fmt::format(" --{} {}", name, value);
    }

  private:
    template <class T>
    static Json detail_json(const T& value) {
        if constexpr (std::is_same_v<T, float>) return shortest(value);
        else return value;
    }
};

}  // namespace

Json read_set_settings(const fs::path& folder) {
    const fs::path file = folder / "dataset.json";
    if (!fs::is_directory(folder))
        throw UsageError("{}: expected the folder of a data set, found none", folder.string());
    if (!fs::exists(file))
        throw UsageError("{}: expected a data set of `fastscene rooms dataset`, found no dataset.json",
                         folder.string());
    Json settings = read_json(file);
    const std::string format = settings.is_object() ? settings.value("format", "") : "";
    if (format != kSetFormat)
        throw UsageError("{}: expected \"{}\", found {}: make the set anew with this version, in another folder",
                         file.string(), kSetFormat, format.empty() ? "no format" : "\"" + format + "\"");
    return settings;
}

MadeFrom made_from(const Json& settings, const fs::path& folder) {
    MadeFrom from;
    try {
        from.seed = settings.at("seed").get<std::uint64_t>();
        from.request.count = settings.at("count").get<int>();
        from.request.width = settings.at("width").get<int>();
        from.request.height = settings.at("height").get<int>();
        fields_from_json(settings.at("settings"), from.request.params);
    } catch (const Json::exception& e) {
        throw Error("{}: expected seed, count, width, height and settings: {}", (folder / "dataset.json").string(),
                    e.what());
    }
    check_fields("", from.request.params);
    if (from.request.count < 1 || from.request.width < 1 || from.request.height < 1)
        throw Error("{}: expected a count and a size above 0", (folder / "dataset.json").string());
    return from;
}

std::string command_of(const MadeFrom& from) {
    const Json usual = fields_json(DatasetParams{});
    OtherThanUsual others{usual, {}};
    DatasetParams params = from.request.params;
    visit_fields(params, others);
    return fmt::format("fastscene rooms dataset --count {} --size {}x{} --seed {}{}", from.request.count,
                       from.request.width, from.request.height, from.seed, others.out);
}

std::string picture_stem(int picture, int shard) { return fmt::format("shard-{:05}/{:08}", picture / shard, picture); }

std::string room_document_name(int room) { return fmt::format("rooms-{:05}/{:07}.json", room / kRoomsOfFolder, room); }

std::string index_text(int count, int shard) {
    std::string lines;
    for (int i = 0; i < count; ++i) lines += picture_stem(i, shard) + ".json\n";
    return lines;
}

void seal(Json& about) { about["check"] = Hash().add(about.dump()).hex(); }

bool is_sealed(const Json& about) {
    if (!about.is_object() || !about.contains("check")) return false;
    Json before = about;
    before.erase("check");
    return about["check"] == Hash().add(before.dump()).hex();
}

std::vector<int> missing_pictures(const fs::path& folder, const Json& settings) {
    const MadeFrom from = made_from(settings, folder);
    std::vector<int> out;
    for (int i = 0; i < from.request.count; ++i)
        if (!fs::exists(folder / (picture_stem(i, from.request.params.shard) + ".json"))) out.push_back(i);
    return out;
}

DataSet::DataSet(fs::path folder, bool complete)
    : folder_(std::move(folder)), settings_(read_set_settings(folder_)), made_(made_from(settings_, folder_)) {
    const int count = made_.request.count, shard = made_.request.params.shard;
    const std::vector<int> missing = missing_pictures(folder_, settings_);
    if (complete && !missing.empty())
        throw Error("{}: expected {} pictures, found {}: {} -o {} makes the others", folder_.string(), count,
                    count - static_cast<int>(missing.size()), command_of(made_), folder_.string());
    for (int i = 0; i < count; ++i) {
        if (std::binary_search(missing.begin(), missing.end(), i)) continue;
        const fs::path stem = picture_stem(i, shard);
        pictures_.push_back(
            {i, i / made_.request.params.views, stem.filename().string(), stem.parent_path().string(), {}});
    }
    parallel_for(static_cast<std::int64_t>(pictures_.size()), 64, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            SetPicture& picture = pictures_[static_cast<std::size_t>(i)];
            const fs::path file = folder_ / picture.shard / (picture.name + ".json");
            picture.about = read_json(file);
            if (!is_sealed(picture.about))
                throw Error("{}: damaged: `fastscene dataset verify {} --repair` makes it again", file.string(),
                            folder_.string());
        }
    });
}

std::vector<Channel> DataSet::channels() const {
    const std::vector<std::string> asked = asked_channels(made_.request.params.channels);
    std::vector<Channel> out;
    for (const Channel& channel : kChannels)
        if (channel.asked.empty() || std::find(asked.begin(), asked.end(), channel.asked) != asked.end())
            out.push_back(channel);
    return out;
}

std::vector<std::string> DataSet::classes() const { return settings_.at("classes").get<std::vector<std::string>>(); }

std::string DataSet::license() const { return settings_.value("license", ""); }

fs::path DataSet::file(const SetPicture& picture, std::string_view channel) const {
    const std::string name(channel);
    const fs::path path = folder_ / picture.shard / picture.about.at(name).get<std::string>();
    if (const std::string fault = fault_of(path, checksum_from_json(picture.about.at("files").at(name)), false);
        !fault.empty())
        throw Error("{}: {}; `fastscene dataset verify {} --repair` makes it again", path.lexically_normal().string(),
                    fault, folder_.string());
    return path;
}

std::string DataSet::bytes(const SetPicture& picture, std::string_view channel) const {
    return read_file(file(picture, channel));
}

Camera DataSet::camera(const SetPicture& picture) const { return camera_from_json(picture.about, width(), height()); }

}  // namespace fastscene::dataset
