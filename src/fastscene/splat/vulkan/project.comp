// One invocation a splat: its record (two of them across the seam of an equirectangular picture), the tiles that it may
// touch, and its key for the sort by depth.
#version 460
#include "tables.glsl"
#include "project.glsl"

layout(local_size_x = 256) in;

void store_record(uint r, vec2 at, Projection p) {
    const vec3 quadratic = vec3(-0.5 * kLog2E * p.conic.x, -kLog2E * p.conic.y, -0.5 * kLog2E * p.conic.z);
    const vec3 color = max(p.color_raw, vec3(0));
    const float half_b = -0.5 * quadratic.y;
    t.records.at[3 * r] = vec4(at, quadratic.xy);
    t.records.at[3 * r + 1] = vec4(quadratic.z, p.log2_opacity, color.rg);
    t.records.at[3 * r + 2] = vec4(color.b, p.depth, half_b / quadratic.z, half_b / quadratic.x);
}
// Tiles of the pixels whose centers lie between `low` and `high`, both counted in pixels.
uvec2 box_of(vec2 low, vec2 high) {
    const vec2 last = vec2(plan.size.xy) - 1.0;
    const uvec2 first_tile = uvec2(clamp(low, vec2(0), last)) / kTile, last_tile = uvec2(clamp(high, vec2(0), last)) / kTile;
    const uvec2 tiles = last_tile - first_tile + 1;
    return uvec2(first_tile.x | first_tile.y << 16, tiles.x | tiles.y << 16);
}

void main() {
    const uint i = gl_GlobalInvocationID.x;
    const bool equirect = flag(kEquirect);
    const uint records_a_splat = equirect ? 2 : 1;
    const bool there = i < t.counters.count && !has_failed();
    uint shown = 0;
    if (there) {
        const Gaussian g = load_gaussian(i);
        const vec4 sight = sight_of(g.mean);
        const Projection p = project(g, more_color(i, sight.xyz));
        const vec2 half_size = sqrt(max(reach2_of(p), 0.0) * vec2(p.xx, p.yy));
        const vec2 low = p.at - half_size - 0.5, high = p.at + half_size - 0.5, last = vec2(plan.size.xy) - 1.0;
        const bool visible = is_drawable(g, p) && high.y >= 0.0 && low.y <= last.y &&
                             (equirect || (high.x >= 0.0 && low.x <= last.x));
        const uint r = i * records_a_splat;
        if (visible) {
            shown = 1;
            store_record(r, p.at, p);
            t.boxes.at[r] = box_of(low, high);
        }
        t.depth_keys[0].at[r] = visible ? floatBitsToUint(p.depth) : kNoKey;
        t.depth_records[0].at[r] = r;
        if (!visible) t.boxes.at[r] = uvec2(0);
        if (equirect) {  // the copy on the other side of the seam
            const bool to_right = low.x < 0.0, copied = visible && (to_right || high.x > last.x);
            if (copied) {
                shown = 2;
                const vec2 aside = vec2(to_right ? float(plan_size().x) : -float(plan_size().x), 0);
                store_record(r + 1, p.at + aside, p);
                t.boxes.at[r + 1] = box_of(low + aside, high + aside);
            } else t.boxes.at[r + 1] = uvec2(0);
            t.depth_keys[0].at[r + 1] = copied ? floatBitsToUint(p.depth) : kNoKey;
            t.depth_records[0].at[r + 1] = r + 1;
        }
    }
    const uint sum = subgroupAdd(shown);
    if (subgroupElect() && sum > 0) atomicAdd(t.counters.visible, sum);
}
