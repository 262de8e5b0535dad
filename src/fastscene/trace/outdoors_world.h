// A small world around the house, as data: meshes of quads, instances of them, and what they are painted with.
//
// Frame of the yard: x right and z forward as in the room's world, y up, the origin on the ground below the viewer's
// eye. In metres.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "fastscene/math/rigid.h"
#include "fastscene/math/vec.h"

namespace fastscene::outdoors {

enum class Finish : std::uint8_t {
    matt,
    leaf,    // a thin sheet: reflects on one side, lets light through to the other
    ground,  // colored by World::ground
    water,
    glass,   // a window pane, with a room behind it
    facade,  // a distant wall with windows too small to be geometry
    light,   // emits its albedo
};
struct Paint {
    Finish finish = Finish::matt;
    Vec3f albedo;
    Vec3f through{};      // share of light that passes a leaf
    float mottle = 0;     // contrast of the weathering, 0..1
    bool tinted = false;  // multiplied by the instance's tint
    bool takes_snow = true;
};

// Paints that every world has; buildings add their own.
enum StandardPaint : std::uint16_t {
    kBark,
    kBirchBark,
    kLeaf,
    kPlainLeaf,  // not tinted: beside petals, which are
    kNeedle,
    kGrass,
    kDarkCore,  // the inside of hedges and shrubs
    kPetal,
    kGround,
    kWater,
    kGlass,
    kTrim,  // window frames, cornices
    kIron,
    kLampGlass,
    kStandardPaints
};

struct QuadMesh {
    std::vector<Vec3f> corners;        // 4 per quad; a triangle repeats its last
    std::vector<std::uint16_t> paint;  // 1 per quad
    void quad(Vec3f a, Vec3f b, Vec3f c, Vec3f d, std::uint16_t p) {
        corners.insert(corners.end(), {a, b, c, d});
        paint.push_back(p);
    }
    std::size_t size() const { return paint.size(); }
};

struct Instance {
    std::uint32_t mesh = 0;
    Mat3f axes;  // linear part of world from mesh
    Vec3f at;
    Vec3f tint{1, 1, 1};
};

// A street lamp: light falls from it without shadows.
struct Lantern {
    Vec3f at;
    Vec3f intensity;  // per steradian
};

struct World {
    std::vector<Paint> paints;
    std::vector<QuadMesh> meshes;
    std::vector<Instance> instances;
    std::vector<Lantern> lanterns;
    // Albedo of the ground; `footprint`: width in metres of what one sample sees.
    std::function<Vec3f(Vec3f at, float footprint)> ground;
    std::function<float(Vec2f at)> height;  // of the ground
    float eye_m = 2;                        // height of the viewer's eye
    float clear_m = 2500;                   // distance at which haze takes all but 1/e of the contrast

    std::uint32_t add(QuadMesh mesh) {
        meshes.push_back(std::move(mesh));
        return static_cast<std::uint32_t>(meshes.size() - 1);
    }
    std::uint16_t add(const Paint& p) {
        paints.push_back(p);
        return static_cast<std::uint16_t>(paints.size() - 1);
    }
    // Stands a mesh on the ground, turned about the vertical and scaled.
    void stand(std::uint32_t mesh, Vec2f at, float turn, Vec3f scale = {1, 1, 1}, Vec3f tint = {1, 1, 1}) {
        const float c = std::cos(turn), s = std::sin(turn);
        const Mat3f axes{{c * scale.x, 0, s * scale.z}, {0, scale.y, 0}, {-s * scale.x, 0, c * scale.z}};
        instances.push_back({mesh, axes, {at.x, height ? height(at) : 0.f, at.y}, tint});
    }
};

inline std::vector<Paint> standard_paints() {
    std::vector<Paint> p(kStandardPaints);
    p[kBark] = {Finish::matt, {0.095f, 0.075f, 0.055f}, {}, 0.6f};
    p[kBirchBark] = {Finish::matt, {0.5f, 0.48f, 0.44f}, {}, 0.7f};
    // Sunlit foliage reflects some 8 % of green light and lets about as much through, yellower.
    p[kLeaf] = {Finish::leaf, {0.058f, 0.084f, 0.03f}, {0.062f, 0.09f, 0.018f}, 0, true};
    p[kPlainLeaf] = {Finish::leaf, {0.052f, 0.078f, 0.033f}, {0.045f, 0.068f, 0.018f}};
    p[kNeedle] = {Finish::leaf, {0.034f, 0.052f, 0.029f}, {0.006f, 0.012f, 0.003f}, 0, true};
    p[kGrass] = {Finish::leaf, {0.072f, 0.096f, 0.036f}, {0.05f, 0.072f, 0.016f}, 0, true};
    p[kDarkCore] = {Finish::matt, {0.016f, 0.022f, 0.01f}};
    p[kPetal] = {Finish::leaf, {0.6f, 0.6f, 0.6f}, {0.2f, 0.2f, 0.2f}, 0, true};
    p[kGround] = {Finish::ground, {}};
    p[kWater] = {Finish::water, {0.02f, 0.06f, 0.065f}, {}, 0, false, false};
    p[kGlass] = {Finish::glass, {0.5f, 0.45f, 0.4f}, {}, 0, false, false};
    p[kTrim] = {Finish::matt, {0.58f, 0.57f, 0.54f}, {}, 0.15f};
    p[kIron] = {Finish::matt, {0.035f, 0.037f, 0.04f}};
    p[kLampGlass] = {Finish::light, {0.9f, 0.62f, 0.32f}, {}, 0, false, false};
    return p;
}

}  // namespace fastscene::outdoors
