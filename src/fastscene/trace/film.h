// Film: tone mapping from radiance to display color. One exposure, white balance and curve per room, so that all views
// agree.
#pragma once

#include <optional>

#include "fastscene/image/image.h"
#include "fastscene/scene/room.h"

namespace fastscene {

// Chooses exposure and white balance from a small radiance panorama seen from the room's first viewpoint. `albedo`, of
// the same pixels or empty, lets the incident light be measured rather than the reflected light: a dark room stays
// dark, a white one white, and neutral surfaces stay neutral beside warm walls. The exposure also determines how much
// of the direct sun is shown (Sky::sun_limit).
// `outside`: luminance of what the windows show (Outdoors::brightness); nothing: that of the sky's ground.
Look automatic_look(const Look& wish, const Sky& sky, const ImageColor& panorama, const ImageColor& albedo = {},
                    std::optional<float> outside = {});

// Radiance of the outside (outdoors.h) as the camera sees it. As illumination it is not adjusted.
Vec3f outside_as_seen(const Sky& sky, const Look& look, Vec3f radiance);

// The radiance of a lamp or flame that the camera sees directly, compressed so that its shape and hue do not clip to
// white. Its illumination of the room is unaffected.
Vec3f lamp_as_seen(const Look& look, Vec3f emission);

// What the film's curve rises by a stop, in display values; 0: the curve is a straight line.
float film_slope(const Look& look);

// Radiance -> linear display-referred color in 0..1.
Vec3f develop(const Look& look, Vec3f radiance);

}  // namespace fastscene
