// Pictures of both eyes, from splats or a traced room. The left eye is above (360 degrees) or on the left (VR180).
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "fastscene/geometry/eyes.h"
#include "fastscene/image/image.h"
#include "fastscene/math/rigid.h"
#include "fastscene/splat/splat.h"

namespace fastscene {

// mono; top-bottom: omnidirectional stereo, two spheres one above the other; vr180: the front halves of two spheres
// side by side, seen by eyes that do not turn.
enum class FilmStereo : std::uint8_t { mono, top_bottom, vr180 };
inline constexpr std::string_view kFilmStereos[] = {"mono", "top-bottom", "vr180"};

// One above the other, or side by side. Throws if the sizes differ.
ImageRgb8 stacked(const ImageRgb8& above, const ImageRgb8& below);
ImageRgb8 beside(const ImageRgb8& left, const ImageRgb8& right);
// The middle half of an equirectangular picture: the front.
ImageRgb8 front_half(const ImageRgb8& sphere);
// The same viewpoint for an eye that does not turn, `eye_m` to the right.
Rigid displaced_eye(const Rigid& world_from_camera, float eye_m);

// The panorama of one turning eye from splats: upright slices, each from the eye's place for its middle and blended
// into its neighbours. Rows beyond the latitude where the offset has faded come from the panorama of the center.
ImageRgb8 eye_sphere_of(const SplatRenderer& splats, int width, const Rigid& world_from_pano, float eye_m,
                        Vec3f background = {});

}  // namespace fastscene
