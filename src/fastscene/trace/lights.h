// Lights: lamps (emissive meshes), windows (portals to the sky) and the sun, sampled by what they give to a place.
#pragma once

#include <vector>

#include "fastscene/base/random.h"
#include "fastscene/scene/room.h"
#include "fastscene/trace/scene_bvh.h"

namespace fastscene {

class Lights {
  public:
    explicit Lights(const Room& room);

    // Which light to ask from a place: probabilities by power, distance and orientation.
    struct Choice {
        std::vector<float> cumulative;  // over all lights; empty: none shines here
    };
    Choice choice_at(Vec3f position, Vec3f normal) const;
    // One estimate of the irradiance from lamps and windows. `which`, `u`, `v`: uniform in [0, 1), best well spread.
    Vec3f sample(const Room& room, const SceneBvh& bvh, const Choice& choice, Vec3f position, Vec3f normal, float which, Vec2f uv, Random& random) const;
    // One estimate of the sun's irradiance (0.5 degree disc, a little wider for thin air).
    Vec3f sun(const Room& room, const SceneBvh& bvh, Vec3f position, Vec3f normal, Random& random) const;
    // Lamps that are large (more than half a square metre) are found by gathering instead of by sampling.
    bool is_large(int mesh) const { return large_[static_cast<std::size_t>(mesh)]; }

  private:
    struct Light {
        int mesh = -1, portal = -1;
        Vec3f center, direction;       // direction: a portal shines only into the room; zero: all around
        float power = 0, area = 0;
        std::vector<float> cumulative; // areas of the mesh's triangles
    };
    std::vector<Light> lights_;
    std::vector<bool> large_;
};

}  // namespace fastscene
