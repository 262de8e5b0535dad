#include <fmt/ranges.h>
#include <zstd.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fastscene/base/bytes.h"
#include "fastscene/io/gzip.h"
#include "fastscene/io/packed.h"
#include "fastscene/io/spz.h"
#include "fastscene/io/spz_layout.h"
#include "fastscene/scene/splat_edit.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kGzipMagic = "\x1f\x8b";

struct SpzHeader {
    std::uint32_t version = 0;
    std::size_t count = 0;
    int sh_degree = 0, fractional_bits = 0;
    std::uint8_t flags = 0;
};

SpzHeader parse_header(ByteReader& in) {
    if (const auto magic = in.get<std::uint32_t>(); magic != kSpzMagic)
        in.refuse(fmt::format("expected the sign NGSP, found {:08x}", magic));
    SpzHeader h;
    h.version = in.get<std::uint32_t>();
    if (h.version < 2 || h.version > 4) in.refuse(fmt::format("expected SPZ version 2, 3 or 4, found {}", h.version));
    h.count = in.get<std::uint32_t>();
    h.sh_degree = in.get<std::uint8_t>();
    h.fractional_bits = in.get<std::uint8_t>();
    h.flags = in.get<std::uint8_t>();
    if (h.sh_degree > (h.version == 4 ? 4 : 3))
        in.refuse(fmt::format("expected spherical harmonics of degree 0 to 3, found {}", h.sh_degree));
    if (h.fractional_bits > 24)
        in.refuse(fmt::format("expected at most 24 fractional bits, found {}", h.fractional_bits));
    return h;
}

std::string unzstd(const fs::path& path, std::string_view bytes, std::size_t at, std::size_t expected) {
    const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(), ZSTD_freeDStream);
    ZSTD_DCtx_setParameter(stream.get(), ZSTD_d_windowLogMax, 27);
    std::string out, piece(ZSTD_DStreamOutSize(), '\0');
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    for (std::size_t more = 1; more != 0;) {
        ZSTD_outBuffer to{piece.data(), piece.size(), 0};
        more = ZSTD_decompressStream(stream.get(), &to, &in);
        if (ZSTD_isError(more))
            throw Error("{}: byte {}: expected a frame of zstd, found: {}", path.string(), at + in.pos,
                        ZSTD_getErrorName(more));
        out.append(piece, 0, to.pos);
        if (out.size() > expected) break;
        if (more != 0 && to.pos == 0 && in.pos == in.size)
            throw Error("{}: byte {}: expected more of a frame of zstd, found its end", path.string(), at + in.pos);
    }
    if (out.size() != expected)
        throw Error("{}: byte {}: expected {} bytes unpacked, found {}", path.string(), at, expected, out.size());
    return out;
}

struct Packed {
    SpzHeader header;
    std::array<std::string, kSpzStreams> streams;
    std::uint32_t axes = kSpzAxes;
    std::vector<std::string> warnings;
};

void read_axes(ByteReader& in, std::size_t bytes, Packed& packed) {
    if (bytes != 4) in.refuse(fmt::format("expected 4 bytes in the record of the axes, found {}", bytes));
    packed.axes = in.get<std::uint32_t>();
    if (packed.axes > kSpzMostAxes)
        in.refuse(fmt::format("expected axes 1 to {} (4: right, up, back), found {}", kSpzMostAxes, packed.axes));
    if (packed.axes != 0) return;
    packed.axes = kSpzAxes;
    packed.warnings.emplace_back("its record of the axes says none; right, up, back are assumed, as without it");
}

// Records up to byte `end`. One warning names all that are unknown.
void read_records(ByteReader& in, std::size_t end, Packed& packed) {
    std::vector<std::string> unknown;
    while (in.at() + kSpzRecordHeader <= end) {
        const auto id = in.get<std::uint32_t>(), bytes = in.get<std::uint32_t>();
        if (bytes > end - in.at())
            in.refuse(fmt::format("expected {} bytes in record {:08x}, found {}", bytes, id, end - in.at()));
        const std::size_t next = in.at() + bytes;
        if (id == kSpzAxesRecord) read_axes(in, bytes, packed);
        else if (unknown.size() < 8) unknown.push_back(fmt::format("{:08x} ({} bytes)", id, bytes));
        in.skip(next - in.at());
    }
    if (in.at() < end) in.skip(end - in.at());
    if (!unknown.empty())
        packed.warnings.push_back(
            fmt::format("unknown records are ignored: {}; if they change how splats are stored, this shows",
                        fmt::join(unknown, ", ")));
}

Packed unpack_gzip(const fs::path& path, std::string_view bytes) {
    std::optional<SpzHeader> header;
    std::size_t expected = kSpzHeader;
    // The header, once it is decompressed, tells how much may follow.
    const std::string whole = inflated(bytes, path, [&](std::string_view so_far) {
        if (!header && so_far.size() >= kSpzHeader) {
            ByteReader in(path, so_far);
            header = parse_header(in);
            for (const std::size_t b : spz_stream_bytes(header->version, header->sh_degree))
                expected += b * header->count;
        }
        if (header && so_far.size() > expected && !(header->flags & kSpzHasExtensions))
            throw Error("{}: expected {} bytes unpacked, found more", path.string(), expected);
    });
    ByteReader in(path, whole);
    Packed packed{parse_header(in), {}, kSpzAxes, {}};
    if (packed.header.version > 3) in.refuse("expected version 2 or 3 in a gzip stream, found 4");
    if (whole.size() < expected)
        throw Error("{}: expected {} bytes unpacked for {} splats, found {}", path.string(), expected,
                    packed.header.count, whole.size());
    std::size_t at = kSpzHeader;
    const auto sizes = spz_stream_bytes(packed.header.version, packed.header.sh_degree);
    for (std::size_t i = 0; i < kSpzStreams; at += sizes[i++] * packed.header.count)
        packed.streams[i] = whole.substr(at, sizes[i] * packed.header.count);
    in.skip(at - in.at());
    if (packed.header.flags & kSpzHasExtensions) read_records(in, whole.size(), packed);
    return packed;
}

Packed unpack_zstd(const fs::path& path, std::string_view bytes) {
    ByteReader in(path, bytes);
    Packed packed{parse_header(in), {}, kSpzAxes, {}};
    const SpzHeader& h = packed.header;
    if (h.version != 4) in.refuse(fmt::format("expected version 4 in a plain header, found {}", h.version));
    const std::size_t streams = in.get<std::uint8_t>(), table = in.get<std::uint32_t>();
    const auto sizes = spz_stream_bytes(h.version, h.sh_degree);
    const std::size_t wanted = h.sh_degree > 0 ? kSpzStreams : kSpzStreams - 1;
    if (streams != wanted) in.refuse(fmt::format("expected {} streams, found {}", wanted, streams));
    if (table < kSpzHeader4 || table > bytes.size())
        in.refuse(fmt::format("expected the table of streams inside the file, found byte {}", table));
    in.skip(kSpzHeader4 - in.at());
    if (h.flags & kSpzHasExtensions) read_records(in, table, packed);
    else in.skip(table - in.at());
    std::array<std::uint64_t, kSpzStreams> packed_bytes{};
    for (std::size_t i = 0; i < streams; ++i) {
        packed_bytes[i] = in.get<std::uint64_t>();
        if (const auto unpacked = in.get<std::uint64_t>(); unpacked != sizes[i] * h.count)
            in.refuse(fmt::format("expected {} bytes in stream {}, found {}", sizes[i] * h.count, i, unpacked));
    }
    for (std::size_t i = 0; i < streams; ++i) {
        if (packed_bytes[i] > in.left())
            in.refuse(fmt::format("expected {} bytes of stream {}, found {}", packed_bytes[i], i, in.left()));
        packed.streams[i] = unzstd(path, bytes.substr(in.at(), packed_bytes[i]), in.at(), sizes[i] * h.count);
        in.skip(packed_bytes[i]);
    }
    return packed;
}

Quatf rotation3(std::uint32_t v) {
    std::array<float, 4> c{};  // x y z w
    const std::size_t largest = v >> 30;
    float rest = 1;
    for (std::size_t i = 4; i-- > 0;) {
        if (i == largest) continue;
        c[i] = std::sqrt(0.5f) * static_cast<float>(v & 511) / 511.f * (v >> 9 & 1 ? -1.f : 1.f);
        rest -= c[i] * c[i];
        v >>= 10;
    }
    c[largest] = std::sqrt(std::max(0.f, rest));
    return {c[3], c[0], c[1], c[2]};
}

Quatf rotation2(const std::uint8_t* b) {
    const auto part = [&](int i) { return static_cast<float>(b[i]) / 127.5f - 1.f; };
    const float x = part(0), y = part(1), z = part(2);
    return {std::sqrt(std::max(0.f, 1.f - x * x - y * y - z * z)), x, y, z};
}

Splats splats_of(const Packed& packed) {
    const SpzHeader& h = packed.header;
    const auto bytes = [&](SpzStream stream) {
        return reinterpret_cast<const std::uint8_t*>(packed.streams[stream].data());
    };
    const float unit = 1.f / static_cast<float>(1 << h.fractional_bits);
    const auto stored = static_cast<std::size_t>((h.sh_degree + 1) * (h.sh_degree + 1) - 1);
    Splats s;
    s.sh_degree = std::min(h.sh_degree, 3);
    s.filter.antialias = h.flags & kSpzAntialiased;
    s.resize(h.count);
    const auto k = static_cast<std::size_t>(s.rest_coefficients());
    for (std::size_t i = 0; i < h.count; ++i) {
        for (std::size_t a = 0; a < 3; ++a) {
            const std::uint8_t* p = bytes(kSpzPositions) + 9 * i + 3 * a;
            const auto high = static_cast<std::uint32_t>(p[0]) << 8 | static_cast<std::uint32_t>(p[1]) << 16 |
                              static_cast<std::uint32_t>(p[2]) << 24;
            s.mean_m[i][a] = static_cast<float>(static_cast<std::int32_t>(high) / 256) * unit;
            s.sh0[i][a] = (static_cast<float>(bytes(kSpzColors)[3 * i + a]) / 255.f - 0.5f) / kSpzColorScale;
            s.log_scale[i][a] = static_cast<float>(bytes(kSpzScales)[3 * i + a]) / 16.f - 10.f;
        }
        s.opacity_logit[i] = logit_of(static_cast<float>(bytes(kSpzAlphas)[i]) / 255.f);
        s.rotation[i] = h.version >= 3 ? rotation3(number_at<std::uint32_t>(packed.streams[kSpzRotations], 4 * i))
                                       : rotation2(bytes(kSpzRotations) + 3 * i);
        for (std::size_t c = 0; c < k; ++c)
            for (std::size_t channel = 0; channel < 3; ++channel)
                s.sh_rest[(i * 3 + channel) * k + c] = (static_cast<float>(
                                                            bytes(kSpzSh)[(i * stored + c) * 3 + channel]) -
                                                        128.f) /
                                                       128.f;
    }
    return s;
}

// World axes point right, down and forward.
Mat3d file_from_world(std::uint32_t axes) {
    const std::uint32_t bits = axes - 1;
    return {{bits & 1 ? 1.0 : -1.0, 0, 0}, {0, bits & 2 ? -1.0 : 1.0, 0}, {0, 0, bits & 4 ? 1.0 : -1.0}};
}

Packed unpack(const fs::path& path, std::string_view bytes) {
    return bytes.starts_with(kGzipMagic) ? unpack_gzip(path, bytes) : unpack_zstd(path, bytes);
}

}  // namespace

bool is_spz(std::string_view bytes) {
    return bytes.starts_with(kGzipMagic) || (bytes.size() >= 4 && number_at<std::uint32_t>(bytes, 0) == kSpzMagic);
}

ReadSplats splats_of_spz(const fs::path& path, std::string_view bytes) {
    Packed packed = unpack(path, bytes);
    ReadSplats read(splats_of(packed));
    read.warnings = std::move(packed.warnings);
    const Mat3d axes = file_from_world(packed.axes);  // mirrored or not, its own inverse
    transform(read.splats, {axes, 1, {}});
    // Turns the local axes back, too, which leaves the Gaussian unchanged.
    const double sign = axes.row0.x * axes.row1.y * axes.row2.z;
    const Quatd turn = quaternion_of(sign < 0 ? Mat3d{-axes.row0, -axes.row1, -axes.row2} : axes);
    const Quatf back{static_cast<float>(turn.w), static_cast<float>(-turn.x), static_cast<float>(-turn.y),
                     static_cast<float>(-turn.z)};
    for (Quatf& q : read.splats.rotation) q = q * back;
    return read;
}

ReadSplats stored_splats_of_spz(const fs::path& path, std::string_view bytes) {
    Packed packed = unpack(path, bytes);
    ReadSplats read(splats_of(packed));
    read.warnings = std::move(packed.warnings);
    return read;
}

}  // namespace fastscene
