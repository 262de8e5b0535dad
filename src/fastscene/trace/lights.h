// Lights: lamps (emissive meshes), windows (portals to the sky) and the sun, importance-sampled for a receiving point.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "fastscene/scene/room.h"
#include "fastscene/trace/light_tree.h"
#include "fastscene/trace/sampler.h"
#include "fastscene/trace/scene_bvh.h"
#include "fastscene/trace/outdoors.h"

namespace fastscene {

// Irradiance and the direction it comes from.
struct DirectedLight {
    Vec3f irradiance, direction;
};

class Lights {
  public:
    // `outside_detail`: pixels per degree of the view through windows (Outdoors); illumination does not need it. `bvh`:
    // of the room; with it, emitters whose light is caught close by (embers under logs, the inside of a flame) are
    // sampled less. `outdoors`: of another room with the same outside; null: it is built, which takes seconds.
    explicit Lights(const Room& room, float outside_detail = 0, const SceneBvh* bvh = nullptr,
                    std::shared_ptr<const Outdoors> outdoors = nullptr);

    // A sampled direction to a lamp or window, and the radiance that arrives if nothing is in between.
    struct LightSample {
        Vec3f direction;
        float far = 0;  // length of the shadow ray
        Vec3f radiance;
        float pdf = 0;       // per solid angle; 0: no sample
        bool alone = false;  // no ray can hit it (a flame): the sample's MIS weight is 1

        // MIS weight of the sample, where the BSDF has the pdf `other` in its direction.
        float weight(float other) const { return alone ? 1.f : power_heuristic(pdf, other); }
    };
    // Samples a light for a surface point: `which` selects an emitter (light_tree.h), `uv` a point on it; both uniform
    // in [0, 1), preferably stratified.
    LightSample draw(const Room& room, Vec3f position, Vec3f normal, float which, Vec2f uv) const;
    // The solid-angle density with which draw() samples this direction, whose ray hit `hit`; for MIS weights.
    float pdf(const Room& room, Vec3f position, Vec3f normal, Vec3f direction, const RayHit& hit) const;
    // A one-sample estimate of the irradiance from lamps and windows.
    DirectedLight sample(const Room& room, const SceneBvh& bvh, Vec3f position, Vec3f normal, float which,
                         Vec2f uv) const;
    // A one-sample estimate of the irradiance from the sun's disc (0.5 degrees, slightly widened for atmospheric
    // scattering).
    Vec3f sun(const Room& room, const SceneBvh& bvh, Vec3f position, Vec3f normal, Vec2f uv) const;
    // Large lamps (more than half a square metre) are not sampled; gathering rays find them.
    bool is_large(int mesh) const { return large_[static_cast<std::size_t>(mesh)]; }

    const Outdoors& outdoors() const { return *outdoors_; }
    std::shared_ptr<const Outdoors> shared_outdoors() const { return outdoors_; }

    // An emissive triangle, or a window.
    struct Emitter {
        std::int32_t mesh = -1, triangle = 0;
        std::int32_t portal = -1;
    };
    const std::vector<Emitter>& emitters() const { return emitters_; }  // windows first
    const LightTree& tree() const { return *tree_; }                    // of emitters()
    // The emitter of a mesh's first triangle, the others follow; -1: not emissive, or large.
    std::int32_t first_of_mesh(std::size_t mesh) const { return first_of_mesh_[mesh]; }
    bool is_watertight(std::size_t mesh) const { return closed_[mesh]; }

  private:
    float portal_pdf(const Room& room, Vec3f position, Vec3f normal, Vec3f direction) const;
    std::shared_ptr<const Outdoors> outdoors_;
    std::vector<Emitter> emitters_;
    std::optional<LightTree> tree_;
    std::vector<std::int32_t> first_of_mesh_;
    std::vector<bool> large_, closed_;
};

}  // namespace fastscene
