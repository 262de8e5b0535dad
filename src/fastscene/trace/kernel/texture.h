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
    const TextureValue even = texture_value(m.color_a, m.roughness, 0.5f);
    switch (m.pattern) {
        case PATTERN(plain): return even;
        case PATTERN(plaster): return IN_USE(plaster) ? plaster(m, p) : even;
        case PATTERN(wood): return IN_USE(wood) ? wood(m, p) : even;
        case PATTERN(planks): return IN_USE(planks) ? planks(m, p) : even;
        case PATTERN(herringbone): return IN_USE(herringbone) ? herringbone(m, p) : even;
        case PATTERN(parquet): return IN_USE(parquet) ? parquet(m, p) : even;
        case PATTERN(tile): return IN_USE(tile) ? tile(m, p) : even;
        case PATTERN(checker): return IN_USE(checker) ? checker(m, p) : even;
        case PATTERN(subway): return IN_USE(subway) ? subway(m, p) : even;
        case PATTERN(brick): return IN_USE(brick) ? brick(m, p) : even;
        case PATTERN(concrete): return IN_USE(concrete) ? concrete(m, p) : even;
        case PATTERN(marble): return IN_USE(marble) ? marble(m, p) : even;
        case PATTERN(terrazzo): return IN_USE(terrazzo) ? terrazzo(m, p) : even;
        case PATTERN(fabric): return IN_USE(fabric) ? fabric(m, p) : even;
        case PATTERN(knit): return IN_USE(knit) ? knit(m, p) : even;
        case PATTERN(carpet): return IN_USE(carpet) ? carpet(m, p) : even;
        case PATTERN(leather): return IN_USE(leather) ? leather(m, p) : even;
        case PATTERN(rug): return IN_USE(rug) ? rug(m, p) : even;
        case PATTERN(stripes): return IN_USE(stripes) ? stripes(m, p) : even;
        case PATTERN(damask): return IN_USE(damask) ? damask(m, p) : even;
        case PATTERN(floral): return IN_USE(floral) ? floral(m, p) : even;
        case PATTERN(wicker): return IN_USE(wicker) ? wicker(m, p) : even;
        case PATTERN(metal): return IN_USE(metal) ? metal(m, p) : even;
        case PATTERN(art): return IN_USE(art) ? art(m, p) : even;
        case PATTERN(book): return IN_USE(book) ? book(m, p) : even;
        case PATTERN(leaf): return IN_USE(leaf) ? leaf(m, p) : even;
        case PATTERN(grass): return IN_USE(grass) ? grass(m, p) : even;
        case PATTERN(bark): return IN_USE(bark) ? bark(m, p) : even;
        case PATTERN(screen): return IN_USE(screen) ? screen(m, p) : even;
        case PATTERN(dots): return IN_USE(dots) ? dots(m, p) : even;
        case PATTERN(zigzag): return IN_USE(zigzag) ? zigzag(m, p) : even;
        case PATTERN(twill): return IN_USE(twill) ? twill(m, p) : even;
        case PATTERN(geometric): return IN_USE(geometric) ? geometric(m, p) : even;
        case PATTERN(diamonds): return IN_USE(diamonds) ? diamonds(m, p) : even;
        case PATTERN(lattice): return IN_USE(lattice) ? lattice(m, p) : even;
        case PATTERN(stars): return IN_USE(stars) ? stars(m, p) : even;
        case PATTERN(gingham): return IN_USE(gingham) ? gingham(m, p) : even;
        case PATTERN(plaid): return IN_USE(plaid) ? plaid(m, p) : even;
        case PATTERN(houndstooth): return IN_USE(houndstooth) ? houndstooth(m, p) : even;
        case PATTERN(patchwork): return IN_USE(patchwork) ? patchwork(m, p) : even;
        case PATTERN(leopard): return IN_USE(leopard) ? leopard(m, p) : even;
        case PATTERN(zebra): return IN_USE(zebra) ? zebra(m, p) : even;
        case PATTERN(camouflage): return IN_USE(camouflage) ? camouflage(m, p) : even;
        case PATTERN(paisley): return IN_USE(paisley) ? paisley(m, p) : even;
        case PATTERN(encaustic): return IN_USE(encaustic) ? encaustic(m, p) : even;
        case PATTERN(laid_tiles): return IN_USE(laid_tiles) ? laid_tiles(m, p) : even;
        case PATTERN(peeling): return IN_USE(peeling) ? peeling(m, p) : even;
        case PATTERN(image): return IN_USE(image) ? image(m, p) : even;
    }
    return even;
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

static TextureValue in_range(IN(Material) m, TextureValue v) {
    v.metal = m.metal * (m.pattern == PATTERN(image) ? v.metal : 1.f);  // only pictures say it,
    if (m.pattern != PATTERN(screen)) v.shown = vec3(1, 1, 1);          // and only screens this
    v.albedo = vec3(unit_clamp(v.albedo.x), unit_clamp(v.albedo.y), unit_clamp(v.albedo.z));
    v.roughness = clamp(v.roughness, 0.02f, 1.f);
    return v;
}

TextureValue sample_texture(IN(Material) m, IN(TexturePoint) p) { return in_range(m, raw_texture(m, p)); }

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
            if (i == 0) s.value = in_range(m, v);
            if (bumps) height += m.bump_m * v.height;
        }
        if (creases) height += m.crease_m * crease(q.coords, q.footprint_m, m.seed);
        if (i == 0) here = height;
        if (i == 1) s.slope.x = (height - here) / step_m;
        if (i == 2) s.slope.y = (height - here) / step_m;
    }
    if (relief && IN_USE(image)) s.slope = s.slope + normal_map_slope(m, p);
    // Limited, since steep flanks of joints would turn the normal below the horizon.
    const float l = length(s.slope);
    if (l > 0.7f) s.slope = s.slope * (0.7f / l);
    return s;
}

KERNEL_END

#endif
