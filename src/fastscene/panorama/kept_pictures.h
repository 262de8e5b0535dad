// Pictures that took long, kept beside the stage that makes them: a run that was stopped goes on after the last one,
// and a picture that is made larger later begins with the one that is there.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "fastscene/image/image.h"

namespace fastscene {

struct KeptPicture {
    ImageRgb8 picture;
    double seconds = 0;  // that it took when it was made
    bool was_there = false;
};

class KeptPictures {
  public:
    // An empty folder: nothing is kept.
    explicit KeptPictures(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // NAME.png of the folder if it was kept under this key, a hash of all that it hangs on; else what `make` returns,
    // which is kept from then on. Throws what `make` throws; Error when it cannot be written.
    KeptPicture get(const std::string& name, const std::string& key, const std::function<ImageRgb8()>& make) const;
    std::filesystem::path file_of(const std::string& name) const { return folder_ / (name + ".png"); }

  private:
    std::filesystem::path folder_;
};

}  // namespace fastscene
