// The language of the files in this folder, which are C++20 and GLSL 4.60 at once: the surface model has one source for
// processors and graphics cards. This file gives C++ the names that GLSL has, and language.glsl the other way round.
//
// What both understand is plain functions of plain structures: no references (IN and INOUT say how an argument is
// passed, REF how a field is held), default arguments, members, lambdas or recursion. Functions are `inline`, or
// `static` if only one file uses them; files whose functions are neither are compiled in one .cc each, beside which C++
// callers find declarations. GLSL reserves `in`, `half`, `flat`, `sample`, `patch` and `input`, leaves `%` of negative
// numbers (use wrapped()) and powers of negative numbers undefined, and takes vec2(…), not braces. Each variable is
// given its value where it is declared or right after.
#ifndef FASTSCENE_TRACE_KERNEL_LANGUAGE_H
#define FASTSCENE_TRACE_KERNEL_LANGUAGE_H

#ifdef __cplusplus
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "fastscene/math/vec.h"

#define KERNEL_BEGIN namespace fastscene::kernel {
#define KERNEL_END }
#define IN(Type) const Type&
#define INOUT(Type) Type&
#define REF(Type) const Type&
#define KEEP_LOOP

namespace fastscene::kernel {

using uint = std::uint32_t;
using std::abs, std::atan2, std::clamp, std::copysign, std::cos, std::exp2, std::floor, std::hypot, std::lerp,
    std::log2, std::max, std::min, std::pow, std::round, std::sin, std::sqrt;

inline Vec2f vec2(float x, float y) { return {x, y}; }
inline Vec3f vec3(float x, float y, float z) { return {x, y, z}; }
inline float mix(float a, float b, float t) { return a + (b - a) * t; }

}  // namespace fastscene::kernel
#else
#include "fastscene/trace/kernel/language.glsl"
#endif

#endif
