// The user's input files: each is read and each picture decoded once per run, however many steps use it.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "fastscene/panorama/picture_file.h"

namespace fastscene {

class SourceFiles {
  public:
    // The file's content. Throws Error if it cannot be read.
    const std::string& bytes(const std::filesystem::path& file);
    // The decoded panorama. Throws Error as panorama_from_image does.
    const PictureFile& picture(const std::filesystem::path& file);
    // The picture's size; does not decode again.
    EquirectSize size(const std::filesystem::path& file);
    // Frees the bytes, which are not needed for the rest of the run.
    void drop_bytes() { bytes_.clear(); }
    // The same without caching, for the last user.
    PictureFile take(const std::filesystem::path& file);
    void drop_pictures() { pictures_.clear(); }

  private:
    std::map<std::filesystem::path, std::string> bytes_;
    std::map<std::filesystem::path, PictureFile> pictures_;
    std::map<std::filesystem::path, EquirectSize> sizes_;
};

}  // namespace fastscene
