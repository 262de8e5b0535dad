#include <algorithm>

#include "fastscene/base/check.h"
#include "fastscene/walk/coarse_view.h"
#include "fastscene/walk/silhouettes.h"

namespace fastscene {
namespace {

// Cells about which all sixteen pixels lie on one surface.
ImageMask inside_of(const ImageMask& cuts) {
    const int w = cuts.width, h = cuts.height;
    ImageMask beside(w, h), inside(w, h);  // beside: an edge in the row from one pixel before to two behind
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            if (!(cuts.at(x, y) & (kFarSide | kNearSide))) continue;
            for (int i = -2; i <= 1; ++i) beside.at(wrap_column(x + i, w), y) = 1;
        }
    for (int y = 1; y + 2 < h; ++y)
        for (int x = 0; x < w; ++x)
            inside.at(x, y) = !(beside.at(x, y - 1) | beside.at(x, y) | beside.at(x, y + 1) | beside.at(x, y + 2));
    return inside;
}

}  // namespace

WarpSource make_warp_source(const ImageColor& color, const ImageF& range, const Image<std::int16_t>& plane,
                            const ImageMask& used, Vec3f position) {
    WarpSource source;
    source.cuts = range_edges(range);
    Silhouettes silhouettes = find_silhouettes(color, source.cuts);
    source.color = std::move(silhouettes.color);
    if (used.empty()) source.share = std::move(silhouettes.share);  // what was painted is mixed of nothing
    source.inverse_range = ImageF(range.width, range.height);
    std::transform(range.pixels.begin(), range.pixels.end(), source.inverse_range.pixels.begin(), inverse_range);
    source.plane = plane;
    source.used = used;
    if (used.empty()) source.inside = inside_of(source.cuts);
    source.position = position;
    return source;
}

PackedSource::PackedSource(const WarpSource& source)
    : width_(source.color.width), height_(source.color.height), position_(source.position) {
    FASTSCENE_CHECK(source.used.size() == source.color.size());
    const auto& used = source.used.pixels;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) continue;
        const bool goes_on = !stretches_.empty() && stretches_.back().begin + stretches_.back().count == i;
        if (goes_on) ++stretches_.back().count;
        else stretches_.push_back({static_cast<std::uint32_t>(i), 1});
        color_.push_back(source.color.pixels[i]);
        inverse_range_.push_back(source.inverse_range.pixels[i]);
        cuts_.push_back(source.cuts.pixels[i]);
        plane_.push_back(source.plane.empty() ? kNoPlane : source.plane.pixels[i]);
    }
    color_.shrink_to_fit();
    inverse_range_.shrink_to_fit();
    cuts_.shrink_to_fit();
    plane_.shrink_to_fit();
}

void PackedSource::unpack(WarpSource& into) const {
    if (into.color.width != width_ || into.color.height != height_) {
        into.color = ImageColor(width_, height_);
        into.inverse_range = ImageF(width_, height_);
        into.cuts = ImageMask(width_, height_);
        into.plane = Image<std::int16_t>(width_, height_, kNoPlane);
    }
    into.inside = {};
    into.share = {};
    into.used = ImageMask(width_, height_);
    into.position = position_;
    std::size_t from = 0;
    for (const Stretch& s : stretches_) {
        std::copy_n(color_.begin() + static_cast<std::ptrdiff_t>(from), s.count, into.color.pixels.begin() + s.begin);
        std::copy_n(inverse_range_.begin() + static_cast<std::ptrdiff_t>(from), s.count,
                    into.inverse_range.pixels.begin() + s.begin);
        std::copy_n(cuts_.begin() + static_cast<std::ptrdiff_t>(from), s.count, into.cuts.pixels.begin() + s.begin);
        std::copy_n(plane_.begin() + static_cast<std::ptrdiff_t>(from), s.count, into.plane.pixels.begin() + s.begin);
        std::fill_n(into.used.pixels.begin() + s.begin, s.count, std::uint8_t{1});
        from += s.count;
    }
}

}  // namespace fastscene
