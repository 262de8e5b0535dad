// The user's files behind a source, each read once and each picture decoded once in a run, however many steps ask.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "fastscene/panorama/picture_file.h"

namespace fastscene {

class SourceFiles {
  public:
    // All bytes of a file. Throws Error when it cannot be read.
    const std::string& bytes(const std::filesystem::path& file);
    // A panorama from those bytes. Throws Error as panorama_from_image does.
    const PictureFile& picture(const std::filesystem::path& file);
    // What is known of a picture's size without decoding it again.
    EquirectSize size(const std::filesystem::path& file);
    // The bytes are not asked for again: a run goes on for long.
    void drop_bytes() { bytes_.clear(); }
    // The same, and it is not kept: who asks last.
    PictureFile take(const std::filesystem::path& file);
    void drop_pictures() { pictures_.clear(); }

  private:
    std::map<std::filesystem::path, std::string> bytes_;
    std::map<std::filesystem::path, PictureFile> pictures_;
    std::map<std::filesystem::path, EquirectSize> sizes_;
};

}  // namespace fastscene
