// What the reader and the writer of SPZ share: the header and the order of the streams. Little endian. Private to io/.
//   versions 2 and 3: gzip of header (16 bytes), then the streams;
//   version 4: header in plain (32 bytes), a table of (compressed, uncompressed) sizes, then the streams as frames of
//   zstd.
// Each stream holds one attribute of all splats.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fastscene {

inline constexpr std::size_t kSpzHeader = 16, kSpzHeader4 = 32;
inline constexpr int kSpzFractionalBits = 12;                              // positions in 1/4096 m, 24 bits: +-2048 m
inline constexpr float kSpzColorScale = 0.15f;                             // of f_dc, around the middle of a byte
inline constexpr std::uint8_t kSpzAntialiased = 1, kSpzHasExtensions = 2;  // flags

enum SpzStream { kSpzPositions, kSpzAlphas, kSpzColors, kSpzScales, kSpzRotations, kSpzSh, kSpzStreams };

// Bytes of a splat in each stream. Degree 4 exists in version 4.
inline std::array<std::size_t, kSpzStreams> spz_stream_bytes(std::uint32_t version, int sh_degree) {
    const auto d = static_cast<std::size_t>(sh_degree);
    return {9, 1, 3, 3, version >= 3 ? std::size_t{4} : std::size_t{3}, 3 * ((d + 1) * (d + 1) - 1)};
}

}  // namespace fastscene
