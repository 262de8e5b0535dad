// The eight ways in which EXIF says that a picture lies (tag 0x0112): mirrored or not, times four quarter turns.
#pragma once

#include <utility>

#include "fastscene/image/image.h"

namespace fastscene {

// 5 to 8: rows of the upright picture are columns of the stored one.
inline bool lies_on_its_side(int orientation) { return orientation >= 5; }

// The picture as it was meant to be seen. `orientation` 1 to 8: 1 = as it is, 3 = half a turn, 6 = a quarter clockwise,
// 8 = a quarter counter-clockwise; 2, 4, 5, 7 = mirrored.
template <class T>
Image<T> upright(Image<T> stored, int orientation) {
    FASTSCENE_CHECK(orientation >= 1 && orientation <= 8);
    if (orientation == 1) return stored;
    const bool side = lies_on_its_side(orientation);
    const int last_x = stored.width - 1, last_y = stored.height - 1;
    Image<T> out(side ? stored.height : stored.width, side ? stored.width : stored.height);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            // Where the stored picture has what belongs at (x, y).
            const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
            const bool from_below = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
            const int u = side ? y : x, v = side ? x : y;
            out.at(x, y) = stored.at(from_right ? last_x - u : u, from_below ? last_y - v : v);
        }
    return out;
}

}  // namespace fastscene
