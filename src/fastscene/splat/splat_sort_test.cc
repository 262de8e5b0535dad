#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <numeric>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"
#include "fastscene/splat/depth_sort.h"

namespace fastscene::splat {
namespace {

std::vector<std::uint64_t> keys_of(const std::vector<float>& depths) {
    std::vector<std::uint64_t> keys;
    for (std::size_t i = 0; i < depths.size(); ++i)
        keys.push_back(std::uint64_t{std::bit_cast<std::uint32_t>(depths[i])} << 32 | i);
    return keys;
}

TEST(DepthSort, FrontToBackAndStable) {
    Random random(1, "test.depth_sort", 0);
    for (const int count : {0, 1, 2, 1000, 50000}) {
        std::vector<float> depths;
        // Depths as in a room, with duplicates, plus extreme values.
        for (int i = 0; i < count; ++i) depths.push_back(std::round(random.uniform(0.1f, 9.f) * 512) / 512);
        if (count > 100) depths[7] = 1e6f, depths[70] = 0.1f, depths[71] = 1e-30f;
        std::vector<std::uint64_t> keys = keys_of(depths), other, wanted = keys;
        std::stable_sort(wanted.begin(), wanted.end(),
                         [](std::uint64_t a, std::uint64_t b) { return a >> 32 < b >> 32; });
        sort_by_depth(keys, other);
        EXPECT_EQ(keys, wanted) << count;
    }
}

TEST(DepthSort, PiecesHoldEverythingOnce) {
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{16383}, std::size_t{16384},
                                    std::size_t{200001}, std::size_t{5000000}}) {
        const int pieces = depth_pieces(count);
        EXPECT_GE(pieces, 1);
        EXPECT_LE(pieces, 8);
        EXPECT_EQ(piece_begin(count, 0, pieces), 0u);
        EXPECT_EQ(piece_begin(count, pieces, pieces), count);
        for (int p = 0; p < pieces; ++p) EXPECT_LE(piece_begin(count, p, pieces), piece_begin(count, p + 1, pieces));
    }
}

}  // namespace
}  // namespace fastscene::splat
