// Crops: the parts of a picture that a network must see to fill its holes. Private to inpaint/.
#pragma once

#include <vector>

#include "fastscene/image/image.h"

namespace fastscene {

struct Crop {
    int x = 0, y = 0, width = 0, height = 0;
};
// Rectangles that together contain every hole with `margin` pixels of context, as far as the picture provides it. Sides
// are multiples of `multiple` between `smallest` and `largest`, and may extend beyond the right and lower edge of a
// small picture. Larger holes are divided into rectangles that overlap by the margin.
std::vector<Crop> crops_around(const ImageMask& hole, int margin, int multiple, int smallest, int largest);

}  // namespace fastscene
