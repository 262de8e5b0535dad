// AOT-GAN (paper: the inpainting network of PNVI): a learned inpainter for rooms. Needs weights.
#pragma once

#include <filesystem>
#include <memory>

#include "fastscene/inpaint/inpaint.h"
#include "fastscene/nn/aotgan.h"

namespace fastscene {

// Only the surroundings of holes go through the network, as batched crops with context. Near a hole's rim the result is
// shifted to match the known colors, fading inward, so that no seam shows.
class AotganInpainter final : public Inpainter {
  public:
    explicit AotganInpainter(Aotgan network) : network_(std::move(network)) {}
    ImageColor fill(const ImageColor& color, const ImageMask& hole, const Run& run) const override;

  private:
    Aotgan network_;
};

}  // namespace fastscene
