// The picture, front to back. A block ends where all its pixels are opaque; `stops` remembers where.
#version 460
#include "tables.glsl"
#include "raster.glsl"

shared Record near_ones[kBlocks][kSubgroup];

void main() {
    if (has_failed()) return;
    const uvec2 corner = block_corner(), pixel = pixel_at(corner);
    const bool inside = all(lessThan(pixel, plan.size.xy));
    const vec2 center = vec2(pixel) + 0.5;
    const uint begin = t.tile_begin.at[gl_WorkGroupID.x], end = t.tile_begin.at[gl_WorkGroupID.x + 1];
    float transmittance = inside ? 1.0 : 0.0, depth = 0.0;
    vec3 color = vec3(0);
    uint stop = end;
    for (uint base = begin; base < end; base += kSubgroup) {
        if (subgroupAll(transmittance < kOpaque)) {
            stop = base;
            break;
        }
        const uint i = base + gl_SubgroupInvocationID;
        bool touched = false;
        if (i < end) {
            const Record s = load_record(t.pair_records[side].at[i]);
            touched = touches(s, vec2(corner));
            if (touched) near_ones[gl_SubgroupID][gl_SubgroupInvocationID] = s;
        }
        const uvec4 set = subgroupBallot(touched);
        subgroupMemoryBarrierShared();
        subgroupBarrier();
        for (uint word = 0; word < (kSubgroup + 31) / 32; ++word)
            for (uint left = set[word]; left != 0; left &= left - 1) {
                const Record s = near_ones[gl_SubgroupID][word * 32 + findLSB(left)];
                const float weight = alpha_at(s, center - s.place.xy) * transmittance;
                transmittance -= weight;
                color += color_of(s) * weight;
                depth += weight * s.more.y;
            }
        subgroupBarrier();
    }
    if (subgroupElect()) t.stops.at[gl_WorkGroupID.x * kBlocks + gl_SubgroupID] = stop;
    if (!inside) return;
    const uint at = pixel.y * plan_size().x + pixel.x;
    t.color.at[at] = vec4(color + transmittance * plan.background.xyz, transmittance);
    if (flag(kDepth)) t.depth.at[at] = depth;
}
