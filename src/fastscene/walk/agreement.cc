#include "fastscene/walk/agreement.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fastscene/walk/coarse_view.h"

namespace fastscene {

// Minimum share of the sphere that two panoramas must both see.
constexpr double kLeastShared = 0.05;

float scale_to_agree(const Panorama& first, const Panorama& other) {
    const Image<std::int16_t> no_planes(first.range.width, first.range.height, kNoPlane);
    const std::vector<WarpSource> source{
        make_warp_source(first.color, first.range, no_planes, {}, first.world_from_pano.translation)};
    const CoarseView seen = coarse_view(source, other.size(), other.world_from_pano.translation);
    std::vector<float> ratios;
    for (std::size_t i = 0; i < seen.range.size(); ++i) {
        const float a = seen.range.pixels[i], b = other.range.pixels[i];
        if (seen.cover.pixels[i] == Cover::front && std::isfinite(a) && std::isfinite(b) && a > 0 && b > 0)
            ratios.push_back(a / b);
    }
    if (static_cast<double>(ratios.size()) < kLeastShared * static_cast<double>(seen.range.size())) return 1;
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    return *middle;
}

}  // namespace fastscene
