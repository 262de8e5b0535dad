// Response: how a bit of surface sends light back, the same for cached and for path traced pictures.
#pragma once

#include "fastscene/math/vec.h"
#include "fastscene/trace/surface.h"

namespace fastscene {

// Radiance = (diffuse * E_front + behind * E_back) / pi + shine * (what lies in the mirror, spread by GGX of width
// alpha).
struct Response {
    Vec3f diffuse, behind;
    Vec3f specular;
    float alpha = 0;
};
Response response_of(const SurfacePointInfo& surface, Vec3f direction);

// Panes, drinking glasses, shower screens: light goes through as if they were not there, and a camera sees through
// them.
bool is_clear(const Material& material);
// What a camera sees at a clear surface: what is behind it, times `through`; the share `mirrored` of what lies in the
// mirror; and as much as `veil` of what frosted glass would show: dust, scratches; without it no pane is seen.
struct Pane {
    Vec3f through;
    float mirrored, veil;
};
Pane pane_of(const SurfacePointInfo& surface, Vec3f direction);
// What the color of glass leaves of the light that comes through.
Vec3f dye_of(const SurfacePointInfo& surface);

// What mirrors on top of a surface: Schlick's approximation, less steep at grazing angles where it is rough.
struct Coat {
    Vec3f across, grazing;         // what is mirrored straight on, and at a grazing angle
    float sharp = 0;               // the share of it that is mirrored; the rest is spread evenly
    float alpha = 0;               // width of the mirror cone; 0: a perfect mirror
    Vec3f at(float facing) const;  // facing: cosine to the normal
    Vec3f mean() const;            // over the hemisphere, by the cosine
};
Coat coat_of(const Material& material, Vec3f albedo, float roughness);

// What a surface of this albedo sends back of even light, the coat's share included: for light on its second way.
Vec3f mean_reflectance(const Material& material, Vec3f albedo);

// A half vector of the GGX distribution about n; u in [0, 1)^2.
Vec3f ggx_half(Vec3f n, float alpha, Vec2f u);
// Density per solid angle of the direction that mirroring `direction` in such a half vector gives.
float ggx_pdf(Vec3f n, float alpha, Vec3f direction, Vec3f out);
// The radiance towards -direction of the sun in a glossy surface, whose disc no ray meets by chance; `sun`: its
// irradiance there. Surfaces smoother than `least_alpha` spread it as if they were that rough, so that no pixel
// sparkles; a perfect mirror shows none.
inline constexpr float kSharpestSun = 0.1f;  // least_alpha of what a camera sees
inline constexpr float kWideSun = 0.2f;      // and of what lights the rest of the room: few paths meet a sharper glint
Vec3f sun_glint(const Sky& sky, const SurfacePointInfo& surface, const Response& response, Vec3f direction, Vec3f sun,
                float least_alpha);
// The radiance towards -direction, per unit of the sun's irradiance on it, of a surface that no camera looks at:
// evenly, and as a mirror of its gloss would. The floor before a row of lacquered fronts in the sun is a quarter
// brighter than even light would have it. `behind`: a sheet's far side.
Vec3f sun_reflected(const Sky& sky, Vec3f reflectance, const Coat& coat, float transmission, Vec3f normal,
                    Vec3f direction, bool behind);
// Cosine-weighted direction about n; u in [0, 1)^2.
Vec3f cosine_direction(Vec3f n, Vec2f u);

}  // namespace fastscene
