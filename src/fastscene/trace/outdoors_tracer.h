// Ray tracing of the small world around the house: sun with soft shadows, light of the sky with occlusion, light
// through leaves, haze. Embree stays in outdoors_tracer.cc.
#pragma once

#include <memory>

#include "fastscene/base/random.h"
#include "fastscene/scene/room.h"
#include "fastscene/trace/outdoors_world.h"
#include "fastscene/trace/sky.h"

namespace fastscene::outdoors {

class Tracer {
  public:
    Tracer(const Sky& sky, World world);
    ~Tracer();
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    struct Sample {
        Vec3f radiance;
        bool bare_sky = false;  // nothing was hit: the same for every sample
    };
    // One sample of the radiance that arrives at the viewer's eye (world frame, y down). `width`: of the sample, in
    // radians.
    Sample sample(Vec3f direction, float width, Random& random) const;
    // Metres to the first surface; +inf: sky.
    float distance(Vec3f direction) const;
    const SkyDome& dome() const { return dome_; }

  private:
    struct Impl;
    SkyDome dome_;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fastscene::outdoors
