// Spherical films: the boxes that tell players and video services that an MP4 film shows the sphere. Google's Spherical
// Video V2 (st3d and sv3d in the video's sample entry), and V1 (XML in a uuid box of the track) for older players,
// which knows whole spheres only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace fastscene {

// How the eyes share a frame. The left eye is above, or on the left.
enum class StereoLayout : std::uint8_t { mono = 0, top_bottom = 1, left_right = 2 };

struct SphericalFilm {
    StereoLayout stereo = StereoLayout::mono;
    bool half = false;  // the front half only, 180 by 180 degrees for each eye (VR180)
};

// The film with these boxes in its first video track; earlier ones are replaced. Sample positions are corrected. Throws
// Error naming the file unless it is an MP4 with a video track.
std::string with_spherical_boxes(std::string_view mp4, const SphericalFilm& film, const std::string& where);
// What an MP4's first video track says of itself; none if nothing.
std::optional<SphericalFilm> spherical_boxes_of(std::string_view mp4);
// Marks a file. Reads it whole: films of rooms are far smaller than memory.
void mark_spherical(const std::filesystem::path& path, const SphericalFilm& film);

}  // namespace fastscene
