// Vectorized sine, cosine and arc tangent from the C library (glibc 2.35 or newer on x86-64, AVX2 variant if in use),
// otherwise scalar. Results differ in the last digits (3e-16). This matters for the official walk, which truncates
// coordinates that are integers up to rounding; its program uses another library of the same origin, and these vector
// functions reproduce its last bits far more often than scalar ones (docs/goldens.md, "What is not held").
#pragma once

#include <span>

namespace fastscene {

// Radians in and out; `out` has the length of the input and must not overlap it.
void sines(std::span<const double> angles, std::span<double> out);
void cosines(std::span<const double> angles, std::span<double> out);
// atan2(y, x) in [-pi, pi].
void arc_tangents(std::span<const double> y, std::span<const double> x, std::span<double> out);

}  // namespace fastscene
