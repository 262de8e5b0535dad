// Procedural materials: every Pattern of scene/room.h as a function of Mesh::coords. C++ calls these through
// trace/texture.h. Kernels in GLSL include this file, before any declaration of theirs, with glslc's -I src:
//
//   #include "fastscene/trace/kernel/texture.h"
//   layout(push_constant) uniform Push { Materials materials; … };   // MaterialData[] (material_data.h) in a buffer
//   const Material m = materials.at[i];
//   TexturePoint p;
//   p.coords = coords;                                // metres, interpolated from Mesh::coords
//   const int axis = dominant_axis(coords_normal);    // of the triangle's normal in texture space
//   p.plane = flat_coords(coords, axis);
//   p.footprint_m = …;                                // width of the sample on the surface
//   const SurfaceTexture t = texture_with_slope(m, p, axis, true);
//   t.value.albedo, t.value.roughness, t.slope.x, t.slope.y
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
        case PATTERN(plaster): return plaster(m, p);
        case PATTERN(wood): return wood(m, p);
        case PATTERN(planks): return planks(m, p);
        case PATTERN(herringbone): return herringbone(m, p);
        case PATTERN(parquet): return parquet(m, p);
        case PATTERN(tile): return tile(m, p);
        case PATTERN(checker): return checker(m, p);
        case PATTERN(subway): return subway(m, p);
        case PATTERN(brick): return brick(m, p);
        case PATTERN(concrete): return concrete(m, p);
        case PATTERN(marble): return marble(m, p);
        case PATTERN(terrazzo): return terrazzo(m, p);
        case PATTERN(fabric): return fabric(m, p);
        case PATTERN(knit): return knit(m, p);
        case PATTERN(carpet): return carpet(m, p);
        case PATTERN(leather): return leather(m, p);
        case PATTERN(rug): return rug(m, p);
        case PATTERN(stripes): return stripes(m, p);
        case PATTERN(damask): return damask(m, p);
        case PATTERN(floral): return floral(m, p);
        case PATTERN(wicker): return wicker(m, p);
        case PATTERN(metal): return metal(m, p);
        case PATTERN(art): return art(m, p);
        case PATTERN(book): return book(m, p);
        case PATTERN(leaf): return leaf(m, p);
        case PATTERN(grass): return grass(m, p);
        case PATTERN(bark): return bark(m, p);
        case PATTERN(screen): return screen(m, p);
        case PATTERN(dots): return dots(m, p);
        case PATTERN(zigzag): return zigzag(m, p);
        case PATTERN(twill): return twill(m, p);
        case PATTERN(geometric): return geometric(m, p);
        case PATTERN(diamonds): return diamonds(m, p);
        case PATTERN(lattice): return lattice(m, p);
        case PATTERN(stars): return stars(m, p);
        case PATTERN(gingham): return gingham(m, p);
        case PATTERN(plaid): return plaid(m, p);
        case PATTERN(houndstooth): return houndstooth(m, p);
        case PATTERN(patchwork): return patchwork(m, p);
        case PATTERN(leopard): return leopard(m, p);
        case PATTERN(zebra): return zebra(m, p);
        case PATTERN(camouflage): return camouflage(m, p);
        case PATTERN(paisley): return paisley(m, p);
        case PATTERN(encaustic): return encaustic(m, p);
        case PATTERN(laid_tiles): return laid_tiles(m, p);
        case PATTERN(peeling): return peeling(m, p);
        case PATTERN(image): return image(m, p);
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
