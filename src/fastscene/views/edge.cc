#include "fastscene/views/edge.h"

#include <algorithm>
#include <cmath>

#include "fastscene/geometry/sphere.h"

namespace fastscene {
namespace {

// The square root of luminance, close to how brightness is perceived. Columns wrap, rows are clamped.
float brightness(const ImageColor& color, int x, int y) {
    return std::sqrt(
        std::max(0.f, luminance(color.at(wrap_column(x, color.width), std::clamp(y, 0, color.height - 1)))));
}

// Differences over two pixels.
Vec2f gradient(const ImageColor& color, int x, int y) {
    return {brightness(color, x + 1, y) - brightness(color, x - 1, y),
            brightness(color, x, y + 1) - brightness(color, x, y - 1)};
}

// A symmetric 2x2 matrix.
struct Tensor {
    float xx = 0, xy = 0, yy = 0;
};

// Of the gradients per pixel in the 3x3 pixels around (x, y).
Tensor structure_tensor(const ImageColor& color, int x, int y) {
    Tensor out;
    for (int j = y - 1; j <= y + 1; ++j)
        for (int i = x - 1; i <= x + 1; ++i) {
            const Vec2f g = gradient(color, i, j) * 0.5f;
            const float w = (i == x ? 0.5f : 0.25f) * (j == y ? 0.5f : 0.25f);
            out.xx += w * g.x * g.x, out.xy += w * g.x * g.y, out.yy += w * g.y * g.y;
        }
    return out;
}

}  // namespace

float edge_strength(const ImageColor& color, int x, int y) {
    const Vec2f g = gradient(color, x, y);
    return std::fabs(g.x) + std::fabs(g.y);
}

Vec3f edge_at(const ImageColor& color, int x, int y, Vec3f normal, Vec3f across, Vec3f down) {
    constexpr float kNoise = 0.01f;  // gradient per pixel at which noise of the picture and a pattern are as likely
    const Tensor seen = structure_tensor(color, x, y);
    const float strength = (seen.xx + seen.yy) / (seen.xx + seen.yy + kNoise * kNoise);
    // Gradients on the surface, in the frame u, v: the picture's are A times these.
    Vec3f u, v;
    make_frame(normal, u, v);
    const float a = dot(across, u), b = dot(across, v), c = dot(down, u), d = dot(down, v), det = a * d - b * c;
    if (!(std::fabs(det) > 1e-12f)) return {};
    const float ua = d / det, ub = -b / det, va = -c / det, vb = a / det;
    const float uu = ua * ua * seen.xx + 2 * ua * ub * seen.xy + ub * ub * seen.yy,
                uv = ua * va * seen.xx + (ua * vb + ub * va) * seen.xy + ub * vb * seen.yy,
                vv = va * va * seen.xx + 2 * va * vb * seen.xy + vb * vb * seen.yy;
    const float mean = 0.5f * (uu + vv), difference = std::hypot(0.5f * (uu - vv), uv);  // of the eigenvalues
    if (!(mean > 0)) return {};
    const float angle = 0.5f * std::atan2(2 * uv, uu - vv);  // of the strongest change
    return (v * std::cos(angle) - u * std::sin(angle)) * (std::min(1.f, difference / mean) * strength);
}

}  // namespace fastscene
