#include "fastscene/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace fastscene {
namespace {

TEST(Parallel, VisitsEveryIndexOnceInFixedPieces) {
    for (const std::int64_t count : {0, 1, 7, 64, 1000}) {
        for (const std::int64_t grain : {1, 3, 64, 5000}) {
            std::vector<int> visits(static_cast<std::size_t>(count));
            std::atomic<bool> pieces_fixed{true};
            parallel_for(count, grain, [&](std::int64_t begin, std::int64_t end) {
                if (begin % grain != 0 || end != std::min(count, begin + grain)) pieces_fixed = false;
                for (std::int64_t i = begin; i < end; ++i) ++visits[static_cast<std::size_t>(i)];
            });
            EXPECT_TRUE(pieces_fixed) << count << " by " << grain;
            for (const int v : visits) EXPECT_EQ(v, 1);
        }
    }
}

TEST(Parallel, FloatSumsOfPiecesAreTheSameForAnyNumberOfThreads) {
    const auto sum = [](int threads) {
        set_threads(threads);
        std::vector<float> pieces(100);
        parallel_for(10'000, 100, [&](std::int64_t begin, std::int64_t end) {
            float s = 0;
            for (std::int64_t i = begin; i < end; ++i) s += 1.f / static_cast<float>(i + 1);
            pieces[static_cast<std::size_t>(begin / 100)] = s;
        });
        return std::accumulate(pieces.begin(), pieces.end(), 0.f);
    };
    const float one = sum(1), four = sum(4);
    set_threads(0);
    EXPECT_EQ(one, four);
    EXPECT_NEAR(one, 9.787606f, 1e-4f);  // the harmonic number of 10000
}

TEST(Parallel, RethrowsWhatAPieceThrows) {
    EXPECT_THROW(parallel_for(100, 1,
                              [](std::int64_t begin, std::int64_t) {
                                  if (begin == 42) throw std::out_of_range("42");
                              }),
                 std::out_of_range);
}

TEST(Parallel, ZeroThreadsMeansAllCores) {
    EXPECT_EQ(set_threads(3), 3);
    EXPECT_EQ(thread_count(), 3);
    EXPECT_GE(set_threads(0), 1);
}

}  // namespace
}  // namespace fastscene
