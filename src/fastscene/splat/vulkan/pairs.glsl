// Expansion of the sorted records into pairs of a tile and a record, in depth order.
const uint kLocal = 256;
layout(local_size_x = 256) in;

uint tiles_of(uvec2 box) { return (box.y & 0xffff) * (box.y >> 16); }
uint piece_size() { return (t.counters.visible + gl_NumWorkGroups.x - 1) / gl_NumWorkGroups.x; }
uint piece_begin() { return gl_WorkGroupID.x * piece_size(); }
uint piece_end() { return min(piece_begin() + piece_size(), t.counters.visible); }
