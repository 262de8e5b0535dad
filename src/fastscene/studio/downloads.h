// The files of a scene for other programs: those that are there, and those that are made when asked for.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/studio/library.h"

namespace fastscene::studio {

class Downloads {
  public:
    Downloads(Library& library, std::filesystem::path program) : library_(library), program_(std::move(program)) {}

    // [{id, group, file, about, bytes (null: made on demand), command}]
    Json list(const std::string& scene) const;
    // Makes it if it is not there or older than the scene. Throws Refusal 404 for an unknown id, Error with the
    // program's words if it cannot be made.
    std::filesystem::path make(const std::string& scene, const std::string& id);

  private:
    std::filesystem::path made_file(const std::string& scene, const std::string& file) const;
    bool is_current(const std::string& scene, const std::filesystem::path& made) const;

    Library& library_;
    std::filesystem::path program_;
    std::mutex mutex_;  // one at a time: each takes all cores
};

}  // namespace fastscene::studio
