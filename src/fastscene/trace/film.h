// Film: radiance becomes a picture. One exposure, white and curve a room, so that all its views agree.
#pragma once

#include "fastscene/image/image.h"
#include "fastscene/scene/room.h"

namespace fastscene {

// Exposure and white for a room from a small panorama of radiances as seen from its first viewpoint. With the albedo of
// the same pixels (else empty) the light itself is measured, not only what surfaces return of it: a dark room stays
// dark, a white one white, and what is neutral stays so beside warm walls. How much of the sun is seen follows from the
// exposure (Sky::sun_limit).
Look automatic_look(const Look& wish, const Sky& sky, const ImageColor& panorama, const ImageColor& albedo = {});

// What the camera sees of the outside in a direction (world, unit); what that lights is lit by all of it
// (sky_radiance).
Vec3f outside_as_seen(const Sky& sky, const Look& look, Vec3f direction);

// The radiance of a lamp or flame that the camera looks at: as behind a photographer's filter, so that its shape and
// hue are not lost in white. What it lights is lit by all of it.
Vec3f lamp_as_seen(const Look& look, Vec3f emission);

// Radiance -> linear display-referred color in 0..1.
Vec3f develop(const Look& look, Vec3f radiance);

}  // namespace fastscene
