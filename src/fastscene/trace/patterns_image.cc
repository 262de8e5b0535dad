#include <algorithm>
#include <cmath>

#include "fastscene/image/color.h"
#include "fastscene/trace/patterns.h"

namespace fastscene::patterns {
namespace {

int wrapped(int i, int n) { return ((i % n) + n) % n; }

// Bilinear lookup in one mip level; (u, v) in [0, 1) repeated, v upward.
Vec3f sampled(const ImageRgb8& level, Vec2f uv) {
    const float x = (uv.x - std::floor(uv.x)) * static_cast<float>(level.width) - 0.5f,
                y = (1.f - (uv.y - std::floor(uv.y))) * static_cast<float>(level.height) - 0.5f;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
    const auto texel = [&](int i, int j) {
        return linear_from_srgb8(level.at(wrapped(i, level.width), wrapped(j, level.height)));
    };
    return lerp(lerp(texel(x0, y0), texel(x0 + 1, y0), fx), lerp(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), fx), fy);
}

}  // namespace

TextureValue image(const Material& m, const TexturePoint& p) {
    const std::vector<ImageRgb8>& levels = m.image->levels;
    // The mip level whose texels are as wide as the sample's footprint.
    const float texel_m = m.scale_m / static_cast<float>(levels.front().width);
    const float level = std::log2(std::max(p.footprint_m / std::max(texel_m, 1e-6f), 1.f));
    const auto k = std::min(static_cast<std::size_t>(level + 0.5f), levels.size() - 1);
    return {sampled(levels[k], p.flat) * m.color_a, m.roughness, 0.5f};
}

}  // namespace fastscene::patterns
