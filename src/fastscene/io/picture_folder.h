// Finds pictures whose names on disk differ from those in a model: by letter case, by ending. Private to io/.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fastscene {

// The name with forward slashes: programs on Windows write "images\1.png".
std::string with_slashes(std::string name);

class PictureFolder {
  public:
    explicit PictureFolder(std::filesystem::path root) : root_(std::move(root)) {}
    // The only file below the folder that has the name in another letter case, or else with another picture's ending.
    // Empty: there is none, or several.
    std::filesystem::path similar_to(const std::string& name);
    // The only file below the folder with this name, whatever its folder; or with this name and some ending.
    std::filesystem::path labelled(const std::string& label);

  private:
    void look();
    std::filesystem::path root_;
    bool looked_ = false;
    std::map<std::string, std::vector<std::filesystem::path>> by_name_, by_stem_, by_label_;  // lower case
};

// Pictures that were found under a name other than the model's, for one warning.
struct RenamedPictures {
    std::size_t count = 0;
    std::string name, file;  // of the first
    void add(const std::string& in_model, const std::filesystem::path& on_disk);
    std::optional<std::string> warning(const std::string& source, std::size_t of) const;
};

}  // namespace fastscene
