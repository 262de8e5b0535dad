// Procedural materials: every Pattern of scene/room.h as a function of Mesh::coords. C++ calls these through
// trace/texture.h. Kernels in GLSL include this file, before any declaration of theirs, with glslc's -I src:
//
//   #include "fastscene/trace/kernel/texture.h"
//   layout(push_constant) uniform Push { Materials materials; … };   // MaterialData[] (material_data.h) in a buffer
//   Material m = materials.at[i];                     // not const, as it holds a reference
//   TexturePoint p;
//   p.coords = coords;                                // metres, interpolated from Mesh::coords
//   const int axis = dominant_axis(coords_normal);    // of the triangle's normal in texture space
//   p.plane = flat_coords(coords, axis);
//   p.footprint_m = …;                                // width of the sample on the surface
//   const SurfaceTexture t = texture_with_slope(m, p, axis, true);
//   t.value.albedo, t.value.roughness, t.slope.x, t.slope.y
//
// response.h, film.h and sampler.h beside this file are used in the same way.
//
// Drivers put the text of every called function in its caller's place, and the patterns are long: a kernel has one call
// of texture_with_slope, or of sample_texture, in all.
#ifndef FASTSCENE_TRACE_KERNEL_TEXTURE_H
#define FASTSCENE_TRACE_KERNEL_TEXTURE_H

#include "fastscene/trace/kernel/noise.h"
#include "fastscene/trace/kernel/patterns.h"

KERNEL_BEGIN

static TextureValue raw_texture(IN(Material) m, IN(TexturePoint) p) {
    switch (m.pattern) {
        case PATTERN(plain): return texture_value(m.color_a, m.roughness, 0.5f);
        case PATTERN(plaster): if (IN_USE(plaster)) return plaster(m, p); break;
        case PATTERN(wood): if (IN_USE(wood)) return wood(m, p); break;
        case PATTERN(planks): if (IN_USE(planks)) return planks(m, p); break;
        case PATTERN(herringbone): if (IN_USE(herringbone)) return herringbone(m, p); break;
        case PATTERN(parquet): if (IN_USE(parquet)) return parquet(m, p); break;
        case PATTERN(tile): if (IN_USE(tile)) return tile(m, p); break;
        case PATTERN(checker): if (IN_USE(checker)) return checker(m, p); break;
        case PATTERN(subway): if (IN_USE(subway)) return subway(m, p); break;
        case PATTERN(brick): if (IN_USE(brick)) return brick(m, p); break;
        case PATTERN(concrete): if (IN_USE(concrete)) return concrete(m, p); break;
        case PATTERN(marble): if (IN_USE(marble)) return marble(m, p); break;
        case PATTERN(terrazzo): if (IN_USE(terrazzo)) return terrazzo(m, p); break;
        case PATTERN(fabric): if (IN_USE(fabric)) return fabric(m, p); break;
        case PATTERN(knit): if (IN_USE(knit)) return knit(m, p); break;
        case PATTERN(carpet): if (IN_USE(carpet)) return carpet(m, p); break;
        case PATTERN(leather): if (IN_USE(leather)) return leather(m, p); break;
        case PATTERN(rug): if (IN_USE(rug)) return rug(m, p); break;
        case PATTERN(stripes): if (IN_USE(stripes)) return stripes(m, p); break;
        case PATTERN(damask): if (IN_USE(damask)) return damask(m, p); break;
        case PATTERN(floral): if (IN_USE(floral)) return floral(m, p); break;
        case PATTERN(wicker): if (IN_USE(wicker)) return wicker(m, p); break;
        case PATTERN(metal): if (IN_USE(metal)) return metal(m, p); break;
        case PATTERN(art): if (IN_USE(art)) return art(m, p); break;
        case PATTERN(book): if (IN_USE(book)) return book(m, p); break;
        case PATTERN(leaf): if (IN_USE(leaf)) return leaf(m, p); break;
        case PATTERN(grass): if (IN_USE(grass)) return grass(m, p); break;
        case PATTERN(bark): if (IN_USE(bark)) return bark(m, p); break;
        case PATTERN(screen): if (IN_USE(screen)) return screen(m, p); break;
        case PATTERN(dots): if (IN_USE(dots)) return dots(m, p); break;
        case PATTERN(zigzag): if (IN_USE(zigzag)) return zigzag(m, p); break;
        case PATTERN(twill): if (IN_USE(twill)) return twill(m, p); break;
        case PATTERN(geometric): if (IN_USE(geometric)) return geometric(m, p); break;
        case PATTERN(diamonds): if (IN_USE(diamonds)) return diamonds(m, p); break;
        case PATTERN(lattice): if (IN_USE(lattice)) return lattice(m, p); break;
        case PATTERN(stars): if (IN_USE(stars)) return stars(m, p); break;
        case PATTERN(gingham): if (IN_USE(gingham)) return gingham(m, p); break;
        case PATTERN(plaid): if (IN_USE(plaid)) return plaid(m, p); break;
        case PATTERN(houndstooth): if (IN_USE(houndstooth)) return houndstooth(m, p); break;
        case PATTERN(patchwork): if (IN_USE(patchwork)) return patchwork(m, p); break;
        case PATTERN(leopard): if (IN_USE(leopard)) return leopard(m, p); break;
        case PATTERN(zebra): if (IN_USE(zebra)) return zebra(m, p); break;
        case PATTERN(camouflage): if (IN_USE(camouflage)) return camouflage(m, p); break;
        case PATTERN(paisley): if (IN_USE(paisley)) return paisley(m, p); break;
        case PATTERN(encaustic): if (IN_USE(encaustic)) return encaustic(m, p); break;
        case PATTERN(laid_tiles): if (IN_USE(laid_tiles)) return laid_tiles(m, p); break;
        case PATTERN(peeling): if (IN_USE(peeling)) return peeling(m, p); break;
        case PATTERN(image): if (IN_USE(image)) return image(m, p); break;
    }
    return texture_value(m.color_a, m.roughness, 0.5f);
}

// The axis of the plane that a flat pattern lies in, by the dominant axis of the normal in texture space: 2 -> (x, y),
// 1 -> (x, z), 0 -> (z, y).
int dominant_axis(Vec3f n) {
    const float x = abs(n.x), y = abs(n.y), z = abs(n.z);
    return z >= x && z >= y ? 2 : y >= x ? 1 : 0;
}
Vec2f flat_coords(Vec3f c, int axis) {
    return axis == 2 ? vec2(c.x, c.y) : axis == 1 ? vec2(c.x, c.z) : vec2(c.z, c.y);
}
static TexturePoint moved(IN(TexturePoint) p, int axis, float du, float dv) {
    TexturePoint q = p;
    q.plane = p.plane + vec2(du, dv);
    q.coords = p.coords + (axis == 2 ? vec3(du, dv, 0) : axis == 1 ? vec3(du, 0, dv) : vec3(0, dv, du));
    return q;
}

static TextureValue in_range(TextureValue v) {
    v.albedo = vec3(unit_clamp(v.albedo.x), unit_clamp(v.albedo.y), unit_clamp(v.albedo.z));
    v.roughness = clamp(v.roughness, 0.02f, 1.f);
    return v;
}

TextureValue sample_texture(IN(Material) m, IN(TexturePoint) p) { return in_range(raw_texture(m, p)); }

// The pattern's value and, if `relief`, the slope of the surface: of the pattern's relief and the creases of soft
// things. Relief finer than the footprint fades, as in the pattern itself.
SurfaceTexture texture_with_slope(IN(Material) m, IN(TexturePoint) p, int axis, bool relief) {
    const bool bumps = relief && m.bump_m > 0.f, creases = relief && m.crease_m > 0.f;
    const float step_m = max(0.5f * p.footprint_m, 0.0004f);
    SurfaceTexture s;
    s.slope = vec2(0, 0);
    const int places = bumps || creases ? 3 : 1;  // here, a step along u, a step along v
    float here = 0;
    for (int i = 0; i < places; ++i) {
        const TexturePoint q = moved(p, axis, i == 1 ? step_m : 0.f, i == 2 ? step_m : 0.f);
        float height = 0;
        if (i == 0 || bumps) {
            const TextureValue v = raw_texture(m, q);
            if (i == 0) s.value = in_range(v);
            if (bumps) height += m.bump_m * v.height;
        }
        if (creases) height += m.crease_m * crease(q.coords, q.footprint_m, m.seed);
        if (i == 0) here = height;
        if (i == 1) s.slope.x = (height - here) / step_m;
        if (i == 2) s.slope.y = (height - here) / step_m;
    }
    // Limited, since steep flanks of joints would turn the normal below the horizon.
    const float l = length(s.slope);
    if (l > 0.7f) s.slope = s.slope * (0.7f / l);
    return s;
}

KERNEL_END

#endif
