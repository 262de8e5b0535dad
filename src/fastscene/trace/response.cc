#include "fastscene/trace/response.h"

#include "fastscene/trace/kernel/response.h"

namespace fastscene {

Response response_of(const SurfacePointInfo& s, Vec3f direction) {
    return kernel::response_of(*s.material, s.texture, s.bumped, direction);
}

Vec3f flame_as_seen(const Look& look, const SurfacePointInfo& s, Vec3f direction) {
    return kernel::flame_as_seen(look.exposure_ev, s.material->emission, s.normal, direction);
}

Vec3f emission_as_seen(const Look& look, const SurfacePointInfo& s) {
    return kernel::lamp_as_seen(look.exposure_ev, s.material->emission) * s.texture.shown;
}

Pane pane_of(const SurfacePointInfo& s, Vec3f direction) {
    return kernel::pane_of(s.texture.albedo, s.normal, direction);
}

Vec3f dye_of(const SurfacePointInfo& s) { return kernel::dye_of(s.texture.albedo); }

Vec3f sun_glint(const Sky& sky, const SurfacePointInfo& surface, const Response& response, Vec3f direction, Vec3f sun,
                float least_alpha) {
    return kernel::sun_glint(sky.sun_dir, surface.bumped, response, direction, sun, least_alpha);
}

Vec3f sun_reflected(const Sky& sky, Vec3f reflectance, const Coat& coat, float transmission, Vec3f normal,
                    Vec3f direction, bool behind) {
    return kernel::sun_reflected(sky.sun_dir, reflectance, coat, transmission, normal, direction, behind);
}

}  // namespace fastscene
