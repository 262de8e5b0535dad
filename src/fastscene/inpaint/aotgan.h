// AOT-GAN (paper: the inpainting network of PNVI): holes painted by a network that has learned what rooms look like.
// Needs weights.
#pragma once

#include <filesystem>
#include <memory>

#include "fastscene/inpaint/inpaint.h"
#include "fastscene/nn/aotgan.h"

namespace fastscene {

// Only the surroundings of holes go through the network: crops with context, several at a time. At a hole's rim what is
// painted is moved to meet what is known, fading inward, so that no seam shows.
class AotganInpainter final : public Inpainter {
  public:
    explicit AotganInpainter(Aotgan network) : network_(std::move(network)) {}
    ImageColor fill(const ImageColor& color, const ImageMask& hole, const Run& run) const override;

  private:
    Aotgan network_;
};

}  // namespace fastscene
