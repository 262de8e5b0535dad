// The pixels of cached pictures on a graphics card.
#pragma once

#include "fastscene/trace/pixel_tracer.h"
#include "fastscene/trace/vulkan/tracer.h"

namespace fastscene::vulkan {

struct ShadeOptions {
    bool contacts = false, frugal = false;  // as in ShadeScene
    float min_alpha = 0;
};

class CardPixels : public PixelTracer {
  public:
    // The card must have the light (CardGatherer). The plan must live as long.
    CardPixels(Tracer& tracer, const ShadeOptions& options, const PixelPlan& plan);
    void trace(const PixelRows& pixels, int least, const Done& done, Progress* progress) override;
    PixelRows meeting_others(const PixelRows& pixels, int first, int end, const Guides& guides) override;

  private:
    struct Band;
    void trace_band(const Band& band, int least, const Done& done);

    Tracer& tracer_;
    ShadeOptions options_;
    const PixelPlan& plan_;
    gpu::Buffer camera_, pixels_, list_, sums_, more_;
};

}  // namespace fastscene::vulkan
