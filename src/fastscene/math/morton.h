// Morton order (Z-order curve): neighbours in space are close in the list.
#pragma once

#include <cstdint>

namespace fastscene {

// Interleaves the lower 21 bits of three numbers, x in the lowest bit.
constexpr std::uint64_t morton_code(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
    const auto spread = [](std::uint64_t v) {
        v &= 0x1fffff;
        v = (v | v << 32) & 0x1f00000000ffffull;
        v = (v | v << 16) & 0x1f0000ff0000ffull;
        v = (v | v << 8) & 0x100f00f00f00f00full;
        v = (v | v << 4) & 0x10c30c30c30c30c3ull;
        return (v | v << 2) & 0x1249249249249249ull;
    };
    return spread(x) | spread(y) << 1 | spread(z) << 2;
}

}  // namespace fastscene
