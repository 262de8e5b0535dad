// Crops: the parts of a picture that a network must see to fill its holes. Private to inpaint/.
#pragma once

#include <vector>

#include "fastscene/image/image.h"

namespace fastscene {

struct Crop {
    int x = 0, y = 0, width = 0, height = 0;
};
// Rectangles that together hold every hole with `margin` pixels of context where the picture has them; sides are
// multiples of `multiple`, between `smallest` and `largest`. They may reach over the right and the lower edge of a
// small picture. A hole that is larger is cut into rectangles that overlap by the margin.
std::vector<Crop> crops_around(const ImageMask& hole, int margin, int multiple, int smallest, int largest);

}  // namespace fastscene
