// Depth sorting, front to back: a least-significant-digit radix sort (hence stable) over the depths' bits, parallelized
// over pieces. The order depends on the keys only.
#pragma once

#include <cstdint>
#include <vector>

namespace fastscene::splat {

// The number of pieces that `count` items are divided into; independent of the number of threads.
int depth_pieces(std::size_t count);
// Where piece `piece` of `pieces` begins.
inline std::size_t piece_begin(std::size_t count, int piece, int pieces) {
    return count * static_cast<std::size_t>(piece) / static_cast<std::size_t>(pieces);
}

// Sorts keys (bits of a positive depth << 32
// payload) by depth, stably. `other` is scratch.
void sort_by_depth(std::vector<std::uint64_t>& keys, std::vector<std::uint64_t>& other);

}  // namespace fastscene::splat
