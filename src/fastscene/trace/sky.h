// The bare sky: air, clouds, stars. What stands before it is in outdoors.h.
#pragma once

#include <array>

#include "fastscene/scene/room.h"

namespace fastscene {

// Light scattered once by air (Rayleigh) and haze (Mie) gives the sky its course around the sun; its colors by height
// are the ones that the room asks for (Sky::zenith, Sky::horizon), so that its light on a window does not depend on the
// sun's azimuth.
class SkyDome {
  public:
    explicit SkyDome(const Sky& sky);
    // Radiance from a direction (world frame, unit, y down); below the horizon that of the lowest sky. The sun's disc
    // is excluded, since it is sampled separately.
    Vec3f at(Vec3f direction) const;
    // The same without clouds and stars.
    Vec3f air(Vec3f direction) const;

    static constexpr int kAround = 32, kUp = 32;
    // Relative to the mean at equal height, by angle from the sun's azimuth and by height.
    using Course = std::array<std::array<Vec3f, kAround + 1>, kUp + 1>;
    const Course& course() const { return course_; }
    Vec3f sunward() const { return sunward_; }

  private:
    Vec3f clouded(Vec3f direction, Vec3f behind) const;
    Sky sky_;
    Vec3f sunward_;  // horizontal
    Course course_{};
};

}  // namespace fastscene
