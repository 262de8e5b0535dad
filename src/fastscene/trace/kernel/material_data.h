// Materials as kernels on graphics cards read them: the host's side of material.glsl.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "fastscene/scene/room.h"

namespace fastscene::kernel {

struct MaterialData {
    Vec3f color_a;
    float scale_m;
    Vec3f color_b;
    float bump_m;
    Vec3f color_c;
    float crease_m;
    Vec3f emission;
    float sheen;
    float roughness, specular, metal, transmission;
    float mirror;
    std::uint32_t pattern, seed, variant;
    std::uint64_t image;  // address of its TextureWords; 0: none
    std::uint32_t burns, maps;
    std::uint64_t normals, metallic_roughness;  // as image; `maps` says which there are
};
inline constexpr std::uint32_t kHasNormals = 1, kHasMetallicRoughness = 2, kShowsPicture = 4;
static_assert(sizeof(MaterialData) == 128);
static_assert(offsetof(MaterialData, scale_m) == 12 && offsetof(MaterialData, color_b) == 16 &&
              offsetof(MaterialData, color_c) == 32 && offsetof(MaterialData, emission) == 48 &&
              offsetof(MaterialData, roughness) == 64 && offsetof(MaterialData, mirror) == 80 &&
              offsetof(MaterialData, image) == 96 && offsetof(MaterialData, burns) == 104 &&
              offsetof(MaterialData, normals) == 112);

// The pictures of all materials as TextureWords, one after the other; each picture once.
struct TextureWords {
    std::vector<std::uint32_t> words;
    std::map<const TextureImage*, std::size_t> first;  // word at which a picture begins
};
TextureWords texture_words(std::span<const Material> materials);

// `address`: where the card has `textures.words`.
MaterialData material_data(const Material& material, const TextureWords& textures, std::uint64_t address);

}  // namespace fastscene::kernel
