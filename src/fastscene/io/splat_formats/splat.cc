// The .splat of the first viewers in a browser: 32 bytes a splat and no header. Little endian:
//   float position[3], float scale[3] (linear), uint8 rgba[4], uint8 rotation[4] (w x y z, 128 q + 128)
#include <cmath>

#include "fastscene/base/bytes.h"
#include "fastscene/io/packed.h"
#include "fastscene/io/splat_format.h"

namespace fastscene::splat_formats {
namespace {

constexpr std::size_t kRow = 32;
constexpr float kTurn = 128.f;  // a component of 0 is stored as this, and 1 is this much more

ReadSplats read_splat(const std::filesystem::path& file, std::string_view bytes) {
    ByteReader in(file, bytes);
    if (bytes.size() % kRow != 0)
        throw Error("{}: expected {} bytes a splat, found {} bytes, {} too many", file.string(), kRow, bytes.size(),
                    bytes.size() % kRow);
    const auto three = [&] {
        const float x = in.get<float>(), y = in.get<float>(), z = in.get<float>();
        return Vec3f{x, y, z};
    };
    const auto share = [&] { return static_cast<float>(in.get<std::uint8_t>()) / 255.f; };
    const auto turn = [&] { return (static_cast<float>(in.get<std::uint8_t>()) - kTurn) / kTurn; };
    Splats splats;
    splats.resize(bytes.size() / kRow);
    for (std::size_t i = 0; i < splats.size(); ++i) {
        splats.mean_m[i] = three();
        const Vec3f scale = three();
        splats.log_scale[i] = {std::log(scale.x), std::log(scale.y), std::log(scale.z)};
        for (std::size_t c = 0; c < 3; ++c) splats.sh0[i][c] = (share() - 0.5f) / kSh0;
        splats.opacity_logit[i] = logit_of(share());
        const float w = turn(), x = turn(), y = turn(), z = turn();
        splats.rotation[i] = {w, x, y, z};
    }
    return splats;
}

std::string write_splat(const Splats& splats, const SplatWriting&) {
    std::string out;
    out.reserve(splats.size() * kRow);
    for (std::size_t i = 0; i < splats.size(); ++i) {
        for (std::size_t a = 0; a < 3; ++a) append(out, splats.mean_m[i][a]);
        for (std::size_t a = 0; a < 3; ++a) append(out, std::exp(splats.log_scale[i][a]));
        for (std::size_t c = 0; c < 3; ++c) append(out, byte_near((splats.sh0[i][c] * kSh0 + 0.5f) * 255.f));
        append(out, byte_near(sigmoid(splats.opacity_logit[i]) * 255.f));
        for (const float q : unit_quaternion(splats.rotation[i])) append(out, byte_near(q * kTurn + kTurn));
    }
    return out;
}

}  // namespace

SplatFormat splat() {
    return {.name = "splat",
            .ending = ".splat",
            .about = "32 bytes per splat, the format of the first browser viewers",
            .readers = "antimatter15/splat, SuperSplat, gsplat.js",
            .sh_degree = 0,
            .antialias = false,
            .low_pass = false,
            .precision = {.rotation = 0.02f, .opacity_logit = 0.05f, .sh0 = 0.0071f},
            .read = read_splat,
            .write = write_splat};
}

}  // namespace fastscene::splat_formats
