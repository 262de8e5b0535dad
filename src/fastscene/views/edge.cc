#include "fastscene/views/edge.h"

#include <algorithm>
#include <cmath>

#include "fastscene/geometry/sphere.h"

namespace fastscene {
namespace {

// A symmetric 2x2 matrix.
struct Tensor {
    float xx = 0, xy = 0, yy = 0;
};

// Of the gradients per pixel in the 3x3 pixels around (x, y). Brightness is the square root of luminance, close to how
// it is perceived.
Tensor structure_tensor(const ImageColor& color, int x, int y) {
    const auto value = [&](int i, int j) {
        return std::sqrt(
            std::max(0.f, luminance(color.at(wrap_column(i, color.width), std::clamp(j, 0, color.height - 1)))));
    };
    Tensor out;
    for (int j = y - 1; j <= y + 1; ++j)
        for (int i = x - 1; i <= x + 1; ++i) {
            const float gx = 0.5f * (value(i + 1, j) - value(i - 1, j)),
                        gy = 0.5f * (value(i, j + 1) - value(i, j - 1));
            const float w = (i == x ? 0.5f : 0.25f) * (j == y ? 0.5f : 0.25f);
            out.xx += w * gx * gx, out.xy += w * gx * gy, out.yy += w * gy * gy;
        }
    return out;
}

}  // namespace

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
