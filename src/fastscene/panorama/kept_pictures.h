// Caches expensive pictures next to their stage: an interrupted run resumes after the last one, and later upscaling
// starts from the existing picture.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "fastscene/image/image.h"

namespace fastscene {

struct KeptPicture {
    ImageRgb8 picture;
    double seconds = 0;  // time that it took to make
    bool was_there = false;
};

class KeptPictures {
  public:
    // An empty folder disables caching.
    explicit KeptPictures(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // Returns NAME.png of the folder if it was stored under this key, a hash of everything it depends on; otherwise
    // calls `make` and stores the result. Throws what `make` throws, and Error if it cannot be written.
    KeptPicture get(const std::string& name, const std::string& key, const std::function<ImageRgb8()>& make) const;
    std::filesystem::path file_of(const std::string& name) const { return folder_ / (name + ".png"); }

  private:
    std::filesystem::path folder_;
};

}  // namespace fastscene
