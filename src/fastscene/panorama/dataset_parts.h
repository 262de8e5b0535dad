// What the parts of the dataset maker say to each other. Private to panorama/dataset*.cc.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fastscene/base/json.h"
#include "fastscene/base/random.h"
#include "fastscene/image/image.h"
#include "fastscene/scene/room.h"

namespace fastscene::dataset {

// A room drawn at random: a sentence, and what no sentence says (materials, brightness of lamps, exposure, white
// balance).
struct RandomRoom {
    std::string prompt;
    Room room;
};
RandomRoom random_room(std::uint64_t seed, int index);

// What lens, sensor and file do to a picture.
struct Film {
    float blur_px = 0;          // sigma
    float shot_noise = 0;       // standard deviation at white, shrinks with the square root of the light
    float read_noise = 0;       // standard deviation everywhere
    float gamma = 1, lift = 0;  // tone curve in the encoding of the file
    float s_curve = 0;
    float vignette = 0;  // share of light lost in the corners
    int jpeg_quality = 95;
};
Film random_film(Random& rng, bool perspective);
// `color`: linear, display-referred. Columns wrap when `wraps`.
ImageRgb8 expose(const ImageColor& color, const Film& film, bool wraps, Random& rng);
Json to_json(const Film& film);

// NYU40 classes, which indoor networks are trained with; 0 = outside or unknown.
int nyu40_of(const std::string& klass);
Json nyu40_names();

// One process at a time makes a room: it holds `folder`/NAME.claim. A claim that its process left behind (it is gone,
// or from another machine and older than `stale_minutes`) is taken over. Should two ever make the same room, they write
// the same bytes.
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
