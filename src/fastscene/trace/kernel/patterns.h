// The pattern functions behind texture.h, one each. They take the material and the point, and return linear albedo,
// roughness and relief; callers clamp. C++ compiles each file once, in patterns_*.cc; GLSL has all in one.
#ifndef FASTSCENE_TRACE_KERNEL_PATTERNS_H
#define FASTSCENE_TRACE_KERNEL_PATTERNS_H

#include "fastscene/trace/kernel/material.h"

#ifndef __cplusplus
#include "fastscene/trace/kernel/wood.h"
#include "fastscene/trace/kernel/stone.h"
#include "fastscene/trace/kernel/cloth.h"
#include "fastscene/trace/kernel/ornament.h"
#include "fastscene/trace/kernel/prints.h"
#include "fastscene/trace/kernel/picture.h"
#include "fastscene/trace/kernel/things.h"
#endif

KERNEL_BEGIN

// Wood and wooden floors (wood.h).
TextureValue wood(IN(Material) m, IN(TexturePoint) p);
TextureValue planks(IN(Material) m, IN(TexturePoint) p);
TextureValue herringbone(IN(Material) m, IN(TexturePoint) p);
TextureValue parquet(IN(Material) m, IN(TexturePoint) p);
TextureValue bark(IN(Material) m, IN(TexturePoint) p);

// Stone, plaster and ceramics (stone.h).
TextureValue plaster(IN(Material) m, IN(TexturePoint) p);
TextureValue tile(IN(Material) m, IN(TexturePoint) p);
TextureValue checker(IN(Material) m, IN(TexturePoint) p);
TextureValue subway(IN(Material) m, IN(TexturePoint) p);
TextureValue brick(IN(Material) m, IN(TexturePoint) p);
TextureValue concrete(IN(Material) m, IN(TexturePoint) p);
TextureValue marble(IN(Material) m, IN(TexturePoint) p);
TextureValue terrazzo(IN(Material) m, IN(TexturePoint) p);

// Cloth (cloth.h).
TextureValue fabric(IN(Material) m, IN(TexturePoint) p);
TextureValue knit(IN(Material) m, IN(TexturePoint) p);
TextureValue carpet(IN(Material) m, IN(TexturePoint) p);
TextureValue leather(IN(Material) m, IN(TexturePoint) p);
TextureValue wicker(IN(Material) m, IN(TexturePoint) p);

// Drawn ornaments (ornament.h).
TextureValue rug(IN(Material) m, IN(TexturePoint) p);
TextureValue stripes(IN(Material) m, IN(TexturePoint) p);
TextureValue damask(IN(Material) m, IN(TexturePoint) p);
TextureValue floral(IN(Material) m, IN(TexturePoint) p);

// Prints, weaves and tiles that repeat one motif (prints.h).
TextureValue dots(IN(Material) m, IN(TexturePoint) p);
TextureValue zigzag(IN(Material) m, IN(TexturePoint) p);
TextureValue twill(IN(Material) m, IN(TexturePoint) p);
TextureValue geometric(IN(Material) m, IN(TexturePoint) p);
TextureValue diamonds(IN(Material) m, IN(TexturePoint) p);
TextureValue lattice(IN(Material) m, IN(TexturePoint) p);
TextureValue stars(IN(Material) m, IN(TexturePoint) p);
TextureValue gingham(IN(Material) m, IN(TexturePoint) p);
TextureValue plaid(IN(Material) m, IN(TexturePoint) p);
TextureValue houndstooth(IN(Material) m, IN(TexturePoint) p);
TextureValue patchwork(IN(Material) m, IN(TexturePoint) p);
TextureValue leopard(IN(Material) m, IN(TexturePoint) p);
TextureValue zebra(IN(Material) m, IN(TexturePoint) p);
TextureValue camouflage(IN(Material) m, IN(TexturePoint) p);
TextureValue paisley(IN(Material) m, IN(TexturePoint) p);
TextureValue encaustic(IN(Material) m, IN(TexturePoint) p);
TextureValue laid_tiles(IN(Material) m, IN(TexturePoint) p);
TextureValue peeling(IN(Material) m, IN(TexturePoint) p);

// A picture (picture.h).
TextureValue image(IN(Material) m, IN(TexturePoint) p);
Vec2f normal_map_slope(IN(Material) m, IN(TexturePoint) p);

// Other materials (things.h).
TextureValue metal(IN(Material) m, IN(TexturePoint) p);
TextureValue art(IN(Material) m, IN(TexturePoint) p);
TextureValue book(IN(Material) m, IN(TexturePoint) p);
TextureValue leaf(IN(Material) m, IN(TexturePoint) p);
TextureValue grass(IN(Material) m, IN(TexturePoint) p);
TextureValue screen(IN(Material) m, IN(TexturePoint) p);

// Creases of soft things, about a decimetre long: 0 in the valleys, 1 between them (cloth.h).
float crease(Vec3f coords, float footprint, uint seed);

KERNEL_END

#endif
