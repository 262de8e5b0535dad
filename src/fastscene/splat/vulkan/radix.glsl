// Stable least-significant-digit radix sort, in passes of two kernels. Each workgroup owns a contiguous piece of the
// list, and within it each subgroup a contiguous segment, so that the order is that of the list whatever runs first.

layout(constant_id = 1) const uint kLocal = 256;  // invocations of a workgroup
layout(local_size_x_id = 1) in;
const uint kBins = 256;

bool by_tile() { return first >= 2; }  // `first`: 0 and 1 sort records by depth, 2 pairs by tile
uint list_size() {
    if (by_tile()) return min(t.counters.pairs, t.pair_capacity);
    return first == 1 ? t.counters.count * (flag(kEquirect) ? 2 : 1) : t.counters.visible;
}
uint key_at(uint i) { return by_tile() ? t.pair_tiles[side].at[i] : t.depth_keys[side].at[i]; }
bool is_kept(uint key) { return first != 1 || key != kNoKey; }
uint digit_of(uint key) { return key >> shift & ((1u << bits) - 1); }

// The segment of each subgroup, a multiple of its size.
uint segment_size() {
    const uint unit = gl_NumWorkGroups.x * kLocal;
    return (list_size() + unit - 1) / unit * kSubgroup;
}
uint segment_begin() {
    return (gl_WorkGroupID.x * gl_NumSubgroups + gl_SubgroupID) * segment_size();
}
