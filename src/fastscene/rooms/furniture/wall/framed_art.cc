#include "fastscene/rooms/furniture/wall/framed_art.h"

#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "fastscene/io/image_io.h"
#include "fastscene/rooms/texture_image.h"

namespace fastscene {

// Written by cmake/embed.cmake from wall/art/*.webp.
extern const std::pair<std::string_view, std::string_view> kArtFiles[];
extern const std::size_t kArtCount;

namespace furniture {
namespace {

std::string_view prefix_of(Genre genre) {
    return genre == Genre::photo ? "photo_" : genre == Genre::print ? "print_" : "painting_";
}

std::vector<std::size_t> files_of(Genre genre) {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < kArtCount; ++i)
        if (kArtFiles[i].first.starts_with(prefix_of(genre))) out.push_back(i);
    return out;
}

}  // namespace

FramedArt framed_art(Genre genre, std::uint32_t choice) {
    static std::mutex mutex;
    static std::map<std::size_t, std::shared_ptr<const TextureImage>> decoded;
    const std::vector<std::size_t> files = files_of(genre);
    const std::size_t file = files[choice % files.size()];
    const auto& [name, bytes] = kArtFiles[file];
    const std::lock_guard lock(mutex);
    auto& image = decoded[file];
    if (!image) image = texture_image(decode_rgb8(bytes, std::string(name) + ".webp"));
    return {name, image};
}

}  // namespace furniture
}  // namespace fastscene
