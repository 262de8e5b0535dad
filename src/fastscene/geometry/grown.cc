#include "fastscene/geometry/grown.h"

#include <algorithm>

#include "fastscene/geometry/sphere.h"

namespace fastscene {

ImageMask grown(const ImageMask& mask, int reach, bool wraps) {
    const int w = mask.width, h = mask.height;
    ImageMask wide(w, h), out(w, h);
    const auto marked = [&](int x, int y) {
        return wraps ? mask.at(wrap_column(x, w), y) != 0 : x >= 0 && x < w && mask.at(x, y) != 0;
    };
    for (int y = 0; y < h; ++y) {
        int near = 0;  // number of marked ones within reach of x
        for (int x = -reach; x < reach; ++x) near += marked(x, y);
        for (int x = 0; x < w; ++x) {
            near += marked(x + reach, y);
            wide.at(x, y) = near > 0;
            near -= marked(x - reach, y);
        }
    }
    for (int y = 0; y < h; ++y)
        for (int j = std::max(0, y - reach); j <= std::min(h - 1, y + reach); ++j)
            for (int x = 0; x < w; ++x) out.at(x, y) |= wide.at(x, j);
    return out;
}

}  // namespace fastscene
