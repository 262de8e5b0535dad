// Pictures and range maps that were dropped into the page: .studio/uploads, named by their content.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "fastscene/base/json.h"
#include "fastscene/studio/library.h"

namespace fastscene::studio {

inline constexpr std::int64_t kMostUploadBytes = 64 << 20;  // an 8K panorama as a PNG has 50 MB

class Uploads {
  public:
    explicit Uploads(Library& library) : library_(library) {}

    // `read(put)` calls put(bytes) until all is there or put returns false. Throws Refusal 413 for more than
    // kMostUploadBytes, without reading the rest.
    using Put = std::function<bool(std::string_view bytes)>;
    // A panorama: {id, name, width, height, warnings}; a range map: {id, name, width, height}. Throws Refusal 422 with
    // the decoder's message for a file that is not a picture, whatever its name.
    Json panorama(const std::string& name, const std::function<bool(const Put&)>& read);
    Json range_map(const std::string& name, const std::function<bool(const Put&)>& read);
    // Throws Refusal 404 for an unknown id.
    std::filesystem::path file(const std::string& id) const;

  private:
    std::filesystem::path receive(const std::string& name, const std::function<bool(const Put&)>& read) const;

    Library& library_;
};

}  // namespace fastscene::studio
