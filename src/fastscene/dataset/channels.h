// The maps of a picture, as data.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace fastscene::dataset {

struct Channel {
    std::string_view name;    // key in the picture's JSON; its file is NUMBER.NAME.ENDING
    std::string_view ending;  // of clean film; that of varied film is "jpg" for color
    std::string_view asked;   // the word of --channels that adds it; empty: always there
    std::string_view about;
};
inline constexpr std::array kChannels{
    Channel{"color", "png", "", "sRGB"},
    Channel{"range", "png", "", "16 bit gray: millimetres along the pixel's ray; 0 = outside"},
    Channel{"normal", "png", "",
            "8 bit: (n + 1) / 2 in the camera's frame (x right, y down, z forward); 128 = outside"},
    Channel{"class", "png", "", "8 bit gray: NYU40 class; 0 = outside"},
    Channel{"instance", "png", "", "16 bit gray: id of the JSON's instances; 0 = walls, floor, ceiling, outside"},
    Channel{"albedo", "png", "intrinsics", "sRGB: diffuse albedo; 0 = outside, light sources, mirrors"},
    Channel{"shading", "exr", "intrinsics",
            "16 bit float, linear: light divided by albedo; where that is 0, the light"},
    Channel{"flow", "png", "flow", "16 bit color: (u, v, valid) to the room's next picture, as KITTI writes flow"},
};

// The words of --channels that there are.
std::vector<std::string> further_channels();
// Those of a list separated by commas, in the order of kChannels. Throws UsageError for an unknown word.
std::vector<std::string> asked_channels(const std::string& list);

// The file's ending with its dots: ".color.jpg".
std::string ending_of(const Channel& channel, bool clean_film);

}  // namespace fastscene::dataset
