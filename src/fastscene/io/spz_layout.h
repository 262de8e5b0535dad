// Shared by SPZ's reader and writer: header and order of the streams. Little endian. Private to io/.
// Versions 2 and 3: gzip of a 16 byte header and the streams.
// Version 4: an uncompressed 32 byte header, a table of (compressed, uncompressed) sizes, then the streams as zstd
// frames. Each stream holds one attribute of all splats.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fastscene {

inline constexpr std::size_t kSpzHeader = 16, kSpzHeader4 = 32;
inline constexpr int kSpzFractionalBits = 12;                              // positions in 1/4096 m, 24 bits: +-2048 m
inline constexpr float kSpzColorScale = 0.15f;                             // scale of f_dc around a byte's middle
inline constexpr std::uint8_t kSpzAntialiased = 1, kSpzHasExtensions = 2;  // flags

// Records of extensions: id, number of bytes, bytes. In version 4 they lie between header and table; in versions 1 to 3
// behind the streams, in the gzip stream.
inline constexpr std::uint32_t kSpzAxesRecord = 0xadbe0003;  // Adobe's: one number, the axes below
inline constexpr std::size_t kSpzRecordHeader = 8;
// The axes' number, less 1, has a bit an axis: right (else left), up (else down), front (else back).
inline constexpr std::uint32_t kSpzAxes = 4;  // right, up, back: those of files without the record
inline constexpr std::uint32_t kSpzMostAxes = 8;

enum SpzStream { kSpzPositions, kSpzAlphas, kSpzColors, kSpzScales, kSpzRotations, kSpzSh, kSpzStreams };

// Bytes per splat in each stream. Degree 4 exists in version 4.
inline std::array<std::size_t, kSpzStreams> spz_stream_bytes(std::uint32_t version, int sh_degree) {
    const auto d = static_cast<std::size_t>(sh_degree);
    return {9, 1, 3, 3, version >= 3 ? std::size_t{4} : std::size_t{3}, 3 * ((d + 1) * (d + 1) - 1)};
}

}  // namespace fastscene
