#include <array>
#include <cmath>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/io/ply.h"
#include "fastscene/io/splat_io.h"

namespace fastscene {
namespace {

// Degree 3: 15 coefficients a channel. Always written in full: several readers refuse anything else.
constexpr int kRest = 15;

}  // namespace

void save_splat_ply(const std::filesystem::path& path, const Splats& splats) {
    std::string out = fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", splats.size());
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2"}) out += fmt::format("property float {}\n", name);
    for (int i = 0; i < 3 * kRest; ++i) out += fmt::format("property float f_rest_{}\n", i);
    for (const char* name : {"opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"}) out += fmt::format("property float {}\n", name);
    out += "end_header\n";
    out.reserve(out.size() + splats.size() * 62 * 4);

    const int have = splats.rest_coefficients();
    for (std::size_t i = 0; i < splats.size(); ++i) {
        std::array<float, 62> row{};
        std::size_t at = 0;
        const auto put = [&](float v) { row[at++] = v; };
        const auto put3 = [&](Vec3f v) { put(v.x), put(v.y), put(v.z); };
        put3(splats.mean_m[i]);
        put3({});
        put3(splats.sh0[i]);
        for (int c = 0; c < 3; ++c)
            for (int k = 0; k < kRest; ++k) put(k < have ? splats.sh_rest[i * 3 * static_cast<std::size_t>(have) + static_cast<std::size_t>(c * have + k)] : 0.f);
        put(splats.opacity_logit[i]);
        put3(splats.log_scale[i]);
        const Quatf q = splats.rotation[i];
        put(q.w), put(q.x), put(q.y), put(q.z);
        out.append(reinterpret_cast<const char*>(row.data()), sizeof row);
    }
    write_file(path, out);
}

Splats load_splat_ply(const std::filesystem::path& path) {
    const Ply ply(path);
    const PlyElement& v = ply.element("vertex");
    int rest = 0;
    while (Ply::find(v, fmt::format("f_rest_{}", rest)) >= 0) ++rest;
    Splats splats;
    while (3 * splats.rest_coefficients() < rest && splats.sh_degree < 3) ++splats.sh_degree;
    if (3 * splats.rest_coefficients() != rest)
        throw Error("{}: expected 0, 9, 24 or 45 properties f_rest_*, found {}", path.string(), rest);

    const auto three = [&](std::array<const char*, 3> names) {
        return std::array<int, 3>{ply.property(v, names[0]), ply.property(v, names[1]), ply.property(v, names[2])};
    };
    const auto mean = three({"x", "y", "z"}), dc = three({"f_dc_0", "f_dc_1", "f_dc_2"}), scale = three({"scale_0", "scale_1", "scale_2"});
    const auto rot = three({"rot_1", "rot_2", "rot_3"});
    const int w = ply.property(v, "rot_0"), opacity = ply.property(v, "opacity");
    std::vector<int> rest_at;
    for (int k = 0; k < rest; ++k) rest_at.push_back(ply.property(v, fmt::format("f_rest_{}", k)));
    splats.resize(v.count);
    for (std::size_t i = 0; i < v.count; ++i) {
        const auto vec = [&](const std::array<int, 3>& p) { return Vec3f{ply.number(v, i, p[0]), ply.number(v, i, p[1]), ply.number(v, i, p[2])}; };
        splats.mean_m[i] = vec(mean);
        splats.sh0[i] = vec(dc);
        splats.log_scale[i] = vec(scale);
        splats.opacity_logit[i] = ply.number(v, i, opacity);
        const Vec3f xyz = vec(rot);
        splats.rotation[i] = {ply.number(v, i, w), xyz.x, xyz.y, xyz.z};
        for (int k = 0; k < rest; ++k)
            splats.sh_rest[i * static_cast<std::size_t>(rest) + static_cast<std::size_t>(k)] = ply.number(v, i, rest_at[static_cast<std::size_t>(k)]);
    }
    // A file of degree 3 whose higher bands are all zero is degree 0: that is how we write generated rooms.
    if (splats.sh_degree > 0) {
        bool any = false;
        for (const float f : splats.sh_rest) any = any || f != 0.f;
        if (!any) splats.sh_degree = 0, splats.sh_rest.clear();
    }
    return splats;
}

}  // namespace fastscene
