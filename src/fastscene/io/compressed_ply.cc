#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/ply.h"
#include "fastscene/io/splat_io.h"

// PlayCanvas' compressed PLY: chunks of 256 splats share the bounds between which positions, scales and
// colors are stored with 8 to 11 bits. Splats come in Morton order, so that a chunk is small in space.
namespace fastscene {
namespace {

constexpr std::size_t kChunk = 256;

std::uint32_t unorm(float v, int bits) {
    const float top = static_cast<float>((1u << bits) - 1u);
    if (!(v > 0.f)) return 0;  // NaN too
    return static_cast<std::uint32_t>(std::floor(std::clamp(v, 0.f, 1.f) * top + 0.5f));
}

struct Bounds3 {
    Vec3f low{1e30f, 1e30f, 1e30f}, high{-1e30f, -1e30f, -1e30f};
    void add(Vec3f v) {
        for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], v[a]), high[a] = std::max(high[a], v[a]);
    }
    Vec3f share(Vec3f v) const {
        Vec3f s;
        for (std::size_t a = 0; a < 3; ++a) s[a] = high[a] - low[a] < 1e-5f ? 0.f : (v[a] - low[a]) / (high[a] - low[a]);
        return s;
    }
};

std::uint32_t pack_11_10_11(Vec3f v) { return unorm(v.x, 11) << 21 | unorm(v.y, 10) << 11 | unorm(v.z, 11); }

// The largest component is left out: 2 bits say which, 10 bits each the others.
std::uint32_t pack_rotation(Quatf q) {
    std::array<float, 4> c{q.w, q.x, q.y, q.z};
    const float n = std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + c[3] * c[3]);
    if (!(n > 0.f)) c = {1, 0, 0, 0};
    else for (float& v : c) v /= n;
    std::size_t largest = 0;
    for (std::size_t i = 1; i < 4; ++i)
        if (std::abs(c[i]) > std::abs(c[largest])) largest = i;
    const float sign = c[largest] < 0 ? -1.f : 1.f;
    std::uint32_t out = static_cast<std::uint32_t>(largest);
    for (std::size_t i = 0; i < 4; ++i)
        if (i != largest) out = out << 10 | unorm(sign * c[i] * std::sqrt(0.5f) + 0.5f, 10);
    return out;
}

// Interleaves the lower 10 bits of three numbers.
std::uint32_t spread_bits(std::uint32_t v) {
    v = (v | v << 16) & 0x030000ff;
    v = (v | v << 8) & 0x0300f00f;
    v = (v | v << 4) & 0x030c30c3;
    return (v | v << 2) & 0x09249249;
}

std::vector<std::uint32_t> morton_order(const std::vector<Vec3f>& points) {
    Bounds3 box;
    for (const Vec3f p : points) box.add(p);
    std::vector<std::uint32_t> code(points.size()), order(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3f s = box.share(points[i]);
        code[i] = spread_bits(unorm(s.x, 10)) | spread_bits(unorm(s.y, 10)) << 1 | spread_bits(unorm(s.z, 10)) << 2;
    }
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return code[a] < code[b]; });
    return order;
}

Vec3f clamped_scale(Vec3f s) { return {std::clamp(s.x, -20.f, 20.f), std::clamp(s.y, -20.f, 20.f), std::clamp(s.z, -20.f, 20.f)}; }

}  // namespace

std::string compressed_ply_bytes(const Splats& splats) {
    const std::size_t count = splats.size(), chunks = (count + kChunk - 1) / kChunk;
    std::string out = fmt::format("ply\nformat binary_little_endian 1.0\ncomment fastscene\nelement chunk {}\n", chunks);
    for (const char* what : {"", "scale_", "color"})
        for (const char* end : {"min", "max"})
            for (int a = 0; a < 3; ++a) {
                const bool color = what[0] == 'c';
                out += fmt::format("property float {}_{}{}\n", end, color ? "" : what, color ? "rgb"[a] : "xyz"[a]);
            }
    out += fmt::format("element vertex {}\n", count);
    for (const char* name : {"position", "rotation", "scale", "color"}) out += fmt::format("property uint packed_{}\n", name);
    const int rest = 3 * splats.rest_coefficients();
    if (rest) {
        out += fmt::format("element sh {}\n", count);
        for (int i = 0; i < rest; ++i) out += fmt::format("property uchar f_rest_{}\n", i);
    }
    out += "end_header\n";

    const std::vector<std::uint32_t> order = morton_order(splats.mean_m);
    const auto color_of = [&](std::size_t i) { return splats.sh0[i] * kSh0 + Vec3f{0.5f, 0.5f, 0.5f}; };
    std::string chunk_bytes, vertex_bytes;
    for (std::size_t first = 0; first < count; first += kChunk) {
        const std::size_t last = std::min(count, first + kChunk);
        Bounds3 mean, scale, color;
        for (std::size_t k = first; k < last; ++k) {
            mean.add(splats.mean_m[order[k]]);
            scale.add(clamped_scale(splats.log_scale[order[k]]));
            color.add(color_of(order[k]));
        }
        for (const Bounds3& b : {mean, scale, color})
            for (const Vec3f v : {b.low, b.high}) append(chunk_bytes, v.x), append(chunk_bytes, v.y), append(chunk_bytes, v.z);
        for (std::size_t k = first; k < last; ++k) {
            const std::size_t i = order[k];
            const Vec3f c = color.share(color_of(i));
            const float opacity = 1.f / (1.f + std::exp(-splats.opacity_logit[i]));
            append(vertex_bytes, pack_11_10_11(mean.share(splats.mean_m[i])));
            append(vertex_bytes, pack_rotation(splats.rotation[i]));
            append(vertex_bytes, pack_11_10_11(scale.share(clamped_scale(splats.log_scale[i]))));
            append(vertex_bytes, unorm(c.x, 8) << 24 | unorm(c.y, 8) << 16 | unorm(c.z, 8) << 8 | unorm(opacity, 8));
        }
    }
    out += chunk_bytes;
    out += vertex_bytes;
    for (const std::uint32_t i : order)
        for (int k = 0; k < rest; ++k) {
            const float v = splats.sh_rest[i * static_cast<std::size_t>(rest) + static_cast<std::size_t>(k)];
            out += static_cast<char>(static_cast<std::uint8_t>(std::clamp(std::trunc((v / 8.f + 0.5f) * 256.f), 0.f, 255.f)));
        }
    return out;
}

void save_compressed_ply(const std::filesystem::path& path, const Splats& splats) { write_file(path, compressed_ply_bytes(splats)); }

}  // namespace fastscene
