// Moves each key and its value to their place.
#version 460
#include "tables.glsl"
#include "radix.glsl"

const uint kSubgroups = kLocal / kSubgroup;
shared uint places[kSubgroups][kBins];  // of each subgroup's next key with a digit
shared uint totals[kBins];

// places[0][d] = how many keys of digit d stand before this workgroup's, over all digits below d too.
void first_places() {
    const uint lane = gl_LocalInvocationID.x;
    for (uint d = lane; d < kBins; d += kLocal) {
        uint before = 0, all = 0;
        for (uint w = 0; w < gl_NumWorkGroups.x; ++w) {
            const uint count = t.histogram.at[w * kBins + d];
            if (w < gl_WorkGroupID.x) before += count;
            all += count;
        }
        places[0][d] = before, totals[d] = all;
    }
    barrier();
    if (gl_SubgroupID == 0) {  // exclusive prefix sum of the totals
        uint below = 0;
        for (uint d = gl_SubgroupInvocationID; d < kBins; d += kSubgroup) {
            const uint all = totals[d], sum = subgroupInclusiveAdd(all);
            totals[d] = below + sum - all;
            below += subgroupShuffle(sum, kSubgroup - 1);
        }
    }
    barrier();
    for (uint d = lane; d < kBins; d += kLocal) totals[d] += places[0][d];
    barrier();
}

void move(uint from, uint to, uint key) {
    if (by_tile()) {
        t.pair_tiles[1 - side].at[to] = key;
        t.pair_records[1 - side].at[to] = t.pair_records[side].at[from];
    } else {
        t.depth_keys[1 - side].at[to] = key;
        t.depth_records[1 - side].at[to] = t.depth_records[side].at[from];
    }
}

void main() {
    if (has_failed()) return;
    const uint lane = gl_LocalInvocationID.x, begin = segment_begin(), size = list_size(),
               end = min(begin + segment_size(), size);
    first_places();
    for (uint d = lane; d < kBins; d += kLocal)
        for (uint s = 0; s < kSubgroups; ++s) places[s][d] = 0;
    barrier();
    for (uint i = begin + gl_SubgroupInvocationID; i < end; i += kSubgroup) {
        const uint key = key_at(i);
        if (is_kept(key)) atomicAdd(places[gl_SubgroupID][digit_of(key)], 1);
    }
    barrier();
    for (uint d = lane; d < kBins; d += kLocal) {
        uint place = totals[d];
        for (uint s = 0; s < kSubgroups; ++s) {
            const uint count = places[s][d];
            places[s][d] = place;
            place += count;
        }
    }
    barrier();

    for (uint round = begin; round < begin + segment_size(); round += kSubgroup) {
        const uint i = round + gl_SubgroupInvocationID;
        const uint key = i < end ? key_at(i) : kNoKey;
        const bool kept = i < end && is_kept(key);
        const uint digit = digit_of(key);
        uvec4 peers = subgroupBallot(kept);  // with the same digit
        for (uint b = 0; b < bits; ++b) {
            const bool set = (digit >> b & 1) != 0;
            const uvec4 others = subgroupBallot(set);
            peers &= set ? others : ~others;
        }
        const uint rank = subgroupBallotExclusiveBitCount(peers), count = subgroupBallotBitCount(peers);
        uint place = 0;
        if (kept) place = places[gl_SubgroupID][digit];
        subgroupMemoryBarrierShared();
        subgroupBarrier();
        if (kept && rank == 0) places[gl_SubgroupID][digit] = place + count;
        subgroupMemoryBarrierShared();
        subgroupBarrier();
        if (kept) move(i, place + rank, key);
    }
}
