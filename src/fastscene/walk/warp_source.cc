#include <algorithm>

#include "fastscene/walk/coarse_view.h"

namespace fastscene {
namespace {

// The far side of a silhouette holds some of the near side's color: take it from the next pixel inside the same surface.
ImageColor cleaned(const ImageColor& color, const ImageMask& cuts) {
    const int w = color.width, h = color.height;
    ImageColor out = color;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            if (!(cuts.at(x, y) & kFarSide)) continue;
            Vec3f sum;
            int count = 0;
            const auto take = [&](int x1, int y1) {
                if (cuts.at(x1, y1) & (kFarSide | kNearSide)) return;
                sum += color.at(x1, y1);
                ++count;
            };
            const int left = wrap_column(x - 1, w), right = wrap_column(x + 1, w);
            if (!(cuts.at(left, y) & kCutRight)) take(left, y);
            if (!(cuts.at(x, y) & kCutRight)) take(right, y);
            if (y > 0 && !(cuts.at(x, y - 1) & kCutDown)) take(x, y - 1);
            if (y + 1 < h && !(cuts.at(x, y) & kCutDown)) take(x, y + 1);
            if (count) out.at(x, y) = sum / static_cast<float>(count);
        }
    return out;
}

// Cells about which all sixteen pixels lie on one surface.
ImageMask inside_of(const ImageMask& cuts) {
    const int w = cuts.width, h = cuts.height;
    ImageMask beside(w, h), inside(w, h);   // beside: an edge in the row from one pixel before to two behind
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            if (!(cuts.at(x, y) & (kFarSide | kNearSide))) continue;
            for (int i = -2; i <= 1; ++i) beside.at(wrap_column(x + i, w), y) = 1;
        }
    for (int y = 1; y + 2 < h; ++y)
        for (int x = 0; x < w; ++x) inside.at(x, y) = !(beside.at(x, y - 1) | beside.at(x, y) | beside.at(x, y + 1) | beside.at(x, y + 2));
    return inside;
}

}  // namespace

WarpSource make_warp_source(const ImageColor& color, const ImageF& range, const Image<std::int16_t>& plane, const ImageMask& used,
                            Vec3f position) {
    WarpSource source;
    source.cuts = range_edges(range);
    source.color = cleaned(color, source.cuts);
    source.inverse_range = ImageF(range.width, range.height);
    std::transform(range.pixels.begin(), range.pixels.end(), source.inverse_range.pixels.begin(), inverse_range);
    source.plane = plane;
    source.used = used;
    if (used.empty()) source.inside = inside_of(source.cuts);
    source.position = position;
    return source;
}

}  // namespace fastscene
