// Whether a picture is a picture: finds blank, black, white, transparent ones and numbers that are none. Takes no view
// on beauty: what it complains of is broken whatever it shows.
#pragma once

#include <string>

#include "fastscene/image/image.h"

namespace fastscene {

// Shares of all pixels, 0..1.
struct PictureHealth {
    double black = 0, white = 0;  // no channel above 3, none below 252, of 255
    double contrast = 0;          // standard deviation of the luma, 0..1
    double transparent = 0;       // alpha below one half
    double not_finite = 0;        // NaN or infinite numbers
};

PictureHealth health_of(const ImageRgb8& picture);
// sRGB-encoded color 0..1 with its alpha, as splats are rendered.
PictureHealth health_of(const ImageColor& encoded, const ImageF& alpha);

// What is wrong, for a user: "87 % of it is black". Empty: nothing. `most_transparent`: the share that may be.
std::string complaint(const PictureHealth& health, double most_transparent = 1);

}  // namespace fastscene
