#include "fastscene/trace/texture.h"

#include "fastscene/trace/kernel/texture.h"

namespace fastscene {
namespace {

// A footprint larger than anything in a room.
constexpr float kFarAway = 1e6f;

}  // namespace

float mean_metal(const Material& material) {
    if (!material.metallic_roughness) return material.metal;
    return sample_texture(material, {{}, {}, kFarAway}).metal;
}

Vec3f mean_albedo(const Material& material) {
    if (material.pattern == Pattern::image)
        return sample_texture(material, {{}, {}, kFarAway}).albedo;  // the coarsest mip level
    // A footprint of 1 cm already averages fine grain; points spread over four units, incommensurate with any joints,
    // cover the rest.
    Vec3f sum{};
    constexpr int kPlaces = 1024;
    const float span = 4.f * std::max(material.scale_m, 0.15f);  // leather is worn in patches of 20 cm
    // patterns that do not repeat
    const bool whole = material.pattern == Pattern::art || material.pattern == Pattern::book;
    for (std::uint32_t i = 0; i < kPlaces; ++i) {
        const float u = static_cast<float>((i * 3242174889u) >> 8) * 0x1p-24f,
                    v = static_cast<float>((i * 2447445414u) >> 8) * 0x1p-24f;  // Roberts' R2
        TexturePoint p;
        p.plane = whole ? Vec2f{u * material.scale_m, v * material.scale_m}
                  : material.pattern == Pattern::rug
                      ? Vec2f{(2 * u - 1) * material.scale_m, (2 * v - 1) * material.scale_m}
                      : Vec2f{(u - 0.5f) * span, (v - 0.5f) * span};
        p.coords = {p.plane.x, p.plane.y, 0.3f * (u + v) * span};
        if (material.pattern == Pattern::rug)
            p.coords = {p.plane.x, material.scale_m, p.plane.y};  // coords.y is half the depth
        p.footprint_m = 0.01f;
        sum += sample_texture(material, p).albedo;
    }
    return sum / static_cast<float>(kPlaces);
}

}  // namespace fastscene
