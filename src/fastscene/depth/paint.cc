#include "fastscene/depth/paint.h"

#include <cmath>

#include "fastscene/trace/noise.h"

namespace fastscene {
namespace {

Vec3f random_color(Random& rng, float low, float high) {
    const float level = std::exp(rng.uniform(std::log(low), std::log(high))), tint = rng.chance(0.3f) ? 0.9f : 0.35f;
    return {level * (1 - tint * rng.uniform()), level * (1 - tint * rng.uniform()), level * (1 - tint * rng.uniform())};
}

}  // namespace

Vec3f color_of(const Paint& paint, Vec3f point, Vec3f normal) {
    const Vec3f n{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
    const Vec2f flat = n.y > n.x && n.y > n.z ? Vec2f{point.x, point.z}
                       : n.x > n.z            ? Vec2f{point.z, point.y}
                                              : Vec2f{point.x, point.y};
    const float c = std::cos(paint.turn), s = std::sin(paint.turn);
    const Vec2f uv{(c * flat.x - s * flat.y) / paint.scale, (s * flat.x + c * flat.y) / paint.scale};
    float t = 0;
    switch (paint.pattern) {
        case PaintPattern::stripes: t = static_cast<float>(floor_int(uv.x) & 1); break;
        case PaintPattern::checker: t = static_cast<float>((floor_int(uv.x) + floor_int(uv.y)) & 1); break;
        case PaintPattern::planks:
            t = lattice_unit(floor_int(uv.x), floor_int(uv.y * 0.2f + 0.37f * static_cast<float>(floor_int(uv.x))), 0,
                             paint.seed);
            break;
        case PaintPattern::clouds: t = 0.6f * noise2(uv, paint.seed) + 0.4f * noise2(uv * 3.1f, paint.seed + 1); break;
        default: break;
    }
    return paint.a + (paint.b - paint.a) * t;
}

Paint random_paint(Random& rng, float low, float high, float plain) {
    Paint paint;
    paint.a = random_color(rng, low, high);
    paint.b = rng.chance(0.5f) ? paint.a * rng.uniform(0.5f, 1.3f) : random_color(rng, low, high);
    if (!rng.chance(plain))
        paint.pattern = static_cast<PaintPattern>(1 + rng.index(static_cast<int>(PaintPattern::count) - 1));
    paint.scale = std::exp(rng.uniform(std::log(0.06f), std::log(0.8f)));
    paint.turn = rng.chance(0.7f) ? (rng.chance(0.5f) ? 0.f : kPi / 2) : rng.uniform(0, kPi);
    paint.seed = rng.next_u32();
    return paint;
}

}  // namespace fastscene
