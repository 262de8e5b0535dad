#include <zstd.h>

#include <array>
#include <cmath>
#include <vector>

#include "fastscene/base/check.h"
#include "fastscene/base/bytes.h"
#include "fastscene/io/gzip.h"
#include "fastscene/io/packed.h"
#include "fastscene/io/splat_frames.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/io/spz.h"
#include "fastscene/io/spz_layout.h"

namespace fastscene {
namespace {

using Streams = std::array<std::string, kSpzStreams>;

void append_fixed(std::string& out, float metres) {
    const float v = std::round(metres * static_cast<float>(1 << kSpzFractionalBits));
    if (!(std::fabs(v) < 8388608.f))
        throw Error("SPZ holds positions up to 2048 m from the origin, found {} m: scale or crop the scene first",
                    metres);
    const auto fixed = static_cast<std::uint32_t>(static_cast<std::int32_t>(v));
    for (int shift = 0; shift < 24; shift += 8) out += static_cast<char>(fixed >> shift & 255);
}

// Version 3, smallest three encoding: the largest of x y z w is omitted; the others have a sign and 9 bits.
std::uint32_t bits_of_smallest_three(const std::array<float, 4>& xyzw) {
    const std::size_t largest = largest_of(xyzw);
    const bool negated = xyzw[largest] < 0;
    auto out = static_cast<std::uint32_t>(largest);
    for (std::size_t i = 0; i < 4; ++i) {
        if (i == largest) continue;
        const auto size = static_cast<std::uint32_t>(511.f * (std::fabs(xyzw[i]) / std::sqrt(0.5f)) + 0.5f);
        out = out << 10 | static_cast<std::uint32_t>((xyzw[i] < 0) != negated) << 9 | size;
    }
    return out;
}

void append_rotation(std::string& out, Quatf q, int version) {
    const auto [w, x, y, z] = unit_quaternion(q);
    if (version >= 3) return append(out, bits_of_smallest_three({x, y, z, w}));
    for (const float v : {x, y, z}) out += static_cast<char>(byte_near(v * (w < 0 ? -127.5f : 127.5f) + 127.5f));
}

// 5 bits for degree 1, 4 bits above.
char sh_byte(float v, std::size_t coefficient) {
    const int step = coefficient < 3 ? 8 : 16;
    const int q = (static_cast<int>(std::round(std::clamp(v, -8.f, 8.f) * 128.f)) + 128 + step / 2);
    return static_cast<char>(std::clamp(q < 0 ? 0 : q / step * step, 0, 255));
}

Streams streams_of(const Splats& world, int version) {
    Splats s = world;
    transform(s, {kSpzFromWorld, 1, {}});
    // SPZ implementations also rotate the local axes, which leaves the Gaussian unchanged.
    for (Quatf& q : s.rotation) q = q * Quatf{0, -1, 0, 0};
    Streams out;
    const auto k = static_cast<std::size_t>(s.rest_coefficients());
    for (std::size_t i = 0; i < s.size(); ++i) {
        for (std::size_t a = 0; a < 3; ++a) {
            append_fixed(out[kSpzPositions], s.mean_m[i][a]);
            out[kSpzColors] += static_cast<char>(byte_near(s.sh0[i][a] * (kSpzColorScale * 255.f) + 127.5f));
            out[kSpzScales] += static_cast<char>(byte_near((s.log_scale[i][a] + 10.f) * 16.f));
        }
        out[kSpzAlphas] += static_cast<char>(byte_near(sigmoid(s.opacity_logit[i]) * 255.f));
        append_rotation(out[kSpzRotations], s.rotation[i], version);
        for (std::size_t c = 0; c < k; ++c)
            for (std::size_t channel = 0; channel < 3; ++channel)
                out[kSpzSh] += sh_byte(s.sh_rest[(i * 3 + channel) * k + c], c);
    }
    return out;
}

std::string zstd(const std::string& bytes) {
    std::string out(ZSTD_compressBound(bytes.size()), '\0');
    const std::size_t size = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 12);
    if (ZSTD_isError(size)) throw Error("SPZ: cannot be compressed: {}", ZSTD_getErrorName(size));
    out.resize(size);
    return out;
}

// The first 15 bytes of every version, and the version-specific byte.
std::string header(const Splats& splats, int version, std::uint8_t last) {
    std::string out;
    append(out, kSpzMagic);
    append(out, static_cast<std::uint32_t>(version));
    append(out, static_cast<std::uint32_t>(splats.size()));
    append(out, static_cast<std::uint8_t>(splats.sh_degree));
    append(out, static_cast<std::uint8_t>(kSpzFractionalBits));
    const std::uint8_t records = version >= 4 ? kSpzHasExtensions : std::uint8_t{0};  // old readers refuse them
    append(out, static_cast<std::uint8_t>((splats.filter.antialias ? kSpzAntialiased : 0) | records));
    append(out, last);
    return out;
}

}  // namespace

std::string spz_bytes(const Splats& splats, int version) {
    FASTSCENE_CHECK(version >= 2 && version <= 4);
    const Streams streams = streams_of(splats, version);
    if (version < 4) {
        std::string whole = header(splats, version, 0);
        for (const std::string& stream : streams) whole += stream;
        return gzipped(whole);
    }
    const std::size_t count = splats.sh_degree > 0 ? kSpzStreams : kSpzStreams - 1;
    std::string out = header(splats, version, static_cast<std::uint8_t>(count)), data;
    append(out, static_cast<std::uint32_t>(kSpzHeader4 + kSpzRecordHeader + 4));  // offset of the table
    out.append(12, '\0');
    for (const std::uint32_t v : {kSpzAxesRecord, 4u, kSpzAxes}) append(out, v);
    for (std::size_t i = 0; i < count; ++i) {
        const std::string packed = zstd(streams[i]);
        append(out, static_cast<std::uint64_t>(packed.size()));
        append(out, static_cast<std::uint64_t>(streams[i].size()));
        data += packed;
    }
    return out + data;
}

}  // namespace fastscene
