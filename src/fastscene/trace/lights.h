// Lights: lamps (emissive meshes), windows (portals to the sky) and the sun, sampled by what they give to a place.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "fastscene/scene/room.h"
#include "fastscene/trace/scene_bvh.h"
#include "fastscene/trace/sky.h"

namespace fastscene {

class Lights {
  public:
    explicit Lights(const Room& room);

    // Which light to ask from a place: probabilities by power, distance and orientation.
    static constexpr int kMost = 48;
    struct Choice {
        int count = 0;                       // 0: none shines here
        std::array<float, kMost> cumulative; // the first `count`, rising
        float chance(int i) const {
            return (cumulative[static_cast<std::size_t>(i)] - (i ? cumulative[static_cast<std::size_t>(i - 1)] : 0.f)) /
                   cumulative[static_cast<std::size_t>(count - 1)];
        }
    };
    Choice choice_at(Vec3f position, Vec3f normal) const;

    // A direction towards a lamp or window, and what comes from there if nothing stands between.
    struct Towards {
        Vec3f direction;
        float far = 0;       // how far a shadow ray has to look
        Vec3f radiance;
        float density = 0;   // per solid angle; 0: nothing drawn
    };
    // `which`: the light and the part of it, `uv`: the place on it; uniform in [0, 1), best well spread.
    Towards draw(const Room& room, const Choice& choice, Vec3f position, Vec3f normal, Vec2f which, Vec2f uv) const;
    // The density with which draw() would have found this direction, whose ray ended in `hit`.
    float density(const Room& room, const Choice& choice, Vec3f position, Vec3f direction, const RayHit& hit) const;
    // One estimate of the irradiance from lamps and windows.
    Vec3f sample(const Room& room, const SceneBvh& bvh, const Choice& choice, Vec3f position, Vec3f normal, Vec2f which, Vec2f uv) const;
    // One estimate of the sun's irradiance (0.5 degree disc, a little wider for thin air).
    Vec3f sun(const Room& room, const SceneBvh& bvh, Vec3f position, Vec3f normal, Vec2f uv) const;
    // Lamps that are large (more than half a square metre) are found by gathering instead of by sampling.
    bool is_large(int mesh) const { return large_[static_cast<std::size_t>(mesh)]; }

  private:
    struct Triangle {
        std::int32_t mesh, triangle;
    };
    // Triangles of a lamp that face about the same way.
    struct Part {
        Vec3f center, normal;             // normal: mean of the triangles', not unit where they bend
        float area = 0;
        bool one_sided = false;           // of a closed body: nobody sees it from behind
        std::vector<Triangle> triangles;
        std::vector<float> cumulative;    // their powers; the last is the part's
    };
    // Ways to face: the sides of a cube in three by three fields, for closed bodies and for sheets.
    static constexpr int kFacings = 2 * 6 * 9;
    static std::size_t facing_of(Vec3f normal, bool one_sided);
    // What glows of one object within a lamp's breadth, or one window.
    struct Light {
        int portal = -1;
        Vec3f center, direction;          // direction: a portal shines only into the room; zero: all around
        float power = 0, area = 0;
        std::vector<Part> parts;
        std::array<std::int8_t, kFacings> part_of_facing{};   // -1: none faces that way
        // Rising shares of the parts in what a place gets from the lamp: the first parts.size().
        std::array<float, kFacings> shares_at(Vec3f position) const;
    };
    // A triangle that glows.
    struct Glowing {
        std::int32_t mesh, triangle;
        Vec3f center, across;             // across: along the normal, twice as long as the area
        float area, power;
    };
    using Group = std::vector<Glowing>;
    static void cut(Group group, float width_m, std::vector<Group>& out);
    void add_lamp(const Group& group);
    void add_portal(const Room& room, int portal);
    void keep_strongest();
    float portal_density(const Room& room, const Choice& choice, Vec3f position, Vec3f direction) const;
    std::optional<SkyTable> sky_;         // where there are portals
    std::vector<Light> lights_;
    static constexpr std::int16_t kNoLight = -1;
    std::vector<std::vector<std::int16_t>> light_of_triangle_;   // by mesh; empty where nothing glows
    std::vector<bool> large_, closed_;
};

}  // namespace fastscene
