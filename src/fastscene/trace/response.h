// Reflection model: how a surface point reflects light, shared by cached and path traced pictures.
#pragma once

#include "fastscene/math/vec.h"
#include "fastscene/trace/kernel/response_types.h"
#include "fastscene/trace/surface.h"

namespace fastscene {

// Defined in kernel/response.h, which kernels on graphics cards share.
namespace kernel {

// Window panes, drinking glasses, shower screens: light passes unchanged, and cameras see through them.
bool is_clear(const Material& material);
// Burning gas: cameras see through it, and it glows the more, the longer their ray passes through it.
bool is_flame(const Material& material);
// Neither stops light: for the rays of illumination they do not exist.
bool lets_light_pass(const Material& material);

Coat coat_of(const Material& material, Vec3f albedo, float roughness, float metal);
// Albedo of the surface including its coat under uniform light; for secondary bounces.
Vec3f mean_reflectance(const Material& material, Vec3f albedo, float metal);

// Samples a half vector of the GGX distribution about n; u in [0, 1)^2.
Vec3f ggx_half(Vec3f n, float alpha, Vec2f u);
// Solid-angle pdf of the direction obtained by reflecting `direction` about such a half vector.
float ggx_pdf(Vec3f n, float alpha, Vec3f direction, Vec3f outgoing);
// Cosine-weighted direction about n; u in [0, 1)^2.
Vec3f cosine_direction(Vec3f n, Vec2f u);

}  // namespace kernel

using kernel::is_clear, kernel::is_flame, kernel::lets_light_pass, kernel::coat_of, kernel::mean_reflectance,
    kernel::ggx_half, kernel::ggx_pdf, kernel::cosine_direction;
using kernel::Response, kernel::Pane, kernel::Coat, kernel::kSharpestSun, kernel::kWideSun;

Response response_of(const SurfacePointInfo& surface, Vec3f direction);
// What a flame adds where a ray enters or leaves it.
Vec3f flame_as_seen(const Look& look, const SurfacePointInfo& surface, Vec3f direction);
// What shines as cameras see it. Of a screen the whole picture is dimmed alike, so that it keeps its contrast.
Vec3f emission_as_seen(const Look& look, const SurfacePointInfo& surface);
Pane pane_of(const SurfacePointInfo& surface, Vec3f direction);
// Transmission of colored glass.
Vec3f dye_of(const SurfacePointInfo& surface);

// Radiance towards -direction of the sun's highlight on a glossy surface (rays cannot hit the sun). `sun`: its
// irradiance. Surfaces smoother than `least_alpha` are treated as that rough; perfect mirrors show none.
Vec3f sun_glint(const Sky& sky, const SurfacePointInfo& surface, const Response& response, Vec3f direction, Vec3f sun,
                float least_alpha);
// Radiance towards -direction, per unit of sun irradiance, of a surface that no camera sees directly: diffuse plus
// glossy. Without the glossy part, the floor in front of sunlit lacquered fronts would be a quarter too dark. `behind`:
// the far side of a thin sheet.
Vec3f sun_reflected(const Sky& sky, Vec3f reflectance, const Coat& coat, float transmission, Vec3f normal,
                    Vec3f direction, bool behind);

}  // namespace fastscene
