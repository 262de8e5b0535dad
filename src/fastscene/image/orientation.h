// The eight EXIF orientations (tag 0x0112): four rotations, mirrored or not.
#pragma once

#include <utility>

#include "fastscene/image/image.h"

namespace fastscene {

// 5 to 8: rows of the upright picture are columns of the stored one.
inline bool lies_on_its_side(int orientation) { return orientation >= 5; }

// Rotates the picture upright. `orientation` 1 to 8: 1 = unchanged, 3 = by 180 degrees, 6 = 90 degrees clockwise, 8 =
// 90 degrees counterclockwise; 2, 4, 5, 7 = mirrored.
template <class T>
Image<T> upright(Image<T> stored, int orientation) {
    FASTSCENE_CHECK(orientation >= 1 && orientation <= 8);
    if (orientation == 1) return stored;
    const bool side = lies_on_its_side(orientation);
    const int last_x = stored.width - 1, last_y = stored.height - 1;
    Image<T> out(side ? stored.height : stored.width, side ? stored.width : stored.height);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            // Position in the stored picture of the upright pixel (x, y).
            const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
            const bool from_below = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
            const int u = side ? y : x, v = side ? x : y;
            out.at(x, y) = stored.at(from_right ? last_x - u : u, from_below ? last_y - v : v);
        }
    return out;
}

}  // namespace fastscene
