// Cell keys of the irradiance cache and the spreading of sample points. Private to trace/irradiance*.cc.
#pragma once

#include <cmath>
#include <cstdint>

#include "fastscene/math/vec.h"

namespace fastscene::irradiance {

inline constexpr std::int32_t kBias = 1 << 18;
inline constexpr int kSunSamples = 16;  // shadow rays per cell

inline std::uint64_t key_of(std::int32_t x, std::int32_t y, std::int32_t z, int facing) {
    const auto part = [](std::int32_t v) {
        return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v + kBias) & 0xfffffu);
    };
    return part(x) << 43 | part(y) << 23 | part(z) << 3 | static_cast<std::uint64_t>(facing);
}
struct Place {
    std::int32_t x, y, z;
    int facing;
};
inline Place place_of(std::uint64_t key) {
    const auto part = [&](int shift) { return static_cast<std::int32_t>(key >> shift & 0xfffffu) - kBias; };
    return {part(43), part(23), part(3), static_cast<int>(key & 7)};
}
inline std::int32_t cell_index(float v) { return static_cast<std::int32_t>(std::floor(v)); }

// Roberts' R2 low-discrepancy sequence, with a random shift (Cranley-Patterson rotation).
inline Vec2f r2_point(std::uint32_t i, Vec2f shift) {
    const float u = shift.x + static_cast<float>((i * 3242174889u) >> 8) * 0x1p-24f,
                v = shift.y + static_cast<float>((i * 2447445414u) >> 8) * 0x1p-24f;
    return {u - std::floor(u), v - std::floor(v)};
}

inline float distance_epsilon(Vec3f p) { return 1e-4f + 2e-5f * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z)); }

}  // namespace fastscene::irradiance
