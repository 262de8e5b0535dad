#include "fastscene/splat/depth_sort.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "fastscene/base/parallel.h"

namespace fastscene::splat {
namespace {

constexpr int kMostDigit = 11;  // bits: a piece's counters fit into the L1 cache

std::uint32_t depth_bits(std::uint64_t key) { return static_cast<std::uint32_t>(key >> 32); }

}  // namespace

int depth_pieces(std::size_t count) { return static_cast<int>(std::clamp<std::size_t>(count / 16384, 1, 8)); }

void sort_by_depth(std::vector<std::uint64_t>& keys, std::vector<std::uint64_t>& other) {
    if (keys.size() < 2) return;
    const auto [least, most] = std::minmax_element(keys.begin(), keys.end());
    const std::uint32_t base = depth_bits(*least);
    // Depths within a room differ in about 26 of their 32 bits.
    const int bits = std::bit_width(depth_bits(*most) - base), passes = (bits + kMostDigit - 1) / kMostDigit;
    const int digit = passes ? (bits + passes - 1) / passes : 0, pieces = depth_pieces(keys.size());
    const std::size_t values = std::size_t{1} << digit;
    std::vector<std::uint32_t> counts(values * static_cast<std::size_t>(pieces));
    other.resize(keys.size());
    for (int pass = 0; pass < passes; ++pass) {
        const auto value = [&](std::uint64_t key) { return (depth_bits(key) - base) >> (pass * digit) & (values - 1); };
        const auto each = [&](auto&& visit) {
            parallel_for(pieces, 1, [&](std::int64_t piece, std::int64_t) {
                std::uint32_t* const count = counts.data() + static_cast<std::size_t>(piece) * values;
                const std::size_t end = piece_begin(keys.size(), static_cast<int>(piece) + 1, pieces);
                for (std::size_t i = piece_begin(keys.size(), static_cast<int>(piece), pieces); i < end; ++i)
                    visit(count[value(keys[i])], keys[i]);
            });
        };
        std::fill(counts.begin(), counts.end(), 0u);
        each([](std::uint32_t& count, std::uint64_t) { ++count; });
        std::uint32_t sum = 0;
        for (std::size_t v = 0; v < values; ++v)
            for (std::size_t piece = 0; piece < static_cast<std::size_t>(pieces); ++piece) {
                std::uint32_t& count = counts[piece * values + v];
                count = std::exchange(sum, sum + count);
            }
        each([&](std::uint32_t& at, std::uint64_t key) { other[at++] = key; });
        keys.swap(other);
    }
}

}  // namespace fastscene::splat
