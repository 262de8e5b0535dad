// GPano: what cameras and phones write about a panorama into its XMP, in any picture format.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fastscene {

// Values as written, in pixels of the whole panorama and degrees; absent ones are empty.
struct GPano {
    std::string projection;  // "equirectangular", "cylindrical"; empty: not written
    std::optional<double> full_width, full_height, left, top, cropped_width, cropped_height;
    double pitch_deg = 0;  // of the picture's middle above the horizon
    double roll_deg = 0;   // the horizon is turned by this much, counterclockwise in the picture
    bool has_crop() const { return full_width && full_height && left && top && cropped_width && cropped_height; }
};
// From the picture's first XMP packet, with values as attributes or as elements. Empty: there is none, or it says
// nothing about panoramas, or is damaged.
std::optional<GPano> gpano_of(std::string_view file);

}  // namespace fastscene
