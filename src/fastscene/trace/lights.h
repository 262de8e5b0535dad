// Lights: lamps (emissive meshes), windows (portals to the sky) and the sun, sampled by what they give to a place.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "fastscene/scene/room.h"
#include "fastscene/trace/light_tree.h"
#include "fastscene/trace/scene_bvh.h"
#include "fastscene/trace/sky.h"

namespace fastscene {

class Lights {
  public:
    explicit Lights(const Room& room);

    // A direction towards a lamp or window, and what comes from there if nothing stands between.
    struct LightSample {
        Vec3f direction;
        float far = 0;  // how far a shadow ray has to look
        Vec3f radiance;
        float pdf = 0;  // per solid angle; 0: nothing drawn
    };
    // `which`: the bit of a lamp or the window, by what it gives there (light_tree.h), `uv`: the place on it; uniform
    // in [0, 1), best well spread.
    LightSample draw(const Room& room, Vec3f position, Vec3f normal, float which, Vec2f uv) const;
    // The pdf with which draw() would have found this direction, whose ray ended in `hit`.
    float pdf(const Room& room, Vec3f position, Vec3f normal, Vec3f direction, const RayHit& hit) const;
    // One estimate of the irradiance from lamps and windows.
    Vec3f sample(const Room& room, const SceneBvh& bvh, Vec3f position, Vec3f normal, float which, Vec2f uv) const;
    // One estimate of the sun's irradiance (0.5 degree disc, a little wider for thin air).
    Vec3f sun(const Room& room, const SceneBvh& bvh, Vec3f position, Vec3f normal, Vec2f uv) const;
    // Lamps that are large (more than half a square metre) are found by gathering instead of by sampling.
    bool is_large(int mesh) const { return large_[static_cast<std::size_t>(mesh)]; }

  private:
    // A triangle that glows, or a window.
    struct Emitter {
        std::int32_t mesh = -1, triangle = 0;
        std::int32_t portal = -1;
    };
    float portal_pdf(const Room& room, Vec3f position, Vec3f normal, Vec3f direction) const;
    std::optional<SkyTable> sky_;    // where there are portals
    std::vector<Emitter> emitters_;  // windows first
    std::optional<LightTree> tree_;  // of emitters_
    std::vector<std::int32_t>
        first_of_mesh_;  // the emitter that is its first triangle; the others follow. -1: does not glow, or is large
    std::vector<bool> large_, closed_;
};

}  // namespace fastscene
