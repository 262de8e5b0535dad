// Recovers metres from relative depth. A network trained with a scale- and shift-invariant loss predicts range = scale
// * depth + shift with unknown scale and shift; the floor determines them: it is flat, level, and at a known height
// below the camera. Of a network that is invariant to scale alone, the shift is 0.
#pragma once

#include "fastscene/image/image.h"

namespace fastscene {

struct MetricFit {
    float scale = 1, shift = 0;    // range_m = scale * relative + shift, scale > 0
    float camera_height_m = 1.6f;  // assumed
    float ceiling_m = 0;           // estimated, above the camera; 0 if no level ceiling was found
    float floor_share = 0;         // share of the lower hemisphere, by solid angle, that lies on the floor found
    bool sure = false;             // false: too little floor; then scale comes from the nadir, and shift is 0
};

enum class UnknownOfRange { scale_and_shift, scale };

// `relative`: equirectangular, increasing with distance. Robust: furniture and lamps are outliers. Not in the paper;
// the published code divides depth by its maximum and assumes shift 0.
MetricFit fit_metres(const ImageF& relative, float camera_height_m,
                     UnknownOfRange unknown = UnknownOfRange::scale_and_shift);
// Ranges are limited below to a hand's breadth, whatever the shift.
ImageF metric_range(const ImageF& relative, const MetricFit& fit);

}  // namespace fastscene
