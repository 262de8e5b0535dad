// The pattern functions behind texture.h, one each. They take the material and the point, and return linear albedo,
// roughness and relief; callers clamp.
#pragma once

#include "fastscene/trace/noise.h"
#include "fastscene/trace/texture.h"

namespace fastscene::patterns {

// Wood and wooden floors (patterns_wood.cc).
TextureValue wood(const Material& m, const TexturePoint& p);
TextureValue planks(const Material& m, const TexturePoint& p);
TextureValue herringbone(const Material& m, const TexturePoint& p);
TextureValue parquet(const Material& m, const TexturePoint& p);
TextureValue bark(const Material& m, const TexturePoint& p);

// Stone, plaster and ceramics (patterns_stone.cc).
TextureValue plaster(const Material& m, const TexturePoint& p);
TextureValue tile(const Material& m, const TexturePoint& p);
TextureValue checker(const Material& m, const TexturePoint& p);
TextureValue subway(const Material& m, const TexturePoint& p);
TextureValue brick(const Material& m, const TexturePoint& p);
TextureValue concrete(const Material& m, const TexturePoint& p);
TextureValue marble(const Material& m, const TexturePoint& p);
TextureValue terrazzo(const Material& m, const TexturePoint& p);

// Cloth (patterns_cloth.cc).
TextureValue fabric(const Material& m, const TexturePoint& p);
TextureValue knit(const Material& m, const TexturePoint& p);
TextureValue carpet(const Material& m, const TexturePoint& p);
TextureValue leather(const Material& m, const TexturePoint& p);
TextureValue wicker(const Material& m, const TexturePoint& p);

// Drawn ornaments (patterns_ornament.cc).
TextureValue rug(const Material& m, const TexturePoint& p);
TextureValue stripes(const Material& m, const TexturePoint& p);
TextureValue damask(const Material& m, const TexturePoint& p);
TextureValue floral(const Material& m, const TexturePoint& p);

// Prints, weaves and tiles that repeat one motif (patterns_prints.cc).
TextureValue dots(const Material& m, const TexturePoint& p);
TextureValue zigzag(const Material& m, const TexturePoint& p);
TextureValue twill(const Material& m, const TexturePoint& p);
TextureValue geometric(const Material& m, const TexturePoint& p);
TextureValue diamonds(const Material& m, const TexturePoint& p);
TextureValue lattice(const Material& m, const TexturePoint& p);
TextureValue stars(const Material& m, const TexturePoint& p);
TextureValue gingham(const Material& m, const TexturePoint& p);
TextureValue plaid(const Material& m, const TexturePoint& p);
TextureValue houndstooth(const Material& m, const TexturePoint& p);
TextureValue patchwork(const Material& m, const TexturePoint& p);
TextureValue leopard(const Material& m, const TexturePoint& p);
TextureValue zebra(const Material& m, const TexturePoint& p);
TextureValue camouflage(const Material& m, const TexturePoint& p);
TextureValue paisley(const Material& m, const TexturePoint& p);
TextureValue encaustic(const Material& m, const TexturePoint& p);
TextureValue laid_tiles(const Material& m, const TexturePoint& p);
TextureValue peeling(const Material& m, const TexturePoint& p);

// A picture (patterns_image.cc).
TextureValue image(const Material& m, const TexturePoint& p);

// Other materials (patterns_things.cc).
TextureValue metal(const Material& m, const TexturePoint& p);
TextureValue art(const Material& m, const TexturePoint& p);
TextureValue book(const Material& m, const TexturePoint& p);
TextureValue leaf(const Material& m, const TexturePoint& p);
TextureValue grass(const Material& m, const TexturePoint& p);
TextureValue screen(const Material& m, const TexturePoint& p);

// Creases of soft things, about a decimetre long: 0 in the valleys, 1 between them (patterns_cloth.cc).
float crease(Vec3f coords, float footprint, std::uint32_t seed);

// Shared helpers.
inline float positive(float scale_m) { return scale_m > 1e-3f ? scale_m : 1e-3f; }
inline float fraction(float v) { return v - static_cast<float>(floor_int(v)); }

}  // namespace fastscene::patterns
