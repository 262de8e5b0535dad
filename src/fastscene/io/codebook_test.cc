#include "fastscene/io/codebook.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fastscene/base/parallel.h"
#include "fastscene/base/random.h"

namespace fastscene {
namespace {

double mean_squared_error(const std::vector<float>& points, const VectorCodebook& book) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float c = book.centroids[book.labels[i / book.dimensions] * book.dimensions + i % book.dimensions];
        sum += static_cast<double>((points[i] - c) * (points[i] - c));
    }
    return sum / static_cast<double>(points.size());
}

TEST(Codebook, ScalarsFallOnTheNearestOf256) {
    Random random(1, "codebook");
    std::vector<float> values(5000);
    for (float& v : values) v = random.normal();
    const ScalarCodebook book = scalar_codebook(values);
    double error = 0;
    for (const float v : values) {
        float best = 1e9f;
        for (const float c : book) best = std::min(best, std::abs(v - c));
        EXPECT_FLOAT_EQ(std::abs(book[nearest_in(book, v)] - v), best);
        error += static_cast<double>(best * best);
    }
    // Panter and Dite: the best codebook of a normal distribution has an error of pi sqrt(3) / 2 / 256^2.
    EXPECT_LT(error / 5000, 2 * 2.72 / 65536);
}

TEST(Codebook, FewPointsKeepTheirOwn) {
    const std::vector<float> points{1, 2, 3, 4, 5, 6};
    const VectorCodebook book = vector_codebook(points, 2, 8);
    EXPECT_EQ(mean_squared_error(points, book), 0);
}

// Centroids in a square: the error of a perfect grid is side^2 / 12 / count an axis; a random choice has about twice
// as much.
TEST(Codebook, TwoLevelsComeNearTheBest) {
    Random random(2, "codebook");
    std::vector<float> points(2 * 40000);
    for (float& v : points) v = random.uniform();
    const VectorCodebook book = vector_codebook(points, 2, 2000);
    EXPECT_LE(book.size(), 2000u);
    EXPECT_GT(book.size(), 1700u);
    EXPECT_LT(mean_squared_error(points, book), 1.25 / 12 / 2000);
}

TEST(Codebook, ThreadsDoNotMatter) {
    Random random(3, "codebook");
    std::vector<float> points(9 * 5000);
    for (float& v : points) v = random.normal();
    const int threads = thread_count();
    set_threads(1);
    const VectorCodebook one = vector_codebook(points, 9, 1024);
    set_threads(3);
    const VectorCodebook three = vector_codebook(points, 9, 1024);
    set_threads(threads);
    EXPECT_EQ(one.centroids, three.centroids);
    EXPECT_EQ(one.labels, three.labels);
}

}  // namespace
}  // namespace fastscene
