// Writes the pairs. All invocations of a workgroup share the pairs of its records evenly, for a record may touch one
// tile or thousands.
#version 460
#include "tables.glsl"
#include "pairs.glsl"

shared uint up_to[kLocal];  // pairs of the round's records up to and with each
shared uint record[kLocal];
shared uint counts[2][kLocal];

void main() {
    const uint lane = gl_LocalInvocationID.x;
    // Pairs of the workgroups before, and of all.
    uint before = 0, all = 0;
    for (uint w = lane; w < gl_NumWorkGroups.x; w += kLocal) {
        const uint count = t.block_pairs.at[w];
        if (w < gl_WorkGroupID.x) before += count;
        all += count;
    }
    counts[0][lane] = before, counts[1][lane] = all;
    barrier();
    for (uint half_size = kLocal / 2; half_size > 0; half_size /= 2) {
        if (lane < half_size)
            counts[0][lane] += counts[0][lane + half_size], counts[1][lane] += counts[1][lane + half_size];
        barrier();
    }
    uint base = counts[0][0];
    all = counts[1][0];
    // Told to the host by the last kernel of the step. Kernels of this dispatch do not read these.
    if (gl_WorkGroupID.x == 0 && lane == 0 && !has_failed()) {
        t.counters.pairs = all;
        if (all > t.pair_capacity) t.counters.failed = plan.number;
    }
    if (all > t.pair_capacity) return;

    for (uint begin = piece_begin(); begin < piece_end(); begin += kLocal) {
        const uint i = begin + lane;
        uint tiles = 0, r = 0;
        if (i < piece_end()) {
            r = t.depth_records[side].at[i];
            tiles = tiles_of(t.boxes.at[r]);
        }
        barrier();
        up_to[lane] = tiles, record[lane] = r;
        barrier();
        for (uint reach = 1; reach < kLocal; reach *= 2) {  // inclusive prefix sum
            const uint more = lane >= reach ? up_to[lane - reach] : 0;
            barrier();
            up_to[lane] += more;
            barrier();
        }
        if (tiles > 0) t.first_pair.at[r] = base + up_to[lane] - tiles;
        const uint made = up_to[kLocal - 1];
        for (uint pair = lane; pair < made; pair += kLocal) {
            uint low = 0;  // the first record with up_to > pair
            for (uint reach = kLocal / 2; reach > 0; reach /= 2)
                if (up_to[low + reach - 1] <= pair) low += reach;
            const uint of = record[low], nth = pair - (low > 0 ? up_to[low - 1] : 0);
            const uvec2 box = t.boxes.at[of];
            const uint wide = box.y & 0xffff, x = (box.x & 0xffff) + nth % wide, y = (box.x >> 16) + nth / wide;
            t.pair_tiles[0].at[base + pair] = y * plan_size().z + x;
            t.pair_records[0].at[base + pair] = of;
        }
        base += made;
    }
}
