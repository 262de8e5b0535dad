// A photographed outside (HDRI) as what a room's windows show and what lights it.
#pragma once

#include <memory>

#include "fastscene/rooms/user_assets.h"

namespace fastscene {

// In the picture's own frame: y down, its center column looks along +z. Radiances relative to the mean luminance of its
// upper half, which is 1.
struct PhotographedSky {
    ImageColor picture;             // without the sun's disc
    Vec3f sun_dir{0, -1, 0};        // unit
    Vec3f sun_irradiance{};         // on a surface facing it; zero: no sun stands out
    Vec3f zenith, horizon, ground;  // means of the highest, the lower half of the upper, and the lower part
};

// Throws Error naming the file for what is no 2:1 picture of radiance.
PhotographedSky load_user_sky(const std::filesystem::path& folder, const UserSky& sky);
// The same from pixels; `where` names them in errors.
PhotographedSky photographed_sky(ImageColor radiance, const std::string& where);

// The picture turned about the vertical, so that its center looks to an azimuth (radians, from +z to +x).
ImageColor turned_to(const ImageColor& picture, float azimuth);

}  // namespace fastscene
