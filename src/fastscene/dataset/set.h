// A data set on disk, as make_dataset writes it (docs/dataset.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/base/json.h"
#include "fastscene/dataset/camera.h"
#include "fastscene/dataset/channels.h"
#include "fastscene/dataset/dataset.h"

namespace fastscene::dataset {

inline constexpr std::string_view kSetFormat = "fastscene dataset 2";

// dataset.json, checked: throws UsageError if the folder is no data set, or one of another version's.
Json read_set_settings(const std::filesystem::path& folder);
// What make_dataset was asked for, and its seed.
struct MadeFrom {
    DatasetRequest request;
    std::uint64_t seed = 0;
};
MadeFrom made_from(const Json& settings, const std::filesystem::path& folder);
// The command that makes the set again: "fastscene rooms dataset --count …", without its folder.
std::string command_of(const MadeFrom& from);

// Names within the folder.
std::string picture_stem(int picture, int shard);  // "shard-00000/00000042"
std::string room_document_name(int room);          // "rooms-00000/0000010.json"
// The lines of index.txt: the JSON of each picture.
std::string index_text(int count, int shard);

// A picture's JSON ends with a hash of everything before it.
void seal(Json& about);
bool is_sealed(const Json& about);

struct SetPicture {
    int number = 0, room = 0;
    std::string name;   // "00000042"
    std::string shard;  // "shard-00000"
    Json about;
};

class DataSet {
  public:
    // Reads the settings and the JSON of every picture. Throws UsageError if it is no data set, Error naming a picture
    // whose JSON is damaged, or if pictures are missing and `complete` is asked for.
    DataSet(std::filesystem::path folder, bool complete);

    const std::filesystem::path& folder() const { return folder_; }
    const Json& settings() const { return settings_; }
    const MadeFrom& made() const { return made_; }
    const std::vector<SetPicture>& pictures() const { return pictures_; }  // in the order of their numbers
    int width() const { return made_.request.width; }
    int height() const { return made_.request.height; }
    bool is_panorama() const { return settings_.at("camera") == "panorama"; }
    std::vector<Channel> channels() const;  // that its pictures have
    std::vector<std::string> classes() const;
    std::string license() const;  // chosen for it; empty: none yet

    // A file of a picture ("color", "room_document" …), and its content. Throws Error for one that is missing or
    // damaged.
    std::filesystem::path file(const SetPicture& picture, std::string_view channel) const;
    std::string bytes(const SetPicture& picture, std::string_view channel) const;
    Camera camera(const SetPicture& picture) const;

  private:
    std::filesystem::path folder_;
    Json settings_;
    MadeFrom made_;
    std::vector<SetPicture> pictures_;
};

// Numbers of pictures whose JSON is not there.
std::vector<int> missing_pictures(const std::filesystem::path& folder, const Json& settings);

}  // namespace fastscene::dataset
