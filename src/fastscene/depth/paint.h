// A random surface texture: two colors and a pattern with a scale.
#pragma once

#include <cstdint>

#include "fastscene/base/random.h"
#include "fastscene/math/vec.h"

namespace fastscene {

enum class PaintPattern { plain, stripes, checker, planks, clouds, count };

struct Paint {
    PaintPattern pattern = PaintPattern::plain;
    Vec3f a{0.5f, 0.5f, 0.5f}, b{0.5f, 0.5f, 0.5f};  // linear
    float scale = 0.3f, turn = 0;                    // metres; rotation in radians within the surface
    std::uint32_t seed = 0;
};

// The color at a point in metres on a surface with normal `normal`, whose largest component selects the pattern's
// plane.
Vec3f color_of(const Paint& paint, Vec3f point, Vec3f normal);

// Colors between `low` and `high`, as albedo; `plain`: the share of textures without a pattern.
Paint random_paint(Random& rng, float low, float high, float plain);

}  // namespace fastscene
