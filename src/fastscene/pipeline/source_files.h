// The user's input files: each is read and each picture decoded once per run, however many steps use it.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "fastscene/panorama/picture_file.h"

namespace fastscene {

class SourceFiles {
  public:
    // `layout`: what the user says about the panoramas.
    explicit SourceFiles(PictureLayout layout = {}) : layout_(std::move(layout)) {}
    // The file's content; of a folder, that of the faces of a cube in it. Throws Error if it cannot be read.
    const std::string& bytes(const std::filesystem::path& file);
    // The decoded panorama. Throws Error as panorama_from_image does.
    const PictureFile& picture(const std::filesystem::path& file);
    bool has_picture(const std::filesystem::path& file) const { return pictures_.contains(file); }
    // The picture's size; does not decode again.
    EquirectSize size(const std::filesystem::path& file);
    // Frees the bytes, which are not needed for the rest of the run.
    void drop_bytes() { bytes_.clear(); }
    // The same without caching, for the last user.
    PictureFile take(const std::filesystem::path& file);
    void drop_pictures() { pictures_.clear(); }

  private:
    PictureLayout layout_;
    std::map<std::filesystem::path, std::string> bytes_;
    std::map<std::filesystem::path, PictureFile> pictures_;
    std::map<std::filesystem::path, EquirectSize> sizes_;
};

}  // namespace fastscene
