// How many pairs of a record and a tile each workgroup's piece of the sorted records makes.
#version 460
#include "tables.glsl"
#include "pairs.glsl"

shared uint sums[kLocal];

void main() {
    uint sum = 0;
    if (!has_failed())
        for (uint i = piece_begin() + gl_LocalInvocationID.x; i < piece_end(); i += kLocal)
            sum += tiles_of(t.boxes.at[t.depth_records[side].at[i]]);
    sums[gl_LocalInvocationID.x] = sum;
    barrier();
    for (uint half_size = kLocal / 2; half_size > 0; half_size /= 2) {
        if (gl_LocalInvocationID.x < half_size) sums[gl_LocalInvocationID.x] += sums[gl_LocalInvocationID.x + half_size];
        barrier();
    }
    if (gl_LocalInvocationID.x == 0) t.block_pairs.at[gl_WorkGroupID.x] = sums[0];
}
