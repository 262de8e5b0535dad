#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "fastscene/base/check.h"
#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/bytes.h"
#include "fastscene/io/ply.h"
#include "fastscene/io/splat_format.h"
#include "fastscene/io/splat_io.h"

namespace fastscene {
namespace {

constexpr const char* kPlyInstance = "instance";
constexpr std::string_view kLowPassComment = "fastscene low-pass ";  // then square pixels

}  // namespace

std::string ply_comments(const Splats& splats) {
    std::string out = splats.filter.antialias ? "comment SplatRenderMode: mip\n" : "";
    if (splats.filter.low_pass_px2 != FootprintFilter{}.low_pass_px2)
        out += fmt::format("comment {}{}\n", kLowPassComment, splats.filter.low_pass_px2);
    return out;
}

FootprintFilter footprint_filter(const Ply& ply) {
    FootprintFilter filter;
    for (const std::string& c : ply.comments()) {
        if (c == "SplatRenderMode: mip" || (c.starts_with("antialiased ") && c != "antialiased 0"))
            filter.antialias = true;
        std::istringstream number(c.starts_with(kLowPassComment) ? c.substr(kLowPassComment.size()) : "");
        if (float low_pass = 0; number >> low_pass) filter.low_pass_px2 = low_pass_px2_from(low_pass);
    }
    return filter;
}

namespace {

// `absolute`: positions in double, the offset added. Otherwise positions as they are; a comment tells the offset.
std::string ply_bytes(const Splats& splats, PlyBands bands, Vec3d offset, bool absolute, const SplatLabels& labels) {
    const bool labelled = !labels.values.empty();
    FASTSCENE_CHECK(!labelled || labels.values.size() == splats.size());
    const int have = splats.rest_coefficients(), written = bands == PlyBands::all ? 15 : have;
    std::string out = fmt::format("ply\nformat binary_little_endian 1.0\n{}", ply_comments(splats));
    for (const std::string& comment : labels.comments) out += fmt::format("comment {}\n", comment);
    if (offset != Vec3d{} && !absolute)
        out += fmt::format("comment fastscene offset {} {} {}\n", offset.x, offset.y, offset.z);
    out += fmt::format("element vertex {}\n", splats.size());
    for (const char* name : {"x", "y", "z"})
        out += fmt::format("property {} {}\n", absolute ? "double" : "float", name);
    for (const char* name : {"nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2"})
        out += fmt::format("property float {}\n", name);
    for (int i = 0; i < 3 * written; ++i) out += fmt::format("property float f_rest_{}\n", i);
    for (const char* name : {"opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"})
        out += fmt::format("property float {}\n", name);
    if (labelled) out += fmt::format("property int {}\n", kPlyInstance);
    out += "end_header\n";
    const std::size_t floats = 14 + 3 * static_cast<std::size_t>(written);
    out.reserve(out.size() + splats.size() * ((floats + labelled) * 4 + 24));

    std::array<float, 62> row{};
    for (std::size_t i = 0; i < splats.size(); ++i) {
        std::size_t at = 0;
        const auto put = [&](float v) { row[at++] = v; };
        const auto put3 = [&](Vec3f v) { put(v.x), put(v.y), put(v.z); };
        for (std::size_t a = 0; a < 3; ++a)
            if (const float v = splats.mean_m[i][a]; absolute) append(out, static_cast<double>(v) + offset[a]);
            else append(out, v);
        put3({});
        put3(splats.sh0[i]);
        for (int c = 0; c < 3; ++c)
            for (int k = 0; k < written; ++k)
                put(k < have
                        ? splats
                              .sh_rest[i * 3 * static_cast<std::size_t>(have) + static_cast<std::size_t>(c * have + k)]
                        : 0.f);
        put(splats.opacity_logit[i]);
        put3(splats.log_scale[i]);
        const Quatf q = splats.rotation[i];
        put(q.w), put(q.x), put(q.y), put(q.z);
        out.append(reinterpret_cast<const char*>(row.data()), floats * 4);
        if (labelled) append(out, static_cast<std::int32_t>(labels.values[i]));
    }
    return out;
}

}  // namespace

LabelledSplats load_labelled_ply(const std::filesystem::path& path) {
    const Ply ply(path);
    if (is_compressed_ply(ply) || !ply.has("vertex") || Ply::find(ply.element("vertex"), kPlyInstance) < 0) return {};
    const PlyElement& v = ply.element("vertex");
    LabelledSplats out{splats_of_ply(ply).splats, {{}, ply.comments()}};
    const int instance = Ply::find(v, kPlyInstance);
    for (std::size_t i = 0; i < v.count; ++i) {
        const double value = ply.value(v, i, instance);
        if (!(value >= 0 && value <= 0xffff))
            throw Error("{}: expected instances of 0 to 65535, found {} for splat {}", path.string(), value, i);
        out.labels.values.push_back(static_cast<std::uint16_t>(value));
    }
    return out;
}

std::string splat_ply_bytes(const Splats& splats, PlyBands bands, Vec3d offset_m, const SplatLabels& labels) {
    return ply_bytes(splats, bands, offset_m, offset_m != Vec3d{}, labels);
}

void save_splat_ply(const std::filesystem::path& path, const Splats& splats, PlyBands bands, Vec3d offset_m) {
    write_file(path, ply_bytes(splats, bands, offset_m, false, {}));
}

namespace {

// Colors in floats go up to 1, or up to 255.
double brightest_float(const Ply& ply, const PlyElement& v, const std::array<int, 3>& columns) {
    for (std::size_t i = 0; i < v.count; ++i)
        for (const int c : columns)
            if (ply.share(v, i, c) > 1) return 255;
    return 1;
}

// The offset of positions that lie far from the origin in double: whole kilometres near their middle.
Vec3d offset_in(const Ply& ply, const PlyElement& v, const std::array<int, 3>& mean) {
    Vec3d sum;
    double finite = 0;
    if (v.properties[static_cast<std::size_t>(mean[0])].bytes < 8) return {};
    for (std::size_t i = 0; i < v.count; ++i) {
        const Vec3d p{ply.value(v, i, mean[0]), ply.value(v, i, mean[1]), ply.value(v, i, mean[2])};
        if (std::isfinite(p.x + p.y + p.z)) sum = sum + p, finite += 1;
    }
    return finite > 0 ? offset_for(sum * (1 / finite)) : Vec3d{};
}

constexpr std::string_view kOffsetComment = "fastscene offset ";  // then x y z

Vec3d offset_of_comments(const Ply& ply) {
    for (const std::string& comment : ply.comments()) {
        std::istringstream numbers(comment.starts_with(kOffsetComment) ? comment.substr(kOffsetComment.size()) : "");
        if (Vec3d offset; numbers >> offset.x >> offset.y >> offset.z) return offset;
    }
    return {};
}

}  // namespace

ReadSplats splats_of_ply(const Ply& ply) {
    const PlyElement& v = ply.element("vertex");
    const bool as_rgb = Ply::find(v, "f_dc_0") < 0 && Ply::find(v, "red") >= 0;  // nerfstudio's --ply-color-mode rgb
    if (as_rgb && Ply::find(v, "scale_0") < 0)
        throw Error("{}: expected Gaussians (f_dc_*, scale_*, rot_*, opacity), found a cloud of colored points",
                    ply.path().string());
    const auto three = [&](std::array<const char*, 3> names) {
        return std::array<int, 3>{ply.property(v, names[0]), ply.property(v, names[1]), ply.property(v, names[2])};
    };
    const auto mean = three({"x", "y", "z"}), rot = three({"rot_1", "rot_2", "rot_3"}),
               dc = as_rgb ? three({"red", "green", "blue"}) : three({"f_dc_0", "f_dc_1", "f_dc_2"});
    const double brightest = as_rgb ? brightest_float(ply, v, dc) : 1;
    const int w = ply.property(v, "rot_0"), opacity = ply.property(v, "opacity");
    // 2D Gaussian files (2DGS) have two scales: such a disc gets a hundredth of its smaller radius as thickness.
    const std::array<int, 3> scale{ply.property(v, "scale_0"), ply.property(v, "scale_1"), Ply::find(v, "scale_2")};
    const Vec3d offset = offset_in(ply, v, mean);
    Splats splats;
    splats.filter = footprint_filter(ply);
    const std::vector<int> rest = sh_columns(ply, v, splats.sh_degree);
    splats.resize(v.count);
    for (std::size_t i = 0; i < v.count; ++i) {
        const auto vec = [&](const std::array<int, 3>& p) {
            return Vec3f{ply.number(v, i, p[0]), ply.number(v, i, p[1]), ply.number(v, i, p[2])};
        };
        for (std::size_t a = 0; a < 3; ++a)
            splats.mean_m[i][a] = static_cast<float>(ply.value(v, i, mean[a]) - offset[a]);
        if (!as_rgb) splats.sh0[i] = vec(dc);
        for (std::size_t c = 0; c < 3 && as_rgb; ++c)
            splats.sh0[i][c] = static_cast<float>((ply.share(v, i, dc[c]) / brightest - 0.5) / kSh0);
        Vec3f& s = splats.log_scale[i];
        s = {ply.number(v, i, scale[0]), ply.number(v, i, scale[1]), 0};
        s.z = scale[2] >= 0 ? ply.number(v, i, scale[2]) : std::min(s.x, s.y) - 4.6f;
        splats.opacity_logit[i] = ply.number(v, i, opacity);
        const Vec3f xyz = vec(rot);
        splats.rotation[i] = {ply.number(v, i, w), xyz.x, xyz.y, xyz.z};
        for (std::size_t k = 0; k < rest.size(); ++k) splats.sh_rest[i * rest.size() + k] = ply.number(v, i, rest[k]);
    }
    ReadSplats read(std::move(splats));
    read.offset_m = offset + offset_of_comments(ply);
    return read;
}

namespace splat_formats {

SplatFormat ply() {
    return {.name = "ply",
            .ending = ".ply",
            .about = "INRIA's PLY; 62 floats per splat (`--compact`: only the existing SH degrees)",
            .readers = "everything",
            .offset = true,
            .recognizes =
                [](std::string_view bytes) { return bytes.starts_with("ply") && !has_compressed_ply_header(bytes); },
            .read = [](const std::filesystem::path& file,
                       std::string_view bytes) { return splats_of_ply(Ply(file, std::string(bytes))); },
            .write =
                [](const Splats& splats, const SplatWriting& writing) {
                    return splat_ply_bytes(splats, writing.ply_bands, writing.offset_m);
                }};
}

}  // namespace splat_formats
}  // namespace fastscene
