// Quantization helpers of splat formats. Private to io/.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "fastscene/math/rigid.h"

namespace fastscene {

inline float sigmoid(float logit) { return 1.f / (1.f + std::exp(-logit)); }
// Logit of a stored opacity; 0 and 1, which have no finite logit, are replaced by values half a step of `levels` away.
inline float logit_of(float opacity, float levels = 255.f) {
    const float half_step = 0.5f / levels, o = std::clamp(opacity, half_step, 1.f - half_step);
    return std::log(o / (1.f - o));
}

// Quantizes [0, 1] to `bits` bits, and back.
inline std::uint32_t unorm(float v, int bits) {
    const float top = static_cast<float>((1u << bits) - 1u);
    if (!(v > 0.f)) return 0;  // also for NaN
    return static_cast<std::uint32_t>(std::floor(std::min(v, 1.f) * top + 0.5f));
}
inline float from_unorm(std::uint32_t packed, int at, int bits) {
    const std::uint32_t top = (1u << bits) - 1u;
    return static_cast<float>(packed >> at & top) / static_cast<float>(top);
}

// Rounds to a byte.
inline std::uint8_t byte_near(float v) {
    return v > 0.f ? static_cast<std::uint8_t>(std::min(std::round(v), 255.f)) : std::uint8_t{0};
}

// Normalized w x y z; a zero quaternion becomes the identity.
inline std::array<float, 4> unit_quaternion(Quatf q) {
    const double n = std::sqrt(static_cast<double>(q.w) * q.w + static_cast<double>(q.x) * q.x +
                               static_cast<double>(q.y) * q.y + static_cast<double>(q.z) * q.z);
    if (!(n > 0)) return {1, 0, 0, 0};
    const auto part = [&](float v) { return static_cast<float>(static_cast<double>(v) / n); };
    return {part(q.w), part(q.x), part(q.y), part(q.z)};
}
template <std::size_t N>
std::size_t largest_of(const std::array<float, N>& c) {
    std::size_t largest = 0;
    for (std::size_t i = 1; i < N; ++i)
        if (std::abs(c[i]) > std::abs(c[largest])) largest = i;
    return largest;
}

}  // namespace fastscene
