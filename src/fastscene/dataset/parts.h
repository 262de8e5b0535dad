// Shared between the parts of what makes data sets. Private to dataset/.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/base/random.h"
#include "fastscene/image/image.h"
#include "fastscene/scene/room.h"

namespace fastscene::dataset {

// A random room: a prompt, and what prompts do not cover (materials, lamp brightness, exposure, white balance).
struct RandomRoom {
    std::string prompt;
    Room room;
    Json document;  // the room as planned, before its materials and lights vary (docs/room-document.md)
};
RandomRoom random_room(std::uint64_t seed, int index);

// Simulated lens, sensor and file artifacts.
struct Film {
    float blur_px = 0;          // Gaussian sigma
    float shot_noise = 0;       // standard deviation at white; proportional to the square root of the light
    float read_noise = 0;       // standard deviation, independent of the light
    float gamma = 1, lift = 0;  // tone curve, on encoded values
    float s_curve = 0;
    float vignette = 0;  // light falloff in the corners, as a share
    int jpeg_quality = 95;
};
Film random_film(Random& rng, bool perspective);
// `color`: linear, display-referred. `wraps`: columns are circular.
ImageRgb8 expose(const ImageColor& color, const Film& film, bool wraps, Random& rng);
Json to_json(const Film& film);

// A lock for making a room: the file `folder`/NAME.claim. A stale claim (its process is gone, or it is from another
// machine and older than `stale_minutes`) is taken over. Should two processes ever make the same room, they write the
// same bytes.
class Claim {
  public:
    static std::optional<Claim> take(const std::filesystem::path& folder, const std::string& name, int stale_minutes);
    Claim(Claim&& other) noexcept : path_(std::move(other.path_)) { other.path_.clear(); }
    Claim& operator=(Claim&&) = delete;
    ~Claim();
    void still_alive() const;

  private:
    explicit Claim(std::filesystem::path path) : path_(std::move(path)) {}
    std::filesystem::path path_;
};

}  // namespace fastscene::dataset
