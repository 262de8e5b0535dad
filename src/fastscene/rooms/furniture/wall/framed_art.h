// Photographs, black-and-white prints and paintings that hang in frames. All are views of the outside by our own tracer
// (wall/art/README.md).
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "fastscene/scene/room.h"

namespace fastscene::furniture {

// The name of a material that shows one.
inline constexpr const char* kFramedArt = "framed art";

enum class Genre : std::uint8_t { photo, print, painting };

struct FramedArt {
    std::string_view name;  // "print_peaks"
    std::shared_ptr<const TextureImage> image;
};

// One of its genre, chosen by any number. Decoded once, kept as long as the program runs.
FramedArt framed_art(Genre genre, std::uint32_t choice);

}  // namespace fastscene::furniture
