// Material in GLSL: as kernel/material_data.h uploads it, with the names of scene/room.h.
#ifndef FASTSCENE_TRACE_KERNEL_MATERIAL_GLSL
#define FASTSCENE_TRACE_KERNEL_MATERIAL_GLSL
#extension GL_EXT_buffer_reference : require

// In the order of scene/room.h's Pattern.
const uint Pattern_plain = 0, Pattern_plaster = 1, Pattern_wood = 2, Pattern_planks = 3, Pattern_herringbone = 4,
           Pattern_parquet = 5, Pattern_tile = 6, Pattern_checker = 7, Pattern_subway = 8, Pattern_brick = 9,
           Pattern_concrete = 10, Pattern_marble = 11, Pattern_terrazzo = 12, Pattern_fabric = 13, Pattern_knit = 14,
           Pattern_carpet = 15, Pattern_leather = 16, Pattern_rug = 17, Pattern_stripes = 18, Pattern_damask = 19,
           Pattern_floral = 20, Pattern_wicker = 21, Pattern_metal = 22, Pattern_art = 23, Pattern_book = 24,
           Pattern_leaf = 25, Pattern_grass = 26, Pattern_bark = 27, Pattern_screen = 28, Pattern_dots = 29,
           Pattern_zigzag = 30, Pattern_twill = 31, Pattern_geometric = 32, Pattern_diamonds = 33,
           Pattern_lattice = 34, Pattern_stars = 35, Pattern_gingham = 36, Pattern_plaid = 37,
           Pattern_houndstooth = 38, Pattern_patchwork = 39, Pattern_leopard = 40, Pattern_zebra = 41,
           Pattern_camouflage = 42, Pattern_paisley = 43, Pattern_encaustic = 44, Pattern_laid_tiles = 45,
           Pattern_peeling = 46, Pattern_image = 47;
const int kArtDesigns = 8;

// A bit a pattern: drivers leave out those that a room does not have, which are most, and are done sooner.
layout(constant_id = 0) const uint kPatternsInUse = 0xffffffffu;
layout(constant_id = 1) const uint kMorePatternsInUse = 0xffffffffu;
bool is_in_use(uint pattern) {
    return ((pattern < 32 ? kPatternsInUse >> pattern : kMorePatternsInUse >> (pattern - 32)) & 1) != 0;
}

// A picture and its mip levels: their number, three words a level (where its texels begin, width, height), and the
// texels, red in the lowest byte.
layout(buffer_reference, std430, buffer_reference_align = 4) readonly buffer TextureWords { uint at[]; };

struct Material {
    vec3 color_a;
    float scale_m;
    vec3 color_b;
    float bump_m;
    vec3 color_c;
    float crease_m;
    vec3 emission;
    float sheen;
    float roughness, specular, metal, transmission;
    float mirror;
    uint pattern, seed, variant;
    TextureWords image;  // of Pattern_image, and of a Pattern_screen with kShowsPicture
    uint burns;
    uint maps;                                // kHasNormals, kHasMetallicRoughness, kShowsPicture: which there are
    TextureWords normals, metallic_roughness;
};
const uint kHasNormals = 1, kHasMetallicRoughness = 2, kShowsPicture = 4;
layout(buffer_reference, std430, buffer_reference_align = 16) readonly buffer Materials { Material at[]; };

#endif
