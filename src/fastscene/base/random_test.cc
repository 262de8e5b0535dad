#include "fastscene/base/random.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

namespace fastscene {
namespace {

TEST(Random, EqualKeysGiveEqualNumbersAndOthersDoNot) {
    const auto first = [](std::uint64_t seed, const char* stream, std::uint64_t index) {
        return Random(seed, stream, index).next_u64();
    };
    EXPECT_EQ(first(7, "walk", 3), first(7, "walk", 3));
    std::set<std::uint64_t> seen;
    for (std::uint64_t seed = 0; seed < 20; ++seed)
        for (const char* stream : {"walk", "views", "rooms"})
            for (std::uint64_t index = 0; index < 20; ++index) seen.insert(first(seed, stream, index));
    EXPECT_EQ(seen.size(), 20u * 3u * 20u);
}

// The outputs of every finished run depend on these numbers: they must not change.
TEST(Random, KeepsItsNumbers) {
    EXPECT_EQ(mix64(0), 0xe220a8397b1dcdafull);
    Random random(1, "test");
    const std::uint64_t first = random.next_u64();
    EXPECT_EQ(first, Random(1, "test").next_u64());
    EXPECT_NE(first, random.next_u64());
}

// Chi-squared over 64 equal bins; 120 is exceeded with probability below 1e-5.
TEST(Random, UniformFillsItsBinsEvenly) {
    constexpr int kDraws = 64'000;
    std::array<int, 64> bins{};
    Random random(5, "bins");
    for (int i = 0; i < kDraws; ++i) {
        const float u = random.uniform();
        ASSERT_GE(u, 0.f);
        ASSERT_LT(u, 1.f);
        ++bins[static_cast<std::size_t>(u * 64.f)];
    }
    double chi2 = 0;
    for (const int n : bins) chi2 += (n - 1000.0) * (n - 1000.0) / 1000.0;
    EXPECT_LT(chi2, 120);
}

// Neighbouring counters are as independent as numbers of one stream.
TEST(Random, FirstDrawsOfNeighbouringIndicesAreUniformToo) {
    std::array<int, 64> bins{};
    for (std::uint64_t i = 0; i < 64'000; ++i) ++bins[static_cast<std::size_t>(Random(9, "pixel", i).uniform() * 64.f)];
    double chi2 = 0;
    for (const int n : bins) chi2 += (n - 1000.0) * (n - 1000.0) / 1000.0;
    EXPECT_LT(chi2, 120);
}

TEST(Random, NormalHasMeanZeroAndVarianceOne) {
    Random random(2, "normal");
    constexpr int kDraws = 100'000;
    double sum = 0, squares = 0;
    for (int i = 0; i < kDraws; ++i) {
        const double x = random.normal();
        ASSERT_TRUE(std::isfinite(x));
        sum += x;
        squares += x * x;
    }
    EXPECT_NEAR(sum / kDraws, 0, 0.02);  // six standard errors
    EXPECT_NEAR(squares / kDraws, 1, 0.03);
}

TEST(Random, IndexStaysInsideAndReachesBothEnds) {
    Random random(3, "index");
    std::set<int> seen;
    for (int i = 0; i < 1000; ++i) seen.insert(random.index(5));
    EXPECT_EQ(seen, (std::set<int>{0, 1, 2, 3, 4}));
}

}  // namespace
}  // namespace fastscene
