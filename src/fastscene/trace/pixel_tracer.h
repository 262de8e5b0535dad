// What traces the rays of a cached picture, pixel by pixel: Embree, or another processor.
#pragma once

#include <functional>
#include <vector>

#include "fastscene/trace/denoise.h"
#include "fastscene/trace/picture.h"
#include "fastscene/trace/pixel_sum.h"

namespace fastscene {

// What is asked of a picture.
struct PixelPlan {
    const RayCamera& camera;
    const ShotParts& parts;
    int samples, round;  // rays: of a pixel at most, and at a time
    float ray_angle;
    const Look* look;  // null: radiance
    const Run& run;
};
using PixelRows = std::vector<std::vector<int>>;  // columns, by row

class PixelTracer {
  public:
    virtual ~PixelTracer() = default;
    // Traces rounds of rays for each of the pixels until it has `least` and needs no more (needs_more). Calls done()
    // for all of them, and at once for pixels of several rows.
    using Done = std::function<void(int x, int y, const PixelSum& sum)>;
    virtual void trace(const PixelRows& pixels, int least, const Done& done, Progress* progress) = 0;
    // Those of the pixels of which one of the rays [first, end) meets another surface than `guides` have.
    virtual PixelRows meeting_others(const PixelRows& pixels, int first, int end, const Guides& guides) = 0;
};

// With Embree. Both must live as long.
std::unique_ptr<PixelTracer> processor_pixels(const ShadeScene& scene, const PixelPlan& plan);

}  // namespace fastscene
