// Colors of light in half precision, for files.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "fastscene/base/bytes.h"
#include "fastscene/math/half.h"
#include "fastscene/math/vec.h"

namespace fastscene {

constexpr std::size_t kHalvesBytes = 6;

// Makes the brightest number half of the largest that there is, so that the darkest keep their digits. A power of two:
// rounding twice is rounding once.
inline float scale_for_halves(float brightest) {
    return std::exp2(std::floor(std::log2(32768.f / std::max(1e-20f, brightest))));
}
inline void append_halves(std::string& out, Vec3f v, float scale) {
    for (std::size_t a = 0; a < 3; ++a) append(out, half_from_float(v[a] * scale));
}
inline Vec3f halves_from(ByteReader& in, float scale) {
    Vec3f out;
    for (std::size_t a = 0; a < 3; ++a) out[a] = float_from_half(in.get<std::uint16_t>()) / scale;
    return out;
}

}  // namespace fastscene
