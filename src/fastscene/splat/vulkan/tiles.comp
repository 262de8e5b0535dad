// Where each tile's pairs begin in the list sorted by tile.
#version 460
#include "tables.glsl"

layout(local_size_x = 256) in;

void main() {
    if (has_failed()) return;
    const uint pairs = t.counters.pairs, tiles = plan_size().z * plan_size().w;
    const uint stride = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    if (pairs == 0)
        for (uint tile = gl_GlobalInvocationID.x; tile <= tiles; tile += stride) t.tile_begin.at[tile] = 0;
    for (uint i = gl_GlobalInvocationID.x; i < pairs; i += stride) {
        const uint tile = t.pair_tiles[side].at[i];
        const uint from = i == 0 ? 0 : t.pair_tiles[side].at[i - 1] + 1;
        for (uint begun = from; begun <= tile; ++begun) t.tile_begin.at[begun] = i;
        if (i == pairs - 1)
            for (uint begun = tile + 1; begun <= tiles; ++begun) t.tile_begin.at[begun] = pairs;
    }
}
