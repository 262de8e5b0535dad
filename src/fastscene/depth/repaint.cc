#include "fastscene/depth/repaint.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fastscene/base/check.h"
#include "fastscene/depth/paint.h"
#include "fastscene/geometry/sphere.h"
#include "fastscene/image/color.h"

namespace fastscene {
namespace {

constexpr int kUp = 1;  // index of the vertical axis

// Surfaces that share a texture: each object as a whole; of the room itself the floor, the ceiling and the walls.
enum Part { thing = 0, walls, floor, ceiling };
int coat_of(SurfaceId id, Vec3f direction) {
    const int piece = piece_of(id);
    if (piece > 0) return 4 * piece + thing;
    return axis_of(id) != kUp ? walls : direction.y > 0 ? floor : ceiling;
}

Paint paint_of(int coat, Random& rng) {
    switch (coat) {
        case walls: return random_paint(rng, 0.15f, 0.85f, 0.6f);
        case floor: return random_paint(rng, 0.05f, 0.6f, 0.3f);
        case ceiling: return random_paint(rng, 0.4f, 0.9f, 0.85f);
        default: return random_paint(rng, 0.04f, 0.8f, 0.5f);
    }
}

struct Coat {
    double light = 0;  // sum, then mean, of its pixels' luminance
    int pixels = 0;
    bool painted = false;
    Paint paint;
};

}  // namespace

SurfaceId surface_id(int piece, int axis) { return static_cast<SurfaceId>(4 * piece + axis); }
int piece_of(SurfaceId id) { return id / 4; }
int axis_of(SurfaceId id) { return id % 4; }

DepthExample repainted(const DepthExample& example, float share, Random& rng) {
    if (example.surfaces.empty()) return example;
    FASTSCENE_CHECK(example.surfaces.same_size(example.range));
    const EquirectSize size{example.color.width, example.color.height};
    const ImageColor light = linear_from_srgb8(example.color);
    const auto direction = [&](std::size_t i) {
        return direction_of_pixel(static_cast<int>(i) % size.width, static_cast<int>(i) / size.width, size);
    };
    std::map<int, Coat> coats;  // in the order of their ids, which makes the random numbers deterministic
    double all = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
        if (example.range.pixels[i] <= 0) continue;
        Coat& coat = coats[coat_of(example.surfaces.pixels[i], direction(i))];
        coat.light += luminance(light.pixels[i]);
        coat.pixels += 1;
        all += luminance(light.pixels[i]) / static_cast<double>(light.size());
    }
    for (auto& [number, coat] : coats) {
        coat.light = std::max(1e-4, coat.light / coat.pixels);
        coat.painted = rng.chance(share);
        coat.paint = paint_of(number, rng);
    }
    DepthExample out{ImageRgb8(size.width, size.height), example.range, {}};
    for (std::size_t i = 0; i < light.size(); ++i) {
        out.color.pixels[i] = example.color.pixels[i];
        const float range = example.range.pixels[i];
        if (range <= 0) continue;
        const Vec3f d = direction(i);
        const SurfaceId id = example.surfaces.pixels[i];
        const Coat& coat = coats.at(coat_of(id, d));
        if (!coat.painted) continue;
        Vec3f facing{};
        facing[static_cast<std::size_t>(axis_of(id))] = 1;
        // A pattern finer than a pixel becomes its mean color.
        const float pixel = range * 2 * kPi / static_cast<float>(size.width),
                    clear = std::clamp(coat.paint.scale / pixel - 0.5f, 0.f, 1.f);
        const Vec3f mean = (coat.paint.a + coat.paint.b) * 0.5f,
                    albedo = mean + (color_of(coat.paint, d * range, facing) - mean) * clear;
        // Illumination relative to the rest of the surface. For dark surfaces it is unknown whether albedo or light is
        // low: they stay half as dark.
        const auto shade = static_cast<float>(std::min(4., luminance(light.pixels[i]) / coat.light) *
                                              std::sqrt(coat.light * all) / 0.4);
        out.color.pixels[i] = srgb8_from_linear(albedo * shade);
    }
    return out;
}

}  // namespace fastscene
