// Which label of labelled splats a camera sees: the one with the greatest share of the pixel's blend.
#pragma once

#include <cstdint>
#include <vector>

#include "fastscene/splat/splat.h"

namespace fastscene {

struct LabelView {
    Pinhole camera;
    Rigid world_from_camera;
};
// A picture per view. Where nothing is seen the share is that of label 0.
std::vector<Image<std::uint16_t>> seen_labels(const Splats& splats, const std::vector<std::uint16_t>& labels,
                                              const std::vector<LabelView>& views, const SplatBackend& backend,
                                              const Run& run);

// The share of pixels that agree. `of` says what is compared of a label: its class, or itself.
double agreement(const Image<std::uint16_t>& a, const Image<std::uint16_t>& b, const std::vector<int>& of);

}  // namespace fastscene
