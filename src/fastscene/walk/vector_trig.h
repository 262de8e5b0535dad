// Sines, cosines and arc tangents of many numbers at once, by the C library's vector mathematics where it has them
// (glibc 2.35 or newer on x86-64, its variant for AVX2 where that is in use), one by one elsewhere. They differ in last
// digits (3e-16). The official walk cuts coordinates that are whole numbers but for their last bit; its program counts
// on another library of the same descent, whose last bits these vector functions hit far more often than scalar ones do
// (docs/goldens.md, "What is not held").
#pragma once

#include <span>

namespace fastscene {

// Radians in and out; `out` as long as the input, and not the same memory.
void sines(std::span<const double> angles, std::span<double> out);
void cosines(std::span<const double> angles, std::span<double> out);
// atan2(y, x) in [-pi, pi].
void arc_tangents(std::span<const double> y, std::span<const double> x, std::span<double> out);

}  // namespace fastscene
