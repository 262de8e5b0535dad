// Reflection model: how a surface point reflects light, shared by cached and path traced pictures.
#pragma once

#include "fastscene/math/vec.h"
#include "fastscene/trace/surface.h"

namespace fastscene {

// Radiance = (diffuse * E_front + behind * E_back) / pi + specular * (radiance from the mirror direction, spread by a
// GGX lobe of width alpha).
struct Response {
    Vec3f diffuse, behind;
    Vec3f specular;
    float alpha = 0;
};
Response response_of(const SurfacePointInfo& surface, Vec3f direction);

// Window panes, drinking glasses, shower screens: light passes unchanged, and cameras see through them.
bool is_clear(const Material& material);
// Burning gas: cameras see through it, and it glows the more, the longer their ray passes through it.
bool is_flame(const Material& material);
// Neither stops light: for the rays of illumination they do not exist.
bool lets_light_pass(const Material& material);
// What a flame adds where a ray enters or leaves it.
Vec3f flame_as_seen(const Look& look, const SurfacePointInfo& surface, Vec3f direction);
// What a camera sees at clear glass: what is behind it times `through`; the share `mirrored` of what it reflects; and
// the share `veil` of what frosted glass would show, as dust and scratches, without which a pane would be invisible.
struct Pane {
    Vec3f through;
    float mirrored, veil;
};
Pane pane_of(const SurfacePointInfo& surface, Vec3f direction);
// Transmission of colored glass.
Vec3f dye_of(const SurfacePointInfo& surface);

// Specular coat on top of a surface: Schlick's approximation, flatter at grazing angles where it is rough.
struct Coat {
    Vec3f across, grazing;         // reflectance at normal and at grazing incidence
    float sharp = 0;               // the share reflected specularly; the rest is diffuse
    float alpha = 0;               // GGX width; 0: a perfect mirror
    Vec3f at(float facing) const;  // facing: cosine between direction and normal
    Vec3f mean() const;            // cosine-weighted mean over the hemisphere
};
Coat coat_of(const Material& material, Vec3f albedo, float roughness);

// Albedo of the surface including its coat under uniform light; for secondary bounces.
Vec3f mean_reflectance(const Material& material, Vec3f albedo);

// Samples a half vector of the GGX distribution about n; u in [0, 1)^2.
Vec3f ggx_half(Vec3f n, float alpha, Vec2f u);
// Solid-angle pdf of the direction obtained by reflecting `direction` about such a half vector.
float ggx_pdf(Vec3f n, float alpha, Vec3f direction, Vec3f out);
// Radiance towards -direction of the sun's highlight on a glossy surface (rays cannot hit the sun). `sun`: its
// irradiance. Surfaces smoother than `least_alpha` are treated as that rough, which avoids fireflies; perfect mirrors
// show none.
inline constexpr float kSharpestSun = 0.1f;  // least_alpha for camera rays
inline constexpr float kWideSun = 0.2f;      // … and for illumination: few paths would find a sharper highlight
Vec3f sun_glint(const Sky& sky, const SurfacePointInfo& surface, const Response& response, Vec3f direction, Vec3f sun,
                float least_alpha);
// Radiance towards -direction, per unit of sun irradiance, of a surface that no camera sees directly: diffuse plus
// glossy. Without the glossy part, the floor in front of sunlit lacquered fronts would be a quarter too dark. `behind`:
// the far side of a thin sheet.
Vec3f sun_reflected(const Sky& sky, Vec3f reflectance, const Coat& coat, float transmission, Vec3f normal,
                    Vec3f direction, bool behind);
// Cosine-weighted direction about n; u in [0, 1)^2.
Vec3f cosine_direction(Vec3f n, Vec2f u);

}  // namespace fastscene
