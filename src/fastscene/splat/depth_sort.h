// Records by depth, front to back: a radix sort over the bits of the depths (least digit first, so it is stable), cut
// into pieces for threads. The order hangs on the keys alone.
#pragma once

#include <cstdint>
#include <vector>

namespace fastscene::splat {

// How many pieces `count` things in depth order are worked on in; by their number, not by that of the threads.
int depth_pieces(std::size_t count);
// Where piece `piece` of `pieces` begins.
inline std::size_t piece_begin(std::size_t count, int piece, int pieces) {
    return count * static_cast<std::size_t>(piece) / static_cast<std::size_t>(pieces);
}

// Sorts keys (bits of a positive depth << 32 | anything) by depth; equal depths keep their order. `other` is scratch.
void sort_by_depth(std::vector<std::uint64_t>& keys, std::vector<std::uint64_t>& other);

}  // namespace fastscene::splat
