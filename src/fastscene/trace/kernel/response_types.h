// What the reflection model answers (kernel/response.h).
#ifndef FASTSCENE_TRACE_KERNEL_RESPONSE_TYPES_H
#define FASTSCENE_TRACE_KERNEL_RESPONSE_TYPES_H

#include "fastscene/trace/kernel/language.h"

KERNEL_BEGIN

// Radiance = (diffuse * E_front + behind * E_back) / pi + specular * (radiance from the mirror direction, spread by a
// GGX lobe of width alpha).
struct Response {
    Vec3f diffuse, behind;
    Vec3f specular;
    float alpha;
};

// What a camera sees at clear glass: what is behind it times `through`; the share `mirrored` of what it reflects; and
// the share `veil` of what frosted glass would show, as dust and scratches, without which a pane would be invisible.
struct Pane {
    Vec3f through;
    float mirrored, veil;
};

// Specular coat on top of a surface: Schlick's approximation, flatter at grazing angles where it is rough.
struct Coat {
    Vec3f across, grazing;  // reflectance at normal and at grazing incidence
    float sharp;            // the share reflected specularly; the rest is diffuse
    float alpha;            // GGX width; 0: a perfect mirror
};

// The sun's highlight treats smoother surfaces as this rough, which avoids fireflies: for camera rays, and for
// illumination, where few paths would find a sharper one.
const float kSharpestSun = 0.1f, kWideSun = 0.2f;

KERNEL_END

#endif
