// From relative depth to metres. A network trained with a scale-and-shift-invariant loss knows depth up to
// range = scale * depth + shift; the floor says the rest: it is flat, level, and a known height below the camera.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

struct MetricFit {
    float scale = 1, shift = 0;    // range_m = scale * relative + shift, scale > 0
    float camera_height_m = 1.6f;  // assumed
    float ceiling_m = 0;           // found, above the camera; 0 where no level ceiling was found
    float floor_share = 0;         // of the sphere's lower half that lies on the floor so found, by solid angle
    bool sure = false;             // false: too little floor; scale is the nadir's, shift 0
};

// `relative`: equirectangular, grows with distance. Robust: furniture on the floor and lamps under the ceiling are
// outliers. Paper: none; the published code divides depth by its maximum and takes the shift for zero.
MetricFit fit_metres(const ImageF& relative, float camera_height_m);
// Nothing comes nearer than a hand's breadth, whatever the shift says.
ImageF metric_range(const ImageF& relative, const MetricFit& fit);

}  // namespace fastscene
