#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/bytes.h"
#include "fastscene/io/packed.h"
#include "fastscene/io/ply.h"
#include "fastscene/io/splat_format.h"
#include "fastscene/io/splat_io.h"
#include "fastscene/math/morton.h"

// PlayCanvas' compressed PLY: chunks of 256 splats share the bounds between which positions, scales and colors are
// quantized to 8 to 11 bits. Splats are in Morton order, so that a chunk is spatially compact.
namespace fastscene {
namespace {

constexpr std::size_t kChunk = 256;

struct Bounds3 {
    Vec3f low{1e30f, 1e30f, 1e30f}, high{-1e30f, -1e30f, -1e30f};
    void add(Vec3f v) {
        for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], v[a]), high[a] = std::max(high[a], v[a]);
    }
    Vec3f share(Vec3f v) const {
        Vec3f s;
        for (std::size_t a = 0; a < 3; ++a)
            s[a] = high[a] - low[a] < 1e-5f ? 0.f : (v[a] - low[a]) / (high[a] - low[a]);
        return s;
    }
};

std::uint32_t pack_11_10_11(Vec3f v) { return unorm(v.x, 11) << 21 | unorm(v.y, 10) << 11 | unorm(v.z, 11); }

// Smallest three encoding: the largest component is omitted; 2 bits for its index, 10 bits for each of the others.
std::uint32_t bits_of_rotation(Quatf q) {
    const std::array<float, 4> c = unit_quaternion(q);
    const std::size_t largest = largest_of(c);
    const float sign = c[largest] < 0 ? -1.f : 1.f;
    std::uint32_t out = static_cast<std::uint32_t>(largest);
    for (std::size_t i = 0; i < 4; ++i)
        if (i != largest) out = out << 10 | unorm(sign * c[i] * std::sqrt(0.5f) + 0.5f, 10);
    return out;
}

void sort_in_space(const std::vector<Vec3f>& points, std::span<std::uint32_t> order) {
    Bounds3 box;
    for (const std::uint32_t i : order) box.add(points[i]);
    std::vector<std::uint64_t> code(points.size());
    for (const std::uint32_t i : order) {
        const Vec3f s = box.share(points[i]);
        code[i] = morton_code(unorm(s.x, 21), unorm(s.y, 21), unorm(s.z, 21));
    }
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return code[a] < code[b]; });
}

float median_of(std::vector<float> values) {
    std::erase_if(values, [](float v) { return !std::isfinite(v); });
    if (values.empty()) return 0.f;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// Distances from the scene's center, relative to their median.
std::vector<float> distances(const std::vector<Vec3f>& points) {
    std::vector<float> axis[3], out;
    for (const Vec3f p : points) axis[0].push_back(p.x), axis[1].push_back(p.y), axis[2].push_back(p.z);
    const Vec3f middle{median_of(axis[0]), median_of(axis[1]), median_of(axis[2])};
    for (const Vec3f p : points) out.push_back(length(p - middle));
    const float usual = median_of(out);
    for (float& d : out) d = usual > 0 ? d / usual : 0.f;
    return out;
}

// Relative screen area of a splat, independent of distance: opacity times largest cross section.
float weight_of(const Splats& splats, std::uint32_t i) {
    const Vec3f s = splats.log_scale[i];
    return sigmoid(splats.opacity_logit[i]) * std::exp(s.x + s.y + s.z - std::min({s.x, s.y, s.z}));
}

// Neighbours in space become neighbours in the file. A sky hundreds of metres away comes last: sharing a chunk with it
// would shift a room's splats by decimetres, so the chunk at the boundary gets the least visible ones of the room.
std::vector<std::uint32_t> order_of_splats(const Splats& splats) {
    constexpr float kFar = 8.f;  // in medians
    const std::vector<Vec3f>& points = splats.mean_m;
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0u);
    if (order.empty()) return order;
    const std::vector<float> distance = distances(points);
    const auto far = std::stable_partition(order.begin(), order.end(),
                                           [&](std::uint32_t i) { return distance[i] < kFar; });
    auto near_end = far;
    if (far != order.end()) {
        near_end -= (far - order.begin()) % static_cast<std::ptrdiff_t>(kChunk);
        std::nth_element(order.begin(), near_end, far, [&](std::uint32_t a, std::uint32_t b) {
            const float wa = weight_of(splats, a), wb = weight_of(splats, b);
            return wa != wb ? wa > wb : a < b;
        });
    }
    sort_in_space(points, {order.begin(), near_end});
    sort_in_space(points, {near_end, far});
    sort_in_space(points, {far, order.end()});
    return order;
}

Vec3f clamped_scale(Vec3f s) {
    return {std::clamp(s.x, -20.f, 20.f), std::clamp(s.y, -20.f, 20.f), std::clamp(s.z, -20.f, 20.f)};
}

}  // namespace

std::string compressed_ply_bytes(const Splats& splats) {
    const std::size_t count = splats.size(), chunks = (count + kChunk - 1) / kChunk;
    std::string out = fmt::format("ply\nformat binary_little_endian 1.0\ncomment fastscene\n{}element chunk {}\n",
                                  ply_comments(splats), chunks);
    for (const char* what : {"", "scale_", "color"})
        for (const char* end : {"min", "max"})
            for (int a = 0; a < 3; ++a) {
                const bool color = what[0] == 'c';
                out += fmt::format("property float {}_{}{}\n", end, color ? "" : what, color ? "rgb"[a] : "xyz"[a]);
            }
    out += fmt::format("element vertex {}\n", count);
    for (const char* name : {"position", "rotation", "scale", "color"})
        out += fmt::format("property uint packed_{}\n", name);
    const int rest = 3 * splats.rest_coefficients();
    if (rest) {
        out += fmt::format("element sh {}\n", count);
        for (int i = 0; i < rest; ++i) out += fmt::format("property uchar f_rest_{}\n", i);
    }
    out += "end_header\n";

    const std::vector<std::uint32_t> order = order_of_splats(splats);
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
            for (const Vec3f v : {b.low, b.high})
                append(chunk_bytes, v.x), append(chunk_bytes, v.y), append(chunk_bytes, v.z);
        for (std::size_t k = first; k < last; ++k) {
            const std::size_t i = order[k];
            const Vec3f c = color.share(color_of(i));
            const float opacity = sigmoid(splats.opacity_logit[i]);
            append(vertex_bytes, pack_11_10_11(mean.share(splats.mean_m[i])));
            append(vertex_bytes, bits_of_rotation(splats.rotation[i]));
            append(vertex_bytes, pack_11_10_11(scale.share(clamped_scale(splats.log_scale[i]))));
            append(vertex_bytes, unorm(c.x, 8) << 24 | unorm(c.y, 8) << 16 | unorm(c.z, 8) << 8 | unorm(opacity, 8));
        }
    }
    out += chunk_bytes;
    out += vertex_bytes;
    for (const std::uint32_t i : order)
        for (int k = 0; k < rest; ++k) {
            const float v = splats.sh_rest[i * static_cast<std::size_t>(rest) + static_cast<std::size_t>(k)];
            out += static_cast<char>(
                static_cast<std::uint8_t>(std::clamp(std::trunc((v / 8.f + 0.5f) * 256.f), 0.f, 255.f)));
        }
    return out;
}

void save_compressed_ply(const std::filesystem::path& path, const Splats& splats) {
    write_file(path, compressed_ply_bytes(splats));
}

namespace {

// The columns of a chunk's bounds for one attribute.
struct BoundColumns {
    std::array<int, 3> low{-1, -1, -1}, high{-1, -1, -1};
    // Files without bounds of a kind that is not required have none of its six columns.
    BoundColumns(const Ply& ply, const PlyElement& chunk, const std::string& kind, const char* axes, bool required) {
        if (!required && Ply::find(chunk, "min_" + kind + axes[0]) < 0) return;
        for (std::size_t a = 0; a < 3; ++a) {
            const std::string low_name = "min_" + kind + axes[a], high_name = "max_" + kind + axes[a];
            low[a] = ply.property(chunk, low_name);
            high[a] = ply.property(chunk, high_name);
        }
    }
    // Interpolates between the bounds in row `row`; files without bounds of this kind use 0..1.
    Vec3f between(const Ply& ply, const PlyElement& chunk, std::size_t row, Vec3f share) const {
        if (low[0] < 0) return share;
        Vec3f v;
        for (std::size_t a = 0; a < 3; ++a) {
            const float from = ply.number(chunk, row, low[a]), to = ply.number(chunk, row, high[a]);
            v[a] = from + share[a] * (to - from);
        }
        return v;
    }
};

Vec3f unpack_11_10_11(std::uint32_t v) { return {from_unorm(v, 21, 11), from_unorm(v, 11, 10), from_unorm(v, 0, 11)}; }

Quatf rotation_of_bits(std::uint32_t v) {
    std::array<float, 4> c{};
    const std::size_t largest = v >> 30;
    float rest = 1;
    int at = 20;
    for (std::size_t i = 0; i < 4; ++i) {
        if (i == largest) continue;
        c[i] = (from_unorm(v, at, 10) - 0.5f) * std::sqrt(2.f);
        rest -= c[i] * c[i];
        at -= 10;
    }
    c[largest] = std::sqrt(std::max(0.f, rest));
    return {c[0], c[1], c[2], c[3]};
}

// Bytes are the midpoints of 256 equal steps between -4 and 4, except the first and last, which are the ends.
float sh_of_byte(double byte) {
    return static_cast<float>(((byte <= 0 ? 0 : byte >= 255 ? 1 : (byte + 0.5) / 256) - 0.5) * 8);
}

}  // namespace

bool has_compressed_ply_header(std::string_view bytes) {
    const std::string_view header = bytes.substr(0, bytes.find("end_header"));
    return header.starts_with("ply") && header.find("element chunk ") != std::string_view::npos &&
           header.find(" packed_position") != std::string_view::npos;
}

bool is_compressed_ply(const Ply& ply) {
    return ply.has("chunk") && ply.has("vertex") && Ply::find(ply.element("vertex"), "packed_position") >= 0;
}

Splats splats_of_compressed_ply(const Ply& ply) {
    const PlyElement &chunk = ply.element("chunk"), &vertex = ply.element("vertex");
    if (chunk.count != vertex.count / kChunk + (vertex.count % kChunk != 0))
        throw Error("{}: expected {} chunks for {} splats, found {}", ply.path().string(),
                    (vertex.count + kChunk - 1) / kChunk, vertex.count, chunk.count);
    const BoundColumns mean(ply, chunk, "", "xyz", true), scale(ply, chunk, "scale_", "xyz", true),
        color(ply, chunk, "", "rgb", false);
    const int position = ply.property(vertex, "packed_position"), rotation = ply.property(vertex, "packed_rotation");
    const int packed_scale = ply.property(vertex, "packed_scale"), packed_color = ply.property(vertex, "packed_color");
    Splats splats;
    splats.filter = footprint_filter(ply);
    const PlyElement* sh = ply.has("sh") ? &ply.element("sh") : nullptr;
    const std::vector<int> rest = sh ? sh_columns(ply, *sh, splats.sh_degree) : std::vector<int>{};
    if (sh && sh->count != vertex.count)
        throw Error("{}: expected {} rows of \"sh\", found {}", ply.path().string(), vertex.count, sh->count);
    splats.resize(vertex.count);
    for (std::size_t i = 0; i < vertex.count; ++i) {
        const auto packed = [&](int property) { return static_cast<std::uint32_t>(ply.value(vertex, i, property)); };
        const std::uint32_t c = packed(packed_color);
        splats.mean_m[i] = mean.between(ply, chunk, i / kChunk, unpack_11_10_11(packed(position)));
        splats.log_scale[i] = scale.between(ply, chunk, i / kChunk, unpack_11_10_11(packed(packed_scale)));
        splats.rotation[i] = rotation_of_bits(packed(rotation));
        splats.sh0[i] = (color.between(ply, chunk, i / kChunk,
                                       {from_unorm(c, 24, 8), from_unorm(c, 16, 8), from_unorm(c, 8, 8)}) -
                         Vec3f{0.5f, 0.5f, 0.5f}) /
                        kSh0;
        splats.opacity_logit[i] = logit_of(from_unorm(c, 0, 8));
        for (std::size_t k = 0; k < rest.size(); ++k)
            splats.sh_rest[i * rest.size() + k] = sh_of_byte(ply.value(*sh, i, rest[k]));
    }
    return splats;
}

namespace splat_formats {

SplatFormat compressed_ply() {
    return {.name = "compressed_ply",
            .ending = ".compressed.ply",
            .about = "PlayCanvas' compressed PLY: chunks of 256, 16 bytes per splat",
            .readers = "SuperSplat, our viewer",
            .keeps_order = false,
            .precision = {.mean_m = 0.004f,
                          .log_scale = 0.004f,
                          .rotation = 0.006f,
                          .opacity_logit = 0.05f,
                          .sh0 = 0.01f,
                          .sh_rest = 0.02f},
            .recognizes = has_compressed_ply_header,
            .read = [](const std::filesystem::path& file, std::string_view bytes) -> ReadSplats {
                return splats_of_compressed_ply(Ply(file, std::string(bytes)));
            },
            .write = [](const Splats& splats, const SplatWriting&) { return compressed_ply_bytes(splats); }};
}

}  // namespace splat_formats
}  // namespace fastscene
