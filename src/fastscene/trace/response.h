// Response: how a bit of surface sends light back, the same for cached and for path traced pictures.
#pragma once

#include "fastscene/math/vec.h"
#include "fastscene/trace/surface.h"

namespace fastscene {

// Radiance = (diffuse * E_front + behind * E_back) / pi + shine * (what lies in the mirror, spread by GGX of width alpha).
struct Response {
    Vec3f diffuse, behind;
    Vec3f shine;
    float alpha = 0;
};
Response response_of(const SurfacePointInfo& surface, Vec3f direction);

// What a surface of this albedo sends back of even light, the coat's share included: for light on its second way.
Vec3f mean_reflectance(const Material& material, Vec3f albedo);

// A half vector of the GGX distribution about n; u in [0, 1)^2.
Vec3f ggx_half(Vec3f n, float alpha, Vec2f u);
// Density per solid angle of the direction that mirroring `direction` in such a half vector gives.
float ggx_density(Vec3f n, float alpha, Vec3f direction, Vec3f out);
// The radiance towards -direction of the sun in a glossy surface, whose disc no ray meets by chance; `sun`: its irradiance there. Surfaces smoother
// than `least_alpha` spread it as if they were that rough, so that no pixel sparkles; a perfect mirror shows none.
inline constexpr float kSharpestSun = 0.1f;   // least_alpha of what a camera sees
Vec3f sun_glint(const Sky& sky, const SurfacePointInfo& surface, const Response& response, Vec3f direction, Vec3f sun, float least_alpha);
// Cosine-weighted direction about n; u in [0, 1)^2.
Vec3f cosine_direction(Vec3f n, Vec2f u);

}  // namespace fastscene
