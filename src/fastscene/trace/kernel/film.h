// How cameras see very bright things; see trace/film.h.
#ifndef FASTSCENE_TRACE_KERNEL_FILM_H
#define FASTSCENE_TRACE_KERNEL_FILM_H

#include "fastscene/trace/kernel/language.h"

KERNEL_BEGIN

// Compresses light that is `times` as bright as the limit: logarithmic above it, so that order is preserved.
inline float restrained(float times, float doubling) { return times > 1 ? (1 + doubling * log2(times)) / times : 1.f; }

// The radiance of a lamp or flame that the camera sees directly, compressed so that its shape and hue do not clip to
// white. Its illumination of the room is unaffected. `exposure_ev`: Look's.
inline Vec3f lamp_as_seen(float exposure_ev, Vec3f emission) {
    const float kDoubling = 0.15f;  // log compression above white: what each doubling adds
    return emission * restrained(luminance(emission) * exp2(exposure_ev), kDoubling);
}

// Radiance of the outside as the camera sees it; `seen` is Sky's, `outside_seen` Look's.
inline Vec3f outside_as_seen(float seen, float outside_seen, Vec3f radiance) {
    return radiance * (seen * outside_seen);
}

KERNEL_END

#endif
