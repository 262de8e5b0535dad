#include "fastscene/trace/kernel/material_data.h"

namespace fastscene::kernel {
namespace {

void append(TextureWords& out, const TextureImage* picture) {
    if (!picture || !out.first.emplace(picture, out.words.size()).second) return;
    const std::vector<ImageRgb8>& levels = picture->levels;
    auto texel = static_cast<std::uint32_t>(1 + 3 * levels.size());
    out.words.push_back(static_cast<std::uint32_t>(levels.size()));
    for (const ImageRgb8& level : levels) {
        out.words.insert(out.words.end(),
                         {texel, static_cast<std::uint32_t>(level.width), static_cast<std::uint32_t>(level.height)});
        texel += static_cast<std::uint32_t>(level.pixels.size());
    }
    for (const ImageRgb8& level : levels)
        for (const Rgb8 c : level.pixels)
            out.words.push_back(c.r | static_cast<std::uint32_t>(c.g) << 8 | static_cast<std::uint32_t>(c.b) << 16);
}

}  // namespace

TextureWords texture_words(std::span<const Material> materials) {
    TextureWords out;
    for (const Material& m : materials) {
        if (m.pattern == Pattern::screen) append(out, m.image.get());
        if (m.pattern == Pattern::image)
            for (const TextureImage* picture : {m.image.get(), m.normals.get(), m.metallic_roughness.get()})
                append(out, picture);
    }
    return out;
}

MaterialData material_data(const Material& m, const TextureWords& textures, std::uint64_t address) {
    const bool is_image = m.pattern == Pattern::image;
    const auto address_of = [&](const std::shared_ptr<const TextureImage>& picture, bool used) -> std::uint64_t {
        return used && picture ? address + sizeof(std::uint32_t) * textures.first.at(picture.get()) : 0;
    };
    MaterialData out{};
    out.color_a = m.color_a, out.color_b = m.color_b, out.color_c = m.color_c, out.emission = m.emission;
    out.scale_m = m.scale_m, out.bump_m = m.bump_m, out.crease_m = m.crease_m, out.sheen = m.sheen;
    out.roughness = m.roughness, out.specular = m.specular, out.metal = m.metal, out.transmission = m.transmission;
    out.mirror = m.mirror, out.burns = m.burns;
    out.pattern = static_cast<std::uint32_t>(m.pattern), out.seed = m.seed, out.variant = m.variant;
    out.image = address_of(m.image, is_image || m.pattern == Pattern::screen);
    out.normals = address_of(m.normals, is_image), out.metallic_roughness = address_of(m.metallic_roughness, is_image);
    out.maps = (out.normals ? kHasNormals : 0) | (out.metallic_roughness ? kHasMetallicRoughness : 0) |
               (m.pattern == Pattern::screen && out.image ? kShowsPicture : 0);
    return out;
}

}  // namespace fastscene::kernel
